// SPDX-License-Identifier: Apache-2.0
//
// Spherical interpolation of one quantity along a span in the form of paper 000, one or four pixels
// per step. With c = 2 cos(phi) and c' = 2 cos(2 phi):
//
//   N(t+1) = c N(t) - N(t-1)                                   (7)
//   N(t+2) = (c' + 1) N(t) - c N(t-1)                          (9)
//   N(t+3) = c' (c N(t) - N(t-1)) - N(t-1)                     (10), corrected
//   N(t+4) = c' ((c' + 1) N(t) - c N(t-1)) - N(t)              (11), corrected
//
// Timing    Latency 1 cycle from load to first pixels, then Lanes pixels per step_i.
// Formats   seed and value S1.38; inside S1.F, F = FractionBits. Seeds, c, c' and each right-hand
//           side in the order above are rounded half up to F bits once; N(t+3) and N(t+4) use the
//           rounded N(t+1) and N(t+2). Everything wraps at S1.F.
// Error     Lanes 1: (t^2 + t - 1)/2 ulp of S1.F at pixel t, and what the seeds and kappa lose in
//           their own formats: 2098200 ulp for F = 38, 2048 pixels, amplitude 1. Few fraction bits
//           are useless on long spans: slerp_recurrence is the form to use. RTL = model.
// Bad input Values outside [-2, 2) wrap, which the error at low F alone can cause.
// Model     model/normal/slerp_paper.h            Doc  docs/units/normal/slerp_paper.md
module slerp_paper
  import normal_pkg::*;
#(
  parameter int unsigned Lanes = 1,              // 1 or 4
  parameter int unsigned FractionBits = 38       // 8..38
) (
  input  logic                       clk_i,
  input  logic                       load_i,     // takes seed_i and step_kappa_i
  input  logic                       step_i,     // moves on by Lanes pixels; load_i wins
  input  quantity_seed_t [Lanes-1:0] seed_i,     // one lane: first and difference; four: first
  input  kappa_t [1:0]               step_kappa_i,   // of phi; of 2 phi, used by four lanes
  output quantity_t [Lanes-1:0]      value_o     // lane j: pixel t + j
);
  localparam int unsigned Latency = 1;
  localparam int unsigned Dropped = 38 - FractionBits;

  typedef logic signed [FractionBits+1:0]   state_t;     // S1.F
  typedef logic        [FractionBits+1:0]   factor_t;    // U2.F: 2 cos, 0..2, and 2 cos + 1
  typedef logic signed [2*FractionBits+4:0] sum_t;       // S4.2F: two products

  // Rounds half up to F bits; an overflow wraps.
  function automatic state_t to_state(quantity_t value);
    to_state = state_t'((value + quantity_t'((41'd1 << Dropped) >> 1)) >>> Dropped);
  endfunction

  // 2 - kappa, kappa rounded half up to F bits. Its mantissa has 28 + 2 exponent fraction bits.
  function automatic factor_t to_factor(kappa_t kappa);
    logic [39:0] scaled;             // kappa with F + 1 fraction bits, the rest cut off
    scaled    = 40'({kappa.mantissa, 39'd0} >> (7'(66 - FractionBits)
                                                + {2'b0, kappa.exponent, 1'b0}));
    to_factor = factor_t'(41'd1 << (FractionBits + 1)) - factor_t'((41'(scaled) + 41'd1) >> 1);
  endfunction

  function automatic sum_t multiply(factor_t factor, state_t value);
    multiply = sum_t'(signed'({1'b0, factor})) * sum_t'(value);
  endfunction

  function automatic state_t round_sum(sum_t sum);
    round_sum = state_t'((sum + (sum_t'(1) <<< (FractionBits - 1))) >>> FractionBits);
  endfunction

  factor_t cos_q;                    // c
  always_ff @(posedge clk_i) if (load_i) cos_q <= to_factor(step_kappa_i[0]);

  if (Lanes == 1) begin : gen_one
    state_t value_q;                 // N(t)
    state_t next_q;                  // N(t+1)

    assign value_o[0] = quantity_t'(value_q) <<< Dropped;

    always_ff @(posedge clk_i) begin
      if (load_i) begin
        value_q <= to_state(seed_i[0].first);
        next_q  <= to_state(seed_i[0].first + seed_i[0].difference);
      end else if (step_i) begin
        value_q <= next_q;
        next_q  <= round_sum(multiply(cos_q, next_q)) - value_q;
      end
    end
  end else begin : gen_four
    factor_t double_cos_q;           // c'
    state_t [3:0] value_q;           // N(t-3) .. N(t)
    state_t next_1, next_2, next_3, next_4;    // N(t+1) .. N(t+4)
    factor_t double_cos_1;           // c' + 1

    for (genvar lane = 0; lane < 4; lane++) begin : gen_value
      assign value_o[lane] = quantity_t'(state_t'(value_q[lane])) <<< Dropped;
    end
    assign double_cos_1 = double_cos_q + factor_t'(41'd1 << FractionBits);
    assign next_1 = round_sum(multiply(cos_q, value_q[3])) - value_q[2];
    assign next_2 = round_sum(multiply(double_cos_1, value_q[3]) - multiply(cos_q, value_q[2]));
    assign next_3 = round_sum(multiply(double_cos_q, next_1)) - value_q[2];
    assign next_4 = round_sum(multiply(double_cos_q, next_2)) - value_q[3];

    always_ff @(posedge clk_i) begin
      if (load_i) begin
        double_cos_q <= to_factor(step_kappa_i[1]);
        for (int lane = 0; lane < 4; lane++) value_q[lane] <= to_state(seed_i[lane].first);
      end else if (step_i) begin
        value_q <= {next_4, next_3, next_2, next_1};
      end
    end
  end
endmodule
