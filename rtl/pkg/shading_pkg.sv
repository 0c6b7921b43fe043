// SPDX-License-Identifier: Apache-2.0
//
// Shared vocabulary of the shading unit: what each number means. fixed_pkg says how it is stored;
// model/shading_types.h is the C++ twin. Screens reach 4096 x 4096 pixels.
package shading_pkg;
  import fixed_pkg::*;
  import footprint_pkg::*;
  import light_pkg::*;
  import method_pkg::*;
  import normal_pkg::*;

  typedef s9_26_t      intensity_acc_t;      // intensity in codes, for recurrences; sums wrap
  typedef u0_24_t      depth_t;              // [0, 1), smaller is nearer
  typedef s1_38_t      depth_acc_t;          // depth with 14 guard bits
  typedef logic [15:0] tolerance_t;          // U4.12, codes
  typedef logic [11:0] coord_t;              // pixel column or row
  typedef logic signed [12:0] offset_t;      // pixels from the triangle's origin, -4095..4095
  typedef logic [12:0] span_length_t;        // pixels in one span, 1..4096

  // I(x, y) = A x^2 + B y^2 + C xy + D x + E y + F, paper 003 (2), in codes; x and y in pixels from
  // the triangle's origin. F carries the half code that makes truncation round to nearest.
  typedef struct packed {
    intensity_acc_t a;
    intensity_acc_t b;
    intensity_acc_t c;
    intensity_acc_t d;
    intensity_acc_t e;
    intensity_acc_t f;
  } surface_t;

  // A cosine likewise, S1.44; no half unit.
  typedef s1_44_t cosine_acc_t;
  typedef struct packed {
    cosine_acc_t a;
    cosine_acc_t b;
    cosine_acc_t c;
    cosine_acc_t d;
    cosine_acc_t e;
    cosine_acc_t f;
  } cosine_surface_t;
  localparam int unsigned Curves = 3;        // N.L; N.H or N.V; phong-surface: |N|^2

  // The surface of one channel and a pixel on it.
  typedef struct packed {
    surface_t surface;
    offset_t  x;
    offset_t  y;
  } surface_point_t;

  typedef struct packed {
    method_e    method;
    tolerance_t tolerance;                   // quad-segment
    light_t     light;                       // methods that light every pixel
  } frame_t;

  typedef struct packed {
    coord_t                  origin_x;       // first pixel of the first span
    coord_t                  origin_y;
    depth_acc_t              dz_dx;          // depth step per pixel
    material_index_t         material;       // methods that light every pixel
    light_range_t            range;          // auto
    angle_limit_t            limit;          // adaptive methods
    footprint_t              footprint;      // footprint methods
    cosine_surface_t [Curves-1:0]   curve;   // quad-cosine, phong-surface
    intensity_acc_t  [Channels-1:0] ambient; // quad-split: with the half code
    surface_t        [Channels-1:0] specular; // quad-split
    surface_t        [Channels-1:0] surface; // intensity; quad-split: diffuse, no half code
  } triangle_t;

  typedef struct packed {
    coord_t       x;                         // first pixel
    coord_t       y;
    span_length_t length;
    depth_acc_t   z;                         // at the first pixel's centre, plus half a depth ulp
    logic         last;                      // last span of its triangle
    // At the first [0] and last [1] pixel: methods that interpolate normals.
    span_normal_t [1:0][Components-1:0] normal;
    margin_t [Corners-1:0] margin;           // at the first pixel: footprint-paper
  } span_t;

  // Where a span lies: what the pixel walker needs.
  typedef struct packed {
    coord_t       x;
    coord_t       y;
    span_length_t length;
    depth_acc_t   z;
    depth_acc_t   dz_dx;
  } run_t;

  // A run and what lights it.
  typedef struct packed {
    choice_t         choice;
    setup_kind_t     kind;                   // of normal_setup
    run_t            run;
    material_index_t material;
  } lit_run_t;

  // Where the samples of a span's pixels lie.
  typedef struct packed {
    footprint_t            footprint;
    margin_t [Corners-1:0] margin;           // at its first pixel
  } span_footprint_t;

  // Start of one channel along a span, paper 003 (9) and (3).
  typedef struct packed {
    intensity_acc_t first;                   // I(0)
    intensity_acc_t second;                  // I(stride); one pixel, or the number of lanes
    intensity_acc_t difference;              // I(stride) - I(0)
    intensity_acc_t curvature;               // stride^2 2A
  } channel_seed_t;

  // The same of a cosine.
  typedef struct packed {
    cosine_acc_t first;
    cosine_acc_t second;
    cosine_acc_t difference;
    cosine_acc_t curvature;
  } curve_seed_t;

  typedef struct packed {
    channel_seed_t  specular;
    intensity_acc_t ambient;
  } split_seed_t;

  typedef struct packed {
    run_t                         run;
    channel_seed_t [Channels-1:0] channel;
  } seed_t;

  // Where a pixel lies.
  typedef struct packed {
    coord_t x;
    coord_t y;
    depth_t z;
    logic   last;                            // last pixel of its span
  } position_t;

  typedef struct packed {
    coord_t x;
    coord_t y;
    depth_t z;
    code_t  r;
    code_t  g;
    code_t  b;
    logic   last;                            // last pixel of its span
  } pixel_t;

  // Performance counters of one frame.
  typedef struct packed {
    logic [31:0] pixels;                     // pixels that left
    logic [31:0] stall;                      // cycles: pixels were on offer and not taken
    logic [31:0] setup;                      // cycles: no pixel on offer although a span was inside
    logic [31:0] unlit;                      // pixels with N.L <= 0; methods that light every pixel
    logic [31:0] no_highlight;               // pixels whose power was not computed; same methods
    logic [31:0] normalised;                 // normalisations; adaptive methods
    logic [31:0] skipped;                    // pixels less those, span by span; adaptive methods
    logic [31:0] ambient;                    // triangles that no light reaches; auto, as below
    logic [31:0] constant;                   // spans of one colour
    logic [31:0] dark;                       // spans that are lit without a highlight
    logic [31:0] unnormalised;               // spans that are lit without a normalisation
    logic [31:0] black;                      // spans times channels that are black
    sample_counters_t samples;               // footprint methods
  } counters_t;

  // S9.26 -> U8.0: truncates the fraction, clamps to 0..255.
  function automatic code_t to_code(intensity_acc_t intensity);
    if (intensity[35])      to_code = '0;
    else if (intensity[34]) to_code = '1;
    else                    to_code = intensity[33:26];
  endfunction

  // S1.38 -> U0.24: truncates the fraction, clamps to [0, 1).
  function automatic depth_t to_depth(depth_acc_t z);
    if (z[39])      to_depth = '0;
    else if (z[38]) to_depth = '1;
    else            to_depth = z[37:14];
  endfunction
endpackage
