// SPDX-License-Identifier: Apache-2.0
//
// Seeds of the methods that interpolate normals or cosines.
//
//   triangle, span -> span_binder -> normal_setup (-> slerp_direct_setup for slerp-direct) -> seed
//                                 -> adaptive_normalizer -> run, normals of the pixels
//                                 -> footprint_queue beside normal_setup -> footprint
//
// Timing    A span every 8 cycles, adaptive methods as their unit; latency that of the units.
// Streams   ready/valid; a payload holds until taken. The run of an adaptive method is a pulse: its
//           pixels follow, and the walker is free because theirs have left.
// Formats   normal_pkg.
// Error     That of the units on the way.
// Model     LightPixels in model/shading_unit.cpp      Doc  docs/units/shading_unit.md
module normal_seeds
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = NormalMethods,
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

  output logic      seed_valid_o,
  input  logic      seed_ready_i,
  output lit_run_t  run_o,
  output quantity_seed_t [Components-1:0][Lanes-1:0] quantity_o,
  output length_seed_t   [Lanes-1:0]                 length_o,
  output kappa_t                                     kappa_o,
  output kappa_t [1:0]                               step_kappa_o,
  output arc_t                                       arc_o,          // slerp-direct
  output span_footprint_t                            footprint_o,    // footprint methods

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
  logic                               run_valid, run_ready, binder_busy;
  lit_run_t                           run;
  span_normal_t [1:0][Components-1:0] normal;
  angle_limit_t                       limit;
  span_footprint_t                    footprint;

  setup_kind_t kind;                 // of the triangle
  assign kind = '{
    spherical: is_method(Methods, choice_i.method, MethodSlerp) ||
               is_method(Methods, choice_i.method, MethodSlerpPaper) ||
               is_method(Methods, choice_i.method, MethodSlerpIntensity) ||
               is_method(Methods, choice_i.method, MethodSlerpDirect),
    cosines:   is_method(Methods, choice_i.method, MethodPhongDuff) ||
               is_method(Methods, choice_i.method, MethodSlerpIntensity),
    length:    is_method(Methods, choice_i.method, MethodPhongDuff)};

  span_binder u_span_binder (
    .clk_i, .rst_ni,
    .triangle_valid_i, .triangle_ready_o, .triangle_i, .choice_i, .kind_i(kind),
    .span_valid_i, .span_ready_o, .span_i,
    .run_valid_o(run_valid),
    .run_ready_i(run_ready),
    .run_o      (run),
    .normal_o   (normal),
    .limit_o    (limit),
    .footprint_o(footprint),
    .busy_o     (binder_busy)
  );

  logic     is_direct, recurrence_valid, recurrence_busy, direct_valid, direct_ready, direct_busy;
  logic     is_adaptive, recurrence_ready, adaptive_valid, adaptive_ready, adaptive_busy;
  lit_run_t recurrence_run, direct_run, adaptive_run;
  assign is_direct   = is_method(Methods, method_i, MethodSlerpDirect);
  assign is_adaptive = is_any_of(Methods, method_i, AdaptiveMethods);
  assign run_ready   = is_adaptive ? adaptive_ready : recurrence_ready;

  if (|(Methods & ~AdaptiveMethods)) begin : gen_normal_setup
    normal_setup #(.Lanes(Lanes)) u_normal_setup (
      .clk_i, .rst_ni,
      .light_i,
      .span_valid_i(run_valid && !is_adaptive),
      .span_ready_o(recurrence_ready),
      .run_i       (run),
      .normal_i    (normal),
      .seed_valid_o(recurrence_valid),
      .seed_ready_i(is_direct ? direct_ready : seed_ready_i),
      .run_o       (recurrence_run),
      .quantity_o, .length_o, .kappa_o, .step_kappa_o,
      .busy_o      (recurrence_busy)
    );
  end else begin : gen_no_normal_setup
    assign {recurrence_ready, recurrence_valid, recurrence_busy, recurrence_run} = '0;
    assign {quantity_o, length_o, kappa_o, step_kappa_o} = '0;
  end

  if (|(Methods & AdaptiveMethods)) begin : gen_adaptive
    adaptive_kind_e adaptive_kind;
    assign adaptive_kind = is_method(Methods, method_i, MethodAdaptivePaper) ? AdaptiveExtended
                         : is_method(Methods, method_i, MethodAdaptiveChord) ? AdaptiveChord
                         : AdaptiveSphere;
    logic [Lanes-1:0] mask;  // the walker's
    logic             last;
    adaptive_normalizer #(.Lanes(Lanes)) u_adaptive_normalizer (
      .clk_i, .rst_ni,
      .kind_i       (adaptive_kind),
      .span_valid_i (run_valid && is_adaptive),
      .span_ready_o (adaptive_ready),
      .run_i        (run),
      .normal_i     (normal),
      .limit_i      (limit),
      .run_valid_o  (adaptive_valid),
      .run_o        (adaptive_run),
      .pixel_valid_o(group_valid_o),
      .pixel_ready_i(group_ready_i),
      .normal_o     (group_o),
      .mask_o       (mask),
      .last_o       (last),
      .count_valid_o, .normalised_o, .skipped_o,
      .busy_o       (adaptive_busy)
    );
  end else begin : gen_no_adaptive
    assign {adaptive_ready, adaptive_valid, adaptive_run, adaptive_busy} = '0;
    assign {group_valid_o, group_o, count_valid_o, normalised_o, skipped_o} = '0;
  end

  if (|(Methods & FootprintMethods)) begin : gen_footprint
    logic is_footprint;
    assign is_footprint = is_any_of(Methods, method_i, FootprintMethods);
    footprint_queue u_footprint_queue (
      .clk_i, .rst_ni,
      .write_i    (run_valid && run_ready && is_footprint),
      .footprint_i(footprint),
      .read_i     (recurrence_valid && seed_ready_i && is_footprint),
      .footprint_o
    );
  end else begin : gen_no_footprint
    assign footprint_o = '0;
  end

  // Starts from the seeds of one pixel's stride, whatever the lanes.
  if (Methods[MethodSlerpDirect]) begin : gen_direct_setup
    quantity_seed_t [Components-1:0] step;
    for (genvar c = 0; c < Components; c++) begin : gen_step
      assign step[c].first = quantity_o[c][0].first;
      if (Lanes == 1) assign step[c].difference = quantity_o[c][0].difference;
      else            assign step[c].difference = quantity_o[c][1].first - quantity_o[c][0].first;
    end
    slerp_direct_setup u_slerp_direct_setup (
      .clk_i, .rst_ni,
      .seed_valid_i(recurrence_valid && is_direct),
      .seed_ready_o(direct_ready),
      .run_i       (recurrence_run),
      .quantity_i  (step),
      .kappa_i     (Lanes == 1 ? kappa_o : step_kappa_o[0]),
      .seed_valid_o(direct_valid),
      .seed_ready_i,
      .run_o       (direct_run),
      .arc_o,
      .busy_o      (direct_busy)
    );
  end else begin : gen_no_direct_setup
    assign {direct_ready, direct_run, direct_valid, direct_busy, arc_o} = '0;
  end

  assign seed_valid_o  = is_adaptive ? adaptive_valid : is_direct ? direct_valid : recurrence_valid;
  assign run_o         = is_adaptive ? adaptive_run : is_direct ? direct_run : recurrence_run;
  assign span_inside_o = recurrence_busy || direct_busy || adaptive_busy;
  assign busy_o        = binder_busy || span_inside_o;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    assert (!adaptive_valid || seed_ready_i) else $error("normal_seeds: the walker is not free");
  end
`endif
endmodule
