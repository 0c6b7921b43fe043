// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/adaptive_table.h"

#include <fmt/format.h>

#include <cmath>

#include "model/normal/adaptive_normalizer.h"

namespace shading::accuracy {
namespace {

constexpr Effort kEffort = {10, 5, 30};
constexpr double kLeastDegrees = 0.05;

// As the front end has it, for a material with highlights unless n = 1.
AngleLimit LimitOf(double tolerance, int shininess) {
  return AdaptiveNormalizer::LimitOf(Tolerance::Round(tolerance),
                                     Shininess::FromRaw(shininess << Shininess::kFraction),
                                     shininess > 1);
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
