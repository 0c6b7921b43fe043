// SPDX-License-Identifier: Apache-2.0
//
// Set-up of a span by the method of its triangle.
//
//   triangle, span -> span_setup   -> run, seed, split, point; curve and material       surfaces
//                  -> normal_seeds -> run, material, quantity ..; group of normals      normals
//                  -> both -> seed_queue -> in the order of the spans                   auto
//
// Timing    That of span_setup and normal_seeds; in auto frames a cycle more for surfaces, and a
//           triangle passes when the last span of the one before has been taken.
// Streams   ready/valid; a payload holds until taken. Method and light hold while busy_o is high;
//           the choice goes with its triangle.
// Formats   shading_pkg, normal_pkg.
// Error     That of the units.
// Model     model/shading_unit.cpp      Doc  docs/units/shading_unit.md
module span_seeds
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods,
  parameter int unsigned Lanes = 1
) (
  input  logic      clk_i,
  input  logic      rst_ni,
  input  method_e   method_i,        // of the frame; method and light are stable while busy_o
  input  light_t    light_i,

  input  logic      triangle_valid_i,
  output logic      triangle_ready_o,
  input  triangle_t triangle_i,
  input  choice_t   choice_i,        // of the triangle

  input  logic      span_valid_i,
  output logic      span_ready_o,
  input  span_t     span_i,

  output logic            seed_valid_o,
  input  logic            seed_ready_i,
  output run_t            run_o,
  output material_index_t material_o,
  output choice_t         choice_o,
  output seed_t                                      seed_o,     // of intensities
  output split_seed_t    [Channels-1:0]              split_o,    // quad-split
  output surface_point_t [Channels-1:0]              point_o,    // quad-polynomial, quad-horner
  output curve_seed_t    [Curves-1:0]                curve_o,    // quad-cosine, phong-surface
  output quantity_seed_t [Components-1:0][Lanes-1:0] quantity_o,
  output length_seed_t   [Lanes-1:0]                 length_o,
  output kappa_t                                     kappa_o,
  output kappa_t [1:0]                               step_kappa_o,
  output arc_t                                       arc_o,      // slerp-direct
  output span_footprint_t                            footprint_o,

  // Adaptive methods: the normals of the walker's pixels, group by group.
  output logic                                       group_valid_o,
  input  logic                                       group_ready_i,
  output pixel_normal_t [Lanes-1:0][Components-1:0]  group_o,
  output logic                                       count_valid_o,  // once a span
  output span_length_t                               normalised_o,
  output span_length_t                               skipped_o,

  output logic      span_inside_o,   // a span is being set up or waits as a seed
  output logic      busy_o           // a triangle or a span is inside
);
  localparam bit HasSurface = |(Methods & SurfaceMethods);
  localparam bit HasNormal = |(Methods & NormalMethods);
  localparam bit HasAuto = Methods[MethodAuto];

  // Triangles and spans go to one of the two set-ups. In auto frames that of the triangle whose
  // spans are being taken is remembered.
  logic is_auto, triangle_normal, span_normal, open_q, open_normal_q, pass;
  assign is_auto         = HasAuto && method_i == MethodAuto;
  assign triangle_normal = is_any_of(Methods, choice_i.method, NormalMethods);
  assign span_normal     = is_auto && open_q ? open_normal_q : triangle_normal;
  assign pass            = !(is_auto && open_q);

  typedef struct packed {
    seed_t                     seed;
    curve_seed_t [Curves-1:0]  curve;
    material_index_t           material;
    choice_t                   choice;
  } surface_seed_t;
  surface_seed_t surface_seed, queued_seed, shown_seed;

  logic surface_triangle_ready, surface_span_ready, surface_valid, surface_ready;
  logic surface_busy, surface_inside;
  logic normal_triangle_ready, normal_span_ready, normal_valid, normal_ready;
  logic normal_busy, normal_inside;
  logic queue_valid, queue_normal, queue_surface_ready, queue_normal_ready, queue_busy, is_normal;
  lit_run_t lit_run;
  assign triangle_ready_o = pass && (triangle_normal ? normal_triangle_ready
                                                     : surface_triangle_ready);
  assign span_ready_o     = span_normal ? normal_span_ready : surface_span_ready;
  assign is_normal        = is_auto ? queue_normal : triangle_normal;
  assign seed_valid_o     = is_auto ? queue_valid : is_normal ? normal_valid : surface_valid;
  assign surface_ready    = is_auto ? queue_surface_ready : seed_ready_i && !is_normal;
  assign normal_ready     = is_auto ? queue_normal_ready : seed_ready_i && is_normal;
  assign span_inside_o    = surface_inside || normal_inside || queue_busy;
  assign busy_o           = surface_busy || normal_busy || queue_busy;
  assign shown_seed       = is_auto ? queued_seed : surface_seed;
  assign seed_o           = shown_seed.seed;
  assign curve_o          = shown_seed.curve;
  assign run_o            = is_normal ? lit_run.run : seed_o.run;
  assign material_o       = is_normal ? lit_run.material : shown_seed.material;
  assign choice_o         = is_normal ? lit_run.choice : shown_seed.choice;

  if (HasAuto) begin : gen_queue
    logic take_triangle, take_span;
    assign take_triangle = triangle_valid_i && triangle_ready_o;
    assign take_span     = span_valid_i && span_ready_o;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) open_q <= 1'b0;
      else         open_q <= is_auto && (open_q || take_triangle) && !(take_span && span_i.last);
    end
    always_ff @(posedge clk_i) if (take_triangle) open_normal_q <= triangle_normal;

    seed_queue #(.Width($bits(surface_seed_t))) u_seed_queue (
      .clk_i, .rst_ni,
      .span_i         (is_auto && take_span),
      .span_normal_i  (span_normal),
      .surface_valid_i(is_auto && surface_valid),
      .surface_ready_o(queue_surface_ready),
      .surface_i      (surface_seed),
      .normal_valid_i (normal_valid),
      .normal_ready_o (queue_normal_ready),
      .seed_valid_o   (queue_valid),
      .seed_ready_i,
      .seed_normal_o  (queue_normal),
      .surface_o      (queued_seed),
      .busy_o         (queue_busy)
    );
  end else begin : gen_no_queue
    assign {open_q, open_normal_q, queue_valid, queue_normal, queue_busy} = '0;
    assign {queue_surface_ready, queue_normal_ready, queued_seed} = '0;
  end

  if (HasSurface) begin : gen_span_setup
    span_setup #(.Methods(Methods & SurfaceMethods)) u_span_setup (
      .clk_i, .rst_ni,
      .triangle_valid_i(triangle_valid_i && pass && !triangle_normal),
      .triangle_ready_o(surface_triangle_ready),
      .triangle_i, .choice_i,
      .span_valid_i    (span_valid_i && !span_normal),
      .span_ready_o    (surface_span_ready),
      .span_i,
      .seed_valid_o    (surface_valid),
      .seed_ready_i    (surface_ready),
      .seed_o          (surface_seed.seed),
      .split_o,
      .curve_o         (surface_seed.curve),
      .point_o,
      .material_o      (surface_seed.material),
      .choice_o        (surface_seed.choice),
      .span_inside_o   (surface_inside),
      .busy_o          (surface_busy)
    );
  end else begin : gen_no_span_setup
    assign {surface_triangle_ready, surface_span_ready, surface_valid} = '0;
    assign {surface_inside, surface_busy, surface_seed, split_o, point_o} = '0;
  end

  if (HasNormal) begin : gen_normal_seeds
    normal_seeds #(.Methods(Methods & NormalMethods), .Lanes(Lanes)) u_normal_seeds (
      .clk_i, .rst_ni, .method_i, .light_i,
      .triangle_valid_i(triangle_valid_i && pass && triangle_normal),
      .triangle_ready_o(normal_triangle_ready),
      .triangle_i, .choice_i,
      .span_valid_i    (span_valid_i && span_normal),
      .span_ready_o    (normal_span_ready),
      .span_i,
      .seed_valid_o    (normal_valid),
      .seed_ready_i    (normal_ready),
      .run_o           (lit_run),
      .quantity_o, .length_o, .kappa_o, .step_kappa_o, .arc_o, .footprint_o,
      .group_valid_o, .group_ready_i, .group_o, .count_valid_o, .normalised_o, .skipped_o,
      .span_inside_o   (normal_inside),
      .busy_o          (normal_busy)
    );
  end else begin : gen_no_normal_seeds
    assign {normal_triangle_ready, normal_span_ready, normal_valid} = '0;
    assign {normal_busy, normal_inside, lit_run} = '0;
    assign {quantity_o, length_o, kappa_o, step_kappa_o, arc_o, footprint_o} = '0;
    assign {group_valid_o, group_o, count_valid_o, normalised_o, skipped_o} = '0;
  end
endmodule
