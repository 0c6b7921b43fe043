// SPDX-License-Identifier: Apache-2.0
//
// The methods that light every pixel: cosines of every pixel, for every lane.
//
//   quad-cosine      quad_cosine x 2
//   phong            linear_recurrence x 3 -> phong_direct      -> dot_product x 2
//   phong-taylor     linear_recurrence x 3 -> taylor_normalizer -> dot_product x 2
//   phong-duff       linear_recurrence x 2 + length_recurrence  -> duff_normalizer
//   slerp            slerp_recurrence x 3                       -> dot_product x 2
//   slerp-paper      slerp_paper x 3                            -> dot_product x 2
//   slerp-direct     slerp_direct                               -> dot_product x 2
//   slerp-intensity  slerp_recurrence x 2
//   adaptive, -paper, -chord   normals from adaptive_normalizer -> dot_product x 2
//   footprint, -paper   linear_recurrence x 3 -> aniso_footprint -> phong_direct -> dot_product x 2
//
// Timing    The recurrences march with the walker: 1 cycle from load_i to the first pixels. From
//           the cycle in which pixels leave the walker and enter the queue to valid_o: 0 cycles for
//           slerp-intensity and quad-cosine, else the sum of the units on the way. Never stops.
//           Footprints hold a group in the walker until its last sample; each sample is valid_o.
// Formats   quantities S1.38, normals S1.24, cosines S1.30, each rounded to nearest once.
// Error     That of the units on the way.
// Model     model/normal/normal_shader.h      Doc  docs/units/shading_unit.md
module normal_shader
  import footprint_pkg::*;
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = LitMethods,
  parameter int unsigned Lanes = 1
) (
  input  logic    clk_i,
  input  logic    rst_ni,
  input  method_e method_i,          // method and light are stable while pixels are inside
  input  light_t  light_i,

  input  logic    load_i,
  input  logic    step_i,
  input  quantity_seed_t [Components-1:0][Lanes-1:0] quantity_i,
  input  length_seed_t   [Lanes-1:0]                 length_i,
  input  kappa_t                                     kappa_i,       // of one stride
  input  kappa_t [1:0]                               step_kappa_i,  // of one and of two pixels
  input  arc_t                                       arc_i,
  input  curve_seed_t [Cosines-1:0]                  cosine_i,
  input  pixel_normal_t [Lanes-1:0][Components-1:0]  group_i,       // adaptive, with the pixels
  input  span_footprint_t                            footprint_i,

  // From the walker to the queue.
  input  logic                 pixel_valid_i,
  output logic                 pixel_ready_o,
  input  logic [Lanes-1:0]     mask_i,
  output logic                 enter_valid_o,
  input  logic                 enter_ready_i,

  output logic                 valid_o,
  output cosines_t [Lanes-1:0] cosines_o,
  output sample_place_t        place_o,       // of one sample, but for footprints
  output logic [Lanes-1:0]     live_o,

  input  logic                 clear_i,
  output sample_counters_t     samples_o      // since clear_i
);
  localparam bit HasCosine = Methods[MethodQuadCosine];
  localparam bit HasPhong = Methods[MethodPhong];
  localparam bit HasTaylor = Methods[MethodPhongTaylor];
  localparam bit HasDuff = Methods[MethodPhongDuff];
  localparam bit HasSlerp = Methods[MethodSlerp];
  localparam bit HasPaper = Methods[MethodSlerpPaper];
  localparam bit HasIntensity = Methods[MethodSlerpIntensity];
  localparam bit HasFootprint = |(Methods & FootprintMethods);
  localparam bit HasLinearVector = HasPhong || HasTaylor || HasFootprint;
  localparam bit HasDirect = Methods[MethodSlerpDirect];
  localparam bit HasAdaptive = |(Methods & AdaptiveMethods);
  localparam bit HasVector = HasLinearVector || HasSlerp || HasPaper || HasDirect || HasAdaptive;
  // Quantities that each kind of recurrence interpolates.
  localparam int unsigned LinearQuantities = HasLinearVector ? 3 : HasDuff ? 2 : 0;
  localparam int unsigned SlerpQuantities = HasSlerp ? 3 : HasIntensity ? 2 : 0;

  logic is_phong, is_taylor, is_duff, is_slerp, is_paper, is_intensity, is_linear, is_reinsch;
  logic is_direct, is_cosine, is_adaptive, is_footprint;
  assign is_footprint = is_any_of(Methods, method_i, FootprintMethods);
  assign is_adaptive  = is_any_of(Methods, method_i, AdaptiveMethods);
  assign is_cosine    = is_method(Methods, method_i, MethodQuadCosine);
  assign is_direct    = is_method(Methods, method_i, MethodSlerpDirect);
  assign is_phong     = is_method(Methods, method_i, MethodPhong);
  assign is_taylor    = is_method(Methods, method_i, MethodPhongTaylor);
  assign is_duff      = is_method(Methods, method_i, MethodPhongDuff);
  assign is_slerp     = is_method(Methods, method_i, MethodSlerp);
  assign is_paper     = is_method(Methods, method_i, MethodSlerpPaper);
  assign is_intensity = is_method(Methods, method_i, MethodSlerpIntensity);
  assign is_linear    = is_phong || is_taylor || is_duff || is_footprint;
  assign is_reinsch   = is_slerp || is_intensity;

  /////////////////
  // Recurrences //
  /////////////////

  quantity_t  [Components-1:0][Lanes-1:0] linear, reinsch, paper;
  length_sq_t [Lanes-1:0]                 length_sq;

  for (genvar q = 0; q < Components; q++) begin : gen_quantity
    for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
      if (q < LinearQuantities) begin : gen_linear
        linear_recurrence u_linear_recurrence (
          .clk_i, .load_i(load_i && is_linear), .step_i(step_i && is_linear),
          .seed_i(quantity_i[q][lane]), .value_o(linear[q][lane]));
      end else begin : gen_no_linear
        assign linear[q][lane] = '0;
      end
      if (q < SlerpQuantities) begin : gen_slerp
        slerp_recurrence u_slerp_recurrence (
          .clk_i, .load_i(load_i && is_reinsch), .step_i(step_i && is_reinsch),
          .seed_i(quantity_i[q][lane]), .kappa_i, .value_o(reinsch[q][lane]));
      end else begin : gen_no_slerp
        assign reinsch[q][lane] = '0;
      end
    end
    if (HasPaper) begin : gen_paper
      kappa_t [1:0] kappa;
      if (Lanes == 1) assign kappa = '{kappa_i, kappa_i};
      else            assign kappa = step_kappa_i;
      slerp_paper #(.Lanes(Lanes)) u_slerp_paper (
        .clk_i, .load_i(load_i && is_paper), .step_i(step_i && is_paper),
        .seed_i(quantity_i[q]), .step_kappa_i(kappa), .value_o(paper[q]));
    end else begin : gen_no_paper
      assign paper[q] = '0;
    end
  end

  /////////////
  // Samples //
  /////////////

  logic                                  leaves;        // pixels, from the walker
  logic                                  sample_valid;
  quantity_t [Lanes-1:0][Components-1:0] sample;
  assign leaves = pixel_valid_i && enter_ready_i;

  footprint_samples #(.Built(HasFootprint), .Lanes(Lanes)) u_footprint_samples (
    .clk_i, .rst_ni, .is_footprint_i(is_footprint),
    .load_i, .footprint_i, .pixel_valid_i, .pixel_ready_o, .mask_i, .normal_i(linear),
    .enter_valid_o, .enter_ready_i,
    .sample_valid_o(sample_valid),
    .normal_o      (sample),
    .place_o, .live_o, .clear_i,
    .counters_o    (samples_o)
  );

  /////////////
  // Cosines //
  /////////////

  logic [Lanes-1:0] lane_valid;
  assign valid_o = lane_valid[0];

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_cosines
    logic     vector_valid, dot_valid, duff_valid;
    cosines_t dot, duff, interpolated, curved;

    if (HasVector) begin : gen_vector
      logic                           phong_valid, taylor_valid, direct_valid;
      pixel_normal_t [Components-1:0] phong_normal, taylor_normal, slerp_normal, normal;
      pixel_normal_t [Components-1:0] direct_normal;
      quantity_t     [Components-1:0] line;
      assign line = {linear[2][lane], linear[1][lane], linear[0][lane]};
      if (HasPhong || HasFootprint) begin : gen_phong
        phong_direct u_phong_direct (
          .clk_i, .rst_ni, .valid_i(is_footprint ? sample_valid : leaves && is_phong),
          .normal_i(is_footprint ? sample[lane] : line),
          .valid_o(phong_valid), .normal_o(phong_normal));
      end else begin : gen_no_phong
        assign phong_valid  = 1'b0;
        assign phong_normal = '0;
      end
      if (HasTaylor) begin : gen_taylor
        taylor_normalizer u_taylor_normalizer (
          .clk_i, .rst_ni, .valid_i(leaves && is_taylor), .normal_i(line),
          .valid_o(taylor_valid), .normal_o(taylor_normal));
      end else begin : gen_no_taylor
        assign taylor_valid  = 1'b0;
        assign taylor_normal = '0;
      end
      if (HasDirect) begin : gen_direct
        slerp_direct #(.Lane(lane), .Lanes(Lanes)) u_slerp_direct (
          .clk_i, .rst_ni, .load_i(load_i && is_direct), .step_i(step_i && is_direct), .arc_i,
          .valid_i(leaves && is_direct), .valid_o(direct_valid), .normal_o(direct_normal));
      end else begin : gen_no_direct
        assign direct_valid  = 1'b0;
        assign direct_normal = '0;
      end
      for (genvar c = 0; c < Components; c++) begin : gen_component
        assign slerp_normal[c] = to_pixel_normal(is_paper ? paper[c][lane] : reinsch[c][lane]);
        assign normal[c] = is_phong || is_footprint ? phong_normal[c] : is_taylor ? taylor_normal[c]
                         : is_direct ? direct_normal[c] : is_adaptive ? group_i[lane][c]
                         : slerp_normal[c];
      end
      assign vector_valid = is_phong || is_footprint ? phong_valid : is_taylor ? taylor_valid
                          : is_direct ? direct_valid
                          : leaves && (is_slerp || is_paper || is_adaptive);

      logic dot_h_valid;  // the same as dot_valid
      dot_product u_n_dot_l (
        .clk_i, .rst_ni, .valid_i(vector_valid), .normal_i(normal), .vector_i(light_i.light),
        .valid_o(dot_valid), .cosine_o(dot.n_dot_l));
      dot_product u_n_dot_h_or_v (
        .clk_i, .rst_ni, .valid_i(vector_valid), .normal_i(normal),
        .vector_i(light_i.half_or_view), .valid_o(dot_h_valid), .cosine_o(dot.n_dot_h_or_v));
    end else begin : gen_no_vector
      assign vector_valid = 1'b0;
      assign dot_valid    = 1'b0;
      assign dot          = '0;
    end

    if (HasDuff) begin : gen_duff
      length_recurrence u_length_recurrence (
        .clk_i, .load_i(load_i && is_duff), .step_i(step_i && is_duff),
        .seed_i(length_i[lane]), .value_o(length_sq[lane]));
      duff_normalizer u_duff_normalizer (
        .clk_i, .rst_ni, .valid_i(leaves && is_duff), .n_dot_l_i(linear[0][lane]),
        .n_dot_h_or_v_i(linear[1][lane]), .length_sq_i(length_sq[lane]),
        .valid_o(duff_valid), .cosines_o(duff));
    end else begin : gen_no_duff
      assign length_sq[lane] = '0;
      assign duff_valid      = 1'b0;
      assign duff            = '0;
    end

    if (HasCosine) begin : gen_curve
      quad_cosine #(.Lane(lane), .Lanes(Lanes)) u_n_dot_l_curve (
        .clk_i, .load_i(load_i && is_cosine), .step_i(step_i && is_cosine),
        .seed_i(cosine_i[0]), .cosine_o(curved.n_dot_l));
      quad_cosine #(.Lane(lane), .Lanes(Lanes)) u_n_dot_h_or_v_curve (
        .clk_i, .load_i(load_i && is_cosine), .step_i(step_i && is_cosine),
        .seed_i(cosine_i[1]), .cosine_o(curved.n_dot_h_or_v));
    end else begin : gen_no_curve
      assign curved = '0;
    end

    assign interpolated.n_dot_l      = quantity_to_cosine(reinsch[0][lane]);
    assign interpolated.n_dot_h_or_v = quantity_to_cosine(reinsch[1][lane]);
    assign lane_valid[lane] = is_intensity || is_cosine ? leaves
                            : is_duff                   ? duff_valid : dot_valid;
    assign cosines_o[lane]  = is_cosine    ? curved
                            : is_intensity ? interpolated
                            : is_duff      ? duff : dot;
  end
endmodule
