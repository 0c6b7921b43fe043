// SPDX-License-Identifier: Apache-2.0
//
// Binds each span to its triangle: adds the depth step, the material, the limit of
// adaptive_normalizer and the footprint to the span's position.
//
// Timing    Combinational from span to run. A triangle is kept until its last span is taken; a span
//           never passes before its triangle, and may pass in the cycle in which that comes.
// Streams   ready/valid; run_valid_o does not wait for run_ready_i.
// Formats   shading_pkg.
// Error     None.
// Model     model/raster/span_binder.h      Doc  docs/units/raster/span_binder.md
module span_binder
  import footprint_pkg::*;
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
(
  input  logic      clk_i,
  input  logic      rst_ni,

  input  logic      triangle_valid_i,
  output logic      triangle_ready_o,
  input  triangle_t triangle_i,
  input  choice_t   choice_i,        // of the triangle
  input  setup_kind_t kind_i,        // likewise

  input  logic      span_valid_i,
  output logic      span_ready_o,
  input  span_t     span_i,

  output logic      run_valid_o,
  input  logic      run_ready_i,
  output lit_run_t  run_o,
  output span_normal_t [1:0][Components-1:0] normal_o,
  output angle_limit_t                       limit_o,
  output span_footprint_t                    footprint_o,

  output logic      busy_o           // a triangle is inside
);
  localparam int unsigned Latency = 0;

  logic            triangle_valid_q;
  depth_acc_t      dz_dx_q, dz_dx;
  material_index_t material_q, material;
  angle_limit_t    limit_q;
  choice_t         choice_q;
  setup_kind_t     kind_q;
  footprint_t      footprint_q;

  logic take_triangle, take_last;
  assign take_last        = span_valid_i && span_ready_o && span_i.last;
  assign triangle_ready_o = !triangle_valid_q || (span_valid_i && run_ready_i && span_i.last);
  assign take_triangle    = triangle_valid_i && triangle_ready_o;
  assign run_valid_o      = span_valid_i && (triangle_valid_q || triangle_valid_i);
  assign span_ready_o     = run_ready_i && (triangle_valid_q || triangle_valid_i);
  assign busy_o           = triangle_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)               triangle_valid_q <= 1'b0;
    else if (triangle_valid_q) triangle_valid_q <= take_triangle || !take_last;
    else                       triangle_valid_q <= take_triangle && !take_last;
  end

  always_ff @(posedge clk_i) begin
    if (take_triangle) begin
      dz_dx_q     <= triangle_i.dz_dx;
      material_q  <= triangle_i.material;
      limit_q     <= triangle_i.limit;
      choice_q    <= choice_i;
      kind_q      <= kind_i;
      footprint_q <= triangle_i.footprint;
    end
  end

  assign dz_dx    = triangle_valid_q ? dz_dx_q : triangle_i.dz_dx;
  assign material = triangle_valid_q ? material_q : triangle_i.material;
  assign run_o    = '{choice: triangle_valid_q ? choice_q : choice_i,
                      kind: triangle_valid_q ? kind_q : kind_i,
                      run: '{x: span_i.x, y: span_i.y, length: span_i.length, z: span_i.z,
                             dz_dx: dz_dx},
                      material: material};
  assign normal_o = span_i.normal;
  assign limit_o  = triangle_valid_q ? limit_q : triangle_i.limit;
  assign footprint_o = '{footprint: triangle_valid_q ? footprint_q : triangle_i.footprint,
                         margin: span_i.margin};
endmodule
