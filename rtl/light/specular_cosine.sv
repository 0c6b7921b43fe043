// SPDX-License-Identifier: Apache-2.0
//
// Prepares the cosines of a pixel for lighting: the diffuse factor and the base of the highlight's
// power, paper 000 (1), (12).
//
//   diffuse  = N.L clamped to [0, 1]
//   specular = N.H                                     LightingBlinn
//   specular = R.V = 2 (N.L)(N.V) - L.V                LightingPhong
//
// Timing    Latency 2 cycles for both, a pixel a cycle, never stalls.
// Formats   cosines S1.30. Diffuse U1.17, halves up. R.V: 2 (N.L)(N.V) rounded to S3.30, halves up,
//           L.V subtracted, saturated to S1.30. N.H passes unchanged.
// Error     Specular <= 0.5 ulp of S1.30, diffuse <= 0.5 ulp of U1.17; R.V saturates at -2 and
//           2 - 2^-30, which no unit vectors reach.
// Model     model/light/specular_cosine.h      Doc  docs/units/light/specular_cosine.md
module specular_cosine
  import light_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,
  input  light_t   light_i,         // stable while pixels are inside
  input  logic     valid_i,
  input  cosines_t cosines_i,
  output logic     valid_o,
  output diffuse_t diffuse_o,
  output logic     unlit_o,         // N.L <= 0
  output cosine_t  specular_o
);
  localparam int unsigned Latency = 2;

  typedef logic signed [63:0] product_t;               // S3.60, one sign bit more than needed

  logic     product_valid_q, specular_valid_q;
  product_t product_q;                                 // (N.L)(N.V), LightingPhong only
  cosine_t  n_dot_h_q;                                 // LightingBlinn only
  diffuse_t [1:0] diffuse_q;
  logic     [1:0] unlit_q;
  cosine_t  specular_q;

  logic     phong;
  product_t doubled;                                   // S3.30, sign-extended

  assign phong   = light_i.lighting == LightingPhong;
  assign doubled = (product_q + (product_t'(1) <<< 28)) >>> 29;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      product_valid_q  <= 1'b0;
      specular_valid_q <= 1'b0;
    end else begin
      product_valid_q  <= valid_i;
      specular_valid_q <= product_valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      diffuse_q[0] <= to_diffuse(cosines_i.n_dot_l);
      unlit_q[0]   <= cosines_i.n_dot_l <= 0;
      if (phong) begin
        product_q <= product_t'(cosines_i.n_dot_l) * product_t'(cosines_i.n_dot_h_or_v);
      end else begin
        n_dot_h_q <= cosines_i.n_dot_h_or_v;
      end
    end
    if (product_valid_q) begin
      diffuse_q[1] <= diffuse_q[0];
      unlit_q[1]   <= unlit_q[0];
      specular_q   <= phong ? to_cosine(35'(doubled) - 35'(light_i.l_dot_v)) : n_dot_h_q;
    end
  end

  assign valid_o    = specular_valid_q;
  assign diffuse_o  = diffuse_q[1];
  assign unlit_o    = unlit_q[1];
  assign specular_o = specular_q;
endmodule
