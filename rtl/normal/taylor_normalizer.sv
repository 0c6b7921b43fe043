// SPDX-License-Identifier: Apache-2.0
//
// Lyon's normalisation of a pixel, paper 000: three terms of the Taylor series of 1/sqrt(q) at 1,
// for normals that are almost unit. No reciprocal square root.
//
//   N = M (1 - (q - 1)/2 + 3/8 (q - 1)^2),   q = M.M
//
// Timing    Latency 5 cycles, 1 normal per cycle, never stalls.
// Formats   M S1.38, truncated to S1.30; q - 1 S0.28, truncated; factor U1.27 and N S1.24, rounded
//           to nearest.
// Error     < 0.67 ulp of S1.24 to the polynomial, for |M| <= 1 + 2^-9. The polynomial is short of
//           unit length by 5/16 (1 - q)^3 + ...: see the doc page.
// Bad input q >= 2 counts as 2.
// Model     model/normal/taylor_normalizer.h      Doc  docs/units/normal/taylor_normalizer.md
module taylor_normalizer
  import fixed_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
(
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           valid_i,
  input  quantity_t     [Components-1:0] normal_i,
  output logic                           valid_o,
  output pixel_normal_t [Components-1:0] normal_o
);
  localparam int unsigned Latency = 5;
  localparam int unsigned Factored = 3;          // cycles from normal_i to the factor

  logic [Latency-1:0] valid_q;

  span_normal_t [Components-1:0]      normal_q [Factored];
  logic [Components-1:0][62:0]        square_q;          // U3.60
  logic signed [28:0]                 excess_q;          // q - 1, S0.28
  logic [27:0]                        factor_q;          // U1.27
  logic signed [Components-1:0][59:0] product_q;         // S2.57
  pixel_normal_t [Components-1:0]     unit_q;

  // q U4.60 -> q - 1 S0.28: saturates, truncates.
  function automatic logic signed [28:0] excess_of(logic [63:0] length_sq);
    if (length_sq[63:61] != '0) excess_of = 29'sh0fff_ffff;
    else                        excess_of = {~length_sq[60], length_sq[59:32]};
  endfunction

  // (8 - 4 d + 3 d^2) / 8 in U1.59 -> U1.27: rounds halves up.
  function automatic logic [27:0] factor_of(logic signed [28:0] excess);
    logic signed [60:0] sum;
    sum = (61'sd8 <<< 56) - (61'(excess) <<< 30) + 61'sd3 * 61'(excess) * 61'(excess);
    factor_of = 28'((sum + 61'sd2147483648) >>> 32);
  endfunction

  // S2.57 -> S1.24: rounds halves up.
  function automatic pixel_normal_t round(logic signed [59:0] product);
    round = 26'((product + 60'sd4294967296) >>> 33);
  endfunction

  logic [63:0] length_sq;                                // U4.60
  assign length_sq = 64'(square_q[0]) + 64'(square_q[1]) + 64'(square_q[2]);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < Components; ++i) begin
      if (valid_i)    normal_q[0][i] <= quantity_to_span_normal(normal_i[i]);
      if (valid_i)    square_q[i]    <= square_of(quantity_to_span_normal(normal_i[i]));
      if (valid_q[2]) product_q[i]   <= 60'(signed'(normal_q[2][i])) * signed'(60'(factor_q));
      if (valid_q[3]) unit_q[i]      <= round(product_q[i]);
    end
    if (valid_q[0]) normal_q[1] <= normal_q[0];
    if (valid_q[1]) normal_q[2] <= normal_q[1];
    if (valid_q[0]) excess_q    <= excess_of(length_sq);
    if (valid_q[1]) factor_q    <= factor_of(excess_q);
  end

  assign valid_o  = valid_q[Latency-1];
  assign normal_o = unit_q;
endmodule
