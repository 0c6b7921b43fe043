// SPDX-License-Identifier: Apache-2.0
//
// Performance counters of one frame: pixels that left, cycles in which they waited, cycles in which
// none was on offer although a span was inside, pixels that needed less light, normalisations,
// samples, and in auto frames what was skipped.
//
// Timing    Counts at the end of each cycle.
// Formats   32-bit counters; they wrap.
// Error     None.
// Model     Counters in model/shading_unit.h      Doc  docs/units/shading_unit.md
module frame_counters
  import footprint_pkg::*;
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic             clk_i,
  input  logic             clear_i,
  input  logic             offer_i,
  input  logic             take_i,
  input  logic             inside_i,
  input  logic [Lanes-1:0] mask_i,          // pixels of the group on offer
  input  logic [Lanes-1:0] unlit_i,
  input  logic [Lanes-1:0] no_highlight_i,
  input  logic             count_i,         // of a span: normalisations done and skipped
  input  span_length_t     normalised_i,
  input  span_length_t     skipped_i,
  input  logic             ambient_i,       // auto: a triangle that no light reaches
  input  logic             load_i,          // auto: a span starts, of these kinds
  input  logic             constant_i,
  input  logic             dark_i,
  input  logic             unnormalised_i,
  input  logic [Channels-1:0] channels_i,   // that are not black
  input  sample_counters_t samples_i,       // counted by aniso_footprint
  output counters_t        counters_o
);
  counters_t counters_q;                    // but for the samples
  always_comb begin
    counters_o         = counters_q;
    counters_o.samples = samples_i;
  end

  function automatic logic [31:0] ones(logic [Lanes-1:0] bits);
    ones = '0;
    for (int i = 0; i < int'(Lanes); i++) ones += 32'(bits[i]);
  endfunction

  always_ff @(posedge clk_i) begin
    if (clear_i) begin
      counters_q <= '0;
    end else begin
      if (take_i) begin
        counters_q.pixels       <= counters_q.pixels + ones(mask_i);
        counters_q.unlit        <= counters_q.unlit + ones(unlit_i);
        counters_q.no_highlight <= counters_q.no_highlight + ones(no_highlight_i);
      end
      if (offer_i && !take_i)   counters_q.stall <= counters_q.stall + 1'b1;
      if (!offer_i && inside_i) counters_q.setup <= counters_q.setup + 1'b1;
      counters_q.ambient <= counters_q.ambient + 32'(ambient_i);
      if (load_i) begin
        counters_q.constant     <= counters_q.constant + 32'(constant_i);
        counters_q.dark         <= counters_q.dark + 32'(dark_i);
        counters_q.unnormalised <= counters_q.unnormalised + 32'(unnormalised_i);
        counters_q.black        <= counters_q.black + 32'($countones(~channels_i));
      end
      if (count_i) begin
        counters_q.normalised <= counters_q.normalised + 32'(normalised_i);
        counters_q.skipped    <= counters_q.skipped + 32'(skipped_i);
      end
    end
  end
endmodule
