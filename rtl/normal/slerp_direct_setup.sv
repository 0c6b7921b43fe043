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

  logic [Stages:0]        valid, ready;      // between stages; [Stages]: the output register
  logic [Stages-1:0]      busy, take;
  logic [Stages-1:0][2:0] step;
  lit_run_t [Stages:0]    run_q;
  logic                   arc_valid_q, write_arc;

  assign valid[0]      = seed_valid_i;
  assign seed_ready_o  = ready[0];
  assign ready[Stages] = !arc_valid_q || seed_ready_i;
  assign write_arc     = valid[Stages] && ready[Stages];
  assign seed_valid_o  = arc_valid_q;
  assign run_o         = run_q[Stages];
  assign busy_o        = (|busy) || arc_valid_q;

  for (genvar i = 0; i < Stages; i++) begin : gen_stage
    normal_setup_stage i_stage (
      .clk_i, .rst_ni, .valid_i(valid[i]), .ready_o(ready[i]), .valid_o(valid[i+1]),
      .ready_i(ready[i+1]), .busy_o(busy[i]), .take_o(take[i]), .step_o(step[i]));
    always_ff @(posedge clk_i) if (take[i]) run_q[i] <= i == 0 ? run_i : run_q[i == 0 ? 0 : i - 1];
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) arc_valid_q <= 1'b0;
    else         arc_valid_q <= write_arc || (arc_valid_q && !seed_ready_i);
  end
  always_ff @(posedge clk_i) if (write_arc) run_q[Stages] <= run_q[Stages-1];

  arc_turn_t                     turn;
  span_normal_t [Components-1:0] start;
  arc_rise_t    [Components-1:0] rise;
  slerp_direct_setup_root i_root (
    .clk_i, .rst_ni, .take_i(take[0]), .step_i(step[0]), .quantity_i, .kappa_i,
    .turn_o(turn), .start_o(start), .rise_o(rise));

  arc_t arc, arc_q;
  slerp_direct_setup_side i_side (
    .clk_i, .take_i(take[1]), .step_i(step[1]), .turn_i(turn), .start_i(start), .rise_i(rise),
    .arc_o(arc));
  always_ff @(posedge clk_i) if (write_arc) arc_q <= arc;
  assign arc_o = arc_q;
endmodule
