// SPDX-License-Identifier: Apache-2.0
//
// Cosines of a pixel from its normal, for one lane: the methods that have a vector.
//
//   phong            phong_direct      -> dot_product x 2
//   phong-taylor     taylor_normalizer -> dot_product x 2
//   slerp, -paper    the recurrence    -> dot_product x 2
//   slerp-direct     slerp_direct      -> dot_product x 2
//   adaptive ..      adaptive_normalizer's normals -> dot_product x 2
//   footprint ..     samples -> phong_direct -> dot_product x 2
//
// A part of normal_shader; it has no page of its own.
//
// Timing    The sum of the units on the way; never stops.
// Formats   quantities S1.38, normals S1.24, cosines S1.30, each rounded to nearest once.
// Error     That of the units on the way.
// Model     model/normal/normal_shader.h      Doc  docs/units/shading_unit.md
module vector_cosines
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
#(
  parameter methods_t Methods = LitMethods,
  parameter int unsigned Lane = 0,
  parameter int unsigned Lanes = 1
) (
  input  logic    clk_i,
  input  logic    rst_ni,
  input  method_e method_i,          // method and light are stable while pixels are inside
  input  light_t  light_i,
  input  logic    load_i,            // slerp-direct
  input  logic    step_i,
  input  arc_t    arc_i,

  input  logic                           valid_i,
  input  quantity_t     [Components-1:0] linear_i,
  input  quantity_t     [Components-1:0] reinsch_i,
  input  quantity_t     [Components-1:0] paper_i,
  input  pixel_normal_t [Components-1:0] group_i,         // adaptive
  input  logic                           sample_valid_i,  // footprints
  input  quantity_t     [Components-1:0] sample_i,

  output logic     valid_o,
  output cosines_t cosines_o
);
  localparam bit HasFootprint = |(Methods & FootprintMethods);
  localparam bit HasPhong = Methods[MethodPhong] || HasFootprint;
  localparam bit HasTaylor = Methods[MethodPhongTaylor];
  localparam bit HasDirect = Methods[MethodSlerpDirect];

  logic is_phong, is_taylor, is_slerp, is_paper, is_direct, is_adaptive, is_footprint;
  assign is_phong     = is_method(Methods, method_i, MethodPhong);
  assign is_taylor    = is_method(Methods, method_i, MethodPhongTaylor);
  assign is_slerp     = is_method(Methods, method_i, MethodSlerp);
  assign is_paper     = is_method(Methods, method_i, MethodSlerpPaper);
  assign is_direct    = is_method(Methods, method_i, MethodSlerpDirect);
  assign is_adaptive  = is_any_of(Methods, method_i, AdaptiveMethods);
  assign is_footprint = is_any_of(Methods, method_i, FootprintMethods);

  logic                           phong_valid, taylor_valid, direct_valid, vector_valid;
  pixel_normal_t [Components-1:0] phong_normal, taylor_normal, slerp_normal, direct_normal;
  pixel_normal_t [Components-1:0] normal;

  if (HasPhong) begin : gen_phong
    phong_direct u_phong_direct (
      .clk_i, .rst_ni, .valid_i(is_footprint ? sample_valid_i : valid_i && is_phong),
      .normal_i(is_footprint ? sample_i : linear_i),
      .valid_o(phong_valid), .normal_o(phong_normal));
  end else begin : gen_no_phong
    assign phong_valid  = 1'b0;
    assign phong_normal = '0;
  end
  if (HasTaylor) begin : gen_taylor
    taylor_normalizer u_taylor_normalizer (
      .clk_i, .rst_ni, .valid_i(valid_i && is_taylor), .normal_i(linear_i),
      .valid_o(taylor_valid), .normal_o(taylor_normal));
  end else begin : gen_no_taylor
    assign taylor_valid  = 1'b0;
    assign taylor_normal = '0;
  end
  if (HasDirect) begin : gen_direct
    slerp_direct #(.Lane(Lane), .Lanes(Lanes)) u_slerp_direct (
      .clk_i, .rst_ni, .load_i, .step_i, .arc_i,
      .valid_i(valid_i && is_direct), .valid_o(direct_valid), .normal_o(direct_normal));
  end else begin : gen_no_direct
    assign direct_valid  = 1'b0;
    assign direct_normal = '0;
  end

  for (genvar c = 0; c < Components; c++) begin : gen_component
    assign slerp_normal[c] = to_pixel_normal(is_paper ? paper_i[c] : reinsch_i[c]);
    assign normal[c] = is_phong || is_footprint ? phong_normal[c] : is_taylor ? taylor_normal[c]
                     : is_direct ? direct_normal[c] : is_adaptive ? group_i[c] : slerp_normal[c];
  end
  assign vector_valid = is_phong || is_footprint ? phong_valid : is_taylor ? taylor_valid
                      : is_direct ? direct_valid
                      : valid_i && (is_slerp || is_paper || is_adaptive);

  logic dot_h_valid;  // the same as valid_o
  dot_product u_n_dot_l (
    .clk_i, .rst_ni, .valid_i(vector_valid), .normal_i(normal), .vector_i(light_i.light),
    .valid_o, .cosine_o(cosines_o.n_dot_l));
  dot_product u_n_dot_h_or_v (
    .clk_i, .rst_ni, .valid_i(vector_valid), .normal_i(normal), .vector_i(light_i.half_or_view),
    .valid_o(dot_h_valid), .cosine_o(cosines_o.n_dot_h_or_v));
endmodule
