// SPDX-License-Identifier: Apache-2.0
//
// The methods that interpolate intensities, for every lane and channel: no light per pixel.
//
//   seed -> lane_seed -> one unit a method -> code
//   seed ->              flat_color -> code
//   point ->             quad_polynomial | quad_horner -> code
//
// Timing    Latency 1 cycle from load_i to the codes of the first pixels, then Lanes per step_i.
// Formats   seeds S9.26, codes U8.0.
// Error     That of the unit in use. Lanes show the same codes as one lane does; quad-segment's
//           lanes have their own segments, each within the tolerance.
// Model     ShadeSpan in model/shading_unit.cpp      Doc  docs/units/shading_unit.md
module surface_shader
  import light_pkg::*;
  import method_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = IntensityMethods,
  parameter int unsigned Lanes = 1
) (
  input  logic       clk_i,
  input  tolerance_t tolerance_i,    // stable while pixels are inside
  input  choice_t    choice_i,       // of the span that starts, at load_i
  input  logic       load_i,
  input  logic       step_i,
  input  channel_seed_t  [Channels-1:0] seed_i,
  input  split_seed_t    [Channels-1:0] split_i,
  input  surface_point_t [Channels-1:0] point_i,
  output code_t [Lanes-1:0][Channels-1:0] code_o
);
  localparam int unsigned Latency = 1;

  // The method of the span that starts and of the one inside, of those that are built.
  choice_t  choice_q;
  methods_t starts, active;
  for (genvar m = 0; m < NumMethods; m++) begin : gen_active
    assign starts[m] = is_method(Methods, choice_i.method, method_e'(m));
    assign active[m] = is_method(Methods, choice_q.method, method_e'(m));
  end
  always_ff @(posedge clk_i) if (load_i) choice_q <= choice_i;

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    for (genvar ch = 0; ch < Channels; ch++) begin : gen_channel
      channel_seed_t         curve;
      code_t [NumMethods-1:0] code;  // by method

      lane_seed #(.Lane(lane), .Lanes(Lanes)) u_lane_seed (.seed_i(seed_i[ch]), .seed_o(curve));

      for (genvar m = 0; m < NumMethods; m++) begin : gen_method
        logic load, step;
        assign load = load_i && starts[m] && choice_i.channels[ch];
        assign step = step_i && active[m] && choice_q.channels[ch];
        if (!Methods[m]) begin : gen_none
          assign code[m] = '0;
        end else if (m == MethodFlat) begin : gen_flat
          flat_color u_flat_color (.clk_i, .load_i(load), .seed_i(seed_i[ch]), .code_o(code[m]));
        end else if (m == MethodGouraud) begin : gen_gouraud
          gouraud_interpolator u_gouraud_interpolator (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else if (m == MethodQuad || m == MethodQuadFootprint) begin : gen_quad
          quad_surface u_quad_surface (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else if (m == MethodQuadPolynomial) begin : gen_polynomial
          quad_polynomial #(.Lane(lane), .Lanes(Lanes)) u_quad_polynomial (
            .clk_i, .load_i(load), .step_i(step), .point_i(point_i[ch]), .code_o(code[m]));
        end else if (m == MethodQuadHorner) begin : gen_horner
          quad_horner #(.Lane(lane), .Lanes(Lanes)) u_quad_horner (
            .clk_i, .load_i(load), .step_i(step), .point_i(point_i[ch]), .code_o(code[m]));
        end else if (m == MethodQuadStep) begin : gen_step
          quad_step u_quad_step (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else if (m == MethodQuadMidpoint) begin : gen_midpoint
          quad_midpoint u_quad_midpoint (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else if (m == MethodQuadThreeTerm) begin : gen_three_term
          quad_three_term u_quad_three_term (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else if (m == MethodQuadThirdDifference) begin : gen_third_difference
          quad_third_difference u_quad_third_difference (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else if (m == MethodQuadSegment) begin : gen_segment
          quad_segment u_quad_segment (
            .clk_i, .load_i(load), .step_i(step), .tolerance_i,
            .seed_i(load ? curve : '0), .code_o(code[m]));
        end else if (m == MethodQuadDifference) begin : gen_difference
          quad_difference u_quad_difference (
            .clk_i, .load_i(load), .step_i(step), .seed_i(curve), .code_o(code[m]));
        end else begin : gen_split
          channel_seed_t highlight;
          lane_seed #(.Lane(lane), .Lanes(Lanes)) u_specular_lane_seed (
            .seed_i(split_i[ch].specular), .seed_o(highlight));
          quad_split u_quad_split (
            .clk_i, .load_i(load), .step_i(step), .diffuse_i(curve),
            .split_i('{specular: highlight, ambient: split_i[ch].ambient}), .code_o(code[m]));
        end
      end

      always_comb begin
        code_o[lane][ch] = '0;
        for (int m = 0; m < NumMethods; m++) begin
          if (active[m] && choice_q.channels[ch]) code_o[lane][ch] = code[m];
        end
      end
    end
  end
endmodule
