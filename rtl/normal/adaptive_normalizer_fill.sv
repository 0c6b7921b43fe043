// SPDX-License-Identifier: Apache-2.0
//
// Last stage of adaptive_normalizer: the pixels of the segments, Lanes at a time.
//
//   N(i + Lanes) = N(i) + Lanes dN
//
// Groups are aligned to the span's first pixel. A group across borders of segments is gathered, one
// segment a cycle, and is on offer with its last.
//
// Timing    Segment taken in cycle c: first group in c + 1. Segments follow without a bubble.
// Formats   S1.38, wraps; out S1.24, rounded half up.
// Model     model/normal/adaptive_clock.h          Doc  docs/units/normal/adaptive_normalizer.md
module adaptive_normalizer_fill
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1           // 1 or 4
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              segment_valid_i,
  output logic              segment_ready_o,
  input  adaptive_segment_t segment_i,
  output logic              load_o,          // the first segment of a span is taken

  output logic              pixel_valid_o,
  input  logic              pixel_ready_i,
  output pixel_normal_t [Lanes-1:0][Components-1:0] normal_o,
  output logic          [Lanes-1:0]                 mask_o,
  output logic              last_o,          // last group of its span
  output logic              busy_o
);
  typedef logic [2:0] lane_t;                // 0..4
  typedef pixel_normal_t [Components-1:0] normal_t;

  logic         active_q, first_q, last_q;   // first_q: the next segment begins a span
  lane_t        lane_q;                      // of the segment's next pixel
  span_length_t left_q;                      // pixels of the segment to come
  quantity_t [Lanes-1:0][Components-1:0] value_q;
  quantity_t [Components-1:0]            difference_q;

  logic [13:0] end_lane;                     // behind the segment's last pixel, from this group on
  logic        ends, complete, advance, load, end_segment;
  assign end_lane        = 14'(left_q) + 14'(lane_q);
  assign ends            = end_lane <= 14'(Lanes);
  assign complete        = end_lane >= 14'(Lanes) || last_q;
  assign pixel_valid_o   = active_q && complete;
  assign advance         = active_q && (!complete || pixel_ready_i);
  assign end_segment     = advance && ends;
  assign segment_ready_o = !active_q || end_segment;
  assign load            = segment_valid_i && segment_ready_o;
  assign load_o          = load && (end_segment ? last_q : first_q);
  assign last_o          = last_q && ends;
  assign busy_o          = active_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      first_q  <= 1'b1;
      lane_q   <= '0;
    end else begin
      active_q <= load || (active_q && !end_segment);
      if (end_segment) first_q <= last_q;
      if (advance)     lane_q  <= complete ? '0 : end_lane[2:0];
    end
  end
  always_ff @(posedge clk_i) begin
    if (load) begin
      left_q       <= segment_i.count;
      last_q       <= segment_i.last;
      difference_q <= segment_i.difference;
    end else if (advance) begin
      left_q <= left_q + 13'(lane_q) - span_length_t'(Lanes);
    end
  end

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    normal_t rounded;
    for (genvar i = 0; i < Components; i++) begin : gen_component
      quantity_t offset, stride;            // from the first lane; of a group
      constant_product #(.value_t(quantity_t), .Factor(lane)) u_offset (
        .value_i(segment_i.difference[i]), .product_o(offset));
      constant_product #(.value_t(quantity_t), .Factor(Lanes)) u_stride (
        .value_i(difference_q[i]), .product_o(stride));
      assign rounded[i] = to_pixel_normal(value_q[lane][i]);
      always_ff @(posedge clk_i) begin
        if (load) begin
          value_q[lane][i] <= segment_i.first[i] + offset;
        end else if (advance) begin
          value_q[lane][i] <= value_q[lane][i] + stride;
        end
      end
    end
    assign mask_o[lane] = end_lane > 14'(lane);
    if (lane + 1 < Lanes) begin : gen_gather
      normal_t gathered_q;
      always_ff @(posedge clk_i) begin
        if (advance && !complete && lane_q <= lane_t'(lane)) gathered_q <= rounded;
      end
      assign normal_o[lane] = lane_q <= lane_t'(lane) ? rounded : gathered_q;
    end else begin : gen_direct
      assign normal_o[lane] = rounded;
    end
  end
endmodule
