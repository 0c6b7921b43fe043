// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span by forward differences: the two additions per
// pixel that paper 003 does not mention. (3) with its slope kept in a register:
//
//   I(x+1) = I(x) + d(x)      d(x+1) = d(x) + 2A      d(x) = 2Ax + A + Cy + D
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), code U8.0 (truncate, clamp);
//           internal S9.26, wraps on values that are not shown: shown ones lie in -86..341.
// Error     The recurrence is exact; I(0), d(0) and 2A rounded to 2^-27 codes move pixel t by at
//           most (1 + t + t(t-1)/2) 2^-27 codes: < 1/64 code for 2048 pixels. RTL = model.
// Model     model/intensity/quad_difference.h      Doc  docs/units/intensity/quad_difference.md
module quad_difference
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

  intensity_acc_t value;
  second_difference u_second_difference (
    .clk_i,
    .load_i,
    .step_i,
    .first_i      (seed_i.first),
    .difference_i (seed_i.difference),
    .curvature_i  (seed_i.curvature),
    .value_o      (value)
  );

  assign code_o = to_code(value);
endmodule
