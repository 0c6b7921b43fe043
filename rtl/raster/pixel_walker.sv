// SPDX-License-Identifier: Apache-2.0
//
// Walks the pixels of a span, Lanes at a time: position and depth of each, and the load and step
// commands for the units that march with it.
//
//   x(i) = x + i,   z(i) = z + i dz/dx
//
// Timing    Latency 1 cycle from run accepted to first pixels, then Lanes pixels per cycle.
//           ready/valid on both ports; back-to-back runs leave no bubble.
// Formats   depth in S1.38 (half an ulp of U0.24 included), out U0.24 (truncate, clamp).
// Error     dz/dx rounded to 2^-39 moves pixel i by i 2^-39: <= 1/8 ulp of U0.24 for 4096 pixels.
// Model     model/raster/pixel_walker.h      Doc  docs/units/raster/pixel_walker.md
module pixel_walker
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic      clk_i,
  input  logic      rst_ni,

  // Runs, one per span.
  input  logic      run_valid_i,
  output logic      run_ready_o,
  input  run_t      run_i,

  // Pixels, left to right: lane j holds pixel j of the group, mask_o says which lanes do.
  output logic                  pixel_valid_o,
  input  logic                  pixel_ready_i,
  output position_t [Lanes-1:0] position_o,
  output logic      [Lanes-1:0] mask_o,

  output logic      load_o,       // a run is taken: load the units that march along
  output logic      step_o        // the run goes on: step them
);
  localparam int unsigned Latency = 1;

  coord_t                 x_q, y_q;
  depth_acc_t [Lanes-1:0] z_q;
  depth_acc_t             dz_dx_q;
  span_length_t           left_q;  // pixels left, this group included

  logic send, last_group;
  assign last_group    = left_q <= span_length_t'(Lanes);
  assign send          = pixel_valid_o && pixel_ready_i;
  assign pixel_valid_o = left_q != '0;
  assign run_ready_o   = !pixel_valid_o || (last_group && pixel_ready_i);
  assign load_o        = run_valid_i && run_ready_o;
  assign step_o        = send && !last_group;

  depth_acc_t stride;
  constant_product #(.Factor(Lanes)) u_stride (.value_i(dz_dx_q), .product_o(stride));

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    depth_acc_t offset;                     // from the first lane
    constant_product #(.Factor(lane)) u_offset (.value_i(run_i.dz_dx), .product_o(offset));
    assign position_o[lane] = '{x: x_q + coord_t'(lane), y: y_q, z: to_depth(z_q[lane]),
                                last: left_q == span_length_t'(lane + 1)};
    assign mask_o[lane] = left_q > span_length_t'(lane);

    always_ff @(posedge clk_i) begin
      if (load_o)      z_q[lane] <= run_i.z + offset;
      else if (step_o) z_q[lane] <= z_q[lane] + stride;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)     left_q <= '0;
    else if (load_o) left_q <= run_i.length;
    else if (send)   left_q <= last_group ? '0 : left_q - span_length_t'(Lanes);
  end

  // Datapath registers need no reset: pixel_valid_o qualifies them.
  always_ff @(posedge clk_i) begin
    if (load_o) begin
      x_q     <= run_i.x;
      y_q     <= run_i.y;
      dz_dx_q <= run_i.dz_dx;
    end else if (step_o) begin
      x_q <= x_q + coord_t'(Lanes);
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (load_o) begin
      assert (run_i.length != '0) else $error("pixel_walker: a run of 0 pixels");
    end
  end
`endif
endmodule
