// SPDX-License-Identifier: Apache-2.0
//
// Light of pixels from their cosines, paper 000 (1), (12), Lanes pixels of one material a cycle.
//
//   I = ka + kd (N.L) + ks (N.H)^n                     LightingBlinn
//   I = ka + kd (N.L) + ks (R.V)^n                     LightingPhong
//
// With is_mean_i the pixels are samples, and diffuse factor and highlight are the mean of a pixel's
// samples, paper 001. A group with dark_i has no highlight: its power is not computed.
//
// Timing    Latency 13 cycles, a group of Lanes pixels a cycle, never stalls; 16 from a pixel's
//           last sample. A material is written at any time when no pixel is inside; the next
//           cycle may bring its first pixel.
// Formats   cosines S1.30, material U1.16 and U9.7, code U8.0.
// Error     0.504 codes against real cosines of unit vectors and the same material: half a
//           code is the rounding to a code.
// Model     model/light/pixel_light.h      Doc  docs/units/light/pixel_light.md
module pixel_light
  import footprint_pkg::*;
  import light_pkg::*;
#(
  parameter bit HasMean = 1'b1,
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
  input  logic                              dark_i,            // no highlight is wanted
  input  cosines_t [Lanes-1:0]              cosines_i,
  input  logic                              is_mean_i,         // stable while pixels are inside
  input  sample_place_t                     place_i,           // samples: all lanes alike
  input  logic [Lanes-1:0]                  live_i,            // samples: not excluded

  output logic                              valid_o,
  output code_t [Lanes-1:0][Channels-1:0]   code_o,
  output logic  [Lanes-1:0]                 unlit_o,           // N.L <= 0
  output logic  [Lanes-1:0]                 no_highlight_o     // the power was not computed
);
  localparam int unsigned CosineLatency = 2;
  localparam int unsigned PowerLatency = 8;
  localparam int unsigned MeanLatency = 3;
  localparam int unsigned CombineLatency = 3;
  localparam int unsigned LightLatency = CosineLatency + PowerLatency;
  localparam int unsigned Latency = CosineLatency + PowerLatency + CombineLatency;

  // What the power needs of a material.
  typedef struct packed {
    logic       has_specular;
    shininess_t shininess;
  } specular_t;

  specular_t specular_table [NumMaterials];
  material_t color_table [NumMaterials];   // shininess is not read

  // Stage k holds what came k + 1 cycles ago. The index is needed until the colour is read, one
  // cycle before it is combined: of a pixel, or of its last sample.
  localparam int unsigned IndexStages = LightLatency - 1 + (HasMean ? MeanLatency : 0);
  logic [Latency-2:0]                valid_q;
  material_index_t [IndexStages-1:0] index_q;
  logic                              is_mean, read_color;
  material_index_t                   color_index;
  assign is_mean     = HasMean && is_mean_i;
  assign read_color  = valid_q[is_mean ? IndexStages - 1 : LightLatency - 2];
  assign color_index = index_q[is_mean ? IndexStages - 1 : LightLatency - 2];
  specular_t specular_q;
  logic [CosineLatency-1:0] dark_q;
  material_t color_q;

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
    for (int unsigned k = 1; k < IndexStages; k++) begin
      if (valid_q[k-1]) index_q[k] <= index_q[k-1];
    end
    if (valid_q[CosineLatency-2]) specular_q <= specular_table[index_q[CosineLatency-2]];
    dark_q <= {dark_q[0], dark_i};
    if (read_color) color_q <= color_table[color_index];
  end

  // Of the sample whose light comes now.
  sample_place_t    place;
  logic [Lanes-1:0] live;
  if (HasMean) begin : g_place
    sample_place_t [LightLatency-1:0]            place_q;
    logic          [LightLatency-1:0][Lanes-1:0] live_q;
    always_ff @(posedge clk_i) begin
      place_q <= {place_q[LightLatency-2:0], place_i};
      live_q  <= {live_q[LightLatency-2:0], live_i};
    end
    assign place = place_q[LightLatency-1];
    assign live  = live_q[LightLatency-1];
  end else begin : g_no_place
    assign {place, live} = '0;
  end

  logic [Lanes-1:0] lane_valid;            // all alike

  for (genvar lane = 0; lane < Lanes; lane++) begin : g_lane
    logic       cosine_valid, power_valid, unlit, skipped;
    diffuse_t   diffuse;
    cosine_t    specular;
    highlight_t highlight;

    diffuse_t [PowerLatency-1:0]   diffuse_q;
    logic     [PowerLatency-1:0]   unlit_q;
    logic     [CombineLatency-1:0] combine_unlit_q, combine_skipped_q;

    // What is combined: of the pixel, or the mean of its samples.
    logic       mean_valid, mean_unlit, mean_skipped;
    diffuse_t   mean_diffuse;
    highlight_t mean_highlight;

    specular_cosine u_specular_cosine (
      .clk_i, .rst_ni, .light_i, .valid_i, .cosines_i(cosines_i[lane]),
      .valid_o(cosine_valid), .diffuse_o(diffuse), .unlit_o(unlit), .specular_o(specular)
    );

    blinn_specular u_blinn_specular (
      .clk_i, .rst_ni, .valid_i(cosine_valid),
      .skip_i(!specular_q.has_specular || dark_q[CosineLatency-1]),
      .cosine_i(specular), .shininess_i(specular_q.shininess),
      .valid_o(power_valid), .highlight_o(highlight), .skipped_o(skipped)
    );

    // The diffuse factor waits for the highlight.
    always_ff @(posedge clk_i) begin
      if (cosine_valid) diffuse_q[0] <= diffuse;
      for (int unsigned k = 1; k < PowerLatency; k++) begin
        if (valid_q[CosineLatency+k-1]) diffuse_q[k] <= diffuse_q[k-1];
      end
      unlit_q           <= {unlit_q[PowerLatency-2:0], unlit};
      combine_unlit_q   <= {combine_unlit_q[CombineLatency-2:0],
                            is_mean ? mean_unlit : unlit_q[PowerLatency-1]};
      combine_skipped_q <= {combine_skipped_q[CombineLatency-2:0],
                            is_mean ? mean_skipped : skipped};
    end

    if (HasMean) begin : g_mean
      footprint_mean u_footprint_mean (
        .clk_i, .rst_ni, .valid_i(power_valid && is_mean_i), .place_i(place), .live_i(live[lane]),
        .diffuse_i(diffuse_q[PowerLatency-1]), .highlight_i(highlight),
        .unlit_i(unlit_q[PowerLatency-1]), .skipped_i(skipped),
        .valid_o(mean_valid), .diffuse_o(mean_diffuse), .highlight_o(mean_highlight),
        .unlit_o(mean_unlit), .skipped_o(mean_skipped)
      );
    end else begin : g_no_mean
      assign {mean_valid, mean_unlit, mean_skipped, mean_diffuse, mean_highlight} = '0;
    end

    rgb_combine u_rgb_combine (
      .clk_i, .rst_ni, .valid_i(is_mean ? mean_valid : power_valid),
      .diffuse_i(is_mean ? mean_diffuse : diffuse_q[PowerLatency-1]),
      .highlight_i(is_mean ? mean_highlight : highlight), .material_i(color_q),
      .valid_o(lane_valid[lane]), .code_o(code_o[lane])
    );

    assign unlit_o[lane]        = combine_unlit_q[CombineLatency-1];
    assign no_highlight_o[lane] = combine_skipped_q[CombineLatency-1];
  end

  assign valid_o = lane_valid[0];
endmodule
