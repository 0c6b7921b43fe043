// SPDX-License-Identifier: Apache-2.0
//
// Third stage of adaptive_normalizer: from a part of a span to its pixels' line, and the queue of
// segments between division and pixels.
//
//   dN = (Nr - Nl) 2^level / m         first = Nl + (p - place) dN
//
// p is the part's first pixel, or with four lanes the first of its group.
//
// Timing    A part taken in cycle c is on offer from c + 4, one a cycle. The queue holds Depth,
//           those in the pipeline included. A place is free in the cycle after its segment left.
// Formats   dN and first S1.38, each rounded half up once; sums wrap.
// Model     model/normal/adaptive_normalizer.h     Doc  docs/units/normal/adaptive_normalizer.md
module adaptive_normalizer_segment
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              part_valid_i,
  output logic              part_ready_o,
  input  lit_run_t          run_i,
  input  adaptive_part_t    part_i,

  output logic              segment_valid_o,
  input  logic              segment_ready_i,
  output lit_run_t          run_o,           // of the segment's span
  output adaptive_segment_t segment_o,
  output logic              busy_o           // parts are inside
);
  localparam int unsigned Depth = 8;
  localparam int unsigned Stages = 3;        // before the queue

  typedef logic [$clog2(Depth)-1:0] index_t;
  typedef logic [$clog2(Depth):0]   index_count_t;
  typedef struct packed {
    span_normal_t [Components-1:0] left;
    logic signed [14:0]            offset;   // p - place, S2.12
    span_length_t                  count;
    logic                          last;
    lit_run_t                      run;
  } passed_t;

  index_count_t taken_q, written_q, left_q;  // so far, modulo 2 Depth
  logic         take, leave;
  logic [Stages-1:0] valid_q;
  assign part_ready_o    = index_count_t'(taken_q - left_q) != index_count_t'(Depth);
  assign take            = part_valid_i && part_ready_o;
  assign segment_valid_o = written_q != left_q;
  assign leave           = segment_valid_o && segment_ready_i;
  assign busy_o          = taken_q != left_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q   <= '0;
      taken_q   <= '0;
      written_q <= '0;
      left_q    <= '0;
    end else begin
      valid_q <= {valid_q[Stages-2:0], take};
      if (take)              taken_q   <= taken_q + 1'b1;
      if (valid_q[Stages-1]) written_q <= written_q + 1'b1;
      if (leave)             left_q    <= left_q + 1'b1;
    end
  end

  passed_t passed, passed_q [Stages];
  logic [11:0] group;                        // its first pixel
  assign group  = part_i.first & ~12'(Lanes - 1);
  assign passed = '{left: part_i.normal[0], offset: 15'({1'b0, group, 12'd0} - part_i.place),
                    count: part_i.count, last: part_i.last, run: run_i};
  logic [5:0] shift_q;                       // 22 + exponent - level, 10..34
  always_ff @(posedge clk_i) begin
    if (take) begin
      passed_q[0] <= passed;
      shift_q     <= 6'd22 + 6'(part_i.exponent) - 6'(part_i.level);
    end
    for (int unsigned i = 1; i < Stages; i++) if (valid_q[i-1]) passed_q[i] <= passed_q[i-1];
  end

  quantity_t [Components-1:0] first, difference_q, difference_last_q;
  for (genvar i = 0; i < Components; i++) begin : gen_component
    logic signed [32:0] chord;
    logic signed [64:0] product_q;           // dN, 60 fraction bits
    logic signed [54:0] offset_q;            // (p - place) dN, 50 fraction bits
    assign chord    = 33'(signed'(part_i.normal[1][i])) - 33'(signed'(part_i.normal[0][i]));
    assign first[i] = quantity_t'({passed_q[Stages-1].left[i], 8'd0}) +
                      quantity_t'((offset_q + 55'sd2048) >>> 12);
    always_ff @(posedge clk_i) begin
      if (take)       product_q <= 65'(chord) * 65'(signed'({1'b0, part_i.inverse}));
      if (valid_q[0]) difference_q[i] <= quantity_t'(((product_q >>> (shift_q - 6'd1)) + 65'sd1)
                                                     >>> 1);
      if (valid_q[1]) begin
        offset_q             <= 55'(signed'(difference_q[i])) * 55'(passed_q[1].offset);
        difference_last_q[i] <= difference_q[i];
      end
    end
  end

  adaptive_segment_t segment_mem [Depth];
  lit_run_t          run_mem     [Depth];
  always_ff @(posedge clk_i) begin
    if (valid_q[Stages-1]) begin
      segment_mem[index_t'(written_q)] <= '{first: first, difference: difference_last_q,
                                            count: passed_q[Stages-1].count,
                                            last: passed_q[Stages-1].last};
      run_mem[index_t'(written_q)]     <= passed_q[Stages-1].run;
    end
  end
  assign segment_o = segment_mem[index_t'(left_q)];
  assign run_o     = run_mem[index_t'(left_q)];
endmodule
