// SPDX-License-Identifier: Apache-2.0
//
// Light of pixels from their cosines, paper 000 (1), (12), Lanes pixels of one material a cycle.
//
//   I = ka + kd (N.L) + ks (N.H)^n                     LightingBlinn
//   I = ka + kd (N.L) + ks (R.V)^n                     LightingPhong
//
// Timing    Latency 13 cycles, a group of Lanes pixels a cycle, never stalls. A material is written
//           at any time when no pixel is inside; the next cycle may bring its first pixel.
// Formats   cosines S1.30, material U1.16 and U9.7, code U8.0.
// Error     0.504 codes against real cosines of unit vectors and the same material: half a
//           code is the rounding to a code.
// Model     model/light/pixel_light.h      Doc  docs/units/light/pixel_light.md
module pixel_light
  import light_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,
  input  light_t                            light_i,           // stable while pixels are inside

  input  logic                              material_valid_i,  // writes one material
  input  material_index_t                   material_index_i,
  input  material_t                         material_i,

  input  logic                              valid_i,
  input  material_index_t                   index_i,
  input  cosines_t [Lanes-1:0]              cosines_i,

  output logic                              valid_o,
  output code_t [Lanes-1:0][Channels-1:0]   code_o,
  output logic  [Lanes-1:0]                 unlit_o,           // N.L <= 0
  output logic  [Lanes-1:0]                 no_highlight_o     // the power was not computed
);
  localparam int unsigned CosineLatency = 2;
  localparam int unsigned PowerLatency = 8;
  localparam int unsigned CombineLatency = 3;
  localparam int unsigned Latency = CosineLatency + PowerLatency + CombineLatency;

  // What the power needs of a material.
  typedef struct packed {
    logic       has_specular;
    shininess_t shininess;
  } specular_t;

  specular_t specular_table [NumMaterials];
  material_t color_table [NumMaterials];   // shininess is not read

  // Stage k holds what came k + 1 cycles ago. The index is needed until the colour is read, one
  // cycle before it is combined.
  logic [Latency-2:0]                                valid_q;
  material_index_t [CosineLatency+PowerLatency-2:0]  index_q;
  specular_t                                         specular_q;
  material_t                                         color_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-3:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (material_valid_i) begin
      specular_table[material_index_i] <= '{material_i.specular != '0, material_i.shininess};
      color_table[material_index_i] <= material_i;
    end
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) index_q[0] <= index_i;
    for (int unsigned k = 1; k < CosineLatency + PowerLatency - 1; k++) begin
      if (valid_q[k-1]) index_q[k] <= index_q[k-1];
    end
    if (valid_q[CosineLatency-2]) specular_q <= specular_table[index_q[CosineLatency-2]];
    if (valid_q[CosineLatency+PowerLatency-2]) begin
      color_q <= color_table[index_q[CosineLatency+PowerLatency-2]];
    end
  end

  logic [Lanes-1:0] lane_valid;            // all alike

  for (genvar lane = 0; lane < Lanes; lane++) begin : g_lane
    logic       cosine_valid, power_valid, unlit, skipped;
    diffuse_t   diffuse;
    cosine_t    specular;
    highlight_t highlight;

    diffuse_t [PowerLatency-1:0]                diffuse_q;
    logic     [PowerLatency+CombineLatency-1:0] unlit_q;
    logic     [CombineLatency-1:0]              skipped_q;

    specular_cosine u_specular_cosine (
      .clk_i, .rst_ni, .light_i, .valid_i, .cosines_i(cosines_i[lane]),
      .valid_o(cosine_valid), .diffuse_o(diffuse), .unlit_o(unlit), .specular_o(specular)
    );

    blinn_specular u_blinn_specular (
      .clk_i, .rst_ni, .valid_i(cosine_valid), .skip_i(!specular_q.has_specular),
      .cosine_i(specular), .shininess_i(specular_q.shininess),
      .valid_o(power_valid), .highlight_o(highlight), .skipped_o(skipped)
    );

    // The diffuse factor waits for the highlight.
    always_ff @(posedge clk_i) begin
      if (cosine_valid) diffuse_q[0] <= diffuse;
      for (int unsigned k = 1; k < PowerLatency; k++) begin
        if (valid_q[CosineLatency+k-1]) diffuse_q[k] <= diffuse_q[k-1];
      end
      unlit_q   <= {unlit_q[PowerLatency+CombineLatency-2:0], unlit};
      skipped_q <= {skipped_q[CombineLatency-2:0], skipped};
    end

    rgb_combine u_rgb_combine (
      .clk_i, .rst_ni, .valid_i(power_valid), .diffuse_i(diffuse_q[PowerLatency-1]),
      .highlight_i(highlight), .material_i(color_q),
      .valid_o(lane_valid[lane]), .code_o(code_o[lane])
    );

    assign unlit_o[lane]        = unlit_q[PowerLatency+CombineLatency-1];
    assign no_highlight_o[lane] = skipped_q[CombineLatency-1];
  end

  assign valid_o = lane_valid[0];
endmodule
