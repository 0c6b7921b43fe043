// SPDX-License-Identifier: Apache-2.0
//
// Phong's method with its strength reduced, Duff 1979: for light and viewer at infinity, N.L and
// N.H of the linear normal M are linear along the span and q = |M|^2 is quadratic. One reciprocal
// square root and two products normalise both cosines; the normal itself is not needed.
//
//   N.L = M.L / sqrt(q),   N.H = M.H / sqrt(q)
//
// Timing    Latency 9 cycles, 1 pixel per cycle, never stalls.
// Formats   M.L, M.H S1.38; q S1.44; cosines S1.30, rounded to nearest, saturated. M.L 2^exponent
//           is truncated to S2.30, saturated, before the product.
// Error     < 87.2 ulp of S1.30 (2^-23.5) for |M.L|, |M.H| <= sqrt(q), q as given; an error dq of q
//           adds dq / (2 q).
// Bad input q <= 0 gives 0; cosines beyond the range saturate.
// Model     model/normal/duff_normalizer.h      Doc  docs/units/normal/duff_normalizer.md
module duff_normalizer
  import fixed_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic       valid_i,
  input  quantity_t  n_dot_l_i,
  input  quantity_t  n_dot_h_or_v_i,
  input  length_sq_t length_sq_i,
  output logic       valid_o,
  output cosines_t   cosines_o
);
  localparam int unsigned Latency = 9;
  localparam int unsigned Rooted = 6;            // cycles of reciprocal_sqrt

  typedef logic signed [32:0] scaled_t;          // S2.30
  typedef logic signed [57:0] product_t;         // S3.54

  typedef struct packed {
    quantity_t n_dot_l;
    quantity_t n_dot_h_or_v;
  } pair_t;

  logic [Latency-1:0] valid_q;

  pair_t            pair_q [Rooted];
  scaled_t          scaled_l_q, scaled_h_q;
  u1_24_t           mantissa_q;
  product_t         product_l_q, product_h_q;
  cosines_t         cosines_q;
  reciprocal_sqrt_t root;
  logic             root_valid;

  // S1.38 times 2^exponent -> S2.30: truncates, saturates.
  function automatic scaled_t scale(quantity_t quantity, logic [4:0] exponent);
    logic signed [53:0] wide;                    // S23.30
    wide = 54'((62'(quantity) <<< exponent) >>> 8);
    if (wide[53:32] == {22{wide[53]}}) scale = wide[32:0];
    else                               scale = {wide[53], {32{!wide[53]}}};
  endfunction

  // S3.54 -> S1.30: rounds halves up, saturates.
  function automatic cosine_t round(product_t product);
    logic signed [33:0] rounded;                 // S3.30
    rounded = 34'((product + 58'sd8388608) >>> 24);
    if (rounded[33:31] == {3{rounded[33]}}) round = rounded[31:0];
    else                                    round = {rounded[33], {31{!rounded[33]}}};
  endfunction

  reciprocal_sqrt u_reciprocal_sqrt (
    .clk_i,
    .rst_ni,
    .valid_i,
    .length_sq_i (length_sq_i[45] ? '0 : u2_44_t'(length_sq_i)),
    .valid_o     (root_valid),
    .root_o      (root)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) pair_q[0] <= '{n_dot_l: n_dot_l_i, n_dot_h_or_v: n_dot_h_or_v_i};
    for (int unsigned i = 1; i < Rooted; ++i) begin
      if (valid_q[i-1]) pair_q[i] <= pair_q[i-1];
    end
    if (root_valid) begin
      scaled_l_q <= scale(pair_q[Rooted-1].n_dot_l, root.exponent);
      scaled_h_q <= scale(pair_q[Rooted-1].n_dot_h_or_v, root.exponent);
      mantissa_q <= root.mantissa;
    end
    if (valid_q[Rooted]) begin
      product_l_q <= 58'(scaled_l_q) * signed'(58'(mantissa_q));
      product_h_q <= 58'(scaled_h_q) * signed'(58'(mantissa_q));
    end
    if (valid_q[Rooted+1]) begin
      cosines_q <= '{n_dot_l: round(product_l_q), n_dot_h_or_v: round(product_h_q)};
    end
  end

  assign valid_o   = valid_q[Latency-1];
  assign cosines_o = cosines_q;
endmodule
