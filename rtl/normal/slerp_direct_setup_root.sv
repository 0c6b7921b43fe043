// SPDX-License-Identifier: Apache-2.0
//
// First stage of slerp_direct_setup: 1/sqrt(kappa) before its step of Newton, the two functions of
// kappa, and Nk sin(phi).
//
//   kappa = X 4^-E,  R = 1/sqrt(X),  h = 1 - X R^2,  A(kappa), B(kappa),  rise = d + Na kappa/2
//
// Timing    Steps 0, 1 A; 2, 3 B; 0 the three products of rise; R arrives in step 5; 5 X R; 6 h.
// Formats   X U2.28, R U1.24, X R U2.38, h S-21.46; A and B U1.34; rise S2.40.
// Model     model/normal/slerp_direct_setup.cpp    Doc  docs/units/normal/slerp_direct_setup.md
module slerp_direct_setup_root
  import light_pkg::*;
  import normal_pkg::*;
(
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         take_i,
  input  logic [2:0]   step_i,
  input  quantity_seed_t [Components-1:0] quantity_i,
  input  kappa_t       kappa_i,
  output arc_turn_t    turn_o,
  output span_normal_t [Components-1:0] start_o,
  output arc_rise_t    [Components-1:0] rise_o
);
  localparam logic [33:0] MaxPlace = 34'h2_7fff_ffff;    // just below 0.625

  kappa_t                        kappa_q;
  span_normal_t [Components-1:0] start_q;
  quantity_t    [Components-1:0] difference_q;
  logic [Components-1:0][61:0]   bend_q;                 // Na kappa, 58 + 2 p fraction bits

  ///////////////////
  // Root of kappa //
  ///////////////////

  reciprocal_sqrt_t root;
  logic             root_valid;              // in step 5; it stays until the next seed's
  reciprocal_sqrt u_reciprocal_sqrt (
    .clk_i, .rst_ni, .valid_i(take_i), .length_sq_i({1'b0, kappa_i.mantissa, 16'd0}),
    .valid_o(root_valid), .root_o(root));
  logic [29:0] x;
  assign x = 30'(kappa_q.mantissa) << {root.exponent, 1'b0};

  ////////////////////////
  // Functions of kappa //
  ////////////////////////

  logic [34:0] kappa;                        // U1.34
  logic [33:0] place;
  assign kappa = {kappa_q.mantissa, 6'd0} >> {kappa_q.exponent, 1'b0};
  assign place = kappa > 35'(MaxPlace) ? MaxPlace : kappa[33:0];

  logic [34:0] value;
  logic [25:0] slope;
  logic [17:0] curvature;
  slerp_direct_setup_table u_table (
    .table_i(step_i[1]), .segment_i(place[33:28]), .value_o(value), .slope_o(slope),
    .curvature_o(curvature));

  // Every step of the stage takes one product.
  logic [67:0] product_q, product;
  logic [39:0] left, xr;
  logic [27:0] right;
  logic [34:0] rounded, value_q, result, angle_q, sine_q;
  assign rounded = 35'((product_q + 68'h800_0000) >> 28);
  assign xr      = 40'((product_q + 68'h2000) >> 14);
  assign result  = value_q + rounded;
  assign product = 68'(left) * 68'(right);
  always_comb begin
    case (step_i)
      3'd0, 3'd2: {left, right} = {22'd0, curvature, place[27:0]};
      3'd1, 3'd3: {left, right} = {14'd0, slope + 26'(rounded), place[27:0]};
      3'd5:       {left, right} = {10'd0, x, 3'd0, root.mantissa};
      default:    {left, right} = {xr, 3'd0, root.mantissa};
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (take_i) begin
      kappa_q <= kappa_i;
      for (int unsigned i = 0; i < Components; i++) begin
        start_q[i]      <= quantity_to_span_normal(quantity_i[i].first);
        difference_q[i] <= quantity_i[i].difference;
      end
    end
    if (step_i != 3'd7) product_q <= product;
    value_q <= value;
    if (step_i == 3'd2) angle_q <= result;
    if (step_i == 3'd4) sine_q  <= result;
    if (step_i == 3'd0) begin
      for (int unsigned i = 0; i < Components; i++) begin
        bend_q[i] <= 62'($signed(start_q[i])) * 62'($signed({1'b0, kappa_q.mantissa}));
      end
    end
  end

  logic [24:0] correction;                   // 1 - x R^2, 46 fraction bits
  logic [5:0]  shift;
  assign correction = 25'(((68'h1 << 62) - product_q + 68'h8000) >> 16);
  assign shift      = 6'd18 + {1'b0, kappa_q.exponent, 1'b0};

  assign turn_o = '{straight: kappa_q.mantissa == '0,
                    exponent: 5'(kappa_q.exponent) + root.exponent, x: x, root: root.mantissa,
                    correction: correction, angle: angle_q, sine: sine_q};
  assign start_o = start_q;
  for (genvar i = 0; i < Components; i++) begin : gen_rise
    arc_rise_t bend;                         // Na kappa/2
    assign bend      = arc_rise_t'((($signed(bend_q[i]) >>> shift) + 62'sd1) >>> 1);
    assign rise_o[i] = $signed({difference_q[i][39], difference_q[i], 2'd0}) + bend;
  end
endmodule
