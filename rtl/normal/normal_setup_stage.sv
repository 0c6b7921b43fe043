// SPDX-License-Identifier: Apache-2.0
//
// Control of one stage of normal_setup: eight steps, of which the last waits for the next stage.
//
// Timing    Taken in cycle c, steps 0..7 in cycles c+1..c+8, the last held until ready_i; the stage
//           may take the next span in the cycle in which this one passes on.
// Doc       docs/units/normal/normal_setup.md
module normal_setup_stage (
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic       valid_i,
  output logic       ready_o,
  output logic       valid_o,      // the last step
  input  logic       ready_i,
  output logic       busy_o,
  output logic       take_o,       // valid_i && ready_o: load the registers of the stage
  output logic [2:0] step_o
);
  logic       busy_q;
  logic [2:0] step_q;

  assign valid_o = busy_q && step_q == 3'd7;
  assign ready_o = !busy_q || (valid_o && ready_i);
  assign take_o  = valid_i && ready_o;
  assign busy_o  = busy_q;
  assign step_o  = step_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) busy_q <= 1'b0;
    else         busy_q <= take_o || (busy_q && !(valid_o && ready_i));
  end
  always_ff @(posedge clk_i) begin
    if (take_o)                          step_q <= '0;
    else if (busy_q && step_q != 3'd7)   step_q <= step_q + 3'd1;
  end
endmodule
