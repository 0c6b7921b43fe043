// SPDX-License-Identifier: Apache-2.0
//
// Diffuse and specular light of one channel as two second-order surfaces along a span, paper 003, each
// clamped at 0 and added: where the light turns away, N.L is not clamped before it is fitted.
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

  intensity_acc_t diffuse_q, diffuse_step_q, diffuse_curvature_q;
  intensity_acc_t specular_q, specular_step_q, specular_curvature_q;
  intensity_acc_t ambient_q;

  typedef logic [$bits(intensity_acc_t):0] sum_t;  // U11.26
  sum_t diffuse, specular, sum;
  assign diffuse  = diffuse_q < 0 ? '0 : sum_t'(diffuse_q);
  assign specular = specular_q < 0 ? '0 : sum_t'(specular_q);
  assign sum      = sum_t'(ambient_q) + diffuse + specular;
  assign code_o   = sum[$bits(sum_t)-1:34] != '0 ? '1 : sum[33:26];

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      diffuse_q            <= diffuse_i.first;
      diffuse_step_q       <= diffuse_i.difference;
      diffuse_curvature_q  <= diffuse_i.curvature;
      specular_q           <= split_i.specular.first;
      specular_step_q      <= split_i.specular.difference;
      specular_curvature_q <= split_i.specular.curvature;
      ambient_q            <= split_i.ambient;
    end else if (step_i) begin
      diffuse_q       <= diffuse_q + diffuse_step_q;
      diffuse_step_q  <= diffuse_step_q + diffuse_curvature_q;
      specular_q      <= specular_q + specular_step_q;
      specular_step_q <= specular_step_q + specular_curvature_q;
    end
  end
endmodule
