// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/stress/growth.h"
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

const accuracy::DriftForm& DriftFormOf(const std::string& name) {
  static const std::vector<accuracy::DriftForm> forms = accuracy::DriftForms();
  return *std::find_if(forms.begin(), forms.end(),
                       [&](const accuracy::DriftForm& f) { return f.name == name; });
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
  const int phases = quick ? 8 : 32;
  struct Paper {
    double degrees;
    int bits;
    double codes;
  };
  for (const Paper& p : {Paper{1, 16, 9.4}, {1, 20, 0.62}, {1, 24, 0.070}, {30, 16, 40},
                         {30, 20, 35}, {30, 24, 19}, {90, 16, 297}, {90, 20, 214}, {90, 24, 5.6}}) {
    references.push_back({fmt::format("000 (7), F = {}, {} degrees", p.bits, p.degrees), "codes",
                          p.codes, WorstOfTurn(Form::kPaper, p.degrees, p.bits, kPixels, phases)});
  }
  struct Growing {
    int pixels;
    double nearest, truncated;  // ulp of 2^-20
  };
  for (const Growing& g : {Growing{16, 4, 20}, {64, 9, 68}, {256, 18, 253}, {1024, 45, 993},
                           {2048, 188, 1974}, {4096, 645, 3927}}) {
    const auto ulps = [&](Form form) {
      return std::ldexp(WorstOfTurns(form, 20 + kStateBits, g.pixels, quick) / 255, 20);
    };
    references.push_back({fmt::format("scaled, F = 20, {} pixels, nearest", g.pixels), "2^-20",
                          g.nearest, ulps(Form::kScaled)});
    references.push_back({fmt::format("scaled, F = 20, {} pixels, truncated", g.pixels), "2^-20",
                          g.truncated, ulps(Form::kScaledTruncated)});
  }
  struct Drift {
    std::string form;
    int bits, pixels;
    double codes;
  };
  for (const Drift& d :
       {Drift{"(5)", 16, 256, 0.50}, {"(5)", 20, 2047, 1.99}, {"(5)", 24, 4096, 0.50},
        {"(7)", 20, 2047, 1.99}, {"(8)", 16, 256, 0.86}, {"(8)", 20, 2047, 3.25},
        {"two registers, 2A", 16, 256, 0.25}, {"two registers, 2A", 20, 2047, 0.99},
        {"two registers, 2A", 24, 2047, 0.062}}) {
    references.push_back({fmt::format("003 {}, F = {}, {} pixels", d.form, d.bits, d.pixels),
                          "codes", d.codes,
                          accuracy::WorstDrift(DriftFormOf(d.form), d.bits, d.pixels - 1)});
  }
  return references;
}

}  // namespace shading::stress
