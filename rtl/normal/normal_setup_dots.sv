// SPDX-License-Identifier: Apache-2.0
//
// First stage of normal_setup: dot products, one a step on three multipliers.
//
//   |Nb-Na|^2, Na.L, Nb.L, Na.H, Nb.H, |Na|^2, Na.(Nb-Na)
//
// Timing    Step k forms the products of dot k, step k+1 adds them; dots_o in step 7.
// Formats   normals S1.30, L and H S1.22; sums exact, modulo 2^64, then rounded half up once:
//           cosines S1.38, |Na|^2 S1.44, Na.(Nb-Na) S2.37, |Nb-Na|^2 U3.38 / 2 and S3.36.
// Model     model/normal/normal_setup.cpp          Doc  docs/units/normal/normal_setup.md
module normal_setup_dots
  import light_pkg::*;
  import normal_pkg::*;
(
  input  logic        clk_i,
  input  setup_kind_t kind_i,
  input  light_t      light_i,
  input  logic        take_i,
  input  logic [2:0]  step_i,
  input  span_normal_t [1:0][Components-1:0] normal_i,
  output quantity_t [1:0][2:0] end_o,        // quantities at the ends of the span
  output logic [40:0]        delta_o,        // |Nb-Na|^2 / 2, U3.38
  output logic signed [39:0] square_o,       // |Nb-Na|^2, S3.36
  output logic signed [39:0] along_o,        // Na.(Nb-Na), S2.37
  output length_sq_t         length_o        // |Na|^2
);
  typedef logic signed [32:0] factor_t;

  span_normal_t [1:0][Components-1:0] normal_q;
  logic signed [Components-1:0][63:0] product_q;
  logic        [63:0] sum;
  logic        [63:0] chord_q;               // |Nb-Na|^2, U4.60
  quantity_t [1:0][1:0] cosine_q;
  length_sq_t length_q;

  for (genvar i = 0; i < Components; i++) begin : gen_component
    factor_t chord, first, left, right, light, half_or_view;
    assign first        = factor_t'(signed'(normal_q[0][i]));
    assign chord        = factor_t'(signed'(normal_q[1][i])) - first;
    assign light        = factor_t'(signed'(light_i.light[i]));
    assign half_or_view = factor_t'(signed'(light_i.half_or_view[i]));
    always_comb begin
      case (step_i)
        3'd0:       {left, right} = {chord, chord};
        3'd1:       {left, right} = {first, light};
        3'd2:       {left, right} = {factor_t'(signed'(normal_q[1][i])), light};
        3'd3:       {left, right} = {first, half_or_view};
        3'd4:       {left, right} = {factor_t'(signed'(normal_q[1][i])), half_or_view};
        3'd5:       {left, right} = {first, first};
        default:    {left, right} = {first, chord};
      endcase
    end
    always_ff @(posedge clk_i) begin
      if (step_i != 3'd7) product_q[i] <= 64'(left) * 64'(right);
    end
    assign end_o[0][i] = kind_i.cosines ? (i == 2 ? '0 : cosine_q[0][i % 2])
                                        : quantity_t'({normal_q[0][i], 8'd0});
    assign end_o[1][i] = kind_i.cosines ? (i == 2 ? '0 : cosine_q[1][i % 2])
                                        : quantity_t'({normal_q[1][i], 8'd0});
  end

  assign sum      = product_q[0] + product_q[1] + product_q[2];
  assign delta_o  = 41'((65'(chord_q) + (65'd1 << 22)) >> 23);
  assign square_o = 40'((65'(chord_q) + (65'd1 << 23)) >> 24);
  assign along_o  = 40'((65'(signed'(sum)) + (65'sd1 <<< 22)) >>> 23);
  assign length_o = length_q;

  quantity_t cosine;                         // 52 fraction bits rounded to 38
  assign cosine = quantity_t'((sum + (64'd1 << 13)) >> 14);

  always_ff @(posedge clk_i) begin
    if (take_i) normal_q <= normal_i;
    case (step_i)
      3'd1:    chord_q        <= sum;
      3'd2:    cosine_q[0][0] <= cosine;
      3'd3:    cosine_q[1][0] <= cosine;
      3'd4:    cosine_q[0][1] <= cosine;
      3'd5:    cosine_q[1][1] <= cosine;
      3'd6:    length_q       <= length_sq_t'((sum + (64'd1 << 15)) >> 16);
      default: ;
    endcase
  end
endmodule
