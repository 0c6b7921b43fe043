// SPDX-License-Identifier: Apache-2.0
//
// Faithful reciprocal square root of a squared length, by a table of quadratics: no division and
// no recurrence of digits.
//
//   1/sqrt(q) = mantissa 2^exponent,  x = q 4^exponent in [1, 4),  mantissa = 1/sqrt(x)
//   mantissa  = value - (slope - curvature t) t    on each of 256 segments of x
//
// Timing    Latency 6 cycles, 1 value per cycle, never stalls.
// Formats   q U2.44; mantissa U1.24 in [1/2, 1], rounded to nearest, exponent 0..22. t is U0.20 and
//           drops the bits of x beyond; the slope is truncated to 28 fraction bits.
// Error     < 0.77 ulp of U1.24 for every q > 0; found 0.67 (every segment, every t).
// Bad input q = 0 gives the mantissa 0, and exponent 22: what is scaled by it becomes 0.
// Model     model/normal/reciprocal_sqrt.h      Doc  docs/units/normal/reciprocal_sqrt.md
module reciprocal_sqrt
  import fixed_pkg::*;
  import normal_pkg::*;
(
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  input  u2_44_t           length_sq_i,
  output logic             valid_o,
  output reciprocal_sqrt_t root_o
);
  localparam int unsigned Latency = 6;

  typedef struct packed {
    u2_44_t     length_sq;
    logic [4:0] exponent;
  } counted_t;

  typedef struct packed {
    logic [4:0]  exponent;
    logic        zero;
    logic [7:0]  index;              // segment of x
    logic [19:0] t;                  // place in it
  } located_t;

  typedef struct packed {
    logic [4:0]  exponent;
    logic        zero;
    logic [19:0] t;
  } place_t;

  typedef struct packed {
    logic [4:0]  exponent;
    logic        zero;
    u1_28_t      value;
    logic [20:0] slope;
    logic [19:0] t;
  } sloped_t;

  typedef struct packed {
    logic [4:0]  exponent;
    logic        zero;
    u1_28_t      value;
    logic [40:0] descent;            // slope t, 48 fraction bits
  } descended_t;

  logic [Latency-1:0] valid_q;
  counted_t           counted_q;
  located_t           located_q;
  place_t             place_q;
  root_coefficients_t coefficients_q;
  sloped_t            sloped_q;
  descended_t         descended_q;
  reciprocal_sqrt_t   root_q;

  // Pairs of zeros before the highest one bit.
  logic [4:0] exponent;
  always_comb begin
    exponent = 5'd22;
    for (int unsigned pair = 0; pair < 23; ++pair) begin
      if (length_sq_i[2*pair+:2] != '0) exponent = 5'(22 - pair);
    end
  end

  // q 4^exponent, U2.44; a one in bit 45 puts x into [2, 4).
  u2_44_t x;
  assign x = counted_q.length_sq << {counted_q.exponent, 1'b0};

  logic        upper;
  logic [26:0] place;                // segment of its half, t
  assign upper = x[45];
  assign place = upper ? x[44:18] : x[43:17];

  // curvature t by the 14 high bits of t; 28 + 14 fraction bits.
  logic [26:0] bend;
  assign bend = coefficients_q.curvature * place_q.t[19:6];

  // value - slope t and half an ulp of U1.24; U1.48.
  logic [48:0] rounded;
  assign rounded = {descended_q.value, 20'h0} - 49'(descended_q.descent) + 49'h80_0000;

  reciprocal_sqrt_table u_table (
    .clk_i,
    .enable_i       (valid_q[1]),
    .index_i        (located_q.index),
    .coefficients_o (coefficients_q)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (valid_i)    counted_q <= '{length_sq: length_sq_i, exponent: exponent};
    if (valid_q[0]) begin
      located_q <= '{exponent: counted_q.exponent, zero: counted_q.length_sq == '0,
                     index: {upper, place[26:20]}, t: place[19:0]};
    end
    if (valid_q[1]) begin
      place_q <= '{exponent: located_q.exponent, zero: located_q.zero, t: located_q.t};
    end
    if (valid_q[2]) begin
      sloped_q <= '{exponent: place_q.exponent, zero: place_q.zero, t: place_q.t,
                    value: coefficients_q.value,
                    slope: coefficients_q.slope - 21'(bend[26:14])};
    end
    if (valid_q[3]) begin
      descended_q <= '{exponent: sloped_q.exponent, zero: sloped_q.zero, value: sloped_q.value,
                       descent: sloped_q.slope * sloped_q.t};
    end
    if (valid_q[4]) begin
      root_q.mantissa <= descended_q.zero ? '0 : rounded[48:24];
      root_q.exponent <= descended_q.exponent;
    end
  end

  assign valid_o = valid_q[Latency-1];
  assign root_o  = root_q;
endmodule
