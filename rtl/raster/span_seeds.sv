// SPDX-License-Identifier: Apache-2.0
//
// Set-up of a span by the method of the frame.
//
//   triangle, span -> span_setup   -> run, seed, split, point; cosine and material      surfaces
//                  -> normal_seeds -> run, material, quantity ..; group of normals      normals
//
// Timing    That of span_setup and normal_seeds.
// Streams   ready/valid; a payload holds until taken. Both take turns by frame: a method changes
//           only while busy_o is low.
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
  input  method_e   method_i,        // method and light are stable while busy_o
  input  light_t    light_i,

  input  logic      triangle_valid_i,
  output logic      triangle_ready_o,
  input  triangle_t triangle_i,

  input  logic      span_valid_i,
  output logic      span_ready_o,
  input  span_t     span_i,

  output logic            seed_valid_o,
  input  logic            seed_ready_i,
  output run_t            run_o,
  output material_index_t material_o,
  output seed_t                                      seed_o,     // of intensities
  output split_seed_t    [Channels-1:0]              split_o,    // quad-split
  output surface_point_t [Channels-1:0]              point_o,    // quad-polynomial, quad-horner
  output curve_seed_t    [Cosines-1:0]               cosine_o,   // quad-cosine
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
  localparam bit HasNormal = |(Methods & ~SurfaceMethods);
  logic is_normal;                   // the frame interpolates normals
  assign is_normal = is_any_of(Methods, method_i, ~SurfaceMethods);

  logic surface_triangle_ready, surface_span_ready, surface_valid, surface_busy, surface_inside;
  logic normal_triangle_ready, normal_span_ready, normal_valid, normal_busy, normal_inside;
  material_index_t surface_material;
  lit_run_t        lit_run;
  assign triangle_ready_o = is_normal ? normal_triangle_ready : surface_triangle_ready;
  assign span_ready_o     = is_normal ? normal_span_ready : surface_span_ready;
  assign seed_valid_o     = is_normal ? normal_valid : surface_valid;
  assign span_inside_o    = is_normal ? normal_inside : surface_inside;
  assign busy_o           = surface_busy || normal_busy;
  assign run_o            = is_normal ? lit_run.run : seed_o.run;
  assign material_o       = is_normal ? lit_run.material : surface_material;

  if (HasSurface) begin : gen_span_setup
    span_setup #(.Methods(Methods & SurfaceMethods)) u_span_setup (
      .clk_i, .rst_ni, .method_i,
      .triangle_valid_i(triangle_valid_i && !is_normal),
      .triangle_ready_o(surface_triangle_ready),
      .triangle_i,
      .span_valid_i    (span_valid_i && !is_normal),
      .span_ready_o    (surface_span_ready),
      .span_i,
      .seed_valid_o    (surface_valid),
      .seed_ready_i    (seed_ready_i && !is_normal),
      .seed_o, .split_o, .cosine_o, .point_o,
      .material_o      (surface_material),
      .span_inside_o   (surface_inside),
      .busy_o          (surface_busy)
    );
  end else begin : gen_no_span_setup
    assign {surface_triangle_ready, surface_span_ready, surface_valid} = '0;
    assign {surface_inside, surface_busy, surface_material} = '0;
    assign {seed_o, split_o, cosine_o, point_o} = '0;
  end

  if (HasNormal) begin : gen_normal_seeds
    normal_seeds #(.Methods(Methods & ~SurfaceMethods), .Lanes(Lanes)) u_normal_seeds (
      .clk_i, .rst_ni, .method_i, .light_i,
      .triangle_valid_i(triangle_valid_i && is_normal),
      .triangle_ready_o(normal_triangle_ready),
      .triangle_i,
      .span_valid_i    (span_valid_i && is_normal),
      .span_ready_o    (normal_span_ready),
      .span_i,
      .seed_valid_o    (normal_valid),
      .seed_ready_i    (seed_ready_i && is_normal),
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
