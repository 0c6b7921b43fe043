// SPDX-License-Identifier: Apache-2.0
//
// Gives kappa its exponent: mantissa 4^-exponent with the largest exponent, 0..10, for which
// kappa 4^exponent <= 1. Saturates at 1.
//
// Timing    Combinational.
// Formats   U3.50 in, mantissa U1.28, rounded half up.
// Model     model/normal/normal_setup.cpp          Doc  docs/units/normal/normal_setup.md
module normal_setup_exponent
  import normal_pkg::*;
(
  input  logic [52:0] kappa_i,
  output kappa_t      kappa_o
);
  localparam logic [52:0] One = 53'h4_0000_0000_0000;

  logic [3:0] exponent;
  always_comb begin
    exponent = '0;
    for (int p = 1; p <= 10; p++) if (kappa_i <= One >> (2 * p)) exponent = 4'(p);
    kappa_o.exponent = exponent;
    kappa_o.mantissa = kappa_i >= One ? 29'h1000_0000
                       : 29'(((kappa_i << {exponent, 1'b0}) + 53'h20_0000) >> 22);
  end
endmodule
