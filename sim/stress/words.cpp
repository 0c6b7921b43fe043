// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/stress/growth.h"
#include "sim/stress/narrow_recurrence.h"
#include "sim/stress/quad_drift.h"

namespace shading::stress {
namespace {

constexpr int kPixels = 2048;
constexpr int kStateBits = 10;  // of slerp_recurrence's state beyond its multiplier's operand

double WorstOfTurns(Form form, int bits, int pixels, bool quick) {
  double worst = 0;
  for (const double degrees : {0.01, 0.1, 1.0, 5.0, 15.0, 30.0, 60.0, 90.0, 150.0, 179.0})
    worst = std::max(worst, WorstOfTurn(form, degrees, bits, pixels, quick ? 4 : 16));
  return worst;
}

// The scaled recurrence with all its bits: difference d 2^p and value with F + p of them, operand
// and kappa 2^(2p) with F, where 2^-p is just over 2 sin(phi / 2).
class ScaledStudy {
 public:
  ScaledStudy(const Arc& arc, int fraction_bits, bool truncate) : truncate_(truncate) {
    const Real chord = 2 * std::abs(std::sin(arc.phi / 2));
    const int p = static_cast<int>(std::floor(-std::log2(chord)));
    bits_ = fraction_bits + p;
    drop_ = p;
    kappa_ = RoundTo(std::ldexp(chord * chord, 2 * p), fraction_bits);
    value_ = RoundTo(arc.At(0), bits_);
    difference_ = RoundTo(arc.FirstDifference(), bits_);
  }
  Real value() const { return std::ldexp(static_cast<Real>(value_), -bits_); }
  void Step() {
    value_ += difference_;
    difference_ -= Shifted(kappa_ * Shifted(value_, drop_), bits_);
  }

 private:
  int64_t Shifted(int64_t raw, int n) const {
    return n == 0 ? raw : (raw + (truncate_ ? 0 : int64_t{1} << (n - 1))) >> n;
  }
  bool truncate_;
  int bits_ = 0, drop_ = 0;
  int64_t kappa_ = 0, value_ = 0, difference_ = 0;
};

// The worst pixel, any turn and phase, in ulp of 2^-20.
double ScaledUlps(int pixels, bool truncate, int phases) {
  Real worst = 0;
  for (const double degrees : {0.01, 0.1, 1.0, 5.0, 15.0, 30.0, 60.0, 90.0, 150.0, 179.0}) {
    const Real turn = kPi / 180 * static_cast<Real>(degrees), phi = turn / (pixels - 1);
    for (int i = 0; i < phases; ++i) {
      const Arc arc{phi, kPi * static_cast<Real>(i) / phases - turn / 2};
      ScaledStudy unit(arc, 20, truncate);
      for (int t = 0; t < pixels; ++t, unit.Step())
        Raise(&worst, std::abs(unit.value() - arc.At(t)));
    }
  }
  return static_cast<double>(std::ldexp(worst, 20));
}

const accuracy::DriftForm& DriftFormOf(const std::string& name) {
  static const std::vector<accuracy::DriftForm> forms = accuracy::DriftForms();
  return *std::find_if(forms.begin(), forms.end(),
                       [&](const accuracy::DriftForm& f) { return f.name == name; });
}

void AddPaper(int phases, std::vector<Reference>* references) {
  struct Paper {
    double degrees;
    int bits;
    double codes;
  };
  for (const Paper& p : {Paper{1, 16, 9.4},
                         {1, 20, 0.62},
                         {1, 24, 0.070},
                         {30, 16, 40},
                         {30, 20, 35},
                         {30, 24, 19},
                         {90, 16, 297},
                         {90, 20, 214},
                         {90, 24, 5.6}}) {
    references->push_back({fmt::format("000 (7), F = {}, {} degrees", p.bits, p.degrees), "codes",
                           p.codes, WorstOfTurn(Form::kPaper, p.degrees, p.bits, kPixels, phases)});
  }
}

void AddScaled(int phases, std::vector<Reference>* references) {
  struct Growing {
    int pixels;
    double nearest, truncated;  // ulp of 2^-20
  };
  for (const Growing& g : {Growing{16, 4, 20},
                           {64, 9, 68},
                           {256, 18, 253},
                           {1024, 45, 993},
                           {2048, 188, 1974},
                           {4096, 645, 3927}}) {
    references->push_back({fmt::format("scaled, F = 20, {} pixels, nearest", g.pixels), "2^-20",
                           g.nearest, ScaledUlps(g.pixels, false, phases)});
    references->push_back({fmt::format("scaled, F = 20, {} pixels, truncated", g.pixels), "2^-20",
                           g.truncated, ScaledUlps(g.pixels, true, phases)});
  }
}

void AddDrift(std::vector<Reference>* references) {
  struct Drift {
    std::string form;
    int bits, pixels;
    double codes;
  };
  for (const Drift& d : {Drift{"(5)", 16, 256, 0.50},
                         {"(5)", 20, 2047, 1.99},
                         {"(5)", 24, 4096, 0.50},
                         {"(7)", 20, 2047, 1.99},
                         {"(8)", 16, 256, 0.86},
                         {"(8)", 20, 2047, 3.25},
                         {"two registers, 2A", 16, 256, 0.25},
                         {"two registers, 2A", 20, 2047, 0.99},
                         {"two registers, 2A", 24, 2047, 0.062}}) {
    references->push_back({fmt::format("003 {}, F = {}, {} pixels", d.form, d.bits, d.pixels),
                           "codes", d.codes,
                           accuracy::WorstDrift(DriftFormOf(d.form), d.bits, d.pixels - 1)});
  }
}

}  // namespace

std::vector<Word> WordLengths(bool quick) {
  std::vector<Word> words;
  for (int f = kLeastWord; f <= kMostWord; f += quick ? 2 : 1) {
    const int state = f + kStateBits;
    words.push_back({"000 (7), as printed", f, WorstOfTurns(Form::kPaper, f, kPixels, quick),
                     WorstOfTurns(Form::kPaperTruncated, f, kPixels, quick)});
    words.push_back({"slerp_recurrence, F + 10", f,
                     WorstOfTurns(Form::kScaled, state, kPixels, quick),
                     WorstOfTurns(Form::kScaledTruncated, state, kPixels, quick)});
    for (const accuracy::DriftForm& form : accuracy::DriftForms()) {
      words.push_back({"003 " + form.name, f, accuracy::WorstDrift(form, f, kPixels - 1),
                       accuracy::WorstDrift(form, f, kPixels - 1, 0, true)});
    }
  }
  return words;
}

std::vector<Reference> References(bool quick) {
  std::vector<Reference> references;
  const int phases = quick ? 64 : 400;
  AddPaper(phases, &references);
  AddScaled(phases / 4, &references);
  AddDrift(&references);
  return references;
}

}  // namespace shading::stress
