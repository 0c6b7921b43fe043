// SPDX-License-Identifier: Apache-2.0
//
// Shading unit: triangles and their spans in, shaded pixels out, Lanes per cycle.
//
//   triangle, span -> span_seeds -> pixel_walker + surface_shader -> pixel     intensities
//                                -> pixel_walker + lit_pixels -> pixel         quad-cosine, normals
//
// Methods   A build holds only the hardware of the methods in Methods; a frame names one of them.
// Timing    Lanes pixels per cycle. Set-up overlaps the previous spans: no bubble between spans
//           of 2 cycles or more for surfaces, of 8 cycles or more for normals.
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
  localparam bit HasIntensity = |(Methods & ~LitMethods);
  localparam bit HasLit = |(Methods & LitMethods);

  logic   frame_valid_q, take_frame, triangle_gate;
  frame_t frame_q;
  logic   is_lit;                  // the frame lights every pixel
  logic   is_adaptive;
  logic   seeds_ready, span_inside;
  assign is_lit           = is_any_of(Methods, frame_q.method, LitMethods);
  assign is_adaptive      = is_any_of(Methods, frame_q.method, AdaptiveMethods);
  assign triangle_gate    = frame_valid_q && !frame_valid_i;
  assign triangle_ready_o = seeds_ready && triangle_gate;

  ////////////
  // Set-up //
  ////////////

  logic                          seeds_inside, seeds_busy, seed_valid, seed_ready;
  run_t                          run;
  seed_t                         seed;     // of intensities
  split_seed_t    [Channels-1:0] split;    // quad-split
  surface_point_t [Channels-1:0] point;    // quad-polynomial, quad-horner
  curve_seed_t    [Cosines-1:0]  cosine;   // quad-cosine
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
    .triangle_valid_i(triangle_valid_i && triangle_gate),
    .triangle_ready_o(seeds_ready),
    .triangle_i, .span_valid_i, .span_ready_o, .span_i,
    .seed_valid_o    (seed_valid),
    .seed_ready_i    (seed_ready),
    .run_o           (run),
    .material_o      (material),
    .seed_o          (seed),
    .split_o         (split),
    .point_o         (point),
    .cosine_o        (cosine),
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

  logic                         load, step, walker_valid, walker_ready, queue_ready, enter_valid;
  position_t [Lanes-1:0]        position;
  logic      [Lanes-1:0]        mask;
  // The pixels of an adaptive method leave the walker together with their normals.
  assign enter_valid  = walker_valid && is_lit && (!is_adaptive || group_valid);
  assign group_ready  = is_adaptive && queue_ready;
  assign walker_ready = is_lit ? queue_ready && (!is_adaptive || group_valid) : pixel_ready_i;

  pixel_walker #(.Lanes(Lanes)) u_pixel_walker (
    .clk_i, .rst_ni,
    .run_valid_i  (seed_valid),
    .run_ready_o  (seed_ready),
    .run_i        (run),
    .pixel_valid_o(walker_valid),
    .pixel_ready_i(walker_ready),
    .position_o   (position),
    .mask_o       (mask),
    .load_o       (load),
    .step_o       (step)
  );

  code_t [Lanes-1:0][Channels-1:0] surface_code;
  if (HasIntensity) begin : gen_surface_shader
    surface_shader #(.Methods(Methods & ~LitMethods), .Lanes(Lanes)) u_surface_shader (
      .clk_i,
      .method_i   (frame_q.method),
      .tolerance_i(frame_q.tolerance),
      .load_i     (load && !is_lit),
      .step_i     (step && !is_lit),
      .seed_i     (seed.channel),
      .split_i    (split),
      .point_i    (point),
      .code_o     (surface_code)
    );
  end else begin : gen_no_surface_shader
    assign surface_code = '0;
  end

  logic               lit_valid, queue_busy;
  pixel_t [Lanes-1:0] lit_pixel;
  logic   [Lanes-1:0] lit_mask, unlit, no_highlight;

  if (HasLit) begin : gen_lit_pixels
    lit_pixels #(.Methods(Methods & LitMethods), .Lanes(Lanes)) u_lit_pixels (
      .clk_i, .rst_ni,
      .method_i      (frame_q.method),
      .light_i       (frame_q.light),
      .material_valid_i, .material_index_i, .material_i,
      .load_i        (load && is_lit),
      .step_i        (step && is_lit),
      .index_i       (material),
      .quantity_i    (quantity),
      .length_i      (length),
      .kappa_i(kappa), .step_kappa_i(step_kappa),
      .arc_i(arc), .footprint_i(footprint),
      .cosine_i      (cosine),
      .group_i       (group),
      .enter_valid_i (enter_valid),
      .enter_ready_o (queue_ready),
      .position_i    (position),
      .mask_i        (mask),
      .pixel_valid_o (lit_valid),
      .pixel_ready_i,
      .pixel_o       (lit_pixel),
      .mask_o        (lit_mask),
      .unlit_o       (unlit),
      .no_highlight_o(no_highlight),
      .busy_o        (queue_busy),
      .clear_i(take_frame), .samples_o(samples)
    );
  end else begin : gen_no_lit_pixels
    assign {lit_valid, queue_busy, queue_ready, lit_pixel, lit_mask, unlit, no_highlight} = '0;
    assign samples = '0;
  end

  assign pixel_valid_o = is_lit ? lit_valid : walker_valid;
  assign pixel_mask_o  = is_lit ? lit_mask : mask;
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_pixel
    pixel_t surface_pixel;
    assign surface_pixel = '{
      x: position[lane].x, y: position[lane].y, z: position[lane].z, r: surface_code[lane][0],
      g: surface_code[lane][1], b: surface_code[lane][2], last: position[lane].last};
    assign pixel_o[lane] = is_lit ? lit_pixel[lane] : surface_pixel;
  end

  ////////////////////////
  // Frame and counters //
  ////////////////////////

  assign span_inside   = seeds_inside || (is_lit && (walker_valid || queue_busy));
  assign frame_ready_o = !seeds_busy && !walker_valid && !queue_busy;
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
    .unlit_i       (is_lit ? unlit : '0),
    .no_highlight_i(is_lit ? no_highlight : '0),
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
