// SPDX-License-Identifier: Apache-2.0
//
// Linear interpolation of one quantity along a span: a component of the normal, or N.L or N.H, by
// Phong's rule. The vector that three of them form is not of unit length.
//
//   s(t+1) = s(t) + D
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i. With k lanes, lane j
//           starts at pixel j and D spans k pixels.
// Formats   seed and value S1.38; wraps on values outside [-2, 2).
// Error     The recurrence is exact; s(0) and D rounded to 2^-39 move step t by (t + 1)/2 ulp:
//           1024 ulp of S1.38 in 2048 pixels. RTL = model on every pixel.
// Bad input Seeds that leave [-2, 2) wrap and come back exactly.
// Model     model/normal/linear_recurrence.h      Doc  docs/units/normal/linear_recurrence.md
module linear_recurrence
  import normal_pkg::*;
(
  input  logic           clk_i,
  input  logic           load_i,   // takes seed_i
  input  logic           step_i,   // moves to the next pixel; load_i wins
  input  quantity_seed_t seed_i,
  output quantity_t      value_o
);
  localparam int unsigned Latency = 1;

  quantity_t value_q;              // s(t)
  quantity_t difference_q;         // D

  assign value_o = value_q;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      value_q      <= seed_i.first;
      difference_q <= seed_i.difference;
    end else if (step_i) begin
      value_q <= value_q + difference_q;
    end
  end
endmodule
