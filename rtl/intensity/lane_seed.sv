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

  localparam value_t First = value_t'(Lane);
  localparam value_t FirstPairs = value_t'(32'(Lane * (Lane - 1) / 2));
  localparam value_t Second = value_t'(32'(Lane + Lanes));
  localparam value_t SecondPairs =
    value_t'(32'((Lane + Lanes) * (Lane + Lanes - 1) / 2));
  localparam value_t Stride = value_t'(Lanes);
  localparam value_t StridePairs =
    value_t'(32'(Lanes * Lane + Lanes * (Lanes - 1) / 2));
  localparam value_t StrideSquare = value_t'(32'(Lanes * Lanes));

  if (Lanes == 1) begin : gen_one
    assign seed_o = seed_i;
  end else begin : gen_many
    assign seed_o.first      = seed_i.first + First * seed_i.difference +
                               FirstPairs * seed_i.curvature;
    assign seed_o.second     = seed_i.first + Second * seed_i.difference +
                               SecondPairs * seed_i.curvature;
    assign seed_o.difference = Stride * seed_i.difference + StridePairs * seed_i.curvature;
    assign seed_o.curvature  = StrideSquare * seed_i.curvature;
  end
endmodule
