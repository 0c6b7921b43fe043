// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/shading_types.h"

namespace shading::accuracy {

// Rows of pixels as a processor would compute them by the formulas of paper 003, operation by
// operation as they are printed. Word is an integer or a CountedWord. Coordinates are numbers that
// the caller has anyway, so stepping them is no operation.

// A x^2 + B y^2 + C x y + D x + E y + F and the first point of a row.
template <typename Word>
struct RowPoint {
  Word a, b, c, d, e, f;
  int64_t x = 0, y = 0;
};

template <typename Word>
Word Number(int64_t number) {
  return Word(static_cast<uint64_t>(number));
}

// (9): the value, and what else of it serves the rest of the row.
template <typename Word>
struct RowStart {
  Word value;
  Word ax, cy;
  Word row;  // Ax + Cy + D
};

template <typename Word>
RowStart<Word> StartOf(const RowPoint<Word>& p) {
  const Word x = Number<Word>(p.x), y = Number<Word>(p.y);
  const Word ax = p.a * x, cy = p.c * y, row = ax + cy + p.d;
  return {row * x + (p.b * y + p.e) * y + p.f, ax, cy, row};
}

// (3), the value at x + 1.
template <typename Word>
Word NextByStep(const Word& value, const Word& a, const Word& cy, const Word& d, int64_t x) {
  return value + ((a * Number<Word>(x)) << 1) + a + cy + d;
}

// (5), the value at x + 2.
template <typename Word>
Word NextByTwo(const Word& zero, const Word& one, const Word& a) {
  return (one << 1) - zero + (a << 1);
}

template <typename Word>
std::vector<Word> StepRow(const Word& first, const Word& a, const Word& cy, const Word& d,
                          int64_t x, int pixels) {
  std::vector<Word> row = {first};
  while (static_cast<int>(row.size()) < pixels) {
    row.push_back(NextByStep(row.back(), a, cy, d, x));
    ++x;
  }
  return row;
}

// Continues a row of at least two, or three, pixels: next(row) is what follows.
template <typename Word, typename Next>
std::vector<Word> Continued(std::vector<Word> row, int pixels, const Next& next) {
  row.reserve(static_cast<size_t>(pixels));
  while (static_cast<int>(row.size()) < pixels) row.push_back(next(row.end()));
  return row;
}

template <typename Word>
std::vector<Word> TwoRow(std::vector<Word> row, const Word& a, int pixels) {
  return Continued(row, pixels, [&](auto end) { return NextByTwo(end[-2], end[-1], a); });
}
template <typename Word>
std::vector<Word> TwoRowKept(std::vector<Word> row, const Word& two_a, int pixels) {
  return Continued(row, pixels, [&](auto end) { return (end[-1] << 1) - end[-2] + two_a; });
}

// (7): 4A as two one-bit shifts, or kept.
template <typename Word>
std::vector<Word> ThreeTermRow(std::vector<Word> row, const Word& a, int pixels) {
  return Continued(row, pixels, [&](auto end) { return end[-1] + end[-2] - end[-3] + (a << 2); });
}
template <typename Word>
std::vector<Word> ThreeTermRowKept(std::vector<Word> row, const Word& four_a, int pixels) {
  return Continued(row, pixels, [&](auto end) { return end[-1] + end[-2] - end[-3] + four_a; });
}

// (8): two products by 3; without a product, as printed; and with one product by 3 as 2 + 1.
template <typename Word>
std::vector<Word> ThirdRowProducts(std::vector<Word> row, int pixels) {
  const Word three = Number<Word>(3);
  return Continued(row, pixels,
                   [&](auto end) { return three * end[-1] - three * end[-2] + end[-3]; });
}
template <typename Word>
std::vector<Word> ThirdRowShifts(std::vector<Word> row, int pixels) {
  return Continued(row, pixels, [&](auto end) {
    return (end[-1] << 1) + end[-1] - (end[-2] << 1) - end[-2] + end[-3];
  });
}
template <typename Word>
std::vector<Word> ThirdRowRise(std::vector<Word> row, int pixels) {
  return Continued(row, pixels, [&](auto end) {
    const Word rise = end[-1] - end[-2];
    return (rise << 1) + rise + end[-3];
  });
}

// Two registers: I += d, d += 2A. The last difference is not formed.
template <typename Word>
std::vector<Word> DifferenceRow(const Word& first, Word difference, const Word& two_a, int pixels) {
  std::vector<Word> row = {first};
  while (static_cast<int>(row.size()) < pixels) {
    if (row.size() > 1) difference = difference + two_a;
    row.push_back(row.back() + difference);
  }
  return row;
}

// Ends of segments of 2^k pixels as printed, both products anew for every segment, and the line
// between them: its slope, and an addition a pixel.
template <typename Word>
std::vector<Word> SegmentRow(const RowPoint<Word>& p, const Word& first, int k, int pixels) {
  std::vector<Word> row;
  Word start = first;
  for (int64_t x = p.x; static_cast<int>(row.size()) < pixels; x += int64_t{1} << k) {
    const Word end = start + ((p.a * Number<Word>(x)) << (k + 1)) + (p.a << (2 * k)) +
                     ((p.c * Number<Word>(p.y)) << k) + (p.d << k);
    const Word slope = (end - start) >> k;
    row.push_back(start);
    for (int i = 1; i < 1 << k && static_cast<int>(row.size()) < pixels; ++i) {
      row.push_back(row.back() + slope);
    }
    start = end;
  }
  return row;
}

// 2A = 1/32 code, and the tolerance that segments of 2^k pixels attain: 2A 4^k / 8.
inline constexpr int kBend = IntensityAcc::kFraction - 5;
inline const ChannelSeed kBent = {{}, {}, {}, IntensityAcc::FromRaw(int64_t{1} << kBend)};
inline Tolerance ToleranceFor(int k) { return Tolerance::FromRaw(int64_t{16} << (2 * k)); }

}  // namespace shading::accuracy
