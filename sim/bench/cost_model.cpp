// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/cost_model.h"

#include <algorithm>

namespace shading::sim {
namespace {

// Parts that methods share: multiplications, additions, shifts, look-ups.
constexpr Operations kTwoDots = {6, 4, 0, 0};  // N.L and N.H of a vector
constexpr Operations kColour = {6, 9, 3, 0};   // ka + kd d + ks s, times 255 = 2^8 - 1; 3 channels
constexpr Operations kPower = {5, 6, 2, 2};    // x^n by two tables of quadratics
constexpr Operations kRoot = {2, 2, 2, 1};     // reciprocal square root by one table
constexpr Operations kQuadratic = {2, 2, 0, 1};            // a value of a table of quadratics
constexpr Operations kNormalise = Operations{6, 2, 3, 0};  // 3 squares, 3 products, beside kRoot

// Normals at both ends of a span step down the edges: one addition a component, or the slerp's
// product and two additions, paper 000 (7).
constexpr Operations kLinearEnds = {0, 6, 0, 0};
constexpr Operations kSphericalEnds = {6, 12, 6, 0};

// Per channel: 3 of them.
Operations Channels(const Operations& one) { return 3 * one; }

Operations Normalisation() { return kNormalise + kRoot; }

// Light of one vertex or node, the highlight in it.
Operations NodeLight() { return kTwoDots + kColour + kPower; }

// surface_fit: 27 products of planes, then some a channel.
MethodCost Surface(int nodes, double products_a_channel, const Operations& start,
                   const Operations& pixel, const char* reason) {
  MethodCost cost;
  const double fit = 27 + 3 * products_a_channel;
  // A node at the middle of an edge needs its cosines: the mean of the ends' over a root.
  const Operations middles = std::max(0, nodes - 3) * (kRoot + Operations{5, 4, 0, 0});
  cost.triangle = nodes * NodeLight() + middles + Operations{fit, fit, 0, 0};
  cost.span = Channels(start);
  cost.pixel = Channels(pixel);
  cost.reason = reason;
  return cost;
}

// Row start by paper 003 (9) and the difference by (3) from its terms; 2A; then what a unit's load
// adds.
Operations RowStart(const Operations& load) { return Operations{5, 7, 2, 0} + load; }

// A row form of paper 003, all of the six-node surface.
MethodCost Row(const Operations& load, const Operations& pixel, const char* reason) {
  return Surface(6, 27, RowStart(load), pixel, reason);
}

// A method that lights every pixel: start of its span, normal or cosines of a pixel.
MethodCost Lit(const Operations& span, const Operations& pixel, const char* reason) {
  MethodCost cost;
  cost.span = span;
  cost.pixel = pixel + kColour;
  cost.highlight = kPower;
  cost.reason = reason;
  return cost;
}

// 1/m, and a difference of each quantity.
Operations LinearStart(int quantities) {
  return kLinearEnds + kQuadratic + quantities * Operations{1, 1, 1, 0};
}

// normal_setup: chord and its square, 1/m^2, four functions by tables, kappa and r, then two
// products a quantity.
Operations SphericalStart(int quantities) {
  return kSphericalEnds + 5 * kQuadratic + Operations{3 + 1 + 6, 5 + 2, 3, 0} +
         quantities * Operations{2, 1, 0, 0};
}

// N.L and N.H of both ends.
constexpr Operations kEndCosines = {12, 8, 0, 0};

// adaptive_normalizer: chord and its square, 1/m, a level of the ladder of 1/z, and the slope of
// the first part; each further normal takes its own products and the slope of a part.
MethodCost Adaptive(const Operations& ends, const Operations& normal, const char* reason) {
  constexpr Operations kSlope = {3, 3, 3, 0};
  MethodCost cost = Lit(ends + 3 * kQuadratic + Operations{3, 5, 1, 0} + kSlope,
                        Operations{0, 3, 0, 0} + kTwoDots, reason);
  cost.normalisation = normal + kSlope;
  return cost;
}

// aniso_footprint and footprint_mean: a sample is an offset normal, lit; its sums and, in the
// paper's form, the inside test. A pixel has the division of two sums by the number of samples.
MethodCost Footprint(const Operations& inside, const char* reason) {
  MethodCost cost;
  cost.span = LinearStart(3);
  cost.pixel = Operations{2, 3, 0, 0} + kColour;
  cost.sample = Operations{0, 3 + 2, 0, 0} + inside + kNormalise + kRoot + kTwoDots + kPower;
  cost.reason = reason;
  return cost;
}

// quad-cosine: surfaces of N.L and N.H. phong-surface: their planes, and |N|^2 from the chords
// between the normals; the RTL steps planes as surfaces.
MethodCost CosineCost(Method method) {
  if (method == Method::kPhongSurface) {
    MethodCost cost = Lit(3 * RowStart({}), Operations{2, 6, 2, 0} + kRoot,
                          "N.L, N.H and |N|^2 by additions, a reciprocal root; set up by triangle");
    cost.triangle = 3 * kTwoDots + Operations{9 + 18 + 27, 15 + 18 + 27, 0, 0};
    return cost;
  }
  MethodCost cost = Lit(2 * RowStart({}), {0, 4, 0, 0}, "N.L and N.H by differences, then light");
  cost.triangle = 3 * kTwoDots + 3 * (kRoot + Operations{5, 4, 0, 0}) + Operations{81, 81, 0, 0};
  return cost;
}

MethodCost SurfaceCost(Method method) {
  switch (method) {
    case Method::kFlat: {
      MethodCost cost;
      cost.triangle = Operations{0, 6, 0, 0} + Normalisation() + NodeLight();
      cost.reason = "one light a triangle";
      return cost;
    }
    case Method::kGouraud: return Surface(3, 9, {2, 2, 0, 0}, {0, 1, 0, 0}, "3 lights; I += D");
    case Method::kQuad: return Row({0, 1, 0, 0}, {0, 2, 1, 0}, "003 (5): 2 I(x+1) - I(x) + 2A");
    case Method::kQuadPolynomial:
      return Surface(6, 27, {}, {8, 5, 0, 0}, "003 (2): 8 products at every pixel");
    case Method::kQuadHorner:
      return Surface(6, 27, {}, {5, 5, 0, 0}, "003 (9): 5 products at every pixel");
    case Method::kQuadStep: return Row({}, {1, 2, 0, 0}, "003 (3), 2A and A + Cy + D kept");
    case Method::kQuadMidpoint: return Row({0, 2, 3, 0}, {0, 2, 1, 0}, "003 (5) of stride 2, (6)");
    case Method::kQuadThreeTerm: return Row({0, 2, 1, 0}, {0, 3, 0, 0}, "003 (7), 4A kept");
    case Method::kQuadThirdDifference:
      return Row({0, 2, 0, 0}, {0, 3, 1, 0}, "003 (8) as 3 (I(x+2) - I(x+1)) + I(x)");
    case Method::kQuadSegment:
      return Row({0, 2, 2, 0}, {0, 1.25, 0, 0}, "003, slope kept, in segments of 4 pixels");
    case Method::kQuadDifference: return Row({}, {0, 2, 0, 0}, "I += d, d += 2A");
    case Method::kQuadFootprint:
      return Row({0, 1, 0, 0}, {0, 2, 1, 0}, "003 (5); the mean over a footprint is in F");
    case Method::kQuadSplit: {
      MethodCost cost = Surface(6, 54, 2 * RowStart({}), {0, 6, 0, 0},
                                "two surfaces a channel by differences, and their sum");
      return cost;
    }
    default: break;
  }
  return CosineCost(method);
}

// method_choice, and the cosines at the vertices that it goes by.
MethodCost ChoiceCost() {
  MethodCost cost;
  cost.triangle = 3 * kTwoDots + Operations{9 + 1, 15 + 40, 8, 5};
  cost.reason = "cosines and chords of the vertices, one product and some sums of logarithms";
  return cost;
}

MethodCost NormalCost(Method method) {
  switch (method) {
    case Method::kPhong:
      return Lit(LinearStart(3), Operations{0, 3, 0, 0} + Normalisation() + kTwoDots,
                 "3 additions, 6 products and a reciprocal root, 2 dot products");
    case Method::kPhongTaylor:
      return Lit(LinearStart(3), Operations{7, 9, 3, 0} + kTwoDots,
                 "3 additions, |N|^2, its series, 3 products, 2 dot products");
    case Method::kPhongDuff:
      return Lit(LinearStart(2) + kEndCosines + Operations{9 + 3, 6 + 2, 2, 0},
                 Operations{2, 4, 2, 0} + kRoot,
                 "N.L, N.H and |N|^2 by additions, a reciprocal root");
    case Method::kSlerp:
      return Lit(SphericalStart(3), Operations{3, 6, 3, 0} + kTwoDots,
                 "000 (7), Reinsch's form: 1 product, 2 additions, 1 shift a component");
    case Method::kSlerpPaper:
      return Lit(SphericalStart(3), Operations{3, 3, 0, 0} + kTwoDots,
                 "000 (7): 1 product, 1 subtraction a component; 2 cos(phi) is one factor");
    case Method::kSlerpIntensity:
      return Lit(SphericalStart(2) + kEndCosines, {2, 4, 2, 0},
                 "000 (14), Reinsch's form, no vector");
    case Method::kSlerpDirect:
      return Lit(SphericalStart(3) + kRoot + 2 * kQuadratic + Operations{9 + 6, 3 + 3, 6, 0},
                 Operations{6, 85, 54, 0} + kTwoDots,
                 "000 (6): 27 rotations of a CORDIC of 3 additions and 2 shifts, 6 products");
    case Method::kAdaptive:
      return Adaptive(kSphericalEnds, {3, 3, 0, 0}, "002: 3 additions; a normal is a sum over z");
    case Method::kAdaptivePaper:
      return Adaptive(kSphericalEnds, {3, 3, 0, 0},
                      "002 as printed; the root of its end is left out");
    case Method::kAdaptiveChord:
      return Adaptive(kLinearEnds, Operations{3, 3, 0, 0} + Normalisation(),
                      "3 additions; a normal is a point of the chord, normalised");
    case Method::kFootprint:
      return Footprint({}, "001, seamless: 3 additions a sample, light of each");
    case Method::kFootprintPaper:
      return Footprint({0, 3, 0, 0}, "001: samples outside the enlarged triangle are left out");
    default: return {};
  }
}

}  // namespace

MethodCost CostOf(Method method) {
  if (method == Method::kAuto) return ChoiceCost();
  return InterpolatesNormals(method) ? NormalCost(method) : SurfaceCost(method);
}

Operations VectorLight() { return kTwoDots + kColour; }

Operations TotalOf(const MethodCost& cost, const Workload& work) {
  const auto times = [](int64_t n) { return static_cast<double>(n); };
  return times(work.triangles) * cost.triangle + times(work.spans) * cost.span +
         times(work.pixels) * cost.pixel + times(work.highlights) * cost.highlight +
         times(work.normalisations) * cost.normalisation + times(work.samples) * cost.sample;
}

Operations TotalOf(Method method, const Workload& work) {
  if (method != Method::kAuto) return TotalOf(CostOf(method), work);
  Workload part;
  part.triangles = work.triangles;
  Operations total = TotalOf(CostOf(method), part);
  part.triangles = 0;
  part.highlights = work.highlights;
  total = total + TotalOf(CostOf(Method::kPhong), part);  // a highlight costs all methods the same
  for (const Method chosen : kAllMethods) {
    const MethodShare& share = work.share[static_cast<size_t>(chosen)];
    part = {share.triangles, share.spans, share.pixels, 0, 0, 0, {}};
    total = total + TotalOf(CostOf(chosen), part);
  }
  return total;
}

}  // namespace shading::sim
