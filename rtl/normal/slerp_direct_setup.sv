// SPDX-License-Identifier: Apache-2.0
//
// From the seed of a recurrence to the arc that slerp_direct marches along, paper 000 (6). With
// d = N(1) - N(0) and kappa = 4 sin^2(phi/2) = X 4^-E, X in [1, 4):
//
//   phi = sqrt(kappa) A(kappa)          1/sin(phi) = B(kappa) / sqrt(kappa)
//   Nk = (N(1) - Na cos(phi)) / sin(phi) = (d + Na kappa/2) / sin(phi)
//   kappa = 0, all |d| < 2^-24:  phi = 2^-25, Nk = 2^25 d
//              all |d| < 2^-19:  phi = 2^-20, Nk = 2^20 d
//              else (one step):  phi = a quarter of a turn, Nk = Na + d
//
// Timing    Two stages of 8 steps: a seed taken in cycle c is on offer as an arc in cycle c + 17;
//           one every 8 cycles. ready/valid on both ports. Stages as those of normal_setup.
// Formats   first and difference S1.38, kappa U1.28 4^-p; phi U1.40, Na and Nk S1.30. Products are
//           rounded half up once, d + Na kappa/2 is cut to S2.34 2^-E; Nk saturates.
// Error     9 ulp of 2^-30 at any of 4096 pixels that turn at most 90 degrees, kappa <= 0.625.
//           RTL = model.
// Bad input kappa saturates at 0.625 in A and B; Nk saturates. first drops its 8 lowest bits, which
//           are 0 for normals at the ends of spans.
// Model     model/normal/slerp_direct_setup.h    Doc  docs/units/normal/slerp_direct_setup.md
module slerp_direct_setup
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     seed_valid_i,
  output logic     seed_ready_o,
  input  lit_run_t run_i,
  input  quantity_seed_t [Components-1:0] quantity_i,    // of one pixel, whatever the lanes
  input  kappa_t   kappa_i,                              // of one pixel

  output logic     seed_valid_o,
  input  logic     seed_ready_i,
  output lit_run_t run_o,
  output arc_t     arc_o,
  output logic     busy_o                                // a span is inside or its arc waits
);
  localparam int unsigned Stages = 2;
  localparam int unsigned Latency = 8 * Stages + 1;
  localparam int unsigned Interval = 8;

  logic [Stages-1:0]      take;
  logic [Stages-1:0][2:0] step;
  lit_run_t [Stages-1:0]  stage_run;         // the stages read no run
  logic                   write_arc;
  normal_setup_control #(.Stages(Stages)) u_control (
    .clk_i, .rst_ni, .valid_i(seed_valid_i), .ready_o(seed_ready_o), .run_i,
    .valid_o(seed_valid_o), .ready_i(seed_ready_i), .run_o, .take_o(take), .step_o(step),
    .stage_run_o(stage_run), .write_o(write_arc), .busy_o);

  arc_turn_t                     turn;
  span_normal_t [Components-1:0] start;
  arc_rise_t    [Components-1:0] rise;
  slerp_direct_setup_root u_root (
    .clk_i, .rst_ni, .take_i(take[0]), .step_i(step[0]), .quantity_i, .kappa_i,
    .turn_o(turn), .start_o(start), .rise_o(rise));

  arc_t arc, arc_q;
  slerp_direct_setup_side u_side (
    .clk_i, .take_i(take[1]), .step_i(step[1]), .turn_i(turn), .start_i(start), .rise_i(rise),
    .arc_o(arc));
  always_ff @(posedge clk_i) if (write_arc) arc_q <= arc;
  assign arc_o = arc_q;
endmodule
