// SPDX-License-Identifier: Apache-2.0
//
// Third stage of normal_setup: the turn from pixel to pixel, one product a step.
//
//   u = phi^2 = psi^2 / m^2,  kappa = u K(u),  r = R S(u) / m
//
// Timing    Step 0 u; 1, 2 K; 3 kappa; 4, 5 S; 6 R/m; 7 r, straight to the next stage.
// Formats   u U2.36 4^-e, 35 bits to the tables; kappa U0.50; R/m U1.36 2^-e; r U1.38.
// Model     model/normal/normal_setup.cpp          Doc  docs/units/normal/normal_setup.md
module normal_setup_angle (
  input  logic        clk_i,
  input  logic        take_i,
  input  logic [2:0]  step_i,
  input  logic [3:0]  exponent_i,            // e
  input  logic [34:0] inverse_i,             // 2^e / m
  input  logic [36:0] inverse_square_i,      // 4^e / m^2
  input  logic [37:0] psi_square_i,
  input  logic [34:0] ratio_i,               // psi / sin(psi)
  output logic [3:0]  exponent_o,
  output logic [34:0] inverse_o,
  output logic [36:0] inverse_square_o,
  output logic [49:0] kappa_o,
  output logic [38:0] slope_o                // r
);
  typedef logic signed [39:0] factor_t;
  typedef logic signed [79:0] product_t;

  logic [3:0]  exponent_q;
  logic [34:0] inverse_q, ratio_q;
  logic [36:0] inverse_square_q;
  logic [37:0] square_q;                     // psi^2, then u 4^e
  product_t    product_q;
  logic [34:0] sine_q;                       // S
  logic [49:0] kappa_q;
  logic [34:0] value_q;

  // product 2^-shift, rounded half up
  function automatic product_t round_off(product_t product, logic [5:0] shift);
    round_off = ((product >>> (shift - 6'd1)) + product_t'(1)) >>> 1;
  endfunction

  logic [5:0]  double_exponent;
  logic [37:0] square;
  logic [34:0] u;
  assign double_exponent = {1'b0, exponent_q, 1'b0};
  assign square = step_i == 3'd1 ? 38'(round_off(product_q, 6'd36)) : square_q;
  assign u      = 35'(square >> (double_exponent + 6'd1));

  logic               select;
  logic        [34:0] value;
  logic signed [28:0] slope;
  logic        [19:0] curvature;
  assign select = step_i[2];
  normal_setup_angle_table u_table (
    .table_i(select), .segment_i(u[34:31]),
    .value_o(value), .slope_o(slope), .curvature_o(curvature));

  factor_t  left, right, rounded;
  product_t product;
  assign rounded = factor_t'(round_off(product_q, 6'd31));
  assign product = product_t'(left) * product_t'(right);
  logic [34:0] result;
  logic [36:0] scaled;                       // R/m 2^e
  assign result = value_q + 35'(rounded);
  assign scaled = 37'(round_off(product_q, 6'd32));
  always_comb begin
    case (step_i)
      3'd0:       {left, right} = {2'd0, square_q, 3'd0, inverse_square_q};
      3'd1, 3'd4: {left, right} = {9'd0, u[30:0], 20'd0, curvature};
      3'd2, 3'd5: {left, right} = {9'd0, u[30:0], factor_t'(slope) + rounded};
      3'd3:       {left, right} = {2'd0, square_q, 5'd0, result};
      3'd6:       {left, right} = {5'd0, inverse_q, 5'd0, ratio_q};
      default:    {left, right} = {3'd0, scaled, 5'd0, sine_q};
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (take_i) begin
      exponent_q       <= exponent_i;
      inverse_q        <= inverse_i;
      inverse_square_q <= inverse_square_i;
      ratio_q          <= ratio_i;
      square_q         <= psi_square_i;
    end else if (step_i == 3'd1) begin
      square_q         <= square;
    end
    if (step_i != 3'd7) product_q <= product;
    value_q <= value;
    if (step_i == 3'd4) kappa_q <= 50'(round_off(product_q, 6'd20 + double_exponent));
    if (step_i == 3'd6) sine_q <= result;
  end
  assign exponent_o       = exponent_q;
  assign inverse_o        = inverse_q;
  assign inverse_square_o = inverse_square_q;
  assign kappa_o          = kappa_q;
  assign slope_o          = 39'(round_off(product, 6'd32 + {2'd0, exponent_q}));
endmodule
