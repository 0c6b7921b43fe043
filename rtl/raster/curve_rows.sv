// SPDX-License-Identifier: Apache-2.0
//
// Row starts of the cosines' surfaces: N.L, N.H or N.V, and |N|^2 for phong-surface; N.H of a dark
// triangle and what the method does not use hold. A part of span_setup and its page; it has no page
// of its own.
//
// Timing    Strobes as in row_start; the material leaves with the seed.
// Formats   S1.44.
// Error     None against the integer polynomial.
// Model     model/raster/span_setup.h      Doc  docs/units/raster/span_setup.md
module curve_rows
  import light_pkg::*;
  import method_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods & SurfaceMethods
) (
  input  logic    clk_i,
  input  choice_t load_choice_i,   // of the triangle that is taken, of the one inside, of the span
  input  choice_t choice_i,        // that has started, and of the one whose seed is due
  input  choice_t run_choice_i,
  input  choice_t sum_choice_i,

  input  logic                         load_i,
  input  cosine_surface_t [Curves-1:0] curve_i,
  input  material_index_t              material_i,
  input  logic                         next_row_i,
  input  logic                         start_i,
  input  offset_t                      x_i,
  input  logic                         finish_i,
  input  offset_t                      run_x_i,
  input  logic                         write_i,
  output curve_seed_t [Curves-1:0]     curve_o,
  output material_index_t              material_o
);
  localparam bit HasSquare = Methods[MethodPhongSurface];

  function automatic logic [Curves-1:0] used(choice_t choice);
    used[0] = is_any_of(Methods, choice.method, CurveMethods);
    used[1] = used[0] && !choice.dark;
    used[2] = is_method(Methods, choice.method, MethodPhongSurface);
  endfunction
  logic [Curves-1:0] loads, moves, runs, writes;
  assign loads  = used(load_choice_i);
  assign moves  = used(choice_i);
  assign runs   = used(run_choice_i);
  assign writes = used(sum_choice_i);

  for (genvar i = 0; i < Curves; i++) begin : gen_curve
    if (i < 2 || HasSquare) begin : gen_rows
      row_start #(.value_t(cosine_acc_t), .surface_t(cosine_surface_t), .seed_t(curve_seed_t),
                  .HasGouraud(1'b0))
      u_row_start (
        .clk_i, .is_quad_i(moves[i]), .is_gouraud_i(1'b0),
        .load_i(load_i && loads[i]), .load_quad_i(1'b1),
        .surface_i(curve_i[i]), .next_row_i, .start_i(start_i && moves[i]), .x_i,
        .run_quad_i(runs[i]), .run_gouraud_i(1'b0), .run_x_i,
        .finish_i(finish_i && runs[i]), .write_i(write_i && writes[i]),
        .seed_o(curve_o[i]));
    end else begin : gen_none
      assign curve_o[i] = '0;
    end
  end

  material_index_t material_q, run_material_q, sum_material_q;
  always_ff @(posedge clk_i) begin
    if (load_i && loads[0])   material_q     <= material_i;
    if (start_i && moves[0])  run_material_q <= material_q;
    if (finish_i && runs[0])  sum_material_q <= run_material_q;
    if (write_i && writes[0]) material_o     <= sum_material_q;
  end
endmodule
