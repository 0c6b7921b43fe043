// SPDX-License-Identifier: Apache-2.0
//
// Colour of a pixel from its diffuse factor and highlight, paper 000 (1), (12).
//
//   I = ka + kd (N.L) + ks (N.H)^n,  code = round(255 I)
//
// Timing    Latency 3 cycles, a pixel a cycle, never stalls.
// Formats   diffuse U1.17, highlight and reflectances U1.16; I exact (U4.33), clamped to 1; code
//           U8.0, halves up.
// Error     0.5 codes: the rounding to a code. Reflectances over 1 are accepted; I is clamped.
// Model     model/light/rgb_combine.h      Doc  docs/units/light/rgb_combine.md
module rgb_combine
  import light_pkg::*;
(
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 valid_i,
  input  diffuse_t             diffuse_i,
  input  highlight_t           highlight_i,
  input  material_t            material_i,
  output logic                 valid_o,
  output code_t [Channels-1:0] code_o
);
  localparam int unsigned Latency = 3;

  typedef struct packed {
    reflectance_t [Channels-1:0]       ambient;    // U1.16
    logic         [Channels-1:0][34:0] diffuse;    // U2.33
    logic         [Channels-1:0][33:0] specular;   // U2.32
  } product_t;

  logic [Latency-1:0]          valid_q;
  product_t                    product_q;
  logic [Channels-1:0][33:0]   light_q, light_d;   // U1.33, 0..1
  code_t [Channels-1:0]        code_q, code_d;

  function automatic logic [33:0] clamp_to_one(logic [36:0] light);
    clamp_to_one = light[36:33] == '0 ? light[33:0] : 34'd1 << 33;
  endfunction

  // Rounds 255 I, 0..255.
  function automatic code_t to_rounded_code(logic [33:0] light);
    logic [42:0] codes;                            // U9.33, with the half code
    codes = {1'b0, light, 8'b0} - 43'(light) + (43'd1 << 32);
    to_rounded_code = codes[40:33];
  endfunction

  always_comb begin
    for (int unsigned c = 0; c < Channels; c++) begin
      light_d[c] = clamp_to_one(37'({product_q.ambient[c], 17'b0}) + 37'(product_q.diffuse[c])
                                + 37'({product_q.specular[c], 1'b0}));
      code_d[c]  = to_rounded_code(light_q[c]);
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      product_q.ambient <= material_i.ambient;
      for (int unsigned c = 0; c < Channels; c++) begin
        product_q.diffuse[c]  <= 35'(material_i.diffuse[c]) * 35'(diffuse_i);
        product_q.specular[c] <= 34'(material_i.specular[c]) * 34'(highlight_i);
      end
    end
    if (valid_q[0]) light_q <= light_d;
    if (valid_q[1]) code_q  <= code_d;
  end

  assign valid_o = valid_q[Latency-1];
  assign code_o  = code_q;
endmodule
