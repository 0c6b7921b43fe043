// SPDX-License-Identifier: Apache-2.0
//
// Flat colour of one channel: one value for the whole triangle.
//
//   I(x) = F
//
// Timing    Latency 1 cycle from load to first pixel, then 1 pixel per step_i.
// Formats   seed S9.26 (the half code for rounding included), code U8.0 (truncate, clamp).
// Error     None: the colour is the seed's. RTL = model on every pixel.
// Model     model/intensity/flat_color.h      Doc  docs/units/intensity/flat_color.md
module flat_color
  import light_pkg::*;
  import shading_pkg::*;
(
  input  logic          clk_i,
  input  logic          load_i,   // takes seed_i; the datapath holds otherwise
  input  channel_seed_t seed_i,
  output code_t         code_o
);
  localparam int unsigned Latency = 1;

  code_t code_q;
  assign code_o = code_q;

  always_ff @(posedge clk_i) begin
    if (load_i) code_q <= to_code(seed_i.first);
  end
endmodule
