// SPDX-License-Identifier: Apache-2.0
//
// Vocabulary of normal interpolation along a span. model/normal/normal_types.h is the C++ twin.
//
// A quantity is what a recurrence interpolates: a component of the normal, or N.L and N.H.
package normal_pkg;
  import fixed_pkg::*;
  import light_pkg::*;

  typedef s1_30_t span_normal_t;             // component of the normal at an end of a span
  typedef s1_38_t quantity_t;                // component or cosine, in a recurrence
  typedef s1_44_t length_sq_t;               // |N|^2 of linearly interpolated normals

  // What a method of normal interpolation needs at the start of a span.
  typedef struct packed {
    logic spherical;                         // angle linear along the span; else the vector linear
    logic cosines;                           // quantities N.L, N.H or N.V, 0; else x, y, z
    logic length;                            // |N|^2 as well; not with spherical
  } setup_kind_t;

  // kappa = 4 sin^2(phi / 2) = mantissa 4^-exponent, for the angle phi from pixel to pixel; the
  // exponent, 0..10, is the largest that keeps the mantissa <= 1.
  typedef struct packed {
    u1_28_t     mantissa;
    logic [3:0] exponent;
  } kappa_t;

  typedef struct packed {
    quantity_t first;                        // s(0)
    quantity_t difference;                   // s(stride) - s(0)
  } quantity_seed_t;

  typedef struct packed {
    length_sq_t first;                       // q(0)
    length_sq_t difference;                  // q(stride) - q(0)
    length_sq_t curvature;                   // second difference
  } length_seed_t;

  typedef u1_40_t angle_t;                   // radians, [0, 2); sums wrap

  // Span on a great circle, N(t) = start cos(t step) + side sin(t step), paper 000 (6).
  typedef struct packed {
    angle_t             step;                // from pixel to pixel
    span_normal_t [2:0] start;               // Na
    span_normal_t [2:0] side;                // Nk, a quarter of a turn ahead of Na
  } arc_t;

  typedef logic signed [42:0] arc_rise_t;    // Nk sin(phi), S2.40

  // Between the stages of slerp_direct_setup: kappa = x 4^-exponent and its functions.
  typedef struct packed {
    logic               straight;            // kappa = 0
    logic        [ 4:0] exponent;
    logic        [29:0] x;                   // U2.28, [1, 4)
    u1_24_t             root;                // 1/sqrt(x)
    logic signed [24:0] correction;          // 1 - x root^2, 46 fraction bits
    logic        [34:0] angle;               // phi / sqrt(kappa), U1.34
    logic        [34:0] sine;                // sqrt(kappa) / sin(phi), U1.34
  } arc_turn_t;

  // Where the normals between the ends of a span come from, paper 002.
  typedef enum logic [1:0] {
    AdaptiveSphere   = 2'd0,                 // bisection of the span itself: slerp
    AdaptiveExtended = 2'd1,                 // the paper's: of the span extended to a power of 2
    AdaptiveChord    = 2'd2                  // normalised points of the chord: Phong
  } adaptive_kind_e;

  // 1 - cos of the largest angle between two normals that are joined by a straight line; U0.30.
  typedef logic [29:0] angle_limit_t;

  // Levels of division: a part of the longest span is as short as a pixel.
  localparam int unsigned AdaptiveLevels = 12;

  // What halves a span: inverse = 2^exponent / width.
  typedef struct packed {
    span_normal_t [1:0][Components-1:0]  normal;      // left and right end
    angle_limit_t                        limit;
    logic [11:0]                         last_pixel;
    logic [12:0]                         width;       // steps between the ends
    u1_30_t                              inverse;
    logic [3:0]                          exponent;
    logic [3:0]                          levels;      // that the angle wants
    u1_32_t [AdaptiveLevels-1:0]         divisor;     // 1/z of each level
  } adaptive_span_t;

  // A part of a span between two normals, with at least one pixel.
  typedef struct packed {
    span_normal_t [1:0][Components-1:0]  normal;      // left and right end
    u1_30_t                              inverse;
    logic [3:0]                          exponent;
    logic [3:0]                          level;
    logic [24:0]                         place;       // of the left end, U13.12 pixels
    logic [11:0]                         first;       // pixel
    logic [12:0]                         count;       // pixels
    logic                                last;        // of its span
  } adaptive_part_t;

  // Its pixels, N(i) = first + i difference from the first pixel of a group of lanes on.
  typedef struct packed {
    quantity_t [Components-1:0]          first;
    quantity_t [Components-1:0]          difference;
    logic [12:0]                         count;
    logic                                last;
  } adaptive_segment_t;

  // 1/sqrt(q) = mantissa 2^exponent; mantissa in [1/2, 1], exponent 0..22.
  typedef struct packed {
    u1_24_t     mantissa;
    logic [4:0] exponent;
  } reciprocal_sqrt_t;

  // value - (slope - curvature t) t, t in [0, 1); 28 fraction bits each.
  typedef struct packed {
    u1_28_t      value;
    logic [20:0] slope;
    logic [12:0] curvature;
  } root_coefficients_t;

  // S1.38 -> S1.30: truncates.
  function automatic span_normal_t quantity_to_span_normal(quantity_t value);
    quantity_to_span_normal = value[39:8];
  endfunction

  // U3.60.
  function automatic logic [62:0] square_of(span_normal_t component);
    square_of = 63'(64'(component) * 64'(component));
  endfunction

  // S1.38 -> S1.24: rounds halves up, saturates.
  function automatic pixel_normal_t to_pixel_normal(quantity_t value);
    logic signed [40:0] rounded;
    rounded = 41'(value) + 41'sd8192;
    if (rounded[40:39] == 2'b01) to_pixel_normal = {1'b0, {25{1'b1}}};
    else                         to_pixel_normal = rounded[39:14];
  endfunction

  // S1.38 -> S1.30: rounds halves up, saturates.
  function automatic cosine_t quantity_to_cosine(quantity_t value);
    quantity_to_cosine = to_cosine(35'((41'(value) + 41'sd128) >>> 8));
  endfunction

  // S1.30 -> S1.38.
  function automatic quantity_t cosine_to_quantity(cosine_t cosine);
    cosine_to_quantity = {cosine, 8'd0};
  endfunction
endpackage
