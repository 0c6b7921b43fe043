// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/triangle_packet.h"
#include "model/unit_contract.h"

namespace shading::stress {

using Real = long double;

// A point of the search, every number in 0..1; each check says what they stand for.
using Genes = std::vector<double>;

// The error of one unit for given operands. `narrow` asks for the unit with `narrow` bits less.
struct Check {
  std::string unit;
  std::string ulp;       // of errors and bound
  double bound = 0;      // what the unit states
  std::string valid;     // for which operands
  std::string narrowed;  // what loses a bit
  std::vector<std::string> genes;
  std::function<double(const Genes&, int narrow)> error;
  std::vector<Genes> starts;  // directed
  // The triangle of the operands, for units that set up triangles; nullopt where they make none.
  std::function<std::optional<TriangleList>(const Genes&)> triangle;
  int cost = 1;        // about microseconds of an evaluation
  double blind = 0.5;  // a search that finds less of the bound is blind
};

// Units without a check, and why.
struct Exempt {
  std::string unit, reason;
};

Check CheckOf(const UnitContract& unit, const std::string& ulp, const std::string& narrowed);

std::vector<Check> RecurrenceChecks();
std::vector<Check> QuadChecks();
std::vector<Check> NormalChecks();  // units that normalise and turn normals
std::vector<Check> SetupChecks();   // set-up of spans of normals
std::vector<Check> LightChecks();
std::vector<Check> VertexChecks();    // whole lights: of a vertex, of a pixel, of a footprint
std::vector<Check> TriangleChecks();  // set-up of triangles
std::vector<Check> TriangleNormalChecks();
std::vector<Check> PieceChecks();  // of a triangle: subdivision, footprints
// span_normals of N1 near -N0: up to 170 degrees, or beyond, as a part of what is allowed there.
Check OpposedNormals(bool beyond);
std::vector<Check> AllChecks();
std::vector<Exempt> Exemptions();

inline int64_t RoundTo(Real value, int fraction_bits) {
  return std::llround(std::ldexp(value, fraction_bits));
}
// Rounded to `fraction_bits` - narrow, in units of 2^-fraction_bits.
inline int64_t RoundNarrow(Real value, int fraction_bits, int narrow) {
  return RoundTo(value, fraction_bits - narrow) * (int64_t{1} << narrow);
}
// An output that loses its last `narrow` bits, rounded half up.
inline int64_t Narrowed(int64_t raw, int narrow) {
  return narrow == 0 ? raw
                     : ((raw + (int64_t{1} << (narrow - 1))) >> narrow) * (int64_t{1} << narrow);
}
// The largest so far; what is no number counts as infinite.
inline void Raise(Real* worst, Real off) {
  if (!(off <= *worst)) *worst = std::isnan(off) ? HUGE_VALL : off;
}
inline double Between(double low, double high, double gene) { return low + (high - low) * gene; }
// Even in the logarithm.
inline double Geometric(double low, double high, double gene) {
  return low * std::pow(high / low, gene);
}
inline constexpr Real kPi = 3.14159265358979323846264338327950288L;

}  // namespace shading::stress
