// SPDX-License-Identifier: Apache-2.0
//
// Row start and first difference of one second-order surface, paper 003 (9) and (3), the rows
// stepped by differences in y:
//
//   R(y)   = B y^2 + E y + F      R(y+1) = R(y) + G(y),  G(y+1) = G(y) + 2B,  G(0) = B + E
//   P(y)   = C y + D              P(y+1) = P(y) + C
//   I(x, y)             = (A x + P) x + R
//   I(x+1, y) - I(x, y) = 2 A x + A + P
//
// Two products a span with A, C and x's slope changing by row (quad), one without (gouraud), none
// for a constant (flat). A part of span_setup and its page; it has no page of its own.
//
// Timing    load_i takes a surface at its row 0; next_row_i moves a row down, load_i wins. start_i
//           takes the row and forms A x, and sees the new row where next_row_i comes with it;
//           finish_i the last product; write_i the seed. They come in this order, a cycle or more
//           apart, one span in each.
// Formats   those of the types: surfaces of intensities S9.26, of cosines S1.44; sums and products
//           keep the low bits, exact wherever the result fits.
// Gating    What the method of the span does not use holds, operands of the multipliers included.
// Error     None against the integer polynomial.
// Model     model/raster/span_setup.h      Doc  docs/units/raster/span_setup.md
module row_start
  import shading_pkg::*;
#(
  parameter type value_t = intensity_acc_t,
  parameter type surface_t = shading_pkg::surface_t,
  parameter type seed_t = channel_seed_t,
  parameter bit HasQuad = 1'b1,
  parameter bit HasGouraud = 1'b1
) (
  input  logic     clk_i,
  input  logic     is_quad_i,      // of the triangle inside
  input  logic     is_gouraud_i,

  input  logic     load_i,
  input  logic     load_quad_i,    // of the triangle that is loaded
  input  surface_t surface_i,
  input  logic     next_row_i,
  input  logic     start_i,
  input  offset_t  x_i,            // of the span's first pixel

  input  logic     run_quad_i,     // of the span that has started
  input  logic     run_gouraud_i,
  input  offset_t  run_x_i,
  input  logic     finish_i,
  input  logic     write_i,
  output seed_t    seed_o
);
  logic is_quad, is_gouraud, load_quad;
  assign load_quad  = HasQuad && load_quad_i;
  assign is_quad    = HasQuad && is_quad_i;
  assign is_gouraud = HasGouraud && is_gouraud_i;

  value_t a_q, b_q, c_q;
  value_t row_q;                   // R
  value_t row_difference_q;        // G
  value_t slope_q;                 // P
  value_t next_row;
  assign next_row = row_q + row_difference_q;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      row_q            <= surface_i.f;
      slope_q          <= surface_i.d;
      row_difference_q <= load_quad ? surface_i.b + surface_i.e : surface_i.e;
      if (load_quad) begin
        a_q <= surface_i.a;
        b_q <= surface_i.b;
        c_q <= surface_i.c;
      end
    end else if (next_row_i && (is_quad || is_gouraud)) begin
      row_q <= next_row;
      if (is_quad) begin
        row_difference_q <= row_difference_q + (b_q <<< 1);
        slope_q          <= slope_q + c_q;
      end
    end
  end

  // The row of the span that has started, and A x.
  value_t  run_row_q, run_slope_q, run_a_q, ax_q;
  offset_t x;
  assign x = is_quad ? x_i : '0;

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      run_row_q <= next_row_i && (is_quad || is_gouraud) ? next_row : row_q;
      if (is_quad || is_gouraud) begin
        run_slope_q <= next_row_i && is_quad ? slope_q + c_q : slope_q;
      end
      if (is_quad) begin
        run_a_q <= a_q;
        ax_q    <= a_q * value_t'(x);
      end
    end
  end

  logic    run_quad, run_line;
  value_t  product_q, base_q, difference_q, curvature_q, slope, first;
  offset_t run_x;
  assign run_quad = HasQuad && run_quad_i;
  assign run_line = run_quad || (HasGouraud && run_gouraud_i);
  assign run_x    = run_line ? run_x_i : '0;
  assign slope    = run_quad ? ax_q + run_slope_q : run_slope_q;
  assign first    = HasQuad || HasGouraud ? base_q + product_q : base_q;

  always_ff @(posedge clk_i) begin
    if (finish_i) begin
      product_q    <= run_line ? slope * value_t'(run_x) : '0;
      base_q       <= run_row_q;
      difference_q <= run_quad ? slope + ax_q + run_a_q : run_line ? slope : '0;
      curvature_q  <= run_quad ? run_a_q <<< 1 : '0;
    end
    if (write_i) seed_o <= '{first: first, second: first + difference_q,
                             difference: difference_q, curvature: curvature_q};
  end
endmodule
