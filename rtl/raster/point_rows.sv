// SPDX-License-Identifier: Apache-2.0
//
// Coefficients of one channel and the span's first pixel, for the forms that evaluate the
// polynomial itself. A part of span_setup and its page; it has no page of its own.
//
// Timing    Strobes as in row_start, given only for quad-polynomial and quad-horner.
// Formats   shading_pkg.
// Error     None.
// Model     model/raster/span_setup.h      Doc  docs/units/raster/span_setup.md
module point_rows
  import shading_pkg::*;
(
  input  logic           clk_i,
  input  logic           load_i,     // takes a surface
  input  surface_t       surface_i,
  input  logic           start_i,
  input  logic           finish_i,
  input  logic           write_i,
  input  offset_t        x_i,        // of the span's first pixel
  input  offset_t        y_i,
  output surface_point_t point_o
);
  surface_t       surface_q;
  surface_point_t run_point_q, sum_point_q;
  always_ff @(posedge clk_i) begin
    if (load_i)   surface_q   <= surface_i;
    if (start_i)  run_point_q <= '{surface: surface_q, x: x_i, y: y_i};
    if (finish_i) sum_point_q <= run_point_q;
    if (write_i)  point_o     <= sum_point_q;
  end
endmodule
