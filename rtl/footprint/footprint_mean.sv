// SPDX-License-Identifier: Apache-2.0
//
// Light of a pixel as the mean of its samples' light, paper 001: the diffuse factor and the
// highlight, each clamped and raised to its power before.
//
//   mean = sum w_s value_s / sum w_s      over the samples that are not excluded, w = 1 or 2
//        = (2 sum + count) reciprocal[count] >> 26,   reciprocal[k] = ceil(2^26 / (2 k))
//
// Timing    A sample a cycle, never stalls; latency 3 cycles from a pixel's last sample.
// Formats   diffuse U1.17, highlight U1.16; sums of 8 exact; rounded to nearest, halves up.
// Error     0.5 ulp: the quotient is exact, since (2 sum + k) (2 k reciprocal[k] - 2^26) < 2^26.
// Bad input A pixel without a sample gives 0.
// Model     model/footprint/footprint_mean.h      Doc  docs/units/footprint/footprint_mean.md
module footprint_mean
  import fixed_pkg::*;
  import footprint_pkg::*;
  import light_pkg::*;
(
  input  logic          clk_i,
  input  logic          rst_ni,

  input  logic          valid_i,
  input  sample_place_t place_i,
  input  logic          live_i,              // not excluded
  input  diffuse_t      diffuse_i,
  input  highlight_t    highlight_i,
  input  logic          unlit_i,             // N.L <= 0
  input  logic          skipped_i,           // the power was not computed

  output logic          valid_o,
  output diffuse_t      diffuse_o,
  output highlight_t    highlight_o,
  output logic          unlit_o,             // every sample is
  output logic          skipped_o            // for every sample
);
  localparam int unsigned Latency = 3;
  localparam int unsigned Fraction = 26;

  typedef struct packed {
    logic [20:0]    diffuse;                 // U4.17, 0..8
    logic [19:0]    highlight;               // U4.16
    sample_weight_t count;
    logic           unlit;
    logic           skipped;
  } sum_t;

  function automatic logic [Fraction-1:0] reciprocal(sample_weight_t count);
    unique case (count)
      4'd1:    reciprocal = 26'd33554432;
      4'd2:    reciprocal = 26'd16777216;
      4'd3:    reciprocal = 26'd11184811;
      4'd4:    reciprocal = 26'd8388608;
      4'd5:    reciprocal = 26'd6710887;
      4'd6:    reciprocal = 26'd5592406;
      4'd7:    reciprocal = 26'd4793491;
      4'd8:    reciprocal = 26'd4194304;
      default: reciprocal = '0;
    endcase
  endfunction

  sum_t sum_q, sum_d;
  logic valid_q, divide_q, mean_valid_q;
  logic [21:0] twice_diffuse;                // 2 sum + count
  logic [20:0] twice_highlight;
  assign twice_diffuse   = {sum_q.diffuse, 1'b0} + 22'(sum_q.count);
  assign twice_highlight = {sum_q.highlight, 1'b0} + 21'(sum_q.count);

  logic [47:0] diffuse_product_q;            // U5.43
  logic [46:0] highlight_product_q;          // U5.42
  logic        unlit_product_q, skipped_product_q;
  diffuse_t    diffuse_q;
  highlight_t  highlight_q;
  logic        unlit_q, skipped_q;

  always_comb begin
    sum_d = place_i.first ? '{unlit: 1'b1, skipped: 1'b1, default: '0} : sum_q;
    if (live_i) begin
      sum_d.diffuse   = sum_d.diffuse + (21'(diffuse_i) << place_i.twice);
      sum_d.highlight = sum_d.highlight + (20'(highlight_i) << place_i.twice);
      sum_d.count     = sum_d.count + (4'd1 << place_i.twice);
      sum_d.unlit     = sum_d.unlit && unlit_i;
      sum_d.skipped   = sum_d.skipped && skipped_i;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) {valid_q, divide_q, mean_valid_q} <= '0;
    else         {valid_q, divide_q, mean_valid_q} <= {valid_i && place_i.last, valid_q, divide_q};
  end

  always_ff @(posedge clk_i) begin
    if (valid_i) sum_q <= sum_d;
    if (valid_q) begin
      diffuse_product_q   <= 48'(twice_diffuse) * 48'(reciprocal(sum_q.count));
      highlight_product_q <= 47'(twice_highlight) * 47'(reciprocal(sum_q.count));
      unlit_product_q     <= sum_q.unlit;
      skipped_product_q   <= sum_q.skipped;
    end
    if (divide_q) begin
      diffuse_q   <= diffuse_product_q[Fraction+17:Fraction];
      highlight_q <= highlight_product_q[Fraction+16:Fraction];
      unlit_q     <= unlit_product_q;
      skipped_q   <= skipped_product_q;
    end
  end

  assign valid_o     = mean_valid_q;
  assign diffuse_o   = diffuse_q;
  assign highlight_o = highlight_q;
  assign unlit_o     = unlit_q;
  assign skipped_o   = skipped_q;
endmodule
