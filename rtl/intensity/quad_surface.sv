// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span: paper 003 (5), the structure of its figure 4.
// Shifts and additions only.
//
//   I(x+2) = 2 I(x+1) - I(x) + 2A
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), code U8.0 (truncate, clamp);
//           internal S9.26, wraps on values that are not shown: shown ones lie in -86..341.
// Error     The recurrence is exact; seeds rounded to 2^-27 codes move pixel t by at most
//           (t^2 + t - 1) 2^-27 codes: < 1/32 code for 2048 pixels. RTL = model on every pixel.
// Model     model/intensity/quad_surface.h      Doc  docs/units/intensity/quad_surface.md
module quad_surface
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
  intensity_acc_t curvature_q;    // 2A

  assign code_o = to_code(current_q);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      current_q   <= seed_i.first;
      next_q      <= seed_i.second;
      curvature_q <= seed_i.curvature;
    end else if (step_i) begin
      current_q <= next_q;
      next_q    <= (next_q <<< 1) - current_q + curvature_q;
    end
  end
endmodule
