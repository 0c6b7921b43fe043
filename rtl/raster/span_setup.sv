// SPDX-License-Identifier: Apache-2.0
//
// Span set-up: row start and first difference of three channels, one multiplier each.
//
//   quad      r = Ax + Cy + D,  s = By + E,  I = r x + s y + F   paper 003 (9): 5 products
//             I(x+1) - I(x) = r + Ax + A                          paper 003 (3)
//   gouraud   I = D x + E y + F,  I(x+1) - I(x) = D               2 products
//   flat      I = F                                               none
//
// Timing    One step a product; the last sum overlaps the next span's first step.
//             method   span accepted to seed on offer   initiation interval
//             quad     7 cycles                         5 cycles
//             gouraud  4                                2
//             flat     3                                1
//           ready/valid on all ports. A span is never taken before its triangle; a triangle leaves
//           with the last step of its last span.
// Formats   coefficients and seeds S9.26, coordinates S12.0 from the triangle's origin; products
//           keep the low 36 bits. Exact whenever the result lies in S9.26.
// Error     None against the integer polynomial. RTL = model on every seed.
// Model     model/raster/span_setup.h      Doc  docs/units/raster/span_setup.md
module span_setup
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods
) (
  input  logic      clk_i,
  input  logic      rst_ni,
  input  method_e   method_i,     // stable while busy_o

  input  logic      triangle_valid_i,
  output logic      triangle_ready_o,
  input  triangle_t triangle_i,

  input  logic      span_valid_i,
  output logic      span_ready_o,
  input  span_t     span_i,

  output logic      seed_valid_o,
  input  logic      seed_ready_i,
  output seed_t     seed_o,

  output logic      span_inside_o,  // a span is being set up or waits as a seed
  output logic      busy_o          // a triangle or a span is inside
);
  localparam int unsigned Latency = 7;
  localparam int unsigned Interval = 5;

  // Steps are named by the product that the multiplier forms in them.
  typedef enum logic [2:0] {
    StepAx = 3'd0, StepCy = 3'd1, StepBy = 3'd2, StepRowX = 3'd3, StepRowY = 3'd4
  } step_e;

  localparam bit HasQuad = Methods[MethodQuad];
  localparam bit HasGouraud = Methods[MethodGouraud];
  logic is_quad, is_gouraud;
  assign is_quad    = HasQuad && (Methods == methods_t'(1 << MethodQuad) ||
                                  method_i == MethodQuad);
  assign is_gouraud = HasGouraud && (Methods == methods_t'(1 << MethodGouraud) ||
                                     method_i == MethodGouraud);

  logic      triangle_valid_q;
  triangle_t triangle_q;
  logic      span_valid_q;        // a span is in its steps
  span_t     span_q;
  step_e     step_q;
  logic      sum_valid_q;         // the last sum of a span is due
  logic      seed_valid_q;

  /////////////
  // Control //
  /////////////

  logic take_triangle, take_span, advance, last_step, release_triangle, write_seed;
  assign advance          = !(sum_valid_q && seed_valid_q && !seed_ready_i);
  assign last_step        = span_valid_q && advance && step_q == StepRowY;
  assign release_triangle = last_step && span_q.last;
  assign write_seed       = sum_valid_q && advance;

  assign triangle_ready_o = !triangle_valid_q || release_triangle;
  assign take_triangle    = triangle_valid_i && triangle_ready_o;
  assign span_ready_o     = (!span_valid_q || last_step) &&
                            (take_triangle || (triangle_valid_q && !release_triangle));
  assign take_span        = span_valid_i && span_ready_o;

  assign seed_valid_o  = seed_valid_q;
  assign span_inside_o = span_valid_q || sum_valid_q || seed_valid_q;
  assign busy_o        = span_inside_o || triangle_valid_q;

  step_e first_step;
  assign first_step = is_quad ? StepAx : is_gouraud ? StepRowX : StepRowY;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      triangle_valid_q <= 1'b0;
      span_valid_q     <= 1'b0;
      sum_valid_q      <= 1'b0;
      seed_valid_q     <= 1'b0;
    end else begin
      triangle_valid_q <= take_triangle || (triangle_valid_q && !release_triangle);
      span_valid_q     <= take_span || (span_valid_q && !last_step);
      sum_valid_q      <= last_step || (sum_valid_q && !advance);
      seed_valid_q     <= write_seed || (seed_valid_q && !seed_ready_i);
    end
  end

  always_ff @(posedge clk_i) begin
    if (take_triangle) triangle_q <= triangle_i;
    if (take_span) begin
      span_q <= span_i;
      step_q <= first_step;
    end else if (span_valid_q && advance) begin
      step_q <= step_e'(step_q + 3'd1);
    end
  end

  //////////////
  // Position //
  //////////////

  offset_t local_x, local_y;
  assign local_x = signed'({1'b0, span_q.x}) - signed'({1'b0, triangle_q.origin_x});
  assign local_y = signed'({1'b0, span_q.y}) - signed'({1'b0, triangle_q.origin_y});

  run_t run_q;                    // of the span whose last sum is due
  run_t seed_run_q;
  always_ff @(posedge clk_i) begin
    if (last_step) begin
      run_q <= '{x: span_q.x, y: span_q.y, length: span_q.length, z: span_q.z,
                 dz_dx: triangle_q.dz_dx};
    end
    if (write_seed) seed_run_q <= run_q;
  end
  assign seed_o.run = seed_run_q;

  //////////////
  // Channels //
  //////////////

  for (genvar ch = 0; ch < Channels; ch++) begin : gen_channel
    surface_t       coef;
    intensity_acc_t factor;
    offset_t        coord;
    intensity_acc_t product_q;
    intensity_acc_t ax_q;         // A x
    intensity_acc_t row_x_q;      // r = Ax + Cy + D
    intensity_acc_t row_y_q;      // s = By + E
    intensity_acc_t base_q;       // r x + F
    intensity_acc_t difference_q, curvature_q;
    intensity_acc_t row_x, first;
    channel_seed_t  seed_q;

    assign coef  = triangle_q.surface[ch];
    assign row_x = ax_q + product_q + coef.d;

    always_comb begin
      factor = is_quad ? row_y_q : coef.e;
      coord  = local_y;
      if (step_q == StepRowX) begin
        factor = is_quad ? row_x_q : coef.d;
        coord  = local_x;
      end
      if (HasQuad) begin
        if (step_q == StepAx) factor = coef.a;
        if (step_q == StepCy) factor = coef.c;
        if (step_q == StepBy) factor = coef.b;
        if (step_q == StepAx) coord = local_x;
      end
    end

    always_ff @(posedge clk_i) begin
      if (span_valid_q && advance) begin
        if (is_quad || is_gouraud) product_q <= factor * intensity_acc_t'(coord);
        if (is_quad) begin
          if (step_q == StepCy)   ax_q         <= product_q;
          if (step_q == StepBy)   row_x_q      <= row_x;
          if (step_q == StepBy)   difference_q <= row_x + ax_q + coef.a;
          if (step_q == StepRowX) row_y_q      <= product_q + coef.e;
          if (step_q == StepRowY) curvature_q  <= coef.a <<< 1;
        end
        if (is_gouraud) difference_q <= coef.d;
        if (step_q == StepRowY) base_q <= (is_quad || is_gouraud) ? product_q + coef.f : coef.f;
      end
    end

    assign first = (is_quad || is_gouraud) ? base_q + product_q : base_q;
    always_ff @(posedge clk_i) begin
      if (write_seed) begin
        seed_q.first      <= first;
        seed_q.second     <= first + difference_q;
        seed_q.difference <= difference_q;
        seed_q.curvature  <= curvature_q;
      end
    end
    assign seed_o.channel[ch] = seed_q;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (take_span) begin
      assert (span_i.length != '0) else $error("span_setup: a span of 0 pixels");
    end
  end
`endif
endmodule
