// SPDX-License-Identifier: Apache-2.0
//
// Cosine of a pixel's normal with a direction of the frame: N.L, N.H or N.V.
//
//   N.D = Nx Dx + Ny Dy + Nz Dz
//
// Timing    Latency 2 cycles, a normal a cycle, never stalls.
// Formats   normal S1.24, vector S1.22; products and sum exact (S4.46), rounded once, halves up, to
//           S1.30; saturates at -2 and 2 - 2^-30.
// Error     <= 0.5 ulp of S1.30 while the sum lies in range: always for vectors up to length 1.4.
// Model     model/light/dot_product.h      Doc  docs/units/light/dot_product.md
module dot_product
  import light_pkg::*;
(
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           valid_i,
  input  pixel_normal_t [Components-1:0] normal_i,
  input  direction_t    [Components-1:0] vector_i,   // constant of the frame
  output logic                           valid_o,
  output cosine_t                        cosine_o
);
  localparam int unsigned Latency = 2;
  localparam int unsigned Extra = 16;                // fraction bits of the sum beyond S1.30

  typedef logic signed [49:0] product_t;             // S3.46
  typedef logic signed [51:0] sum_t;                 // S5.46

  logic                      product_valid_q, cosine_valid_q;
  product_t [Components-1:0] product_q;
  cosine_t                   cosine_q;
  sum_t                      rounded;                // S5.30, sign-extended

  always_comb begin
    rounded = sum_t'(1) <<< (Extra - 1);
    for (int unsigned k = 0; k < Components; k++) rounded += sum_t'($signed(product_q[k]));
    rounded = rounded >>> Extra;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      product_valid_q <= 1'b0;
      cosine_valid_q  <= 1'b0;
    end else begin
      product_valid_q <= valid_i;
      cosine_valid_q  <= product_valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      for (int unsigned k = 0; k < Components; k++) begin
        product_q[k] <= product_t'($signed(normal_i[k])) * product_t'($signed(vector_i[k]));
      end
    end
    if (product_valid_q) begin
      cosine_q <= to_cosine(35'(rounded));
    end
  end

  assign valid_o  = cosine_valid_q;
  assign cosine_o = cosine_q;
endmodule
