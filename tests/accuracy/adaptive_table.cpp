// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/adaptive_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/normal/adaptive_normalizer.h"

namespace shading::accuracy {
namespace {

constexpr Effort kEffort = {10, 5, 30};
constexpr double kLeastDegrees = 0.05;

// As the front end has it, for a material with highlights unless n = 1.
AngleLimit LimitOf(double tolerance, int shininess, Lighting lighting = Lighting::kBlinn) {
  return AdaptiveNormalizer::LimitOf(Tolerance::Round(tolerance),
                                     Shininess::FromRaw(shininess << Shininess::kFraction),
                                     shininess > 1 || lighting == Lighting::kPhong, lighting);
}

double DegreesOf(const SpanCase& span) {
  const Direction a = Unit(ToReal(span.normal[0])), b = Unit(ToReal(span.normal[1]));
  const Direction sum = Combination(1, a, 1, b), difference = Combination(1, a, -1, b);
  const Real half = std::atan2(std::sqrt(Dot(difference, difference)), std::sqrt(Dot(sum, sum)));
  return static_cast<double>(2 * half * 180 / std::acos(Real(-1)));
}

void Search(const Cell& cell, AdaptiveWorst* worst) {
  const Worst found = WorstSearch(cell).Run(kEffort);
  if (found.lsb > worst->lsb) *worst = {found.lsb, DegreesOf(found.span), cell.length};
}

template <typename Lines>
void AddHeader(const std::string& first, const std::string& text, Lines* lines) {
  std::string names = "| " + first, rule = "|---";
  for (const int n : kAdaptiveShininess) {
    names += fmt::format(" | {}{}", n == 1 ? "n = " : "", n);
    rule += "|--:";
  }
  lines->push_back(names + text);
  lines->push_back(rule + (text == " |" ? "|" : "|--:|"));
}

std::vector<std::string> ErrorTable(Method method) {
  std::vector<std::string> lines;
  AddHeader("tolerance", method == Method::kAdaptive ? " | promised |" : " |", &lines);
  for (const double tolerance : kTolerances) {
    std::string line = fmt::format("| {}", tolerance);
    for (const int n : kAdaptiveShininess) {
      const AdaptiveWorst worst = WorstAdaptive(method, tolerance, n);
      line += fmt::format(" | {:.3f} at {:.4g} deg, {} px", worst.lsb, worst.degrees, worst.length);
    }
    if (method == Method::kAdaptive) line += fmt::format(" | {:.2f}", tolerance + kFixedPoint);
    lines.push_back(line + " |");
  }
  return lines;
}

// A span of 2^k steps, whose parts have a pixel in the middle, lit and seen from the normal of one
// of its pixels; its angle is just short of another level.
SpanCase SpanSeenFromAPixel(AngleLimit limit, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return Unit({normal(random), normal(random), normal(random)}); };
  const Direction a = draw(), other = draw();
  const Direction side = Unit(Combination(1, other, -Dot(other, a), a));
  const double part = std::acos(1 - std::ldexp(static_cast<double>(limit.raw()), -30));
  const double turn = std::min(2.0, std::ldexp(0.9999 * part, static_cast<int>(random() % 6)));
  const int steps = 2 << random() % 8;
  const int pixel = static_cast<int>(random() % static_cast<unsigned>(steps + 1));
  const double seen = turn * pixel / steps;
  const Direction b = Combination(std::cos(turn), a, std::sin(turn), side);
  const Direction light = Combination(std::cos(seen), a, std::sin(seen), side);
  SpanCase span;
  span.length = steps + 1;
  for (size_t c = 0; c < 3; ++c) {
    span.normal[0][c] = SpanNormalComponent::Round(static_cast<double>(a[c]));
    span.normal[1][c] = SpanNormalComponent::Round(static_cast<double>(b[c]));
    span.direction[c] = NormalComponent::Round(static_cast<double>(light[c]));
  }
  return span;
}

}  // namespace

AdaptiveWorst WorstAdaptive(Method method, double tolerance, int shininess) {
  Configuration configuration = {method};
  configuration.limit = LimitOf(tolerance, shininess);
  const Ideal ideal = method == Method::kAdaptiveChord ? Ideal::kPhong : Ideal::kSlerp;
  AdaptiveWorst worst;
  for (const int length : kAdaptiveLengths) {
    Search({configuration, ideal, length, kLeastDegrees, kMostDegrees, shininess}, &worst);
  }
  return worst;
}

AdaptiveWorst WorstExtended(double degrees, int shininess) {
  Configuration configuration = {Method::kAdaptivePaper};
  configuration.limit = LimitOf(0.5, shininess);
  AdaptiveWorst worst;
  for (const int length : {10, 34, 130, 514, 1026}) {
    Search({configuration, Ideal::kSlerp, length, kLeastPart * degrees, degrees, shininess},
           &worst);
  }
  return worst;
}

double WorstReflected(double tolerance, int shininess) {
  const BlinnSpecular power(Shininess::FromRaw(shininess << Shininess::kFraction));
  Configuration configuration = {Method::kAdaptive};
  configuration.limit = LimitOf(tolerance, shininess, Lighting::kPhong);
  std::mt19937 random(1);
  std::vector<LightCosines> cosines;
  IdealSpan ideal;
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const SpanCase span = SpanSeenFromAPixel(configuration.limit, random);
    ModelCosines(configuration, span, &cosines);
    ideal.Set(Ideal::kSlerp, span.normal, span.length);
    const IdealSpan::Row row = ideal.Cosines(span.direction);
    for (size_t t = 0; t < cosines.size(); ++t) {
      const double cosine = cosines[t].n_dot_l.ToReal();
      const double reflected = std::clamp(2 * cosine * cosine - 1, -1.0, 1.0);
      const double got = power.Of(Cosine::Round(reflected)).ToReal();
      const Real exact = IdealIntensity(2 * row.At(t) * row.At(t) - 1, shininess);
      worst = std::max(worst, 255 * std::abs(got - static_cast<double>(exact)));
    }
  }
  return worst;
}

std::vector<std::string> GuaranteeTable() { return ErrorTable(Method::kAdaptive); }
std::vector<std::string> ChordTable() { return ErrorTable(Method::kAdaptiveChord); }

std::vector<std::string> ExtensionTable() {
  std::vector<std::string> lines;
  AddHeader("degrees", " |", &lines);
  for (const double degrees : {5, 15, 30, 60, 90}) {
    std::string line = fmt::format("| {}", degrees);
    for (const int n : kAdaptiveShininess) {
      const AdaptiveWorst worst = WorstExtended(degrees, n);
      line += fmt::format(" | {:.1f} at {} px", worst.lsb, worst.length);
    }
    lines.push_back(line + " |");
  }
  return lines;
}

}  // namespace shading::accuracy
