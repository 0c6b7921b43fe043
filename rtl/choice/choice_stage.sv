// SPDX-License-Identifier: Apache-2.0
//
// How each triangle is shaded: in auto frames by method_choice, else by the method of the frame.
// A part of shading_unit and its page; it has no page of its own.
//
//   triangle -> method_choice -> register -> triangle, choice       auto
//   triangle                              -> triangle, choice       else
//
// Timing    Auto: a triangle passes in the cycle after it was taken, at the earliest, and not
//           before the last span of the one before is taken; one triangle a cycle. Else it passes
//           at once. A limit is written while no triangle is inside.
// Streams   ready/valid.
// Formats   method_pkg.
// Error     That of method_choice.
// Model     Triangle in model/shading_clock.h, shading_unit.h   Doc  docs/units/shading_unit.md
module choice_stage
  import light_pkg::*;
  import method_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  method_e         method_i,          // of the frame; stable while busy_o
  input  lighting_e       lighting_i,

  input  logic            material_valid_i,  // writes the limit of one material
  input  material_index_t material_index_i,
  input  choice_limit_t   limit_i,

  input  logic            triangle_valid_i,
  output logic            triangle_ready_o,
  input  triangle_t       triangle_i,

  output logic            triangle_valid_o,
  input  logic            triangle_ready_i,
  output triangle_t       triangle_o,
  output choice_t         choice_o,

  output logic            ambient_o,         // a triangle leaves that no light reaches
  output logic            busy_o
);
  localparam choice_t Anything = '{method: MethodFlat, dark: 1'b0, ambient: 1'b0, channels: '1};
  choice_t frame_choice;
  always_comb begin
    frame_choice        = Anything;
    frame_choice.method = method_i;
  end

  if (Methods[MethodAuto]) begin : gen_choice
    choice_limit_t limit_mem [NumMaterials];
    choice_t       choice, choice_q;
    triangle_t     triangle_q;
    logic          is_auto, valid_q, take;
    assign is_auto = method_i == MethodAuto;

    method_choice u_method_choice (
      .range_i(triangle_i.range), .limit_i(limit_mem[triangle_i.material]), .lighting_i,
      .choice_o(choice));

    assign triangle_ready_o = is_auto ? !valid_q || triangle_ready_i : triangle_ready_i;
    assign take             = is_auto && triangle_valid_i && triangle_ready_o;
    assign triangle_valid_o = is_auto ? valid_q : triangle_valid_i;
    assign triangle_o       = is_auto ? triangle_q : triangle_i;
    assign choice_o         = is_auto ? choice_q : frame_choice;
    assign ambient_o        = valid_q && triangle_ready_i && choice_q.ambient;
    assign busy_o           = valid_q;

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) valid_q <= 1'b0;
      else         valid_q <= take || (valid_q && !triangle_ready_i);
    end
    always_ff @(posedge clk_i) begin
      if (material_valid_i) limit_mem[material_index_i] <= limit_i;
      if (take) begin
        triangle_q <= triangle_i;
        choice_q   <= choice;
      end
    end

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) begin
      assert (!(take && material_valid_i)) else $error("choice_stage: a limit changes");
    end
`endif
  end else begin : gen_none
    assign triangle_ready_o = triangle_ready_i;
    assign triangle_valid_o = triangle_valid_i;
    assign triangle_o       = triangle_i;
    assign choice_o         = frame_choice;
    assign {ambient_o, busy_o} = '0;
  end
endmodule
