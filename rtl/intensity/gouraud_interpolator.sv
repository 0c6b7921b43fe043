// SPDX-License-Identifier: Apache-2.0
//
// Gouraud interpolation of one channel: first-order forward difference along a span.
//
//   I(x+1) = I(x) + D
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), code U8.0 (truncate, clamp);
//           internal S9.26, wraps on values that are not shown.
// Error     The recurrence is exact; D rounded to 2^-27 moves pixel t by t 2^-27 codes.
//           RTL = model on every pixel.
// Model     model/intensity/gouraud_interpolator.h
// Doc       docs/units/intensity/gouraud_interpolator.md
module gouraud_interpolator
  import light_pkg::*;
  import shading_pkg::*;
(
  input  logic          clk_i,
  input  logic          load_i,   // takes seed_i
  input  logic          step_i,   // moves to the next pixel; load_i wins
  input  channel_seed_t seed_i,
  output code_t         code_o
);
  localparam int unsigned Latency = 1;

  intensity_acc_t current_q;      // I(x)
  intensity_acc_t difference_q;   // D

  assign code_o = to_code(current_q);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      current_q    <= seed_i.first;
      difference_q <= seed_i.difference;
    end else if (step_i) begin
      current_q <= current_q + difference_q;
    end
  end
endmodule
