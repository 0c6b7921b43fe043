// SPDX-License-Identifier: Apache-2.0
//
// Second-order surface of one channel along a span, evaluated anew for every pixel: paper 003 (2).
// Eight products a pixel, the three terms in y included: what the other forms save.
//
//   I(x, y) = A x^2 + B y^2 + C x y + D x + E y + F,  x = x(0) + Lane, moves by Lanes
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i. Two multipliers and
//           three adders in a row from the registers to code_o: no pipeline, for comparison.
// Formats   coefficients S9.26 (F with the half code for rounding), x and y S12.0, code U8.0
//           (truncate, clamp); products and sums modulo 2^36: shown values lie in -86..341.
// Error     None against the integer polynomial; coefficients rounded to 2^-27 codes move a pixel
//           by at most (x^2 + |x y| + y^2 + |x| + |y| + 1) 2^-27 codes. RTL = model on every pixel.
// Model     model/intensity/quad_polynomial.h      Doc  docs/units/intensity/quad_polynomial.md
module quad_polynomial
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lane = 0,
  parameter int unsigned Lanes = 1
) (
  input  logic           clk_i,
  input  logic           load_i,   // takes point_i
  input  logic           step_i,   // moves to the next pixel; load_i wins
  input  surface_point_t point_i,  // at lane 0
  output code_t          code_o
);
  localparam int unsigned Latency = 1;

  surface_t surface_q;
  offset_t  x_q, y_q;

  intensity_acc_t x, y;
  assign x = intensity_acc_t'(x_q);
  assign y = intensity_acc_t'(y_q);

  intensity_acc_t second_order, first_order;
  assign second_order = surface_q.a * x * x + surface_q.b * y * y + surface_q.c * x * y;
  assign first_order  = surface_q.d * x + surface_q.e * y + surface_q.f;
  assign code_o       = to_code(second_order + first_order);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      surface_q <= point_i.surface;
      x_q       <= point_i.x + offset_t'(Lane);
      y_q       <= point_i.y;
    end else if (step_i) begin
      x_q <= x_q + offset_t'(Lanes);
    end
  end
endmodule
