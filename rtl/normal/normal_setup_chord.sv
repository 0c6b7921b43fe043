// SPDX-License-Identifier: Apache-2.0
//
// Second stage of normal_setup: what the chord and the number of steps say, one product a step.
//
//   1/m, G(delta), R(delta), psi^2 = 2 delta G, 1/m^2
//
// Timing    Steps 0..5 two products for each of 1/m, G and R; 6 psi^2; 7 1/m^2, straight to the
//           next stage.
// Formats   delta U1.38, saturated; 1/m U1.34 2^-e; G, R U1.34; psi^2 U2.36; 1/m^2 U1.36 4^-e.
// Model     model/normal/normal_setup.cpp          Doc  docs/units/normal/normal_setup.md
module normal_setup_chord (
  input  logic        clk_i,
  input  logic        take_i,
  input  logic [2:0]  step_i,
  input  logic        spherical_i,
  input  logic [40:0] delta_i,               // U3.38
  input  logic [11:0] steps_i,               // m
  output logic [38:0] delta_o,               // 0 when linear or m <= 1
  output logic [3:0]  exponent_o,            // e
  output logic [34:0] inverse_o,             // 2^e / m
  output logic [36:0] inverse_square_o,      // 4^e / m^2
  output logic [37:0] psi_square_o,
  output logic [34:0] ratio_o                // psi / sin(psi)
);
  localparam logic [40:0] MaxDelta = 41'h40_7fff_ffff;    // 1 + 2^-7 - 2^-38

  typedef logic signed [39:0] factor_t;
  typedef logic signed [79:0] product_t;

  logic [38:0] delta_q;
  logic [10:0] mantissa_q;                   // fraction of m 2^-e, U0.11
  logic [3:0]  exponent_q;
  product_t    product_q;
  logic [34:0] inverse_q, angle_q, ratio_q;

  logic [3:0]  exponent;
  always_comb begin
    exponent = '0;
    for (int i = 1; i < 12; i++) if (steps_i[i]) exponent = 4'(i);
  end

  logic [1:0]         select;
  logic [7:0]         segment;
  logic [30:0]        offset;
  logic        [34:0] value;
  logic signed [28:0] slope;
  logic        [19:0] curvature;
  assign select  = step_i[2:1];
  assign segment = select == 2'd0 ? {1'b0, mantissa_q[10:4]} : delta_q[38:31];
  assign offset  = select == 2'd0 ? {mantissa_q[3:0], 27'd0} : delta_q[30:0];
  normal_setup_chord_table u_table (
    .table_i(select), .segment_i(segment),
    .value_o(value), .slope_o(slope), .curvature_o(curvature));

  factor_t  left, right, rounded;
  product_t product;
  assign rounded = factor_t'((product_q + (product_t'(1) <<< 30)) >>> 31);
  assign product = product_t'(left) * product_t'(right);
  always_comb begin
    left  = factor_t'({1'b0, offset});
    right = step_i[0] ? factor_t'(slope) + rounded : factor_t'({1'b0, curvature});
    if (step_i == 3'd6) {left, right} = {1'b0, delta_q, 5'd0, angle_q};
    if (step_i == 3'd7) {left, right} = {5'd0, inverse_q, 5'd0, inverse_q};
  end

  // A table's last product arrives while the next table is read: its value waits.
  logic [34:0] value_q;
  logic [34:0] result;
  assign result = value_q + 35'(rounded);

  always_ff @(posedge clk_i) begin
    if (take_i) begin
      delta_q    <= !spherical_i || steps_i[11:1] == '0 ? '0
                    : delta_i > MaxDelta ? MaxDelta[38:0] : delta_i[38:0];
      exponent_q <= exponent;
      mantissa_q <= 11'(steps_i << (4'd11 - exponent));   // drops the leading 1
    end
    if (step_i != 3'd7) product_q <= product;
    value_q <= value;
    case (step_i)
      3'd2:    inverse_q <= result;
      3'd4:    angle_q   <= result;
      3'd6:    ratio_q   <= result;
      default: ;
    endcase
  end
  assign delta_o          = delta_q;
  assign exponent_o       = exponent_q;
  assign inverse_o        = inverse_q;
  assign inverse_square_o = 37'((product + (product_t'(1) <<< 31)) >>> 32);
  assign psi_square_o     = 38'((product_q + (product_t'(1) <<< 34)) >>> 35);
  assign ratio_o          = ratio_q;
endmodule
