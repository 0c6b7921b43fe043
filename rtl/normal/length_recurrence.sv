// SPDX-License-Identifier: Apache-2.0
//
// Squared length of the linearly interpolated normal along a span, a quadratic: two additions.
//
//   q(t+1) = q(t) + d(t),   d(t+1) = d(t) + c
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i. With k lanes, lane j
//           starts at pixel j and a step spans k pixels.
// Formats   seed and value S1.44; wraps on values outside [-2, 2).
// Error     The recurrence is exact; seeds rounded to 2^-45 move step t by at most
//           (1 + t + t (t - 1)/2)/2 ulp: 2^-24 in 2048 pixels. RTL = model on every pixel.
// Bad input Seeds that leave [-2, 2) wrap and come back exactly.
// Model     model/normal/length_recurrence.h      Doc  docs/units/normal/length_recurrence.md
module length_recurrence
  import normal_pkg::*;
(
  input  logic         clk_i,
  input  logic         load_i,   // takes seed_i
  input  logic         step_i,   // moves to the next pixel; load_i wins
  input  length_seed_t seed_i,
  output length_sq_t   value_o
);
  localparam int unsigned Latency = 1;

  second_difference #(.value_t(length_sq_t)) u_second_difference (
    .clk_i,
    .load_i,
    .step_i,
    .first_i      (seed_i.first),
    .difference_i (seed_i.difference),
    .curvature_i  (seed_i.curvature),
    .value_o
  );
endmodule
