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
endpackage
