// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span from pixels alone: paper 003 (8), its third
// difference is 0. The product with 3 is a shift and an addition, as in the structure of its
// figure 5; both products share one subtraction.
//
//   I(x+3) = 3 I(x+2) - 3 I(x+1) + I(x)
//          = ((I(x+2) - I(x+1)) << 1) + (I(x+2) - I(x+1)) + I(x)
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), code U8.0 (truncate, clamp);
//           internal S9.26, wraps on values that are not shown: shown ones lie in -86..341.
// Error     The recurrence is exact; I(0), I(1) and I(2) rounded to 2^-27 codes move pixel t by at
//           most (2t^2 - 4t + 1) 2^-27 codes: < 1/16 code for 2048 pixels. RTL = model.
// Model     model/intensity/quad_third_difference.h
// Doc       docs/units/intensity/quad_third_difference.md
module quad_third_difference
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
  intensity_acc_t next_q;         // I(x+1)
  intensity_acc_t third_q;        // I(x+2)

  intensity_acc_t rise;           // I(x+2) - I(x+1)

  assign rise   = third_q - next_q;
  assign code_o = to_code(current_q);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      current_q <= seed_i.first;
      next_q    <= seed_i.second;
      third_q   <= seed_i.second + seed_i.difference + seed_i.curvature;
    end else if (step_i) begin
      current_q <= next_q;
      next_q    <= third_q;
      third_q   <= (rise <<< 1) + rise + current_q;
    end
  end
endmodule
