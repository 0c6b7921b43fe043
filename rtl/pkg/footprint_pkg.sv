// SPDX-License-Identifier: Apache-2.0
//
// Vocabulary of footprints: where a pixel's samples lie. model/footprint/footprint_types.h is the
// C++ twin.
package footprint_pkg;
  import light_pkg::*;
  import normal_pkg::*;

  localparam int unsigned Corners = 3;
  localparam int unsigned OffsetPairs = 3;

  // Weighted barycentric of the enlarged triangle, negative outside; S3.28.
  typedef logic signed [31:0] margin_t;

  // Samples of a pixel, in the order in which they are taken: the centre, then + and - of pairs.
  typedef enum logic [1:0] {
    FootprintCentre = 2'd0,                  // the centre
    FootprintTwo    = 2'd1,                  // 1 pair
    FootprintFour   = 2'd2,                  // 2 pairs
    FootprintEight  = 2'd3                   // the centre, which counts twice, and 3 pairs
  } footprint_pattern_e;

  localparam int unsigned MostSamples = 7;   // positions of FootprintEight
  typedef logic [2:0] sample_index_t;
  typedef logic [3:0] sample_weight_t;       // samples of a pixel, 0..8

  typedef struct packed {
    quantity_t [Components-1:0] normal;
    margin_t   [Corners-1:0]    margin;
  } footprint_offset_t;

  // The footprint of the pixels of one triangle.
  typedef struct packed {
    footprint_pattern_e                  pattern;
    footprint_offset_t [OffsetPairs-1:0] offset;      // from the centre to a sample
    margin_t           [Corners-1:0]     margin_dx;   // from pixel to pixel
  } footprint_t;

  // What a sample is to its pixel; the same for all lanes.
  typedef struct packed {
    logic first;
    logic last;
    logic twice;                             // it counts twice
  } sample_place_t;

  typedef struct packed {
    logic [31:0] taken;
    logic [31:0] excluded;                   // outside the enlarged triangle
    logic [31:0] saved;                      // positions of FootprintEight that were not wanted
  } sample_counters_t;

  function automatic logic has_centre(footprint_pattern_e pattern);
    has_centre = pattern == FootprintCentre || pattern == FootprintEight;
  endfunction

  function automatic sample_index_t last_index(footprint_pattern_e pattern);
    unique case (pattern)
      FootprintCentre: last_index = 3'd0;
      FootprintTwo:    last_index = 3'd1;
      FootprintFour:   last_index = 3'd3;
      FootprintEight:  last_index = 3'd6;
    endcase
  endfunction

  // S1.38 plus or minus S1.38: saturates.
  function automatic quantity_t offset_sum(quantity_t value, quantity_t offset, logic negative);
    logic signed [40:0] sum;
    sum = negative ? 41'(value) - 41'(offset) : 41'(value) + 41'(offset);
    if (sum[40] == sum[39]) offset_sum = sum[39:0];
    else                    offset_sum = {sum[40], {39{!sum[40]}}};
  endfunction
endpackage
