// SPDX-License-Identifier: Apache-2.0
//
// Phong's normalisation of a pixel: the linearly interpolated normal divided by its length. The
// baseline that paper 000 compares with.
//
//   N = M / |M|,   1/|M| = reciprocal_sqrt(M.M)
//
// Timing    Latency 11 cycles, 1 normal per cycle, never stalls.
// Formats   M S1.38 (squared in S1.30, truncated; M.M U2.44, truncated), N S1.24, rounded to nearest.
//           M 2^exponent, of length [1, 2), is truncated to S2.28 before the products.
// Error     Direction < 2^-24 for every |M| >= 2^-9; length < 2^-22.7 + 2^-29.1 / |M|; component
//           < 2.15 ulp of S1.24 for |M| >= 1/8.
// Bad input |M| < 2^-22 gives N = 0; |M| >= 2 counts as 2.
// Model     model/normal/phong_direct.h      Doc  docs/units/normal/phong_direct.md
module phong_direct
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
  localparam int unsigned Latency = 11;
  localparam int unsigned Squared = 2;           // cycles from normal_i to M.M
  localparam int unsigned Rooted = Squared + 6;  // and to its reciprocal square root

  logic [Latency-1:0] valid_q;

  quantity_t [Components-1:0]             normal_q [Rooted];
  logic      [Components-1:0][62:0]       square_q;      // U3.60
  u2_44_t                                 length_sq_q;
  logic signed [Components-1:0][30:0]     scaled_q;      // M 2^exponent, S2.28
  u1_24_t                                 mantissa_q;
  logic signed [Components-1:0][56:0]     product_q;     // S4.52
  pixel_normal_t [Components-1:0]         unit_q;
  reciprocal_sqrt_t                       root;
  logic                                   root_valid;

  // S1.38 times 2^exponent -> S2.28.
  function automatic logic signed [30:0] scale(quantity_t quantity, logic [4:0] exponent);
    scale = 31'((62'(quantity) <<< exponent) >>> 10);
  endfunction

  // S4.52 -> S1.24: rounds halves up.
  function automatic pixel_normal_t round(logic signed [56:0] product);
    round = 26'((product + 57'sd134217728) >>> 28);
  endfunction

  // U4.60 -> U2.44: truncates, saturates.
  logic [63:0] length_sq;
  assign length_sq = 64'(square_q[0]) + 64'(square_q[1]) + 64'(square_q[2]);

  reciprocal_sqrt u_reciprocal_sqrt (
    .clk_i,
    .rst_ni,
    .valid_i     (valid_q[Squared-1]),
    .length_sq_i (length_sq_q),
    .valid_o     (root_valid),
    .root_o      (root)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) normal_q[0] <= normal_i;
    for (int unsigned i = 1; i < Rooted; ++i) begin
      if (valid_q[i-1]) normal_q[i] <= normal_q[i-1];
    end
  end

  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < Components; ++i) begin
      if (valid_i)           square_q[i]  <= square_of(quantity_to_span_normal(normal_i[i]));
      if (root_valid)        scaled_q[i]  <= scale(normal_q[Rooted-1][i], root.exponent);
      if (valid_q[Rooted])   product_q[i] <= 57'(scaled_q[i]) * signed'(57'(mantissa_q));
      if (valid_q[Rooted+1]) unit_q[i]    <= round(product_q[i]);
    end
    if (valid_q[0]) length_sq_q <= length_sq[63:62] != '0 ? '1 : length_sq[61:16];
    if (root_valid) mantissa_q  <= root.mantissa;
  end

  assign valid_o  = valid_q[Latency-1];
  assign normal_o = unit_q;
endmodule
