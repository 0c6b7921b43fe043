// SPDX-License-Identifier: Apache-2.0
//
// Samples of the footprints of pixels, paper 001: one after the other, those of Lanes neighbouring
// pixels side by side. A footprint is an ellipse on the surface and a disc on the screen; the
// normal and the enlarged triangle's barycentrics are affine there, so that a sample is a sum.
//
//   N(s) = N(centre) +- offset_k,   inside(s) = a', b', c' of the sample >= 0       (2), (3)
//
// A sample outside the enlarged triangle is excluded. A pixel whose samples are all outside takes
// its centre in place of the last. Offsets and sums of a triangle that excludes nothing are 0.
//
// Timing    A sample a cycle and lane, those of successive pixels back to back: 1, 2, 4 or 7 cycles
//           a pixel. The last one waits for enter_ready_i. 2 cycles from a sample's turn to
//           sample_valid_o, from where it never stalls. 3 from load_i on.
// Formats   normal and offsets S1.38, sums saturate; barycentrics S3.28, wrap.
// Error     Exact for the numbers it is given, but for barycentrics within (x + 1) 2^-29 of 0.
// Bad input Sums of components outside [-2, 2) saturate. Barycentrics wrap beyond +-8.
// Model     model/footprint/aniso_footprint.h      Doc  docs/units/footprint/aniso_footprint.md
module aniso_footprint
  import footprint_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // A span starts.
  input  logic                       load_i,
  input  footprint_t                 footprint_i,
  input  margin_t [Corners-1:0]      margin_i,         // at its first pixel's centre

  // Pixels, as the walker offers them, and their normals, which step when a group is taken.
  input  logic                       pixel_valid_i,
  output logic                       pixel_ready_o,
  input  logic [Lanes-1:0]           mask_i,
  input  quantity_t [Components-1:0][Lanes-1:0] normal_i,

  // A pixel's last sample: its position enters the queue.
  output logic                       enter_valid_o,
  input  logic                       enter_ready_i,

  output logic                       sample_valid_o,
  output sample_place_t              place_o,
  output logic [Lanes-1:0]           live_o,           // not excluded
  output quantity_t [Lanes-1:0][Components-1:0] normal_o,

  input  logic                       clear_i,
  output sample_counters_t           counters_o        // since clear_i
);
  localparam int unsigned Latency = 3;

  footprint_t                       footprint_q;
  margin_t [Lanes-1:0][Corners-1:0] margin_q;          // of the centres
  sample_index_t                    index_q;           // of the sample whose turn it is
  logic [Lanes-1:0]                 any_live_q;        // a sample of this pixel was inside

  //////////////////////
  // Whose turn it is //
  //////////////////////

  logic          issue, first, last, step;
  sample_place_t place;
  assign last          = index_q == last_index(footprint_q.pattern);
  assign enter_valid_o = pixel_valid_i && last;
  assign pixel_ready_o = enter_ready_i && last;
  assign step          = enter_valid_o && enter_ready_i;
  assign issue         = pixel_valid_i && (!last || enter_ready_i);
  assign first         = index_q == '0;
  assign place         = '{first: first, last: last,
                           twice: first && footprint_q.pattern == FootprintEight};

  // + and - of pair 0, 1, 2; none at the centre.
  logic                   at_centre, negative;
  logic [2:0]             turn;
  footprint_offset_t      offset;
  assign at_centre = first && has_centre(footprint_q.pattern);
  assign turn      = index_q - 3'(has_centre(footprint_q.pattern));
  assign negative  = turn[0];
  always_comb begin
    unique case (turn[2:1])
      2'd0:    offset = footprint_q.offset[0];
      2'd1:    offset = footprint_q.offset[1];
      default: offset = footprint_q.offset[2];
    endcase
    if (at_centre) offset = '0;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)    index_q <= '0;
    else if (issue) index_q <= last ? '0 : index_q + 3'd1;
  end

  always_ff @(posedge clk_i) if (load_i) footprint_q <= footprint_i;

  /////////////////
  // Inside test //
  /////////////////

  logic [Lanes-1:0] is_inside, live, falls_back;
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_inside
    margin_t [Corners-1:0] at;               // of the sample
    margin_t [Corners-1:0] lane_offset, stride;
    for (genvar c = 0; c < Corners; c++) begin : gen_corner
      constant_product #(.value_t(margin_t), .Factor(lane)) u_offset (
        .value_i(footprint_i.margin_dx[c]), .product_o(lane_offset[c]));
      constant_product #(.value_t(margin_t), .Factor(Lanes)) u_stride (
        .value_i(footprint_q.margin_dx[c]), .product_o(stride[c]));
    end
    always_comb begin
      is_inside[lane] = 1'b1;
      for (int unsigned c = 0; c < Corners; c++) begin
        at[c] = negative ? margin_q[lane][c] - offset.margin[c]
                         : margin_q[lane][c] + offset.margin[c];
        is_inside[lane] = is_inside[lane] && !at[c][31];
      end
    end

    always_ff @(posedge clk_i) begin
      for (int unsigned c = 0; c < Corners; c++) begin
        if (load_i) begin
          margin_q[lane][c] <= margin_i[c] + lane_offset[c];
        end else if (step) begin
          margin_q[lane][c] <= margin_q[lane][c] + stride[c];
        end
      end
      if (issue) any_live_q[lane] <= is_inside[lane] || (any_live_q[lane] && !first);
    end

    assign falls_back[lane] = last && !is_inside[lane] && (first || !any_live_q[lane]);
    assign live[lane]       = is_inside[lane] || falls_back[lane];
  end

  /////////////
  // Samples //
  /////////////

  logic                                    valid_q, sample_valid_q, negative_q;
  sample_place_t                           place_q, sample_place_q;
  logic [Lanes-1:0]                        live_q, centre_q, sample_live_q;
  quantity_t [Components-1:0]              offset_q;
  quantity_t [Components-1:0][Lanes-1:0]   normal_q;
  quantity_t [Lanes-1:0][Components-1:0]   sample_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) {valid_q, sample_valid_q} <= '0;
    else         {valid_q, sample_valid_q} <= {issue, valid_q};
  end

  always_ff @(posedge clk_i) begin
    if (issue) begin
      place_q    <= place;
      live_q     <= live;
      centre_q   <= falls_back;
      negative_q <= negative;
      offset_q   <= offset.normal;
      normal_q   <= normal_i;
    end
    if (valid_q) begin
      sample_place_q <= place_q;
      sample_live_q  <= live_q;
      for (int unsigned lane = 0; lane < Lanes; lane++) begin
        for (int unsigned c = 0; c < Components; c++) begin
          sample_q[lane][c] <= offset_sum(normal_q[c][lane],
                                          centre_q[lane] ? '0 : offset_q[c], negative_q);
        end
      end
    end
  end

  assign sample_valid_o = sample_valid_q;
  assign place_o        = sample_place_q;
  assign live_o         = sample_live_q;
  assign normal_o       = sample_q;

  //////////////
  // Counters //
  //////////////

  sample_counters_t counters_q;
  assign counters_o = counters_q;

  function automatic logic [31:0] ones(logic [Lanes-1:0] bits);
    ones = '0;
    for (int unsigned lane = 0; lane < Lanes; lane++) ones = ones + 32'(bits[lane]);
  endfunction

  logic [31:0] saved;                        // of the pixels whose last sample this is
  always_comb begin
    saved = '0;
    for (int unsigned lane = 0; lane < Lanes; lane++) begin
      if (mask_i[lane]) saved = saved + MostSamples - 1 - 32'(index_q);
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      counters_q <= '0;
    end else if (clear_i) begin
      counters_q <= '0;
    end else if (issue) begin
      counters_q.taken    <= counters_q.taken + ones(mask_i & live);
      counters_q.excluded <= counters_q.excluded + ones(mask_i & ~live);
      if (last) counters_q.saved <= counters_q.saved + saved;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      assert (index_q == '0 || step) else $error("aniso_footprint: a span cuts the one before");
    end
  end
`endif
endmodule
