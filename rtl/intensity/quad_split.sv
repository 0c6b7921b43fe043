// SPDX-License-Identifier: Apache-2.0
//
// Diffuse and specular light of one channel as two second-order surfaces along a span, paper 003,
// each clamped at 0 and added: where the light turns away, N.L is not clamped before it is fitted.
//
//   D(x+1) = D(x) + d,  d += 2A'      S(x+1) = S(x) + s,  s += 2A''
//   I(x) = ambient + max(0, D(x)) + max(0, S(x))
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seeds S9.26; ambient S9.26, never negative: 0..255.5 codes with the half code for
//           rounding; the sum U11.26, below 3 * 512; code U8.0 (truncate, clamp). Surfaces wrap on
//           values that are not shown; shown ones lie in -426..426.
// Error     The recurrences are exact; seeds rounded to 2^-27 codes move pixel t by at most
//           2 (1 + t + t (t - 1) / 2) 2^-27 codes: < 1/32 code for 2048 pixels. RTL = model on every
//           pixel.
// Model     model/intensity/quad_split.h      Doc  docs/units/intensity/quad_split.md
module quad_split
  import light_pkg::*;
  import shading_pkg::*;
(
  input  logic          clk_i,
  input  logic          load_i,       // takes the seeds
  input  logic          step_i,       // moves to the next pixel; load_i wins
  input  channel_seed_t diffuse_i,
  input  split_seed_t   split_i,      // specular and ambient
  output code_t         code_o
);
  localparam int unsigned Latency = 1;

  intensity_acc_t diffuse, specular, ambient_q;
  second_difference u_diffuse (
    .clk_i,
    .load_i,
    .step_i,
    .first_i      (diffuse_i.first),
    .difference_i (diffuse_i.difference),
    .curvature_i  (diffuse_i.curvature),
    .value_o      (diffuse)
  );
  second_difference u_specular (
    .clk_i,
    .load_i,
    .step_i,
    .first_i      (split_i.specular.first),
    .difference_i (split_i.specular.difference),
    .curvature_i  (split_i.specular.curvature),
    .value_o      (specular)
  );

  typedef logic [$bits(intensity_acc_t):0] sum_t;  // U11.26
  function automatic sum_t lit(intensity_acc_t term);
    lit = term < 0 ? '0 : sum_t'(term);
  endfunction

  sum_t sum;
  assign sum    = sum_t'(ambient_q) + lit(diffuse) + lit(specular);
  assign code_o = sum[$bits(sum_t)-1:34] != '0 ? '1 : sum[33:26];

  always_ff @(posedge clk_i) begin
    if (load_i) ambient_q <= split_i.ambient;
  end
endmodule
