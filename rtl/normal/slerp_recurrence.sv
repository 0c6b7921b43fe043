// SPDX-License-Identifier: Apache-2.0
//
// Spherical interpolation of one quantity along a span, paper 000 (7), (14), in Reinsch's form: the
// second difference of a sine is proportional to the sine. One multiplication per pixel.
//
//   s(t+1) = s(t) + d(t)                 d(t) = s(t+1) - s(t)
//   d(t+1) = d(t) - kappa s(t+1)         kappa = 4 sin^2(phi/2)
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i. With k lanes, lane j
//           starts at pixel j; difference and kappa span k pixels.
// Formats   seed and value S1.38; kappa U1.28 4^-p, p = 0..10. The multiplier sees s rounded half
//           up to S1.28; its product is rounded half up to S1.38. All registers wrap.
// Error     1025 ulp of 2^-28 (3.9e-6) in 2048 pixels that turn at most 90 degrees, amplitude 1,
//           seeds and kappa rounded to nearest; about t^2/4096 ulp at step t. RTL = model.
// Bad input Values outside [-2, 2) wrap. kappa >= 2 (more than 90 degrees a step) does not fit.
// Model     model/normal/slerp_recurrence.h       Doc  docs/units/normal/slerp_recurrence.md
module slerp_recurrence
  import fixed_pkg::*;
  import normal_pkg::*;
(
  input  logic           clk_i,
  input  logic           load_i,   // takes seed_i and kappa_i
  input  logic           step_i,   // moves to the next pixel; load_i wins
  input  quantity_seed_t seed_i,
  input  kappa_t         kappa_i,
  output quantity_t      value_o
);
  localparam int unsigned Latency = 1;

  // S1.28 x U1.28, signed: 30 x 30 bits. The product has 56 + 2p fraction bits.
  typedef logic signed [59:0] product_t;
  localparam int unsigned RoundingShift = 17;  // leaves one bit below S1.38, for p = 0
  localparam quantity_t   HalfOperand = quantity_t'(1 << 9);

  quantity_t value_q;              // s(t)
  quantity_t difference_q;         // d(t)
  kappa_t    kappa_q;

  assign value_o = value_q;

  quantity_t  next_value;          // s(t+1)
  s1_28_t     operand;             // s(t+1), rounded
  product_t   product;
  logic [5:0] shift;
  quantity_t  bend;                // kappa s(t+1)

  assign next_value = value_q + difference_q;
  assign operand    = s1_28_t'((next_value + HalfOperand) >>> 10);
  assign product    = product_t'(operand) * product_t'(signed'({1'b0, kappa_q.mantissa}));
  assign shift      = 6'(RoundingShift) + {1'b0, kappa_q.exponent, 1'b0};
  assign bend       = quantity_t'(((product >>> shift) + product_t'(1)) >>> 1);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      value_q      <= seed_i.first;
      difference_q <= seed_i.difference;
      kappa_q      <= kappa_i;
    end else if (step_i) begin
      value_q      <= next_value;
      difference_q <= difference_q - bend;
    end
  end
endmodule
