// SPDX-License-Identifier: Apache-2.0
//
// Start of one lane of one channel: lane j of Lanes begins at pixel j and steps Lanes pixels.
//
//   I(j) = I(0) + j D + j (j - 1) / 2 2A,  D = I(1) - I(0)          paper 003 (3)
//   D' = I(j + Lanes) - I(j) = Lanes D + (Lanes j + Lanes (Lanes - 1) / 2) 2A,  2A' = Lanes^2 2A
//
// Timing    Combinational; additions of shifted terms only.
// Formats   S9.26 modulo 2^36, or the S1.44 of a cosine modulo 2^46: exact, so lanes show the same
//           intensities as one.
// Error     None.
// Model     model/intensity/lane_seed.h      Doc  docs/units/intensity/lane_seed.md
module lane_seed
  import shading_pkg::*;
#(
  parameter type value_t = intensity_acc_t,
  parameter type seed_t = channel_seed_t,
  parameter int unsigned Lane = 0,
  parameter int unsigned Lanes = 1
) (
  input  seed_t seed_i,            // second is not used where Lanes > 1
  output seed_t seed_o
);
  localparam int unsigned Latency = 0;

  localparam int unsigned FirstPairs = Lane * (Lane - 1) / 2;
  localparam int unsigned Second = Lane + Lanes;
  localparam int unsigned SecondPairs = Second * (Second - 1) / 2;
  localparam int unsigned StridePairs = Lanes * Lane + Lanes * (Lanes - 1) / 2;

  if (Lanes == 1) begin : gen_one
    assign seed_o = seed_i;
  end else begin : gen_many
    value_t to_first, bend_to_first, to_second, bend_to_second, stride, bend_of_stride;
    constant_product #(.value_t(value_t), .Factor(Lane)) u_first (
      .value_i(seed_i.difference), .product_o(to_first));
    constant_product #(.value_t(value_t), .Factor(FirstPairs)) u_first_pairs (
      .value_i(seed_i.curvature), .product_o(bend_to_first));
    constant_product #(.value_t(value_t), .Factor(Second)) u_second (
      .value_i(seed_i.difference), .product_o(to_second));
    constant_product #(.value_t(value_t), .Factor(SecondPairs)) u_second_pairs (
      .value_i(seed_i.curvature), .product_o(bend_to_second));
    constant_product #(.value_t(value_t), .Factor(Lanes)) u_stride (
      .value_i(seed_i.difference), .product_o(stride));
    constant_product #(.value_t(value_t), .Factor(StridePairs)) u_stride_pairs (
      .value_i(seed_i.curvature), .product_o(bend_of_stride));
    constant_product #(.value_t(value_t), .Factor(Lanes * Lanes)) u_curvature (
      .value_i(seed_i.curvature), .product_o(seed_o.curvature));
    assign seed_o.first      = seed_i.first + to_first + bend_to_first;
    assign seed_o.second     = seed_i.first + to_second + bend_to_second;
    assign seed_o.difference = stride + bend_of_stride;
  end
endmodule
