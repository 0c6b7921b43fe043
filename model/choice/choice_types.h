// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/fixed/fixed.h"
#include "model/shading_method.h"
#include "model/triangle_packet.h"

namespace shading {

// Twins of the typedefs in rtl/pkg/method_pkg.sv.
using Turn = U<2, 22>;         // |Na - Nb|^2 of two normals
using RangeCosine = S<1, 16>;  // bound on a cosine
using Log = S<6, 5>;           // binary logarithm; kLogOfZero stands for that of 0

inline constexpr Log kLogOfZero = Log::FromRaw(-(int64_t{32} << Log::kFraction));

// How far the normals of a triangle turn, and the cosines at its vertices, rounded outwards.
struct LightRange {
  Turn turn;  // largest |Ni - Nj|^2
  RangeCosine n_dot_l_low, n_dot_l_high;
  RangeCosine specular_low, specular_high;  // N.H; R.V: bounds on the whole triangle
};

// What the choice needs of a material, relative to the tolerance.
struct ChoiceLimit {
  Log diffuse;        // log2 of 255 kd / tolerance, brightest channel
  Log specular;       // log2 of 255 ks / tolerance
  Log shininess_log;  // log2 n
  Shininess shininess;
  bool below_full = false;       // ambient + kd + ks <= 1 in every channel
  bool below_full_dark = false;  // ambient + kd <= 1
  uint8_t channels = 0;          // bit k: channel k is not black
};

// How a triangle is shaded.
struct Choice {
  Method method = Method::kFlat;
  bool dark = false;     // no highlight that would show
  bool ambient = false;  // nor diffuse light
  uint8_t channels = 0;  // bit k: channel k is not black

  friend bool operator==(const Choice& a, const Choice& b) {
    return a.method == b.method && a.dark == b.dark && a.ambient == b.ambient &&
           a.channels == b.channels;
  }
};

// Of every triangle in a frame of one method: nothing is left out.
constexpr Choice ChoiceOf(Method method) { return {method, false, false, 7}; }

}  // namespace shading
