// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace shading::tables {

// Quadratic on each of 2^k equal segments of [0, 1), in integers:
//
//   f(u) = value + (slope + curvature d) d,   d the distance from the start of u's segment
//
// Values at the borders and second derivatives in the middle are rounded to nearest; the slope is
// the largest that does not exceed the next border. A function with positive derivatives keeps
// rising then, whatever is truncated on the way.
struct Format {
  const char* name;
  int segments_log2;
  int value, slope, curvature;  // fraction bits
};

inline constexpr Format kLogFormat = {"Log", 7, 30, 22, 17};
inline constexpr Format kExpFormat = {"Exp", 5, 22, 17, 13};

inline long double Log(long double u) { return -std::log2(1 - u / 2); }
inline long double Exp(long double g) { return std::exp2(g); }
// Half of the second derivatives.
inline long double LogCurvature(long double u) {
  return 1 / (8 * std::log(2.0L) * (1 - u / 2) * (1 - u / 2));
}
inline long double ExpCurvature(long double g) {
  return std::log(2.0L) * std::log(2.0L) / 2 * std::exp2(g);
}

struct Segment {
  int64_t value, slope, curvature;
};

template <typename F, typename C>
std::vector<Segment> Fit(const Format& format, F f, C half_second_derivative) {
  const int segments = 1 << format.segments_log2;
  const auto border = [&](int k) {
    const long double u = std::ldexp(static_cast<long double>(k), -format.segments_log2);
    return std::llround(std::ldexp(f(u), format.value));
  };
  std::vector<Segment> table;
  for (int k = 0; k < segments; ++k) {
    const long double middle = (k + 0.5L) / segments;
    const int64_t curvature =
        std::llround(std::ldexp(half_second_derivative(middle), format.curvature));
    const long double chord = std::ldexp(static_cast<long double>(border(k + 1) - border(k)),
                                         format.slope - format.value + format.segments_log2);
    const long double bend = std::ldexp(static_cast<long double>(curvature),
                                        format.slope - format.curvature - format.segments_log2);
    table.push_back({border(k), static_cast<int64_t>(std::floor(chord - bend)), curvature});
  }
  return table;
}

inline std::vector<Segment> LogTable() { return Fit(kLogFormat, Log, LogCurvature); }
inline std::vector<Segment> ExpTable() { return Fit(kExpFormat, Exp, ExpCurvature); }

inline const char* kModelFile = "model/light/specular_table.h";
inline const char* kRtlFile = "rtl/pkg/specular_table_pkg.sv";

// The table as C++: one row a segment.
inline void WriteModel(std::ostream& out) {
  out << "// SPDX-License-Identifier: Apache-2.0\n// Written by specular_table: do not edit. Twin "
         "of "
      << kRtlFile
      << ".\n#pragma once\n\n#include <array>\n#include <cstdint>\n\nnamespace shading {\n\n"
      << "// f = value + (slope + curvature d) d, d the distance from the start of the segment.\n"
      << "struct QuadraticSegment {\n  int32_t value, slope, curvature;\n};\n";
  const auto write = [&out](const Format& format, const std::vector<Segment>& table,
                            const char* what) {
    out << "\n// " << what << "; fraction bits " << format.value << ", " << format.slope << ", "
        << format.curvature << ".\ninline constexpr std::array<QuadraticSegment, " << table.size()
        << "> k" << format.name << "Table = {{\n";
    for (const Segment& s : table) {
      out << "    {" << s.value << ", " << s.slope << ", " << s.curvature << "},\n";
    }
    out << "}};\n";
  };
  write(kLogFormat, LogTable(), "-log2(1 - u / 2), u in [0, 1)");
  write(kExpFormat, ExpTable(), "2^g, g in [0, 1)");
  out << "\n}  // namespace shading\n";
}

// The table as SystemVerilog: an array a coefficient.
inline void WriteRtl(std::ostream& out) {
  out << "// SPDX-License-Identifier: Apache-2.0\n"
      << "// Written by specular_table: do not edit. Twin of " << kModelFile << ".\n//\n"
      << "// f = value + (slope + curvature d) d, d the distance from the start of the segment.\n"
      << "package specular_table_pkg;\n";
  const auto write = [&out](const Format& format, const std::vector<Segment>& table,
                            const char* coefficient, int width, int64_t Segment::*member) {
    out << "  localparam logic [" << width - 1 << ":0] " << format.name << coefficient << " ["
        << table.size() << "] = '{";
    for (size_t k = 0; k < table.size(); ++k) {
      out << (k ? "," : "") << (k % 6 ? " " : "\n    ") << width << "'d" << table[k].*member;
    }
    out << "\n  };\n";
  };
  out << "  // -log2(1 - u / 2), u in [0, 1): U0.30, U1.22, U0.17.\n";
  write(kLogFormat, LogTable(), "Value", 30, &Segment::value);
  write(kLogFormat, LogTable(), "Slope", 23, &Segment::slope);
  write(kLogFormat, LogTable(), "Curvature", 17, &Segment::curvature);
  out << "  // 2^g, g in [0, 1): U1.22, U1.17, U0.13.\n";
  write(kExpFormat, ExpTable(), "Value", 23, &Segment::value);
  write(kExpFormat, ExpTable(), "Slope", 18, &Segment::slope);
  write(kExpFormat, ExpTable(), "Curvature", 13, &Segment::curvature);
  out << "endpackage\n";
}

}  // namespace shading::tables
