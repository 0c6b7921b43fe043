// SPDX-License-Identifier: Apache-2.0
//
// Fifth stage of normal_setup, for four lanes: runs seven pixels ahead with the recurrence of
// slerp_recurrence, so that lane j starts at pixel j with a stride of four.
//
//   s += d, d -= kappa s          kappa(2 phi) = kappa (4 - kappa)
//
// Timing    Step t adds s(t+1) and bends d, t = 0..6; 1 and 3 form kappa(2 phi) and kappa(4 phi).
// Formats   s, d S1.38, |N|^2 S1.44, all wrap; kappa U3.50.
// Model     model/normal/normal_setup.cpp          Doc  docs/units/normal/normal_setup.md
module normal_setup_lanes
  import fixed_pkg::*;
  import normal_pkg::*;
(
  input  logic        clk_i,
  input  logic        take_i,
  input  logic [2:0]  step_i,
  input  quantity_seed_t [2:0] quantity_i,
  input  length_seed_t length_i,
  input  logic [52:0] kappa_i,
  input  kappa_t      step_kappa_i,
  output quantity_seed_t [2:0][3:0] quantity_o,
  output length_seed_t [3:0] length_o,
  output kappa_t      step_kappa_o,          // of one pixel
  output logic [52:0] kappa2_o,
  output logic [52:0] kappa4_o
);
  kappa_t      step_kappa_q;
  logic [52:0] kappa_q, kappa2_q, kappa4_q;  // kappa_q: what is doubled
  logic [5:0]  shift;
  assign shift = 6'd17 + {1'b0, step_kappa_q.exponent, 1'b0};

  logic [35:0] rest;                         // 4 - kappa, U3.33
  logic [52:0] doubled;
  assign rest    = 36'h8_0000_0000 - 36'((kappa_q + 53'd65536) >> 17);
  assign doubled = 53'((89'(kappa_q) * 89'(rest) + (89'd1 << 32)) >> 33);

  always_ff @(posedge clk_i) begin
    if (take_i) begin
      step_kappa_q <= step_kappa_i;
      kappa_q      <= kappa_i;
    end else begin
      if (step_i == 3'd1) kappa_q  <= doubled;
      if (step_i == 3'd1) kappa2_q <= doubled;
      if (step_i == 3'd3) kappa4_q <= doubled;
    end
  end
  assign step_kappa_o = step_kappa_q;
  assign kappa2_o     = kappa2_q;
  assign kappa4_o     = kappa4_q;

  for (genvar i = 0; i < 3; i++) begin : gen_quantity
    quantity_t [7:0] value_q;                // value_q[7]: the newest
    quantity_t difference_q, next, bend;
    s1_28_t    operand;
    logic signed [59:0] product;
    assign next    = value_q[7] + difference_q;
    assign operand = s1_28_t'((next + quantity_t'(1 << 9)) >>> 10);
    assign product = 60'(operand) * 60'(signed'({1'b0, step_kappa_q.mantissa}));
    assign bend    = quantity_t'(((product >>> shift) + 60'sd1) >>> 1);
    always_ff @(posedge clk_i) begin
      if (take_i) begin
        value_q[7]   <= quantity_i[i].first;
        difference_q <= quantity_i[i].difference;
      end else if (step_i != 3'd7) begin
        value_q      <= {next, value_q[7:1]};
        difference_q <= difference_q - bend;
      end
    end
    for (genvar lane = 0; lane < 4; lane++) begin : gen_lane
      assign quantity_o[i][lane] = {value_q[lane], value_q[lane+4] - value_q[lane]};
    end
  end

  length_sq_t [7:0] length_q;
  length_sq_t length_difference_q, curvature_q;
  always_ff @(posedge clk_i) begin
    if (take_i) begin
      length_q[7]         <= length_i.first;
      length_difference_q <= length_i.difference;
      curvature_q         <= length_i.curvature;
    end else if (step_i != 3'd7) begin
      length_q            <= {length_q[7] + length_difference_q, length_q[7:1]};
      length_difference_q <= length_difference_q + curvature_q;
    end
  end
  for (genvar lane = 0; lane < 4; lane++) begin : gen_length
    assign length_o[lane] = {length_q[lane], length_q[lane+4] - length_q[lane],
                             curvature_q <<< 4};
  end
endmodule
