// SPDX-License-Identifier: Apache-2.0
//
// Seeds of the recurrences along a span, from the normals at its first and last pixel: no arccos,
// no square root, no trigonometry. With m steps, delta = |Nb - Na|^2 / 2 and phi = psi / m:
//
//   psi^2 = 2 delta G(delta)                 kappa = 4 sin^2(phi/2) = phi^2 K(phi^2)
//   r = sin(phi) / sin(psi) = R(delta) S(phi^2) / m
//   s(1) - s(0) = sb r - sa g                g = (1 - delta) r + kappa/2    paper 000 (3), (6)
//   linear        r = g = 1/m, kappa = 0
//
// Timing    Four stages of 8 steps, Lanes = 4 five: a span taken in cycle c is on offer in cycle
//           c + 33, or c + 41; one span every 8 cycles. ready/valid on both ports.
// Formats   normals S1.30, light S1.22, quantities S1.38, |N|^2 S1.44, kappa U1.28 4^-p. Products
//           are rounded half up once; sums wrap.
// Error     64 ulp of 2^-30 at any pixel up to 90 degrees against slerp, with an exact recurrence.
//           RTL = model on every seed.
// Bad input delta saturates at 1 + 2^-7; sums wrap. 0 steps count as 1. kappa_o saturates at 1,
//           which only a span that ends before it is used (m < 2 Lanes) needs.
// Model     model/normal/normal_setup.h            Doc  docs/units/normal/normal_setup.md
module normal_setup
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1           // 1 or 4
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  light_t      light_i,               // stable while busy_o

  input  logic        span_valid_i,
  output logic        span_ready_o,
  input  lit_run_t    run_i,                 // with what is wanted
  input  span_normal_t [1:0][Components-1:0] normal_i,     // first and last pixel

  output logic        seed_valid_o,
  input  logic        seed_ready_i,
  output lit_run_t    run_o,
  output quantity_seed_t [2:0][Lanes-1:0] quantity_o,
  output length_seed_t [Lanes-1:0] length_o,
  output kappa_t      kappa_o,               // of one stride
  output kappa_t [1:0] step_kappa_o,         // of one and two pixels, Lanes = 4
  output logic        busy_o                 // a span is inside or its seed waits
);
  localparam int unsigned Stages = Lanes == 1 ? 4 : 5;
  localparam int unsigned Latency = 8 * Stages + 1;
  localparam int unsigned Interval = 8;

  /////////////
  // Control //
  /////////////

  logic [Stages-1:0]      take;
  logic [Stages-1:0][2:0] step;
  lit_run_t [Stages-1:0]  stage_run;         // of the span in each stage
  logic                   write_seed;
  normal_setup_control #(.Stages(Stages)) u_control (
    .clk_i, .rst_ni, .valid_i(span_valid_i), .ready_o(span_ready_o), .run_i,
    .valid_o(seed_valid_o), .ready_i(seed_ready_i), .run_o, .take_o(take), .step_o(step),
    .stage_run_o(stage_run), .write_o(write_seed), .busy_o);

  ////////////
  // Stages //
  ////////////

  quantity_t [1:0][2:0] end_dots;
  logic [40:0]          delta_dots;
  logic signed [39:0]   square_dots, along_dots;
  length_sq_t           length_dots;
  normal_setup_dots u_dots (
    .clk_i, .kind_i(stage_run[0].kind), .light_i, .take_i(take[0]), .step_i(step[0]), .normal_i,
    .end_o(end_dots), .delta_o(delta_dots), .square_o(square_dots), .along_o(along_dots),
    .length_o(length_dots));

  logic [38:0] delta_chord;
  logic [3:0]  exponent_chord, exponent_angle;
  logic [34:0] inverse_chord, inverse_angle, ratio_chord;
  logic [36:0] inverse_square_chord, inverse_square_angle;
  logic [37:0] psi_square_chord;
  normal_setup_chord u_chord (
    .clk_i, .take_i(take[1]), .step_i(step[1]), .spherical_i(stage_run[0].kind.spherical),
    .delta_i(delta_dots), .steps_i(12'(stage_run[0].run.length - 13'd1)), .delta_o(delta_chord),
    .exponent_o(exponent_chord), .inverse_o(inverse_chord),
    .inverse_square_o(inverse_square_chord), .psi_square_o(psi_square_chord),
    .ratio_o(ratio_chord));

  logic [49:0] kappa_angle, kappa_difference;
  logic [38:0] slope_angle;
  normal_setup_angle u_angle (
    .clk_i, .take_i(take[2]), .step_i(step[2]), .exponent_i(exponent_chord),
    .inverse_i(inverse_chord), .inverse_square_i(inverse_square_chord),
    .psi_square_i(psi_square_chord), .ratio_i(ratio_chord), .exponent_o(exponent_angle),
    .inverse_o(inverse_angle), .inverse_square_o(inverse_square_angle), .kappa_o(kappa_angle),
    .slope_o(slope_angle));

  // What stages 2 and 3 only pass on: from the dot products to the differences.
  typedef struct packed {
    quantity_t [1:0][2:0] ends;
    logic [39:0]          square;
    logic [39:0]          along;
    length_sq_t           length;
  } passed_t;
  passed_t passed_chord_q, passed_angle_q;
  logic [38:0] delta_angle_q;
  always_ff @(posedge clk_i) begin
    if (take[1]) passed_chord_q <= {end_dots, square_dots, along_dots, length_dots};
    if (take[2]) passed_angle_q <= passed_chord_q;
    if (take[2]) delta_angle_q  <= delta_chord;
  end

  quantity_seed_t [2:0] quantity;
  length_seed_t         length;
  normal_setup_difference u_difference (
    .clk_i, .take_i(take[3]), .step_i(step[3]), .kind_i(stage_run[3].kind),
    .end_i(passed_angle_q.ends),
    .delta_i(delta_angle_q), .exponent_i(exponent_angle), .inverse_i(inverse_angle),
    .inverse_square_i(inverse_square_angle), .kappa_i(kappa_angle), .slope_i(slope_angle),
    .square_i(passed_angle_q.square), .along_i(passed_angle_q.along),
    .length_i(passed_angle_q.length), .quantity_o(quantity), .length_o(length),
    .kappa_o(kappa_difference));

  ///////////
  // Seeds //
  ///////////

  kappa_t step_kappa;                        // of one pixel
  normal_setup_exponent u_exponent (.kappa_i(53'(kappa_difference)), .kappa_o(step_kappa));

  if (Lanes == 1) begin : gen_one
    assign step_kappa_o = '0;
    always_ff @(posedge clk_i) begin
      if (write_seed) begin
        for (int i = 0; i < 3; i++) quantity_o[i][0] <= quantity[i];
        length_o[0] <= length;
        kappa_o     <= step_kappa;
      end
    end
  end else begin : gen_four
    quantity_seed_t [2:0][3:0] quantity_lanes;
    length_seed_t [3:0]        length_lanes;
    kappa_t                    kappa1, kappa2, kappa4;
    logic [52:0]               kappa2_wide, kappa4_wide;
    normal_setup_lanes u_lanes (
      .clk_i, .take_i(take[4]), .step_i(step[4]), .quantity_i(quantity), .length_i(length),
      .kappa_i(53'(kappa_difference)), .step_kappa_i(step_kappa), .quantity_o(quantity_lanes),
      .length_o(length_lanes), .step_kappa_o(kappa1), .kappa2_o(kappa2_wide),
      .kappa4_o(kappa4_wide));
    normal_setup_exponent u_exponent2 (.kappa_i(kappa2_wide), .kappa_o(kappa2));
    normal_setup_exponent u_exponent4 (.kappa_i(kappa4_wide), .kappa_o(kappa4));
    always_ff @(posedge clk_i) begin
      if (write_seed) begin
        quantity_o   <= quantity_lanes;
        length_o     <= length_lanes;
        kappa_o      <= kappa4;
        step_kappa_o <= {kappa2, kappa1};
      end
    end
  end
endmodule
