// SPDX-License-Identifier: Apache-2.0
//
// Seeds of the methods that interpolate normals or cosines.
//
//   triangle, span -> span_binder -> normal_setup (-> slerp_direct_setup for slerp-direct) -> seed
//
// Timing    A span every 8 cycles; latency that of the units on the way.
// Streams   ready/valid; a payload holds until taken.
// Formats   normal_pkg.
// Error     That of the units on the way.
// Model     LightPixels in model/shading_unit.cpp      Doc  docs/units/shading_unit.md
module normal_seeds
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = ~SurfaceMethods,
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

  output logic      seed_valid_o,
  input  logic      seed_ready_i,
  output lit_run_t  run_o,
  output quantity_seed_t [Components-1:0][Lanes-1:0] quantity_o,
  output length_seed_t   [Lanes-1:0]                 length_o,
  output kappa_t                                     kappa_o,
  output kappa_t [1:0]                               step_kappa_o,
  output arc_t                                       arc_o,          // slerp-direct

  output logic      span_inside_o,   // a span is being set up or waits as a seed
  output logic      busy_o           // a triangle or a span is inside
);
  logic                               run_valid, run_ready, binder_busy;
  lit_run_t                           run;
  span_normal_t [1:0][Components-1:0] normal;

  span_binder u_span_binder (
    .clk_i, .rst_ni,
    .triangle_valid_i, .triangle_ready_o, .triangle_i,
    .span_valid_i, .span_ready_o, .span_i,
    .run_valid_o(run_valid),
    .run_ready_i(run_ready),
    .run_o      (run),
    .normal_o   (normal),
    .busy_o     (binder_busy)
  );

  setup_kind_t kind;
  assign kind = '{
    spherical: is_method(Methods, method_i, MethodSlerp) ||
               is_method(Methods, method_i, MethodSlerpPaper) ||
               is_method(Methods, method_i, MethodSlerpIntensity) ||
               is_method(Methods, method_i, MethodSlerpDirect),
    cosines:   is_method(Methods, method_i, MethodPhongDuff) ||
               is_method(Methods, method_i, MethodSlerpIntensity),
    length:    is_method(Methods, method_i, MethodPhongDuff)};

  logic     is_direct, recurrence_valid, recurrence_busy, direct_valid, direct_ready, direct_busy;
  lit_run_t recurrence_run, direct_run;
  assign is_direct = is_method(Methods, method_i, MethodSlerpDirect);

  normal_setup #(.Lanes(Lanes)) u_normal_setup (
    .clk_i, .rst_ni,
    .kind_i      (kind),
    .light_i,
    .span_valid_i(run_valid),
    .span_ready_o(run_ready),
    .run_i       (run),
    .normal_i    (normal),
    .seed_valid_o(recurrence_valid),
    .seed_ready_i(is_direct ? direct_ready : seed_ready_i),
    .run_o       (recurrence_run),
    .quantity_o, .length_o, .kappa_o, .step_kappa_o,
    .busy_o      (recurrence_busy)
  );

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

  assign seed_valid_o  = is_direct ? direct_valid : recurrence_valid;
  assign run_o         = is_direct ? direct_run : recurrence_run;
  assign span_inside_o = recurrence_busy || direct_busy;
  assign busy_o        = binder_busy || span_inside_o;
endmodule
