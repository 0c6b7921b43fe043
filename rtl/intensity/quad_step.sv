// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span, from pixel to pixel: paper 003 (3), one product
// a pixel.
//
//   I(x+1) = I(x) + 2A x + A + Cy + D, relative to the start of the span:
//   I(t+1) = I(t) + d(0) + t 2A,  d(0) = I(1) - I(0)
//
// The product adds shifted copies of 2A that the bits of t select: an array multiplier by another
// name, without a multiplier cell.
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), t 12 bits, code U8.0 (truncate,
//           clamp); sums modulo 2^36: shown values lie in -86..341.
// Error     The sum is exact; seeds rounded to 2^-27 codes move pixel t by at most
//           (t^2 + 1) 2^-27 codes: < 1/32 code for 2048 pixels. RTL = model on every pixel.
// Model     model/intensity/quad_step.h      Doc  docs/units/intensity/quad_step.md
module quad_step
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

  intensity_acc_t current_q;      // I(t)
  intensity_acc_t difference_q;   // d(0)
  intensity_acc_t curvature_q;    // 2A
  coord_t         t_q;

  intensity_acc_t product;        // t 2A
  always_comb begin
    product = '0;
    for (int unsigned k = 0; k < $bits(coord_t); k++) begin
      product += t_q[k] ? curvature_q <<< k : '0;
    end
  end

  assign code_o = to_code(current_q);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      current_q    <= seed_i.first;
      difference_q <= seed_i.difference;
      curvature_q  <= seed_i.curvature;
      t_q          <= '0;
    end else if (step_i) begin
      current_q <= current_q + difference_q + product;
      t_q       <= t_q + 12'd1;
    end
  end
endmodule
