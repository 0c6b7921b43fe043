// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span, in segments of 2^k pixels with a line in each:
// paper 003, its formula for the ends of segments. Shifts and additions only.
//
//   I(x+2^k) = I(x) + 2^(k+1) A x + 2^(2k) A + 2^k (Cy + D) = I(x) + 2^k slope
//   slope = I(x+1) - I(x) + (2^k - 1) A, and 2^k 2A more from segment to segment
//
// k, 0..11, is the largest whose line stays within the tolerance: |A| 4^k / 4 <= tolerance.
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), even curvature; tolerance U4.12
//           codes; code U8.0 (truncate, clamp); sums modulo 2^36: shown values lie in -102..357.
// Error     The tolerance, none at the ends of segments; seeds rounded to 2^-27 codes move pixel t
//           by (t^2 + 1) 2^-27 codes more: < 1/32 code for 2048 pixels. RTL = model.
// Bad input An odd curvature: t 2^-27 codes more.
// Model     model/intensity/quad_segment.h      Doc  docs/units/intensity/quad_segment.md
module quad_segment
  import light_pkg::*;
  import shading_pkg::*;
(
  input  logic          clk_i,
  input  logic          load_i,       // takes seed_i and tolerance_i
  input  logic          step_i,       // moves to the next pixel; load_i wins
  input  tolerance_t    tolerance_i,
  input  channel_seed_t seed_i,
  output code_t         code_o
);
  localparam int unsigned Latency = 1;

  localparam int unsigned MostShift = 11;        // segments of 2048 pixels
  typedef logic [MostShift-1:0] steps_t;

  // |2A| 4^k <= 8 tolerance, in units of 2^-26 codes, without a shift to the left.
  logic [35:0] magnitude, limit;
  assign magnitude = seed_i.curvature[35] ? -seed_i.curvature : seed_i.curvature;
  assign limit     = 36'(tolerance_i) << 17;

  logic [3:0] k;
  always_comb begin
    k = '0;
    for (int unsigned i = 1; i <= MostShift; i++) begin
      if (magnitude <= limit >> (2 * i)) k = 4'(i);
    end
  end

  intensity_acc_t a;
  assign a = seed_i.curvature >>> 1;

  intensity_acc_t current_q;
  intensity_acc_t slope_q;
  intensity_acc_t bend_q;         // 2^k 2A
  steps_t         length_q;       // 2^k - 1
  steps_t         left_q;         // steps to the last pixel of the segment

  assign code_o = to_code(current_q);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      current_q <= seed_i.first;
      slope_q   <= seed_i.difference + (a <<< k) - a;
      bend_q    <= seed_i.curvature <<< k;
      length_q  <= ~(steps_t'('1) << k);
      left_q    <= ~(steps_t'('1) << k);
    end else if (step_i) begin
      current_q <= current_q + slope_q;
      if (left_q == '0) slope_q <= slope_q + bend_q;
      left_q <= left_q == '0 ? length_q : left_q - steps_t'(1);
    end
  end
endmodule
