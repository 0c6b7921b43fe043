// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/growth.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/stress/narrow_paper.h"
#include "sim/stress/quad_drift.h"

namespace shading::stress {
namespace {

template <typename Unit>
double WorstPixel(Unit unit, const Arc& arc, int bits, int pixels) {
  Real worst = 0;
  for (int t = 0; t < pixels; ++t, unit.Step())
    Raise(&worst, std::abs(std::ldexp(static_cast<Real>(unit.value()), -bits) - arc.At(t)));
  return static_cast<double>(255 * worst);
}

// The largest error of the pixels up to the last, in codes.
double WorstOfArc(Form form, const Arc& arc, int bits, int pixels) {
  const bool truncate = form == Form::kScaledTruncated || form == Form::kPaperTruncated;
  return form == Form::kPaper || form == Form::kPaperTruncated
             ? WorstPixel(NarrowPaper(arc, bits, truncate), arc, bits, pixels)
             : WorstPixel(NarrowRecurrence(arc, bits, truncate), arc, bits, pixels);
}

}  // namespace

double WorstOfTurn(Form form, double degrees, int bits, int pixels, int phases) {
  const Real turn = kPi / 180 * static_cast<Real>(degrees);
  const Real phi = turn / std::max(1, pixels - 1);
  if (phi > kPi / 2) return 0;
  double worst = 0;
  for (int i = 0; i < phases; ++i) {
    const Arc arc{phi, kPi * static_cast<Real>(i) / phases - turn / 2};
    worst = std::max(worst, WorstOfArc(form, arc, bits, pixels));
  }
  return worst;
}

std::vector<Growth> GrowthCurves(bool quick) {
  std::vector<Growth> curves;
  const auto add = [&](Form form, const std::string& name, int bits) {
    Growth growth{name, bits, {}};
    for (int pixels = 4; pixels <= 4096; pixels *= quick ? 4 : 2) {
      double worst = 0;
      for (const double degrees : {0.01, 0.1, 1.0, 5.0, 15.0, 30.0, 60.0, 90.0, 150.0})
        worst = std::max(worst, WorstOfTurn(form, degrees, bits, pixels, quick ? 4 : 16));
      growth.points.emplace_back(pixels, worst);
    }
    curves.push_back(growth);
  };
  for (const int bits : {14, 20, 26, 32, 38}) {
    add(Form::kScaled, "slerp_recurrence, nearest", bits);
    add(Form::kScaledTruncated, "slerp_recurrence, truncated", bits);
    add(Form::kPaper, "slerp_paper, nearest", bits);
    add(Form::kPaperTruncated, "slerp_paper, truncated", bits);
  }
  // Second order, start values and coefficients rounded to nearest; (2) is rounded as (3) is.
  for (const int bits : {20, 26}) {
    for (const accuracy::DriftForm& form : accuracy::DriftForms()) {
      if (form.name.find("(2)") != std::string::npos) continue;
      Growth growth{form.name, bits, {}, "003"};
      for (int pixels = 4; pixels <= 4096; pixels *= quick ? 4 : 2)
        growth.points.emplace_back(pixels, accuracy::WorstDrift(form, bits, pixels - 1));
      curves.push_back(growth);
    }
  }
  return curves;
}

std::vector<Heat> HeatMap(Form form, int fraction_bits, bool quick) {
  std::vector<Heat> cells;
  for (const double degrees :
       {0.001, 0.01, 0.1, 1.0, 5.0, 15.0, 30.0, 60.0, 90.0, 120.0, 150.0, 170.0, 179.9}) {
    for (int pixels = 4; pixels <= 4096; pixels *= 2) {
      cells.push_back(
          {degrees, pixels, WorstOfTurn(form, degrees, fraction_bits, pixels, quick ? 2 : 8)});
    }
  }
  return cells;
}

double DeadZone(int fraction_bits, int pixels) {
  return static_cast<double>(std::sqrt(std::ldexp(1.0L, -fraction_bits - 1)) * (pixels - 1) * 180 /
                             kPi);
}

}  // namespace shading::stress
