// SPDX-License-Identifier: Apache-2.0
//
// A product by a constant of lanes, as additions of shifted terms, so that synthesis finds no
// multiplier: what lane_seed, pixel_walker, adaptive_normalizer_fill and aniso_footprint share. A
// part of them; it has no page of its own.
//
//   product = Factor value,  Factor 0..63
//
// Timing    Combinational.
// Formats   value_t, a signed fixed-point number; sums wrap and come back exactly.
// Error     None.
// Model     a product of integers
module constant_product
  import shading_pkg::*;
#(
  parameter type value_t = depth_acc_t,
  parameter int unsigned Factor = 1
) (
  input  value_t value_i,
  output value_t product_o
);
  always_comb begin
    product_o = '0;
    for (int unsigned k = 0; k < 6; k++) begin
      if (Factor[k]) product_o += value_i <<< k;
    end
  end
endmodule
