// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/growth.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/normal/slerp_paper.h"
#include "sim/stress/narrow_recurrence.h"

namespace shading::stress {
namespace {

enum class Form { kReinsch, kReinschTruncated, kPaper };

// The largest error of the pixels up to the last, in codes.
double WorstOfArc(Form form, const Arc& arc, int bits, int pixels) {
  Real worst = 0;
  const auto note = [&](Real value, int t) {
    worst = std::max(worst, std::abs(value - arc.At(t)));
  };
  if (form == Form::kPaper) {
    const std::array<QuantitySeed, kMaxLanes> seed = {
        QuantitySeed{Quantity::Wrap(RoundTo(arc.At(0), 38)),
                     Quantity::Wrap(RoundTo(arc.FirstDifference(), 38))}};
    SlerpPaper unit(seed, {KappaOf(arc.phi), KappaOf(2 * arc.phi)}, 1, bits);
    for (int t = 0; t < pixels; ++t, unit.Step())
      note(std::ldexp(static_cast<Real>(unit.value().raw()), -38), t);
  } else {
    NarrowRecurrence unit(arc, bits, form == Form::kReinschTruncated);
    for (int t = 0; t < pixels; ++t, unit.Step())
      note(std::ldexp(static_cast<Real>(unit.value()), -bits), t);
  }
  return static_cast<double>(255 * worst);
}

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

}  // namespace

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
    add(Form::kReinsch, "slerp_recurrence, nearest", bits);
    add(Form::kReinschTruncated, "slerp_recurrence, floor", bits);
    add(Form::kPaper, "slerp_paper, nearest", bits);
  }
  return curves;
}

std::vector<Heat> HeatMap(bool paper, int fraction_bits, bool quick) {
  std::vector<Heat> cells;
  for (const double degrees :
       {0.001, 0.01, 0.1, 1.0, 5.0, 15.0, 30.0, 60.0, 90.0, 120.0, 150.0, 170.0, 179.9}) {
    for (int pixels = 4; pixels <= 4096; pixels *= 2) {
      cells.push_back({degrees, pixels,
                       WorstOfTurn(paper ? Form::kPaper : Form::kReinsch, degrees, fraction_bits,
                                   pixels, quick ? 2 : 8)});
    }
  }
  return cells;
}

double DeadZone(int fraction_bits, int pixels) {
  return static_cast<double>(std::sqrt(std::ldexp(1.0L, -fraction_bits - 1)) * (pixels - 1) * 180 /
                             kPi);
}

}  // namespace shading::stress
