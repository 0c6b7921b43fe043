// SPDX-License-Identifier: Apache-2.0
//
// A quadratic along a span by forward differences, two additions a step: what quad_difference,
// quad_split, quad_cosine and length_recurrence share. A part of their pages; it has none of its own.
//
//   v(t+1) = v(t) + d(t),  d(t+1) = d(t) + c          paper 003 (3) with its slope kept
//
// Timing    value_o is v(0) in the cycle after load_i, and moves on in the cycle after step_i.
// Formats   value_t, a signed fixed-point number; sums wrap and come back exactly.
// Error     None: the errors are those of the seeds.
// Model     model/intensity/second_difference.h
module second_difference
  import shading_pkg::*;
#(
  parameter type value_t = intensity_acc_t
) (
  input  logic   clk_i,
  input  logic   load_i,        // takes the three below
  input  logic   step_i,        // moves to the next pixel; load_i wins
  input  value_t first_i,       // v(0)
  input  value_t difference_i,  // v(1) - v(0)
  input  value_t curvature_i,   // c
  output value_t value_o
);
  value_t value_q, difference_q, curvature_q;

  assign value_o = value_q;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      value_q      <= first_i;
      difference_q <= difference_i;
      curvature_q  <= curvature_i;
    end else if (step_i) begin
      value_q      <= value_q + difference_q;
      difference_q <= difference_q + curvature_q;
    end
  end
endmodule
