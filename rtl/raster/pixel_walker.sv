// SPDX-License-Identifier: Apache-2.0
//
// Walks the pixels of a span: position and depth of each, and the load and step commands for the
// intensity units that march with it.
//
//   x(i) = x + i,   z(i) = z + i dz/dx
//
// Timing    Latency 1 cycle from run accepted to first pixel, then 1 pixel per cycle.
//           ready/valid on both ports; back-to-back runs leave no bubble.
// Formats   depth in S1.38 (half an ulp of U0.24 included), out U0.24 (truncate, clamp).
// Error     dz/dx rounded to 2^-39 moves pixel i by i 2^-39: <= 1/8 ulp of U0.24 for 4096 pixels.
// Model     model/raster/pixel_walker.h      Doc  docs/units/raster/pixel_walker.md
module pixel_walker
  import shading_pkg::*;
(
  input  logic   clk_i,
  input  logic   rst_ni,

  // Runs, one per span.
  input  logic   run_valid_i,
  output logic   run_ready_o,
  input  run_t   run_i,

  // Pixels, left to right.
  output logic   pixel_valid_o,
  input  logic   pixel_ready_i,
  output coord_t pixel_x_o,
  output coord_t pixel_y_o,
  output depth_t pixel_z_o,
  output logic   pixel_last_o,

  output logic   load_o,          // a run is taken: load the intensity units
  output logic   step_o           // the run goes on: step them
);
  localparam int unsigned Latency = 1;

  coord_t       x_q, y_q;
  depth_acc_t   z_q, dz_dx_q;
  span_length_t left_q;           // pixels left, this one included

  logic send_pixel;
  assign send_pixel    = pixel_valid_o && pixel_ready_i;
  assign pixel_valid_o = left_q != '0;
  assign pixel_last_o  = left_q == span_length_t'(1);
  assign run_ready_o   = !pixel_valid_o || (pixel_last_o && pixel_ready_i);
  assign load_o        = run_valid_i && run_ready_o;
  assign step_o        = send_pixel && !pixel_last_o;

  assign pixel_x_o = x_q;
  assign pixel_y_o = y_q;
  assign pixel_z_o = to_depth(z_q);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)         left_q <= '0;
    else if (load_o)     left_q <= run_i.length;
    else if (send_pixel) left_q <= left_q - 1'b1;
  end

  // Datapath registers need no reset: pixel_valid_o qualifies them.
  always_ff @(posedge clk_i) begin
    if (load_o) begin
      x_q     <= run_i.x;
      y_q     <= run_i.y;
      z_q     <= run_i.z;
      dz_dx_q <= run_i.dz_dx;
    end else if (step_o) begin
      x_q <= x_q + 1'b1;
      z_q <= z_q + dz_dx_q;
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
