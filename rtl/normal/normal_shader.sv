// SPDX-License-Identifier: Apache-2.0
//
// The methods that light every pixel: cosines of every pixel, for every lane.
//
//   quad-cosine      quad_cosine x 2
//   phong-surface    quad_cosine x 2       -> duff_cosines
//   phong            linear_recurrence x 3 -> phong_direct      -> dot_product x 2
//   phong-taylor     linear_recurrence x 3 -> taylor_normalizer -> dot_product x 2
//   phong-duff       linear_recurrence x 2 -> duff_cosines
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
//           Footprints hold a group in the walker until its last sample; each sample is valid_o. In
//           auto frames the cosines of all methods come as late as phong-duff's.
// Gating    What a span's method does not use holds, and N.H of a dark span.
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
  parameter bit HasAuto = 1'b0,
  parameter int unsigned Lanes = 1
) (
  input  logic    clk_i,
  input  logic    rst_ni,
  input  method_e method_i,          // of the frame; stable while pixels are inside, as the light
  input  light_t  light_i,

  input  choice_t choice_i,          // of the span that starts, at load_i
  input  logic    load_i,
  input  logic    step_i,
  input  quantity_seed_t [Components-1:0][Lanes-1:0] quantity_i,
  input  length_seed_t   [Lanes-1:0]                 length_i,
  input  kappa_t                                     kappa_i,       // of one stride
  input  kappa_t [1:0]                               step_kappa_i,  // of one and of two pixels
  input  arc_t                                       arc_i,
  input  curve_seed_t [Curves-1:0]                  curve_i,
  input  pixel_normal_t [Lanes-1:0][Components-1:0]  group_i,       // adaptive, with the pixels
  input  span_footprint_t                            footprint_i,

  // From the walker to the queue.
  input  logic                 pixel_valid_i,
  output logic                 pixel_ready_o,
  input  logic [Lanes-1:0]     mask_i,
  input  logic                 shaded_i,      // auto: the pixels have their codes
  output logic                 enter_valid_o,
  input  logic                 enter_ready_i,

  output logic                 valid_o,
  output cosines_t [Lanes-1:0] cosines_o,
  output sample_place_t        place_o,       // of one sample, but for footprints
  output logic [Lanes-1:0]     live_o,

  input  logic                 clear_i,
  output sample_counters_t     samples_o      // since clear_i
);
  localparam bit HasDuff = Methods[MethodPhongDuff];
  localparam bit HasSurface = Methods[MethodPhongSurface];
  localparam bit HasCurve = |(Methods & CurveMethods);
  localparam bit HasSlerp = Methods[MethodSlerp];
  localparam bit HasPaper = Methods[MethodSlerpPaper];
  localparam bit HasIntensity = Methods[MethodSlerpIntensity];
  localparam bit HasFootprint = |(Methods & FootprintMethods);
  localparam bit HasLinearVector = Methods[MethodPhong] || Methods[MethodPhongTaylor] ||
                                   HasFootprint;
  localparam bit HasVector = HasLinearVector || HasSlerp || HasPaper ||
                             Methods[MethodSlerpDirect] || |(Methods & AdaptiveMethods);
  // Quantities that each kind of recurrence interpolates.
  localparam int unsigned LinearQuantities = HasLinearVector ? 3 : HasDuff ? 2 : 0;
  localparam int unsigned SlerpQuantities = HasSlerp ? 3 : HasIntensity ? 2 : 0;

  // What a span wants: of the one that starts, and of the one inside.
  typedef struct packed {
    logic linear, reinsch, paper, direct, length, surface, curve, intensity;
  } kind_t;
  function automatic kind_t kind_of(method_e method);
    kind_of.surface   = is_method(Methods, method, MethodPhongSurface);
    kind_of.length    = is_method(Methods, method, MethodPhongDuff) || kind_of.surface;
    kind_of.intensity = is_method(Methods, method, MethodSlerpIntensity);
    kind_of.reinsch   = is_method(Methods, method, MethodSlerp) || kind_of.intensity;
    kind_of.paper     = is_method(Methods, method, MethodSlerpPaper);
    kind_of.direct    = is_method(Methods, method, MethodSlerpDirect);
    kind_of.curve     = is_any_of(Methods, method, CurveMethods);
    kind_of.linear    = is_method(Methods, method, MethodPhong) ||
                        is_method(Methods, method, MethodPhongDuff) ||
                        is_method(Methods, method, MethodPhongTaylor) ||
                        is_any_of(Methods, method, FootprintMethods);
  endfunction
  kind_t   starts, now;
  choice_t choice_q;
  logic    is_auto, is_footprint;
  assign starts       = kind_of(choice_i.method);
  assign now          = kind_of(choice_q.method);
  assign is_auto      = HasAuto && method_i == MethodAuto;
  assign is_footprint = is_any_of(Methods, method_i, FootprintMethods);
  always_ff @(posedge clk_i) if (load_i) choice_q <= choice_i;

  /////////////////
  // Recurrences //
  /////////////////

  quantity_t [Components-1:0][Lanes-1:0] linear, reinsch, paper;

  for (genvar q = 0; q < Components; q++) begin : gen_quantity
    logic load, step;                // N.H of a dark span holds
    assign load = load_i && !(q == 1 && is_auto && choice_i.dark);
    assign step = step_i && !(q == 1 && is_auto && choice_q.dark);
    for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
      if (q < LinearQuantities) begin : gen_linear
        linear_recurrence u_linear_recurrence (
          .clk_i, .load_i(load && starts.linear), .step_i(step && now.linear),
          .seed_i(quantity_i[q][lane]), .value_o(linear[q][lane]));
      end else begin : gen_no_linear
        assign linear[q][lane] = '0;
      end
      if (q < SlerpQuantities) begin : gen_slerp
        slerp_recurrence u_slerp_recurrence (
          .clk_i, .load_i(load && starts.reinsch), .step_i(step && now.reinsch),
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
        .clk_i, .load_i(load_i && starts.paper), .step_i(step_i && now.paper),
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
  assign leaves = pixel_valid_i && enter_ready_i && !(is_auto && shaded_i);

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
    logic     dot_valid, duff_valid, late_valid, at_once;
    cosines_t dot, duff, interpolated, curved, straight, late;

    if (HasVector) begin : gen_vector
      quantity_t [Components-1:0] line, arc, chord;
      assign line  = {linear[2][lane], linear[1][lane], linear[0][lane]};
      assign arc   = {reinsch[2][lane], reinsch[1][lane], reinsch[0][lane]};
      assign chord = {paper[2][lane], paper[1][lane], paper[0][lane]};
      vector_cosines #(.Methods(Methods), .Lane(lane), .Lanes(Lanes)) u_vector_cosines (
        .clk_i, .rst_ni, .method_i, .light_i,
        .load_i(load_i && starts.direct), .step_i(step_i && now.direct), .arc_i,
        .valid_i(leaves), .linear_i(line), .reinsch_i(arc), .paper_i(chord),
        .group_i(group_i[lane]), .sample_valid_i(sample_valid), .sample_i(sample[lane]),
        .valid_o(dot_valid), .cosines_o(dot));
    end else begin : gen_no_vector
      assign dot_valid = 1'b0;
      assign dot       = '0;
    end

    if (HasCurve) begin : gen_curve
      quad_cosine #(.Lane(lane), .Lanes(Lanes)) u_n_dot_l_curve (
        .clk_i, .load_i(load_i && starts.curve), .step_i(step_i && now.curve),
        .seed_i(curve_i[0]), .cosine_o(curved.n_dot_l));
      quad_cosine #(.Lane(lane), .Lanes(Lanes)) u_n_dot_h_or_v_curve (
        .clk_i, .load_i(load_i && starts.curve && !(is_auto && choice_i.dark)),
        .step_i(step_i && now.curve && !(is_auto && choice_q.dark)),
        .seed_i(curve_i[1]), .cosine_o(curved.n_dot_h_or_v));
    end else begin : gen_no_curve
      assign curved = '0;
    end

    if (HasDuff || HasSurface) begin : gen_duff
      duff_cosines #(.Methods(Methods), .Lane(lane), .Lanes(Lanes)) u_duff_cosines (
        .clk_i, .rst_ni, .load_i(load_i && starts.length), .step_i(step_i && now.length),
        .load_surface_i(starts.surface), .surface_i(now.surface),
        .length_i(length_i[lane]), .square_i(curve_i[2]),
        .valid_i(leaves && now.length), .dark_i(is_auto && choice_q.dark),
        .n_dot_l_i(linear[0][lane]), .n_dot_h_or_v_i(linear[1][lane]), .curved_i(curved),
        .valid_o(duff_valid), .cosines_o(duff));
    end else begin : gen_no_duff
      assign duff_valid = 1'b0;
      assign duff       = '0;
    end

    assign interpolated.n_dot_l      = quantity_to_cosine(reinsch[0][lane]);
    assign interpolated.n_dot_h_or_v = quantity_to_cosine(reinsch[1][lane]);
    assign at_once                   = now.intensity || (now.curve && !now.surface);
    assign straight                  = now.curve ? curved : interpolated;

    if (HasAuto) begin : gen_delay
      cosine_delay u_cosine_delay (
        .clk_i, .rst_ni, .valid_i(is_auto && leaves && at_once),
        .cosines_i(curved), .valid_o(late_valid), .cosines_o(late));
    end else begin : gen_no_delay
      assign late_valid = 1'b0;
      assign late       = '0;
    end

    assign lane_valid[lane] = is_auto    ? duff_valid || late_valid
                            : at_once    ? leaves
                            : now.length ? duff_valid : dot_valid;
    assign cosines_o[lane]  = is_auto    ? (duff_valid ? duff : late)
                            : at_once    ? straight
                            : now.length ? duff : dot;
  end
endmodule
