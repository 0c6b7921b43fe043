// SPDX-License-Identifier: Apache-2.0
//
// Cosines of a pixel by Duff's method, for one lane: N.L and N.H of the linear normal over the root
// of |N|^2. A part of normal_shader; it has no page of its own.
//
//   phong-duff      N.L, N.H from linear_recurrence, |N|^2 started by normal_setup
//   phong-surface   N.L, N.H from quad_cosine, |N|^2 started by span_setup
//
// Timing    |N|^2 marches with the walker; from valid_i 9 cycles to valid_o. Never stops.
// Formats   quantities S1.38, |N|^2 S1.44, cosines S1.30.
// Error     That of the units.
// Model     model/normal/duff_cosines.h      Doc  docs/units/shading_unit.md
module duff_cosines
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = LitMethods,
  parameter int unsigned Lane = 0,
  parameter int unsigned Lanes = 1
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         load_i,
  input  logic         step_i,
  input  logic         load_surface_i,   // the span that starts is phong-surface's
  input  logic         surface_i,        // so is the one inside
  input  length_seed_t length_i,
  input  curve_seed_t  square_i,

  input  logic         valid_i,
  input  logic         dark_i,           // the highlight is not wanted
  input  quantity_t    n_dot_l_i,        // phong-duff
  input  quantity_t    n_dot_h_or_v_i,
  input  cosines_t     curved_i,         // phong-surface
  output logic         valid_o,
  output cosines_t     cosines_o
);
  localparam bit HasDuff = Methods[MethodPhongDuff];
  localparam bit HasSurface = Methods[MethodPhongSurface];

  logic         load_surface, is_surface;
  length_seed_t seed;
  length_sq_t   length_sq;
  quantity_t    n_dot_l, n_dot_h_or_v;
  assign load_surface = HasSurface && (load_surface_i || !HasDuff);
  assign is_surface   = HasSurface && (surface_i || !HasDuff);
  assign n_dot_l      = is_surface ? cosine_to_quantity(curved_i.n_dot_l) : n_dot_l_i;
  assign n_dot_h_or_v = dark_i     ? '0
                      : is_surface ? cosine_to_quantity(curved_i.n_dot_h_or_v) : n_dot_h_or_v_i;

  if (HasSurface) begin : gen_surface
    curve_seed_t square;
    lane_seed #(.value_t(cosine_acc_t), .seed_t(curve_seed_t), .Lane(Lane), .Lanes(Lanes))
    u_lane_seed (.seed_i(square_i), .seed_o(square));
    assign seed = load_surface ? '{first: square.first, difference: square.difference,
                                   curvature: square.curvature} : length_i;
  end else begin : gen_line
    assign seed = length_i;
  end

  length_recurrence u_length_recurrence (
    .clk_i, .load_i, .step_i, .seed_i(seed), .value_o(length_sq));
  duff_normalizer u_duff_normalizer (
    .clk_i, .rst_ni, .valid_i, .n_dot_l_i(n_dot_l), .n_dot_h_or_v_i(n_dot_h_or_v),
    .length_sq_i(length_sq), .valid_o, .cosines_o);
endmodule
