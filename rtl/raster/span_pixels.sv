// SPDX-License-Identifier: Apache-2.0
//
// Pixels of the spans: the walker and the shaders that march with it.
//
//   seed -> pixel_walker + surface_shader -> pixel                       intensities
//        -> pixel_walker + lit_pixels     -> pixel                       cosines, normals
//        -> pixel_walker + surface_shader -> queue of lit_pixels -> pixel   auto: intensities
//
// A part of shading_unit and its page; it has no page of its own.
//
// Timing    Lanes pixels a cycle; intensities 1 cycle after the seed, one more in auto frames, lit
//           pixels as late as lit_pixels says.
// Streams   ready/valid; a payload holds until taken.
// Formats   shading_pkg.
// Error     That of the method's units.
// Model     model/shading_unit.h      Doc  docs/units/shading_unit.md
module span_pixels
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
  input  method_e         method_i,          // of the frame; stable while pixels are inside
  input  tolerance_t      tolerance_i,
  input  light_t          light_i,

  input  logic            material_valid_i,
  input  material_index_t material_index_i,
  input  material_t       material_i,

  input  logic            seed_valid_i,
  output logic            seed_ready_o,
  input  run_t            run_i,
  input  material_index_t material_of_i,     // of the span
  input  choice_t         choice_i,
  input  channel_seed_t  [Channels-1:0] channel_i,
  input  split_seed_t    [Channels-1:0] split_i,
  input  surface_point_t [Channels-1:0] point_i,
  input  curve_seed_t    [Curves-1:0]   curve_i,
  input  quantity_seed_t [Components-1:0][Lanes-1:0] quantity_i,
  input  length_seed_t   [Lanes-1:0]                 length_i,
  input  kappa_t                                     kappa_i,
  input  kappa_t [1:0]                               step_kappa_i,
  input  arc_t                                       arc_i,
  input  span_footprint_t                            footprint_i,
  input  logic                                       group_valid_i,  // adaptive methods
  output logic                                       group_ready_o,
  input  pixel_normal_t [Lanes-1:0][Components-1:0]  group_i,

  output logic               pixel_valid_o,
  input  logic               pixel_ready_i,
  output pixel_t [Lanes-1:0] pixel_o,
  output logic   [Lanes-1:0] pixel_mask_o,
  output logic   [Lanes-1:0] unlit_o,
  output logic   [Lanes-1:0] no_highlight_o,

  output logic               load_o,         // a span starts
  output logic               load_lit_o,     // and lights its pixels
  input  logic               clear_i,        // the samples
  output sample_counters_t   samples_o,
  output logic               walker_valid_o, // pixels are in the walker
  output logic               queue_busy_o    // or in the queue
);
  localparam bit HasAuto = Methods[MethodAuto];
  localparam methods_t Built = Methods & ~method_bit(MethodAuto);

  logic is_queued;                           // the frame's pixels go through lit_pixels
  logic is_adaptive;
  assign is_queued   = (HasAuto && method_i == MethodAuto) ||
                       is_any_of(Built, method_i, LitMethods);
  assign is_adaptive = is_any_of(Methods, method_i, AdaptiveMethods);

  logic                      step, walker_ready, queue_ready, enter_valid;
  logic                      lit_q;          // the span inside lights its pixels
  position_t [Lanes-1:0]     position;
  logic      [Lanes-1:0]     mask;
  assign load_lit_o = is_any_of(Built, choice_i.method, LitMethods);
  always_ff @(posedge clk_i) if (load_o) lit_q <= load_lit_o;
  // The pixels of an adaptive method leave the walker together with their normals.
  assign enter_valid   = walker_valid_o && is_queued && (!is_adaptive || group_valid_i);
  assign group_ready_o = is_adaptive && queue_ready;
  assign walker_ready  = is_queued ? queue_ready && (!is_adaptive || group_valid_i)
                                   : pixel_ready_i;

  pixel_walker #(.Lanes(Lanes)) u_pixel_walker (
    .clk_i, .rst_ni,
    .run_valid_i  (seed_valid_i),
    .run_ready_o  (seed_ready_o),
    .run_i,
    .pixel_valid_o(walker_valid_o),
    .pixel_ready_i(walker_ready),
    .position_o   (position),
    .mask_o       (mask),
    .load_o,
    .step_o       (step)
  );

  code_t [Lanes-1:0][Channels-1:0] surface_code;
  if (|(Methods & IntensityMethods)) begin : gen_surface_shader
    surface_shader #(.Methods(Methods & IntensityMethods), .Lanes(Lanes)) u_surface_shader (
      .clk_i, .tolerance_i, .choice_i,
      .load_i (load_o && !load_lit_o),
      .step_i (step && !lit_q),
      .seed_i (channel_i),
      .split_i, .point_i,
      .code_o (surface_code)
    );
  end else begin : gen_no_surface_shader
    assign surface_code = '0;
  end

  logic               lit_valid;
  pixel_t [Lanes-1:0] lit_pixel;
  logic   [Lanes-1:0] lit_mask, unlit, no_highlight;

  if (|(Methods & LitMethods)) begin : gen_lit_pixels
    lit_pixels #(.Methods(Methods & LitMethods), .HasAuto(HasAuto), .Lanes(Lanes)) u_lit_pixels (
      .clk_i, .rst_ni, .method_i, .light_i,
      .material_valid_i, .material_index_i, .material_i,
      .load_i        (load_o && load_lit_o),
      .step_i        (step && lit_q),
      .index_i       (material_of_i),
      .choice_i, .quantity_i, .length_i, .kappa_i, .step_kappa_i, .arc_i, .footprint_i, .curve_i,
      .group_i,
      .enter_valid_i (enter_valid),
      .enter_ready_o (queue_ready),
      .position_i    (position),
      .mask_i        (mask),
      .shaded_i      (!lit_q),
      .shaded_code_i (surface_code),
      .pixel_valid_o (lit_valid),
      .pixel_ready_i,
      .pixel_o       (lit_pixel),
      .mask_o        (lit_mask),
      .unlit_o       (unlit),
      .no_highlight_o(no_highlight),
      .busy_o        (queue_busy_o),
      .clear_i, .samples_o
    );
  end else begin : gen_no_lit_pixels
    assign {lit_valid, queue_busy_o, queue_ready, lit_pixel, lit_mask, unlit, no_highlight} = '0;
    assign samples_o = '0;
  end

  assign pixel_valid_o  = is_queued ? lit_valid : walker_valid_o;
  assign pixel_mask_o   = is_queued ? lit_mask : mask;
  assign unlit_o        = is_queued ? unlit : '0;
  assign no_highlight_o = is_queued ? no_highlight : '0;
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_pixel
    pixel_t surface_pixel;
    assign surface_pixel = '{
      x: position[lane].x, y: position[lane].y, z: position[lane].z, r: surface_code[lane][0],
      g: surface_code[lane][1], b: surface_code[lane][2], last: position[lane].last};
    assign pixel_o[lane] = is_queued ? lit_pixel[lane] : surface_pixel;
  end
endmodule
