// SPDX-License-Identifier: Apache-2.0
//
// Fourth stage of normal_setup: first differences, one product a step.
//
//   g = (1 - delta) r + kappa/2,  s(1) - s(0) = sb r - sa g
//   t1 = 2 Na.(Nb-Na) / m,  t2 = |Nb-Na|^2 / m^2,  q(1) - q(0) = t1 + t2
//
// Timing    Step 0 g, or t1 when linear; 1..6 sb r and sa g of three quantities; 7 t2. The sum of
//           quantity 2 and t2 go straight to the next stage.
// Formats   r U1.38, g S1.38, kappa U0.50, ends S1.38; t1, t2 48 fraction bits.
// Model     model/normal/normal_setup.cpp          Doc  docs/units/normal/normal_setup.md
module normal_setup_difference
  import normal_pkg::*;
(
  input  logic        clk_i,
  input  logic        take_i,
  input  logic [2:0]  step_i,
  input  setup_kind_t kind_i,
  input  quantity_t [1:0][2:0] end_i,
  input  logic [38:0] delta_i,
  input  logic [3:0]  exponent_i,
  input  logic [34:0] inverse_i,
  input  logic [36:0] inverse_square_i,
  input  logic [49:0] kappa_i,
  input  logic [38:0] slope_i,               // r
  input  logic signed [39:0] square_i,
  input  logic signed [39:0] along_i,
  input  length_sq_t  length_i,
  output quantity_seed_t [2:0] quantity_o,
  output length_seed_t length_o,
  output logic [49:0] kappa_o
);
  typedef logic signed [39:0] factor_t;
  typedef logic signed [79:0] product_t;

  quantity_t [1:0][2:0] end_q;
  logic [38:0] delta_q, slope_q;
  logic [3:0]  exponent_q;
  logic [34:0] inverse_q;
  logic [36:0] inverse_square_q;
  logic [49:0] kappa_q;
  factor_t     square_q, along_q, other_q;   // other: g
  length_sq_t  length_q;
  product_t    product_q, far_q;             // far: sb r
  quantity_t [1:0] difference_q;
  logic signed [50:0] t1_q, t2;

  function automatic product_t round_off(product_t product, logic [5:0] shift);
    round_off = ((product >>> (shift - 6'd1)) + product_t'(1)) >>> 1;
  endfunction

  factor_t  left, right, g;
  product_t product;
  assign product = product_t'(left) * product_t'(right);
  // r - delta r + kappa/2 with 76 fraction bits.
  assign g = step_i != 3'd1 ? other_q : !kind_i.spherical ? factor_t'({1'b0, slope_q})
             : factor_t'(round_off({3'd0, slope_q, 38'd0} - product_q + {5'd0, kappa_q, 25'd0},
                                   6'd38));
  always_comb begin
    case (step_i)
      3'd0:    {left, right} = kind_i.spherical ? {1'b0, delta_q, 1'b0, slope_q}
                                                : {along_q, 5'd0, inverse_q};
      3'd1:    {left, right} = {end_q[1][0], 1'b0, slope_q};
      3'd2:    {left, right} = {end_q[0][0], g};
      3'd3:    {left, right} = {end_q[1][1], 1'b0, slope_q};
      3'd4:    {left, right} = {end_q[0][1], g};
      3'd5:    {left, right} = {end_q[1][2], 1'b0, slope_q};
      3'd6:    {left, right} = {end_q[0][2], g};
      default: {left, right} = {square_q, 3'd0, inverse_square_q};
    endcase
  end

  quantity_t difference;
  assign difference = quantity_t'(round_off(far_q - product_q, 6'd38));
  always_ff @(posedge clk_i) begin
    if (take_i) begin
      end_q            <= end_i;
      delta_q          <= delta_i;
      exponent_q       <= exponent_i;
      inverse_q        <= inverse_i;
      inverse_square_q <= inverse_square_i;
      kappa_q          <= kappa_i;
      slope_q          <= slope_i;
      square_q         <= square_i;
      along_q          <= along_i;
      length_q         <= length_i;
    end
    if (step_i != 3'd7) product_q <= product;
    case (step_i)
      3'd1: begin
        other_q <= g;
        t1_q    <= 51'(round_off(product_q, 6'd22 + {2'd0, exponent_q}));
      end
      3'd2, 3'd4, 3'd6: far_q <= product_q;
      3'd3: difference_q[0] <= difference;
      3'd5: difference_q[1] <= difference;
      default: ;
    endcase
  end

  assign t2 = 51'(round_off(product, 6'd24 + {1'b0, exponent_q, 1'b0}));
  for (genvar i = 0; i < 3; i++) begin : gen_quantity
    assign quantity_o[i].first = end_q[0][i];
    if (i == 2) begin : gen_last
      assign quantity_o[i].difference = difference;
    end else begin : gen_early
      assign quantity_o[i].difference = difference_q[i];
    end
  end
  always_comb begin
    length_o = '0;
    if (kind_i.length) begin
      length_o.first      = length_q;
      length_o.difference = length_sq_t'((t1_q + t2 + 51'sd8) >>> 4);
      length_o.curvature  = length_sq_t'((t2 + 51'sd4) >>> 3);
    end
  end
  assign kappa_o = kappa_q;
endmodule
