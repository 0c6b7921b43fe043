// SPDX-License-Identifier: Apache-2.0
//
// Control of normal_setup and slerp_direct_setup: Stages stages of eight steps, and the register
// from which the result is on offer. Carries each span's run along.
//
// Timing    Latency 8 Stages + 1 cycles, a span every 8 cycles. write_o: the last stage passes on.
// Model     model/normal/stage_clock.h      Doc  docs/units/normal/normal_setup.md
module normal_setup_control
  import shading_pkg::*;
#(
  parameter int unsigned Stages = 4
) (
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     valid_i,
  output logic     ready_o,
  input  lit_run_t run_i,

  output logic     valid_o,
  input  logic     ready_i,
  output lit_run_t run_o,

  output logic [Stages-1:0]      take_o,     // load the registers of a stage
  output logic [Stages-1:0][2:0] step_o,
  output lit_run_t [Stages-1:0]  stage_run_o,  // of the span in each stage
  output logic                   write_o,    // load the register of the result
  output logic                   busy_o      // a span is inside or its result waits
);
  logic [Stages:0]     valid, ready;         // between stages; [Stages]: the register
  logic [Stages-1:0]   busy;
  lit_run_t [Stages:0] run_q;
  logic                valid_q;

  assign valid[0]      = valid_i;
  assign ready_o       = ready[0];
  assign ready[Stages] = !valid_q || ready_i;
  assign write_o       = valid[Stages] && ready[Stages];
  assign valid_o       = valid_q;
  assign run_o         = run_q[Stages];
  assign stage_run_o   = run_q[Stages-1:0];
  assign busy_o        = (|busy) || valid_q;

  for (genvar i = 0; i < Stages; i++) begin : gen_stage
    normal_setup_stage u_stage (
      .clk_i, .rst_ni, .valid_i(valid[i]), .ready_o(ready[i]), .valid_o(valid[i+1]),
      .ready_i(ready[i+1]), .busy_o(busy[i]), .take_o(take_o[i]), .step_o(step_o[i]));
    always_ff @(posedge clk_i) begin
      if (take_o[i]) run_q[i] <= i == 0 ? run_i : run_q[i == 0 ? 0 : i - 1];
    end
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else         valid_q <= write_o || (valid_q && !ready_i);
  end
  always_ff @(posedge clk_i) if (write_o) run_q[Stages] <= run_q[Stages-1];
endmodule
