// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span, two pixels at a time: even pixels by paper 003
// (5) with twice the stride, odd ones as midpoints by (6). Shifts and additions only.
//
//   x even:  I(x+4) = 2 I(x+2) - I(x) + 8A       I(x+1) = [I(x) + I(x+2)] / 2 - A
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i. The recurrence moves
//           once in two pixels.
// Formats   seed S9.26 (the half code for rounding included), code U8.0 (truncate, clamp);
//           internal S9.26, wraps on values that are not shown: shown ones lie in -86..341. A
//           midpoint is half of a sum modulo 1024 codes, so it is known modulo 512: the residue
//           in -128..383 is shown.
// Error     Exact: what is halved is even. I(0), I(1) - I(0) and A rounded to 2^-27 codes move
//           pixel t by at most (t^2 + 1) 2^-27 codes: < 1/32 code for 2048 pixels. RTL = model.
// Model     model/intensity/quad_midpoint.h      Doc  docs/units/intensity/quad_midpoint.md
module quad_midpoint
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

  intensity_acc_t shown_q;        // the pixel: I(x), or the midpoint I(x+1) when odd_q
  intensity_acc_t current_q;      // I(x), x even
  intensity_acc_t next_q;         // I(x+2)
  intensity_acc_t curvature_q;    // 2A
  logic           odd_q;

  // 2 I(x+1) = I(x) + I(x+2) - 2A: even, as I(x) + I(x+2) = 2 I(x+1) + 2A. One shift halves the
  // sum and 2A, which may be odd.
  intensity_acc_t doubled;
  intensity_acc_t midpoint;

  assign doubled = current_q + next_q - curvature_q;
  // Bits 34:0 are doubled / 2; 384..511 codes stand for -128..-1.
  assign midpoint = {&doubled[35:34], doubled[35:1]};
  assign code_o   = to_code(shown_q);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      shown_q     <= seed_i.first;
      current_q   <= seed_i.first;
      next_q      <= seed_i.first + (seed_i.difference <<< 1) + seed_i.curvature;
      curvature_q <= seed_i.curvature;
      odd_q       <= 1'b0;
    end else if (step_i) begin
      odd_q <= !odd_q;
      if (!odd_q) begin
        shown_q <= midpoint;
      end else begin
        shown_q   <= next_q;
        current_q <= next_q;
        next_q    <= (next_q <<< 1) - current_q + (curvature_q <<< 2);
      end
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (step_i && !load_i && !odd_q) assert (!doubled[0]);
  end
`endif
endmodule
