// SPDX-License-Identifier: Apache-2.0
//
// Shading unit: triangles and their spans in, shaded pixels out, Lanes per cycle.
//
//   triangle, span -> span_seeds -> pixel_walker + surface_shader -> pixel     intensities
//                                -> pixel_walker + lit_pixels -> pixel         cosines, normals
//                                -> surface_shader -> lit_pixels -> pixel      auto: intensities
//
// Methods   A build holds only the hardware of the methods in Methods; a frame names one of them.
//           MethodAuto needs ChosenMethods: choice_stage names one for each triangle.
// Timing    Lanes pixels per cycle. Set-up overlaps the previous spans: no bubble between spans
//           for surfaces, of 8 cycles or more for normals.
// Error     That of the method's units: 0.42 codes for intensities; see the page.
// Streams   ready/valid; valid does not wait for ready, a payload holds until taken. A frame is
//           taken when the unit is empty; while one waits, no further triangle is taken. Materials
//           are written while the unit is empty.
// Formats   shading_pkg. Pixels leave in the order of the spans, left to right; a group of lanes
//           never spans two spans.
// Model     model/shading_unit.h      Doc  docs/units/shading_unit.md
module shading_unit
  import footprint_pkg::*;
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods,
  parameter int unsigned Lanes = 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  input  logic            material_valid_i,
  input  material_index_t material_index_i,
  input  material_t       material_i,
  input  choice_limit_t   limit_i,          // of the material; auto

  input  logic            frame_valid_i,
  output logic            frame_ready_o,
  input  frame_t          frame_i,

  input  logic            triangle_valid_i,
  output logic            triangle_ready_o,
  input  triangle_t       triangle_i,

  input  logic            span_valid_i,
  output logic            span_ready_o,
  input  span_t           span_i,

  output logic               pixel_valid_o,
  input  logic               pixel_ready_i,
  output pixel_t [Lanes-1:0] pixel_o,
  output logic   [Lanes-1:0] pixel_mask_o,

  output counters_t          counters_o    // of the current frame
);
  localparam bit HasAuto = Methods[MethodAuto];

  logic   frame_valid_q, take_frame, triangle_gate;
  frame_t frame_q;
  logic   is_auto;
  logic   stage_ready, span_inside;
  assign is_auto          = HasAuto && frame_q.method == MethodAuto;
  assign triangle_gate    = frame_valid_q && !frame_valid_i;
  assign triangle_ready_o = stage_ready && triangle_gate;

  ////////////
  // Set-up //
  ////////////

  logic      stage_valid, seeds_ready, stage_busy, ambient;
  triangle_t stage_triangle;
  choice_t   stage_choice;
  choice_stage #(.Methods(Methods)) u_choice_stage (
    .clk_i, .rst_ni,
    .method_i  (frame_q.method),
    .lighting_i(frame_q.light.lighting),
    .material_valid_i, .material_index_i, .limit_i,
    .triangle_valid_i(triangle_valid_i && triangle_gate),
    .triangle_ready_o(stage_ready),
    .triangle_i,
    .triangle_valid_o(stage_valid),
    .triangle_ready_i(seeds_ready),
    .triangle_o(stage_triangle),
    .choice_o  (stage_choice),
    .ambient_o (ambient),
    .busy_o    (stage_busy)
  );

  logic                          seeds_inside, seeds_busy, seed_valid, seed_ready;
  choice_t                       choice;   // of the span whose seed is on offer
  run_t                          run;
  seed_t                         seed;     // of intensities
  split_seed_t    [Channels-1:0] split;    // quad-split
  surface_point_t [Channels-1:0] point;    // quad-polynomial, quad-horner
  curve_seed_t    [Curves-1:0]   curve;    // quad-cosine, phong-surface
  material_index_t               material;

  quantity_seed_t [Components-1:0][Lanes-1:0] quantity;
  length_seed_t   [Lanes-1:0]                 length;
  kappa_t                                     kappa;
  kappa_t [1:0]                               step_kappa;
  arc_t                                       arc;      // slerp-direct
  span_footprint_t                            footprint;
  sample_counters_t                           samples;
  pixel_normal_t [Lanes-1:0][Components-1:0]  group;    // adaptive methods
  logic                                       group_valid, group_ready, count_valid;
  span_length_t                               normalised, skipped;

  span_seeds #(.Methods(Methods), .Lanes(Lanes)) u_span_seeds (
    .clk_i, .rst_ni,
    .method_i        (frame_q.method),
    .light_i         (frame_q.light),
    .triangle_valid_i(stage_valid),
    .triangle_ready_o(seeds_ready),
    .triangle_i      (stage_triangle),
    .choice_i        (stage_choice),
    .span_valid_i, .span_ready_o, .span_i,
    .seed_valid_o    (seed_valid),
    .seed_ready_i    (seed_ready),
    .run_o           (run),
    .material_o      (material),
    .choice_o        (choice),
    .seed_o          (seed),
    .split_o         (split),
    .point_o         (point),
    .curve_o         (curve),
    .quantity_o      (quantity),
    .length_o        (length),
    .kappa_o(kappa), .step_kappa_o(step_kappa),
    .arc_o           (arc),
    .footprint_o     (footprint),
    .group_valid_o   (group_valid),
    .group_ready_i   (group_ready),
    .group_o         (group),
    .count_valid_o   (count_valid),
    .normalised_o    (normalised),
    .skipped_o       (skipped),
    .span_inside_o   (seeds_inside),
    .busy_o          (seeds_busy)
  );

  ////////////
  // Pixels //
  ////////////

  logic             load, load_lit, walker_valid, queue_busy;
  logic [Lanes-1:0] unlit, no_highlight;
  span_pixels #(.Methods(Methods), .Lanes(Lanes)) u_span_pixels (
    .clk_i, .rst_ni,
    .method_i    (frame_q.method),
    .tolerance_i (frame_q.tolerance),
    .light_i     (frame_q.light),
    .material_valid_i, .material_index_i, .material_i,
    .seed_valid_i(seed_valid),
    .seed_ready_o(seed_ready),
    .run_i       (run),
    .material_of_i(material),
    .choice_i    (choice),
    .channel_i   (seed.channel),
    .split_i     (split),
    .point_i     (point),
    .curve_i     (curve),
    .quantity_i  (quantity),
    .length_i    (length),
    .kappa_i(kappa), .step_kappa_i(step_kappa), .arc_i(arc), .footprint_i(footprint),
    .group_valid_i(group_valid),
    .group_ready_o(group_ready),
    .group_i     (group),
    .pixel_valid_o, .pixel_ready_i, .pixel_o, .pixel_mask_o,
    .unlit_o     (unlit),
    .no_highlight_o(no_highlight),
    .load_o      (load),
    .load_lit_o  (load_lit),
    .clear_i     (take_frame),
    .samples_o   (samples),
    .walker_valid_o(walker_valid),
    .queue_busy_o(queue_busy)
  );

  ////////////////////////
  // Frame and counters //
  ////////////////////////

  assign span_inside   = seeds_inside || walker_valid || queue_busy;
  assign frame_ready_o = !stage_busy && !seeds_busy && !walker_valid && !queue_busy;
  assign take_frame    = frame_valid_i && frame_ready_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)         frame_valid_q <= 1'b0;
    else if (take_frame) frame_valid_q <= 1'b1;
  end

  frame_counters #(.Lanes(Lanes)) u_frame_counters (
    .clk_i,
    .clear_i       (take_frame),
    .offer_i       (pixel_valid_o),
    .take_i        (pixel_valid_o && pixel_ready_i),
    .inside_i      (span_inside),
    .mask_i        (pixel_mask_o),
    .unlit_i       (unlit),
    .no_highlight_i(no_highlight),
    .ambient_i     (ambient),
    .load_i        (load && is_auto),
    .constant_i    (choice.method == MethodFlat),
    .dark_i        (load_lit && choice.dark),
    .unnormalised_i(load_lit && choice.method != MethodPhongDuff &&
                     choice.method != MethodPhongSurface),
    .channels_i    (choice.channels),
    .count_i       (count_valid),
    .normalised_i  (normalised),
    .skipped_i     (skipped),
    .samples_i     (samples),
    .counters_o
  );

  always_ff @(posedge clk_i) if (take_frame) frame_q <= frame_i;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (take_frame) begin
      assert (Methods[frame_i.method]) else $error("shading_unit: method is not in this build");
    end
    assert (!group_valid || walker_valid) else $error("shading_unit: normals without a pixel");
    if (material_valid_i) begin
      assert (frame_ready_o) else $error("shading_unit: a material changes while spans are inside");
    end
  end
`endif
endmodule
