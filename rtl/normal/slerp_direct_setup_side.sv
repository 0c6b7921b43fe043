// SPDX-License-Identifier: Apache-2.0
//
// Second stage of slerp_direct_setup: the step of Newton, the angle and Nk.
//
//   1/sqrt(X) = R + R h/2,  phi = X (1/sqrt(X)) A 2^-E,  Nk = rise 2^E B / sqrt(X)
//
// Timing    Step 0 R h; 1 B/sqrt(X); 2 sqrt(X); 3 phi and the three products of Nk.
// Formats   1/sqrt(X), sqrt(X) and B/sqrt(X) with 36 fraction bits, rise 2^E S2.34, saturated.
// Model     model/normal/slerp_direct_setup.cpp    Doc  docs/units/normal/slerp_direct_setup.md
module slerp_direct_setup_side
  import light_pkg::*;
  import normal_pkg::*;
(
  input  logic         clk_i,
  input  logic         take_i,
  input  logic [2:0]   step_i,
  input  arc_turn_t    turn_i,
  input  span_normal_t [Components-1:0] start_i,
  input  arc_rise_t    [Components-1:0] rise_i,
  output arc_t         arc_o
);
  localparam angle_t QuarterTurn = 41'h192_1fb5_4443;
  localparam angle_t SmallAngle  = 41'h10_0000;          // 2^-20
  localparam angle_t SmallestAngle = 41'h8000;           // 2^-25

  typedef logic signed [39:0] factor_t;
  typedef logic signed [79:0] product_t;

  // product 2^-shift, rounded half up
  function automatic product_t round_off(product_t product, logic [6:0] shift);
    round_off = ((product >>> (shift - 7'd1)) + product_t'(1)) >>> 1;
  endfunction

  // Drops the bits above S1.30: saturates.
  function automatic span_normal_t to_span_normal(product_t value);
    if (value[79:31] == {49{value[79]}}) to_span_normal = value[31:0];
    else                                 to_span_normal = {value[79], {31{!value[79]}}};
  endfunction

  arc_turn_t                     turn_q;
  span_normal_t [Components-1:0] start_q;
  arc_rise_t    [Components-1:0] rise_q;

  product_t    product_q, product;
  factor_t     left, right;
  logic [36:0] inverse_root, inverse_root_q; // 1/sqrt(X)
  logic [36:0] inverse_sine_q;               // 2^-E / sin(phi)
  assign inverse_root = {turn_q.root, 12'd0} + 37'(round_off(product_q, 7'd35));
  assign product      = product_t'(left) * product_t'(right);
  always_comb begin
    case (step_i)
      3'd0:    {left, right} = {factor_t'(turn_q.correction), 15'd0, turn_q.root};
      3'd1:    {left, right} = {3'd0, inverse_root, 5'd0, turn_q.sine};
      3'd2:    {left, right} = {3'd0, inverse_root_q, 10'd0, turn_q.x};
      default: {left, right} = {2'd0, 38'(round_off(product_q, 7'd28)), 5'd0, turn_q.angle};
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (take_i) begin
      turn_q  <= turn_i;
      start_q <= start_i;
      rise_q  <= rise_i;
    end
    if (!step_i[2]) product_q <= product;
    if (step_i == 3'd1) inverse_root_q <= inverse_root;
    if (step_i == 3'd2) inverse_sine_q <= 37'(round_off(product_q, 7'd34));
  end

  // Straight arcs: 2^20 d or 2^25 d fits Nk.
  logic [Components-1:0] fits_20, fits_25;
  logic                  is_small, is_smallest;
  angle_t                angle;
  assign is_small    = &fits_20;
  assign is_smallest = &fits_25;
  assign angle       = angle_t'(round_off(product_q, 7'd30 + 7'(turn_q.exponent)));

  for (genvar i = 0; i < Components; i++) begin : gen_side
    quantity_t          difference;          // of a straight arc
    logic signed [72:0] raised;              // rise 2^E, 34 fraction bits
    logic signed [36:0] u;                   // saturated, S2.34
    product_t           side_q;              // 70 fraction bits
    product_t           last;                // Na + d
    span_normal_t       straight, turned;
    assign difference = quantity_t'(rise_q[i] >>> 2);
    assign fits_20[i] = difference[39:19] == {21{difference[39]}};
    assign fits_25[i] = difference[39:14] == {26{difference[39]}};
    assign last       = product_t'($signed({start_q[i], 8'd0})) + product_t'(difference);
    assign straight   = is_smallest ? {difference[14:0], 17'd0} :
                        is_small    ? {difference[19:0], 12'd0}
                                    : to_span_normal(round_off(last, 7'd8));

    assign raised = (73'($signed(rise_q[i])) <<< turn_q.exponent) >>> 6;
    assign u      = raised[72:36] == {37{raised[72]}} ? raised[36:0]
                                                      : {raised[72], {36{!raised[72]}}};
    always_ff @(posedge clk_i) begin
      if (step_i == 3'd3) side_q <= product_t'(u) * product_t'($signed({1'b0, inverse_sine_q}));
    end
    assign turned        = to_span_normal(round_off(side_q, 7'd40));
    assign arc_o.side[i] = turn_q.straight ? straight : turned;
  end
  assign arc_o.start = start_q;
  assign arc_o.step  = !turn_q.straight ? angle : is_smallest ? SmallestAngle
                                       : is_small ? SmallAngle : QuarterTurn;
endmodule
