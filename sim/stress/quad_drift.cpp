// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/quad_drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "sim/stress/quad_rows.h"

namespace shading::accuracy {
namespace {

constexpr int64_t kUlp = int64_t{1} << kFineBits;
constexpr int kRestarts = 3, kMoves = 60;
using Row = std::vector<int64_t>;

int64_t RoundToUlp(int64_t fine) { return (fine + kUlp / 2) & ~(kUlp - 1); }
Numbers Rounded(Numbers numbers, bool truncate) {
  for (int64_t& number : numbers) number = truncate ? number & ~(kUlp - 1) : RoundToUlp(number);
  return numbers;
}

// Start values that are the curve's own numbers, and start values that no fourth follows.
Numbers Same(const Numbers& curve) { return curve; }
void Free(Numbers* /*starts*/) {}
double Square(int t) { return static_cast<double>(t) * t; }

// A curve of some 100 codes at t, in the numbers of the form: the first a value, the others small
// enough that no form overflows. The recurrences are linear, so it hardly matters which.
Numbers RandomNumbers(int fraction_bits, int t, std::mt19937& random) {
  const double scale = std::ldexp(100, fraction_bits + kFineBits);
  const auto part = [&](double divisor) {
    const double unit = static_cast<double>(random()) / 4294967296.0 - 0.5;
    return static_cast<int64_t>(scale * unit / divisor);
  };
  return {part(1), part(t), part(Square(t)), 0};
}

// New bits below the ulp of one number: any, or the two that round farthest.
void Move(bool truncate, std::mt19937& random, Numbers* numbers) {
  int64_t& number = (*numbers)[random() % 3];
  const int64_t whole = RoundToUlp(number);
  switch (random() % 3) {
    case 0: number = whole + (truncate ? kUlp : kUlp / 2) - 1; return;
    case 1: number = whole - (truncate ? 0 : kUlp / 2); return;
    default: number = whole - kUlp / 2 + static_cast<int64_t>(random()) % kUlp; return;
  }
}

int64_t DriftOf(const DriftForm& form, const Numbers& exact, int t, bool truncate) {
  return std::abs(form.at(Rounded(exact, truncate), t) - form.at(exact, t));
}

std::vector<DriftForm> CoefficientForms() {
  return {
      {"(2), (9) on y = 0", "F, D, A", "t^2 + t + 1", Same, Free,
       [](const Numbers& s, int t) {
         const RowPoint<int64_t> point = {s[2], 0, 0, s[1], 0, s[0], t, 0};
         return StartOf(point).value;
       },
       [](int t) { return Square(t) + t + 1; }},
      {"(3)", "I(0), Cy + D, A", "t^2 + t + 1", Same, Free,
       [](const Numbers& s, int t) {
         return StepRow<int64_t>(s[0], s[2], 0, s[1], 0, t + 1).back();
       },
       [](int t) { return Square(t) + t + 1; }},
  };
}

// From the first two or three pixels.
std::vector<DriftForm> PixelForms() {
  const auto two_values = [](const Numbers& n) {
    return Numbers{n[0], n[0] + n[1], n[2], 0};  // I(0), I(1), A
  };
  const auto three_values = [](const Numbers& n) {
    return Numbers{n[0], n[0] + n[1], n[0] + 2 * n[1] + 2 * n[2], 0};  // I(0), I(1), I(2)
  };
  const auto tied = [](Numbers* n) { (*n)[3] = 2 * (*n)[1] - (*n)[0] + 2 * (*n)[2]; };  // I(2)
  return {
      {"(5)", "I(0), I(1), A", "t^2 + t - 1", two_values, Free,
       [](const Numbers& s, int t) {
         return TwoRow(Row{s[0], s[1]}, s[2], t + 1).back();
       },
       [](int t) { return Square(t) + t - 1; }},
      {"(7)", "I(0), I(1), I(2), A", "t^2 - t + 1, t even: - 1", two_values, tied,
       [](const Numbers& s, int t) {
         return ThreeTermRow(Row{s[0], s[1], s[3]}, s[2], t + 1).back();
       },
       [](int t) { return Square(t) - t + (t % 2 ? 1 : -1); }},
      {"(8)", "I(0), I(1), I(2)", "2 t^2 - 4 t + 1", three_values, Free,
       [](const Numbers& s, int t) {
         return ThirdRowRise(Row{s[0], s[1], s[2]}, t + 1).back();
       },
       [](int t) { return 2 * Square(t) - 4 * t + 1; }},
  };
}

std::vector<DriftForm> RegisterForms() {
  return {
      {"two registers, A", "I(0), d(0), A", "t^2 + 1", Same, Free,
       [](const Numbers& s, int t) {
         return DifferenceRow<int64_t>(s[0], s[1], 2 * s[2], t + 1).back();
       },
       [](int t) { return Square(t) + 1; }},
      {"two registers, 2A", "I(0), d(0), 2A", "1 + t + t (t - 1) / 2", Same, Free,
       [](const Numbers& s, int t) {
         return DifferenceRow<int64_t>(s[0], s[1], s[2], t + 1).back();
       },
       [](int t) { return 1 + t + (Square(t) - t) / 2; }},
  };
}

}  // namespace

// Curves in numbers: value, difference or second value, A or 2A.
std::vector<DriftForm> DriftForms() {
  std::vector<DriftForm> all = CoefficientForms();
  for (const auto& forms : {PixelForms(), RegisterForms()}) {
    all.insert(all.end(), forms.begin(), forms.end());
  }
  return all;
}

double WorstDrift(const DriftForm& form, int fraction_bits, int t, unsigned seed, bool truncate) {
  std::mt19937 random(static_cast<unsigned>(fraction_bits * 10000 + t) + seed);
  int64_t worst = 0;
  for (int restart = 0; restart < kRestarts; ++restart) {
    Numbers best = form.starts(RandomNumbers(fraction_bits, t, random));
    form.tie(&best);
    int64_t found = DriftOf(form, best, t, truncate);
    for (int move = 0; move < kMoves; ++move) {
      Numbers next = best;
      Move(truncate, random, &next);
      form.tie(&next);
      const int64_t drift = DriftOf(form, next, t, truncate);
      if (drift < found) continue;
      best = next;
      found = drift;
    }
    worst = std::max(worst, found);
  }
  return std::ldexp(static_cast<double>(worst), -fraction_bits - kFineBits);
}

double DriftBound(const DriftForm& form, int fraction_bits, int t) {
  return std::ldexp(form.half_ulps(t), -fraction_bits - 1);
}

std::vector<std::string> DriftTable() {
  std::string head = "| form | rounded | bound, half ulps | F |", rule = "|---|---|---|--:|";
  for (const int t : kDriftPixels) {
    head += fmt::format(" t = {} |", t);
    rule += "--:|";
  }
  std::vector<std::string> lines = {head + " of the bound |", rule + "--:|"};
  for (const DriftForm& form : DriftForms()) {
    for (const int bits : kDriftBits) {
      std::string line = bits == kDriftBits[0]
                             ? fmt::format("| {} | {} | {} |", form.name, form.rounded, form.bound)
                             : "| | | |";
      line += fmt::format(" {} |", bits);
      double share = 1;
      for (const int t : kDriftPixels) {
        const double worst = WorstDrift(form, bits, t);
        share = std::min(share, worst / DriftBound(form, bits, t));
        line += fmt::format(" {:.3g} |", worst);
      }
      lines.push_back(line + fmt::format(" {:.4f} |", share));
    }
  }
  return lines;
}

std::vector<std::string> DriftGrowth() {
  constexpr int kBits = 26;
  const std::vector<DriftForm> forms = DriftForms();
  std::string head = "# t";
  for (const DriftForm& form : forms) {
    head += fmt::format(" \"{}\" \"{}, bound\"", form.name, form.name);
  }
  std::vector<std::string> lines = {head};
  for (const int t : {2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2047, 4095}) {
    std::string line = fmt::format("{}", t);
    for (const DriftForm& form : forms) {
      line += fmt::format(" {:.6g} {:.6g}", WorstDrift(form, kBits, t), DriftBound(form, kBits, t));
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace shading::accuracy
