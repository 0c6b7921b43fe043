// SPDX-License-Identifier: Apache-2.0
//
// The methods that interpolate intensities, for every lane and channel: no light per pixel.
//
//   seed -> lane_seed -> flat_color | gouraud_interpolator | quad_surface -> code
//
// Timing    Latency 1 cycle from load_i to the codes of the first pixels, then Lanes per step_i.
// Formats   seeds S9.26, codes U8.0.
// Error     That of the unit in use. Lanes show the same codes as one lane does.
// Model     ShadeSpan in model/shading_unit.cpp      Doc  docs/units/shading_unit.md
module surface_shader
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = SurfaceMethods,
  parameter int unsigned Lanes = 1
) (
  input  logic    clk_i,
  input  method_e method_i,          // stable while pixels are inside
  input  logic    load_i,
  input  logic    step_i,
  input  channel_seed_t [Channels-1:0] seed_i,
  output code_t [Lanes-1:0][Channels-1:0] code_o
);
  localparam int unsigned Latency = 1;

  logic is_flat, is_gouraud, is_quad;
  assign is_flat    = is_method(Methods, method_i, MethodFlat);
  assign is_gouraud = is_method(Methods, method_i, MethodGouraud);
  assign is_quad    = is_method(Methods, method_i, MethodQuad);

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    for (genvar ch = 0; ch < Channels; ch++) begin : gen_channel
      code_t flat_code, gouraud_code, quad_code;

      if (Methods[MethodFlat]) begin : gen_flat
        flat_color u_flat_color (
          .clk_i, .load_i(load_i && is_flat), .seed_i(seed_i[ch]), .code_o(flat_code));
      end else begin : gen_no_flat
        assign flat_code = '0;
      end

      if (Methods[MethodGouraud]) begin : gen_gouraud
        channel_seed_t line, lane_line;
        assign line = '{first: seed_i[ch].first, second: '0,
                        difference: seed_i[ch].difference, curvature: '0};
        lane_seed #(.Lane(lane), .Lanes(Lanes)) u_lane_seed (.seed_i(line), .seed_o(lane_line));
        gouraud_interpolator u_gouraud_interpolator (
          .clk_i, .load_i(load_i && is_gouraud), .step_i(step_i && is_gouraud),
          .seed_i(lane_line), .code_o(gouraud_code));
      end else begin : gen_no_gouraud
        assign gouraud_code = '0;
      end

      if (Methods[MethodQuad]) begin : gen_quad
        channel_seed_t lane_curve;
        lane_seed #(.Lane(lane), .Lanes(Lanes)) u_lane_seed (
          .seed_i(seed_i[ch]), .seed_o(lane_curve));
        quad_surface u_quad_surface (
          .clk_i, .load_i(load_i && is_quad), .step_i(step_i && is_quad),
          .seed_i(lane_curve), .code_o(quad_code));
      end else begin : gen_no_quad
        assign quad_code = '0;
      end

      assign code_o[lane][ch] = is_quad ? quad_code : is_gouraud ? gouraud_code : flat_code;
    end
  end
endmodule
