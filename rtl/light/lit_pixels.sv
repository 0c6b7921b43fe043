// SPDX-License-Identifier: Apache-2.0
//
// Pixels of the methods that light every pixel, from the walker's positions on.
//
//   load, step -> normal_shader -> cosines -> pixel_light -> code -> pixel_queue -> pixel
//   walker     -> normal_shader, which holds a group until its last sample -> pixel_queue
//
// Timing    From a group that enters to its offer: normal_shader + pixel_light + 1 cycles. The
//           light never stops; pixel_queue admits what it can hold.
// Streams   ready/valid at the walker's and at the pixels' side.
// Formats   normal_pkg, light_pkg.
// Error     That of the units on the way.
// Model     LightSpan in model/shading_unit.cpp      Doc  docs/units/shading_unit.md
module lit_pixels
  import footprint_pkg::*;
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = LitMethods,
  parameter bit HasAuto = 1'b0,
  parameter int unsigned Lanes = 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  method_e         method_i,        // method and light are stable while busy_o
  input  light_t          light_i,

  input  logic            material_valid_i,
  input  material_index_t material_index_i,
  input  material_t       material_i,

  // A span starts or goes on.
  input  logic            load_i,
  input  logic            step_i,
  input  material_index_t index_i,         // of its material, at load_i
  input  choice_t         choice_i,        // likewise
  input  quantity_seed_t [Components-1:0][Lanes-1:0] quantity_i,
  input  length_seed_t   [Lanes-1:0]                 length_i,
  input  kappa_t                                     kappa_i,
  input  kappa_t [1:0]                               step_kappa_i,
  input  arc_t                                       arc_i,
  input  span_footprint_t                            footprint_i,
  input  curve_seed_t [Curves-1:0]                   curve_i,
  input  pixel_normal_t [Lanes-1:0][Components-1:0]  group_i,   // adaptive methods, from the walker

  // From the walker.
  input  logic                  enter_valid_i,
  output logic                  enter_ready_o,
  input  position_t [Lanes-1:0] position_i,
  input  logic      [Lanes-1:0] mask_i,
  input  logic                  shaded_i,  // auto: the pixels have their codes
  input  code_t [Lanes-1:0][Channels-1:0] shaded_code_i,

  output logic               pixel_valid_o,
  input  logic               pixel_ready_i,
  output pixel_t [Lanes-1:0] pixel_o,
  output logic   [Lanes-1:0] mask_o,
  output logic   [Lanes-1:0] unlit_o,
  output logic   [Lanes-1:0] no_highlight_o,
  input  logic               clear_i,     // the samples
  output sample_counters_t   samples_o,
  output logic               busy_o
);
  logic                            cosines_valid, code_valid, queue_valid, queue_ready;
  logic                            is_footprint;
  sample_place_t                   place;      // of the cosines
  logic  [Lanes-1:0]               live;
  cosines_t [Lanes-1:0]            cosines;
  code_t [Lanes-1:0][Channels-1:0] code;
  logic  [Lanes-1:0]               unlit, no_highlight;
  material_index_t                 index_q, cosines_index;  // of the span; of the cosines
  logic                            dark_q, cosines_dark;    // likewise

  always_ff @(posedge clk_i) if (load_i) {dark_q, index_q} <= {choice_i.dark, index_i};

  normal_shader #(.Methods(Methods), .HasAuto(HasAuto), .Lanes(Lanes)) u_normal_shader (
    .clk_i, .rst_ni, .method_i, .light_i, .choice_i,
    .load_i, .step_i, .quantity_i, .length_i, .kappa_i, .step_kappa_i, .arc_i, .curve_i, .group_i,
    .footprint_i,
    .pixel_valid_i(enter_valid_i),
    .pixel_ready_o(enter_ready_o),
    .mask_i, .shaded_i,
    .enter_valid_o(queue_valid),
    .enter_ready_i(queue_ready),
    .valid_o      (cosines_valid),
    .cosines_o    (cosines),
    .place_o      (place),
    .live_o       (live),
    .clear_i, .samples_o
  );

  assign is_footprint = is_any_of(Methods, method_i, FootprintMethods);
  pixel_light #(.HasMean(|(Methods & FootprintMethods)), .Lanes(Lanes)) u_pixel_light (
    .clk_i, .rst_ni, .light_i,
    .material_valid_i, .material_index_i, .material_i,
    .valid_i       (cosines_valid),
    .index_i       (cosines_index),
    .dark_i        (cosines_dark),
    .cosines_i     (cosines),
    .is_mean_i     (is_footprint),
    .place_i       (place),
    .live_i        (live),
    .valid_o       (code_valid),
    .code_o        (code),
    .unlit_o       (unlit),
    .no_highlight_o(no_highlight)
  );

  pixel_queue #(.Lanes(Lanes), .HasShaded(HasAuto)) u_pixel_queue (
    .clk_i, .rst_ni,
    .enter_valid_i  (queue_valid),
    .enter_ready_o  (queue_ready),
    .position_i, .mask_i,
    .material_i     (index_q),
    .dark_i         (dark_q),
    .shaded_i, .shaded_code_i,
    .cosines_valid_i(cosines_valid && place.last),
    .material_o     (cosines_index),
    .dark_o         (cosines_dark),
    .code_valid_i   (code_valid),
    .code_i         (code),
    .unlit_i        (unlit),
    .no_highlight_i (no_highlight),
    .pixel_valid_o, .pixel_ready_i, .pixel_o, .mask_o, .unlit_o, .no_highlight_o, .busy_o
  );
endmodule
