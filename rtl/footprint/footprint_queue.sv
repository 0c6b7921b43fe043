// SPDX-License-Identifier: Apache-2.0
//
// Footprints of the spans that are inside normal_setup, in their order: what their pixels want and
// the set-up has no use for.
//
// Timing    Written with a span, on offer from the next cycle; never full, for normal_setup holds
//           at most Depth spans.
// Formats   shading_pkg.
// Error     None.
// Model     none: the model reads the triangle      Doc  docs/units/shading_unit.md
module footprint_queue
  import shading_pkg::*;
#(
  parameter int unsigned Depth = 8
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic            write_i,
  input  span_footprint_t footprint_i,
  input  logic            read_i,            // the first of them leaves
  output span_footprint_t footprint_o        // the first of them
);
  typedef logic [$clog2(Depth)-1:0] place_t;
  span_footprint_t memory [Depth];
  place_t          write_q, read_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) {write_q, read_q} <= '0;
    else         {write_q, read_q} <= {write_q + place_t'(write_i), read_q + place_t'(read_i)};
  end
  always_ff @(posedge clk_i) if (write_i) memory[write_q] <= footprint_i;
  assign footprint_o = memory[read_q];

`ifndef SYNTHESIS
  logic [$clog2(Depth):0] count_q;           // of spans
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)                count_q <= '0;
    else if (write_i && !read_i) count_q <= count_q + 1'b1;
    else if (read_i && !write_i) count_q <= count_q - 1'b1;
  end
  always_ff @(posedge clk_i) begin
    assert (!read_i || count_q != '0) else $error("footprint_queue: no span");
    assert (!write_i || read_i || int'(count_q) != Depth) else $error("footprint_queue: full");
  end
`endif
endmodule
