// SPDX-License-Identifier: Apache-2.0
//
// Span set-up of the methods that interpolate along a surface: row start and first difference of
// three channels, of six for quad-split, of two cosines for quad-cosine, of these and of |N|^2 for
// phong-surface.
//
//   quad ...  I = (Ax + P) x + R, rows by differences   paper 003 (9), (3): 2 products; row_start
//   gouraud   I = D x + R,  R = E y + F                 1 product
//   flat      I = F                                     none
//   quad-polynomial, quad-horner: the coefficients and the pixel themselves
//
// Timing    A span starts, finishes and is summed up in a cycle each, one span after the other. It
//           waits until its row is reached: `rows` below the span before it, 0 for the first of its
//           triangle, it has max(1, rows) steps, 1 where there are no rows. A seed is on offer
//           steps + 3 cycles after its span was taken; the initiation interval is steps cycles.
//           ready/valid on all ports. A span is never taken before its triangle; a triangle leaves
//           with the last step of its last span.
// Formats   intensities S9.26, cosines S1.44, coordinates S12.0 from the triangle's origin;
//           products keep the low bits. Exact whenever the result fits.
// Error     None against the integer polynomial. RTL = model on every seed.
// Bad input A span above the one before it, and one of 0 pixels, stop the simulation.
// Model     model/raster/span_setup.h      Doc  docs/units/raster/span_setup.md
module span_setup
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods & SurfaceMethods
) (
  input  logic      clk_i,
  input  logic      rst_ni,
  input  logic      triangle_valid_i,
  output logic      triangle_ready_o,
  input  triangle_t triangle_i,
  input  choice_t   choice_i,     // of the triangle

  input  logic      span_valid_i,
  output logic      span_ready_o,
  input  span_t     span_i,

  output logic                         seed_valid_o,
  input  logic                         seed_ready_i,
  output seed_t                        seed_o,
  output split_seed_t   [Channels-1:0] split_o,     // quad-split
  output curve_seed_t   [Curves-1:0]   curve_o,     // quad-cosine, phong-surface
  output material_index_t              material_o,  // likewise
  output choice_t                      choice_o,
  output surface_point_t [Channels-1:0] point_o,    // quad-polynomial, quad-horner

  output logic      span_inside_o,  // a span is being set up or waits as a seed
  output logic      busy_o          // a triangle or a span is inside
);
  localparam int unsigned Latency = 4;
  localparam int unsigned Interval = 1;

  localparam bit HasQuad = (Methods & RowMethods) != '0;
  localparam bit HasGouraud = Methods[MethodGouraud];
  localparam bit HasSplit = Methods[MethodQuadSplit];
  localparam bit HasCurve = (Methods & CurveMethods) != '0;
  localparam bit HasPoint = (Methods & PointMethods) != '0;
  localparam bit HasChannel = (Methods & ~PointMethods & ~CurveMethods) != '0;
  // What a method wants.
  typedef struct packed {
    logic rows;                   // its surfaces are stepped from row to row
    logic channel;                // row_start of intensities
    logic quad;                   // of second order
    logic gouraud;
    logic split;
    logic point;
  } wants_t;
  function automatic wants_t wants_of(method_e method);
    wants_of.gouraud = is_method(Methods, method, MethodGouraud);
    wants_of.rows    = is_any_of(Methods, method, RowMethods) || wants_of.gouraud;
    wants_of.point   = is_any_of(Methods, method, PointMethods);
    wants_of.channel = !wants_of.point && !is_any_of(Methods, method, CurveMethods);
    wants_of.quad    = wants_of.channel && is_any_of(Methods, method, RowMethods);
    wants_of.split   = is_method(Methods, method, MethodQuadSplit);
  endfunction
  // The triangle that is taken, the one inside, the span that has started, the one summed up.
  choice_t choice_q, run_choice_q, sum_choice_q;
  wants_t  loads, now, runs, sums;
  assign loads = wants_of(choice_i.method);
  assign now   = wants_of(choice_q.method);
  assign runs  = wants_of(run_choice_q.method);
  assign sums  = wants_of(sum_choice_q.method);

  logic  triangle_valid_q;
  logic  span_valid_q;            // a span is in its steps
  span_t span_q;
  logic  run_valid_q;             // has started: its last product is due
  logic  sum_valid_q;             // its last sum is due
  logic  seed_valid_q;

  /////////////
  // Control //
  /////////////

  coord_t row_q;                  // of the rows' registers
  logic   take_triangle, take_span, advance, next_row, last_step, release_triangle;
  logic   finish, write_seed;
  assign advance          = !(sum_valid_q && seed_valid_q && !seed_ready_i);
  assign next_row         = span_valid_q && advance && now.rows && row_q != span_q.y;
  assign last_step        = span_valid_q && advance &&
                            (!now.rows || row_q == span_q.y ||
                             coord_t'(row_q + 12'd1) == span_q.y);
  assign finish           = run_valid_q && advance;
  assign release_triangle = last_step && span_q.last;
  assign write_seed       = sum_valid_q && advance;

  assign triangle_ready_o = !triangle_valid_q || release_triangle;
  assign take_triangle    = triangle_valid_i && triangle_ready_o;
  assign span_ready_o     = (!span_valid_q || last_step) &&
                            (take_triangle || (triangle_valid_q && !release_triangle));
  assign take_span        = span_valid_i && span_ready_o;

  assign seed_valid_o  = seed_valid_q;
  assign span_inside_o = span_valid_q || run_valid_q || sum_valid_q || seed_valid_q;
  assign busy_o        = span_inside_o || triangle_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      triangle_valid_q <= 1'b0;
      span_valid_q     <= 1'b0;
      run_valid_q      <= 1'b0;
      sum_valid_q      <= 1'b0;
      seed_valid_q     <= 1'b0;
    end else begin
      triangle_valid_q <= take_triangle || (triangle_valid_q && !release_triangle);
      span_valid_q     <= take_span || (span_valid_q && !last_step);
      run_valid_q      <= last_step || (run_valid_q && !advance);
      sum_valid_q      <= finish || (sum_valid_q && !advance);
      seed_valid_q     <= write_seed || (seed_valid_q && !seed_ready_i);
    end
  end

  always_ff @(posedge clk_i) begin
    if (take_span) span_q <= span_i;
    if (take_triangle) choice_q <= choice_i;
    if (take_triangle) row_q <= triangle_i.origin_y;
    else if (next_row) row_q <= coord_t'(row_q + 12'd1);
  end

  //////////////
  // Position //
  //////////////

  coord_t     origin_x_q, origin_y_q;
  depth_acc_t dz_dx_q;
  offset_t    local_x, local_y;
  assign local_x = signed'({1'b0, span_q.x}) - signed'({1'b0, origin_x_q});
  assign local_y = signed'({1'b0, span_q.y}) - signed'({1'b0, origin_y_q});

  run_t    run_q, sum_run_q, seed_run_q;   // of the span that has started, is summed up, is a seed
  offset_t run_x_q;
  assign seed_o.run = seed_run_q;
  always_ff @(posedge clk_i) begin
    if (take_triangle) begin
      origin_x_q <= triangle_i.origin_x;
      origin_y_q <= triangle_i.origin_y;
      dz_dx_q    <= triangle_i.dz_dx;
    end
    if (last_step) begin
      run_q   <= '{x: span_q.x, y: span_q.y, length: span_q.length, z: span_q.z, dz_dx: dz_dx_q};
      run_x_q <= local_x;
    end
    if (last_step)  run_choice_q <= choice_q;
    if (finish)     {sum_choice_q, sum_run_q} <= {run_choice_q, run_q};
    if (write_seed) {choice_o, seed_run_q}    <= {sum_choice_q, sum_run_q};
  end

  //////////////
  // Surfaces //
  //////////////

  for (genvar ch = 0; ch < Channels; ch++) begin : gen_channel
    if (HasChannel) begin : gen_rows
      row_start #(.HasQuad(HasQuad), .HasGouraud(HasGouraud)) u_row_start (
        .clk_i, .is_quad_i(now.quad), .is_gouraud_i(now.gouraud),
        .load_i(take_triangle && loads.channel), .load_quad_i(loads.quad),
        .surface_i(triangle_i.surface[ch]), .next_row_i(next_row), .x_i(local_x),
        .start_i(last_step && now.channel),
        .run_quad_i(runs.quad), .run_gouraud_i(runs.gouraud), .run_x_i(run_x_q),
        .finish_i(finish && runs.channel), .write_i(write_seed && sums.channel),
        .seed_o(seed_o.channel[ch]));
    end else begin : gen_no_rows
      assign seed_o.channel[ch] = '0;
    end

    if (HasSplit) begin : gen_split
      intensity_acc_t ambient_q, run_ambient_q, sum_ambient_q, seed_ambient_q;
      assign split_o[ch].ambient = seed_ambient_q;
      row_start #(.HasGouraud(1'b0)) u_specular_row_start (
        .clk_i, .is_quad_i(now.split), .is_gouraud_i(1'b0),
        .load_i(take_triangle && loads.split), .load_quad_i(1'b1),
        .surface_i(triangle_i.specular[ch]), .next_row_i(next_row),
        .start_i(last_step && now.split), .x_i(local_x),
        .run_quad_i(runs.split), .run_gouraud_i(1'b0), .run_x_i(run_x_q),
        .finish_i(finish && runs.split), .write_i(write_seed && sums.split),
        .seed_o(split_o[ch].specular));
      always_ff @(posedge clk_i) begin
        if (take_triangle && loads.split) ambient_q      <= triangle_i.ambient[ch];
        if (last_step && now.split)       run_ambient_q  <= ambient_q;
        if (finish && runs.split)         sum_ambient_q  <= run_ambient_q;
        if (write_seed && sums.split)     seed_ambient_q <= sum_ambient_q;
      end
    end else begin : gen_no_split
      assign split_o[ch] = '0;
    end

    if (HasPoint) begin : gen_point
      point_rows u_point_rows (
        .clk_i, .load_i(take_triangle && loads.point), .surface_i(triangle_i.surface[ch]),
        .start_i(last_step && now.point), .finish_i(finish && runs.point),
        .write_i(write_seed && sums.point), .x_i(local_x), .y_i(local_y), .point_o(point_o[ch]));
    end else begin : gen_no_point
      assign point_o[ch] = '0;
    end
  end

  if (HasCurve) begin : gen_curve
    curve_rows #(.Methods(Methods)) u_curve_rows (
      .clk_i,
      .load_choice_i(choice_i),
      .choice_i     (choice_q),
      .run_choice_i (run_choice_q),
      .sum_choice_i (sum_choice_q),
      .load_i       (take_triangle),
      .curve_i      (triangle_i.curve),
      .material_i   (triangle_i.material),
      .next_row_i   (next_row),
      .start_i      (last_step),
      .x_i          (local_x),
      .finish_i     (finish),
      .run_x_i      (run_x_q),
      .write_i      (write_seed),
      .curve_o, .material_o
    );
  end else begin : gen_no_curve
    assign curve_o    = '0;
    assign material_o = '0;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (take_span) begin
      assert (span_i.length != '0) else $error("span_setup: a span of 0 pixels");
    end
    if (span_valid_q && now.rows) begin
      assert (row_q <= span_q.y) else $error("span_setup: a span above the one before it");
    end
  end
`endif
endmodule
