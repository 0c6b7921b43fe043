// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one cosine along a span: paper 003's surface on the unclamped N.L or N.H
// instead of the intensity; clamp and power follow per pixel. Additions only.
//
//   c(t+1) = c(t) + d(t),  d(t+1) = d(t) + 2A
//
// Lane j of Lanes starts at pixel j, paper 003 (3), and steps Lanes pixels.
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S1.44 of one pixel's stride, sums wrap; cosine S1.30, rounded half up, saturated.
// Error     The recurrence is exact; seeds rounded to 2^-45 move pixel t by at most
//           (1 + t + t (t - 1) / 2) 2^-45: 2^-24 in 2048 pixels; rounding adds 0.5 ulp of S1.30.
// Model     model/light/quad_cosine.h      Doc  docs/units/light/quad_cosine.md
module quad_cosine
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lane = 0,
  parameter int unsigned Lanes = 1
) (
  input  logic        clk_i,
  input  logic        load_i,   // takes seed_i
  input  logic        step_i,   // moves on by Lanes pixels; load_i wins
  input  curve_seed_t seed_i,
  output cosine_t     cosine_o
);
  localparam int unsigned Latency = 1;

  curve_seed_t seed;
  lane_seed #(.value_t(cosine_acc_t), .seed_t(curve_seed_t), .Lane(Lane), .Lanes(Lanes))
  u_lane_seed (.seed_i, .seed_o(seed));

  cosine_acc_t value;
  second_difference #(.value_t(cosine_acc_t)) u_second_difference (
    .clk_i,
    .load_i,
    .step_i,
    .first_i      (seed.first),
    .difference_i (seed.difference),
    .curvature_i  (seed.curvature),
    .value_o      (value)
  );

  // S1.44 -> S1.30.
  logic signed [$bits(cosine_acc_t):0] rounded;
  assign rounded  = $bits(rounded)'(value) + 47'sd8192;
  assign cosine_o = to_cosine(35'(rounded >>> 14));
endmodule
