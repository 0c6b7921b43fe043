// SPDX-License-Identifier: Apache-2.0
//
// Cosines that come at once wait as long as duff_normalizer takes, so that cosines of different
// methods keep the order of their pixels. A part of normal_shader; it has no page of its own.
//
// Timing    Latency 9 cycles, a pixel a cycle, never stalls.
// Formats   light_pkg.
// Error     None.
// Gating    Moves only when pixels move: a queue, not a shift register.
// Model     none: the values pass unchanged      Doc  docs/units/shading_unit.md
module cosine_delay
  import light_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,
  input  logic     valid_i,
  input  cosines_t cosines_i,
  output logic     valid_o,
  output cosines_t cosines_o
);
  localparam int unsigned Latency = 9;
  typedef logic [3:0] place_t;

  cosines_t           memory [16];
  logic [Latency-1:0] valid_q;
  place_t             write_q, read_q;
  assign valid_o   = valid_q[Latency-1];
  assign cosines_o = memory[read_q];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q           <= '0;
      {write_q, read_q} <= '0;
    end else begin
      valid_q <= {valid_q[Latency-2:0], valid_i};
      if (valid_i) write_q <= write_q + 1'b1;
      if (valid_o) read_q  <= read_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) if (valid_i) memory[write_q] <= cosines_i;
endmodule
