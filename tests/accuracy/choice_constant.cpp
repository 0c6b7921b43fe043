// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/choice_constant.h"

#include <algorithm>
#include <cmath>

#include "model/choice/method_choice.h"
#include "model/choice/method_choice_table.h"
#include "tests/accuracy/choice_triangle.h"

namespace shading::accuracy {
namespace {

using ideal::Dot;

constexpr double kDegrees = 180 / 3.14159265358979323846;
constexpr double kOutside = -500;

struct Range {
  double low = 9, high = -9;
  void Take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// -log2 of the highlight's bound on the triangle, as the choice has it, in double.
double HighlightLog(const ChoicePoint& point, const ChoiceCase& at, Lighting lighting) {
  const double turn = point.chord * point.chord;
  Range other, sum, difference;
  for (const ideal::Vector& normal : at.normal) {
    const double a = Dot(normal, at.light), b = Dot(normal, at.half_or_view);
    other.Take(b);
    sum.Take(a + b);
    difference.Take(a - b);
  }
  double t = 23.0 / 16 * (1 - other.high) - (turn < 0.25 ? 65.0 / 256 : 5.0 / 16) * turn;
  if (lighting == Lighting::kPhong) {
    const double most = std::max(sum.high, -sum.low);
    const double least = std::max({difference.low, -difference.high, 0.0});
    const double high =
        (most * most * (1 + turn / 2) - least * least) / 2 - Dot(at.light, at.half_or_view);
    t = 23.0 / 16 * (1 - std::min(high, 1.0));
  }
  return std::max(0.0, point.shininess * t);
}

// log2 of what the constant is multiplied with, apart from the light's coefficient.
double FormLog(const ChoiceConstant& constant, const ChoicePoint& point) {
  const double l = std::log2(point.chord), n = std::log2(point.shininess);
  const double few = std::max(0.0, (2 - n) / 2);
  const bool linear = constant.light == ChoiceConstant::Light::kTerminator;
  const bool highlight = constant.light == ChoiceConstant::Light::kHighlight;
  switch (constant.method) {
    case Method::kFlat: return highlight ? l + n / 2 + few : l;
    case Method::kGouraud: return highlight ? 2 * l + n : linear ? l : 2 * l;
    case Method::kQuad: return highlight ? 3 * l + 1.5 * n + few : linear ? l : 3 * l;
    default: break;
  }
  if (!highlight) return 3 * l;
  const double reflected = constant.lighting == Lighting::kPhong ? 1 : 0;
  const double wide = std::max(0.0, l + n / 2 + reflected - choice_table::kWide / 32.0);
  const bool bends = constant.method == Method::kQuadCosine && constant.highlight == 0;
  return 3 * l + n / 2 + few + (bends ? wide : 0);
}

// Triangles that the constant is not meant for.
bool IsOutside(const ChoiceConstant& constant, const ChoicePoint& point, const ChoiceCase& at) {
  Range lit, specular;
  for (const ideal::Vector& normal : at.normal) {
    lit.Take(Dot(normal, at.light));
    specular.Take(Dot(normal, at.half_or_view));
  }
  const bool fits = constant.method == Method::kGouraud || constant.method == Method::kQuad;
  switch (constant.light) {
    case ChoiceConstant::Light::kLit: return fits && lit.low < 0;
    case ChoiceConstant::Light::kTerminator: return lit.low >= 0 || lit.high <= 0;
    default: return fits && point.shininess < 4 && specular.low < 0.5;
  }
}

double Logarithm(const ChoiceConstant& constant, const ChoicePoint& point) {
  const ChoiceCase at = point.Case();
  if (IsOutside(constant, point, at)) return kOutside;
  const bool highlight = constant.light == ChoiceConstant::Light::kHighlight;
  double fall = 0;
  if (highlight) {
    const double log = HighlightLog(point, at, constant.lighting), k = constant.highlight;
    if (log < k) return kOutside / 2 + log - k;
    if (k < 15 && log >= k + 1) return kOutside / 2 + k + 1 - log;
    if (k >= 4 && k < 15) fall = (log - k) * 3 / 4;
  }
  ChoiceLight light;
  light.lighting = constant.lighting;
  light.shininess = point.shininess;
  (highlight ? light.specular : light.diffuse) = 1;
  const double error =
      std::abs(ExactCodes(light, at) - ShownCodes(constant.method, light, at)) / 255;
  if (error < 1e-13) return kOutside / 4;
  // flat's error is the same on an edge as elsewhere.
  const double weight = point.edge || constant.method == Method::kFlat ? 2 : 1;
  return std::log2(weight * error) - FormLog(constant, point) + fall;
}

// Kinds of light for the limits: L or H anywhere over the triangle, full scale.
ChoiceLimit LimitOf(int shininess) {
  return MethodChoice::LimitOf(
      PlainMaterial(0, shininess == 0, shininess != 0, std::max(shininess, 1)),
      Tolerance::Round(1));
}

double WorstError(Method method, int shininess, double chord, const ChoiceEffort& effort) {
  double worst = 0;
  for (const bool edge : {false, true}) {
    ChoiceRegion region;
    region.least_chord = region.most_chord = chord;
    region.least_shininess = region.most_shininess = std::max(shininess, 1);
    region.edge = edge;
    const ChoiceConstant constant = {
        method, shininess == 0 ? ChoiceConstant::Light::kLit : ChoiceConstant::Light::kHighlight};
    const auto error = [&](const ChoicePoint& point) {
      const ChoiceCase at = point.Case();
      if (IsOutside(constant, point, at)) return -1.0;
      ChoiceLight light;
      light.shininess = point.shininess;
      (shininess == 0 ? light.diffuse : light.specular) = 1;
      const double codes = std::abs(ExactCodes(light, at) - ShownCodes(method, light, at));
      return codes * (edge || method == Method::kFlat ? 2 : 1);
    };
    worst =
        std::max(worst, ChoiceSearch(5).Run(region, error, effort.restarts, effort.steps).value);
  }
  return worst;
}

// The largest chord, at most 1, for which a rising test holds, as an angle.
template <typename Test>
double LargestDegrees(const Test& test, int steps) {
  double low = 1e-5, high = 1;
  for (int i = 0; i < steps; ++i) {
    const double middle = std::sqrt(low * high);
    (test(middle) ? low : high) = middle;
  }
  return 2 * std::asin(low / 2) * kDegrees;
}

}  // namespace

double WorstConstant(const ChoiceConstant& constant, const ChoiceEffort& effort) {
  const bool highlight = constant.light == ChoiceConstant::Light::kHighlight;
  double worst = kOutside;
  for (const bool edge : {false, true}) {
    ChoiceRegion region;
    region.edge = edge;
    region.least_chord = highlight ? 0.0008 : 0.02;
    region.highlight = constant.highlight;
    region.reflected = constant.lighting == Lighting::kPhong;
    if (!highlight) region.most_shininess = 1 + 1e-9;
    const auto logarithm = [&](const ChoicePoint& point) { return Logarithm(constant, point); };
    ChoiceSearch search(static_cast<unsigned>(2 * constant.highlight + edge));
    worst = std::max(worst, search.Run(region, logarithm, effort.restarts, effort.steps).value);
  }
  return worst;
}

double AllowedDegrees(Method method, int shininess) {
  const ChoiceLimit limit = LimitOf(shininess);
  return LargestDegrees(
      [&](double chord) {
        LightRange range;
        range.turn = Turn::Saturate(
            static_cast<int64_t>(std::ceil(std::ldexp(chord * chord, Turn::kFraction))));
        range.n_dot_l_high = range.specular_low = range.specular_high = RangeCosine::Round(1);
        for (const auto& bound : MethodChoice::BoundsOf(range, limit, Lighting::kBlinn)) {
          if (bound.method == method) {
            return MethodChoice::LogAdd(bound.diffuse, bound.specular) <= 0;
          }
        }
        return true;
      },
      30);
}

double SearchedDegrees(Method method, int shininess, const ChoiceEffort& effort) {
  return LargestDegrees(
      [&](double chord) { return WorstError(method, shininess, chord, effort) <= 1; }, 14);
}

}  // namespace shading::accuracy
