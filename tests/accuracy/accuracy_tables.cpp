// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/accuracy_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace shading::accuracy {
namespace {

constexpr double kLimit = 0.5;       // LSB
constexpr int kPictureLength = 256;  // pixels, for what hardly depends on the length
constexpr std::array<int, 5> kFractionBits = {16, 20, 24, 30, 38};

struct Row {
  double least, most;  // degrees
};
Row RowOf(double degrees) { return {kLeastPart * degrees, degrees}; }
constexpr Row kFreeRow = {kAngles.front(), kAngles.back()};

Ideal IdealOf(Method method) { return IsSpherical(method) ? Ideal::kSlerp : Ideal::kPhong; }

Cell CellOf(const Configuration& configuration, int length, const Row& row, int shininess) {
  return {configuration, IdealOf(configuration.method), length, row.least, row.most, shininess};
}

std::string Number(double lsb) {
  return lsb < 0.99995 ? fmt::format("{:.4f}", lsb)
         : lsb < 9.95  ? fmt::format("{:.1f}", lsb)
                       : fmt::format("{:.0f}", lsb);
}

// The first two lines of a table.
std::vector<std::string> Header(const std::string& line, size_t columns) {
  std::string rule = "|---|";
  for (size_t i = 1; i < columns; ++i) rule += "--:|";
  return {line + " |", rule};
}

// Lanes change nothing in the exact recurrences of the phong methods.
std::vector<int> LanesOf(Method method) {
  return IsSpherical(method) ? std::vector<int>{1, kMaxLanes} : std::vector<int>{1};
}

std::vector<Configuration> AllConfigurations() {
  std::vector<Configuration> all;
  for (const Method method : kStudiedMethods) {
    for (const int bits : kFractionBits) {
      if (method != Method::kSlerpPaper && bits != Quantity::kFraction) continue;
      for (const int lanes : LanesOf(method)) all.push_back({method, lanes, bits});
    }
  }
  return all;
}

}  // namespace

double AccuracyTables::At(const Cell& cell) {
  const std::string key =
      fmt::format("{} {} {} {} {} {}", NameOf(cell.configuration), static_cast<int>(cell.ideal),
                  cell.length, cell.least_degrees, cell.degrees, cell.shininess);
  const auto known = found_.find(key);
  if (known != found_.end()) return known->second;
  const bool free_angle = cell.least_degrees < kLeastPart * cell.degrees;
  Effort effort = {cell.length > 512 ? 10 : 20, 5, 30};
  if (free_angle) effort.restarts *= 3;
  effort.restarts = std::max(1, effort.restarts / divisor_);
  evaluations_ += effort.evaluations();
  return found_[key] = WorstSearch(cell).Run(effort).lsb;
}

double AccuracyTables::AtAnyAngle(const Configuration& configuration, int length, int shininess) {
  double worst = At(CellOf(configuration, length, kFreeRow, shininess));
  if (std::find(kLengths.begin(), kLengths.end(), length) == kLengths.end()) return worst;
  for (const double degrees : kAngles) {
    worst = std::max(worst, At(CellOf(configuration, length, RowOf(degrees), shininess)));
  }
  return worst;
}

std::vector<std::string> AccuracyTables::Overview() {
  std::vector<std::string> lines = Header("| method | n = 1 | 8 | 32 | 128 | 256", 6);
  for (const Configuration& configuration : AllConfigurations()) {
    std::string line = fmt::format("| {} |", NameOf(configuration));
    for (const int n : kShininess) {
      double worst = 0;
      for (const int length : kLengths) {
        worst = std::max(worst, AtAnyAngle(configuration, length, n));
      }
      line += fmt::format(" {} |", Number(worst));
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> AccuracyTables::Full(Method method) {
  std::vector<std::string> lines = Header(
      "| length | degrees | 1 lane: n = 1 | 8 | 32 | 128 | 256 "
      "| 4 lanes: n = 1 | 8 | 32 | 128 | 256",
      12);
  const auto add = [&](int length, const std::string& label, const auto& at) {
    std::string line = fmt::format("| {} | {} |", length, label);
    for (const int lanes : {1, kMaxLanes}) {
      for (const int n : kShininess) line += fmt::format(" {} |", Number(at({method, lanes}, n)));
    }
    lines.push_back(line);
  };
  using Column = const Configuration&;
  for (const int length : kLengths) {
    for (const double degrees : kAngles) {
      add(length, fmt::format("{}", degrees),
          [&](Column column, int n) { return At(CellOf(column, length, RowOf(degrees), n)); });
    }
    add(length, "any", [&](Column column, int n) { return AtAnyAngle(column, length, n); });
  }
  return lines;
}

std::vector<std::string> AccuracyTables::ByAngleAndLength(Method method, int fraction_bits) {
  std::string header = "| degrees";
  for (const int lanes : LanesOf(method)) {
    for (const int length : kLengths) header += fmt::format(" | {} px, {}x", length, lanes);
  }
  std::vector<std::string> lines = Header(header, 1 + kLengths.size() * LanesOf(method).size());
  const auto add = [&](const std::string& label, const auto& at) {
    std::string line = fmt::format("| {} |", label);
    for (const int lanes : LanesOf(method)) {
      const Configuration column = {method, lanes, fraction_bits};
      for (const int length : kLengths) {
        const double specular =
            std::max({at(column, length, 8), at(column, length, 32), at(column, length, 128)});
        line += fmt::format(" {} / {} |", Number(at(column, length, 1)), Number(specular));
      }
    }
    lines.push_back(line);
  };
  using Column = const Configuration&;
  for (const double degrees : kAngles) {
    add(fmt::format("{}", degrees), [&](Column column, int length, int n) {
      return At(CellOf(column, length, RowOf(degrees), n));
    });
  }
  add("any", [&](Column column, int length, int n) { return AtAnyAngle(column, length, n); });
  return lines;
}

std::vector<std::string> AccuracyTables::OtherIdeal() {
  std::string header = "| degrees";
  for (const Method method : kStudiedMethods) {
    header += fmt::format(" | `{}` to {}", Name(method), IsSpherical(method) ? "Phong" : "slerp");
  }
  std::vector<std::string> lines = Header(header, 1 + kStudiedMethods.size());
  for (const double degrees : kAngles) {
    const Row row = RowOf(degrees);
    std::string line = fmt::format("| {} |", degrees);
    for (const Method method : kStudiedMethods) {
      const Ideal other = IsSpherical(method) ? Ideal::kPhong : Ideal::kSlerp;
      const auto at = [&](int n) {
        return Number(At({{method}, other, kPictureLength, row.least, row.most, n}));
      };
      line += fmt::format(" {} / {} / {} / {} |", at(1), at(8), at(32), at(128));
    }
    lines.push_back(line);
  }
  return lines;
}

double AccuracyTables::LargestAngle(Method method, Ideal ideal, int length, int shininess) {
  double good = 1, bad = 179;
  while (bad - good > 0.05) {
    const double middle = (good + bad) / 2;
    const Cell cell = {{method}, ideal, length, 0.9999 * middle, middle, shininess};
    (At(cell) > kLimit ? bad : good) = middle;
  }
  return good;
}

std::vector<std::string> AccuracyTables::LargestAngles() {
  std::vector<std::string> lines = Header("| compared | length | n = 1 | 8 | 32 | 128 | 256", 7);
  const auto add = [&](Method method, Ideal ideal, int length) {
    std::string line = fmt::format("| `{}` to {} | {} |", Name(method),
                                   ideal == Ideal::kPhong ? "classic Phong" : "the slerp", length);
    for (const int n : kShininess) {
      line += fmt::format(" {:.1f} |", LargestAngle(method, ideal, length, n));
    }
    lines.push_back(line);
  };
  add(Method::kSlerp, Ideal::kPhong, kPictureLength);
  add(Method::kPhongTaylor, Ideal::kPhong, kPictureLength);
  add(Method::kPhongTaylor, Ideal::kSlerp, kPictureLength);
  add(Method::kPhongDuff, Ideal::kPhong, kLengths.back());
  return lines;
}

// Longest of 8, 16 .. 2048 pixels before the first that fails; 0 for none.
int AccuracyTables::LongestSpan(const Configuration& configuration, int shininess) {
  int length = 4;
  while (length < 2048 && AtAnyAngle(configuration, 2 * length, shininess) <= kLimit) {
    length *= 2;
  }
  return length == 4 ? 0 : length;
}

std::vector<std::string> AccuracyTables::LongestSpans() {
  std::vector<std::string> lines = Header("| method | n = 1 | 8 | 32 | 128 | 256", 6);
  for (const Configuration& configuration : AllConfigurations()) {
    if (configuration.method != Method::kSlerpPaper) continue;
    std::string line = fmt::format("| {} |", NameOf(configuration));
    for (const int n : kShininess) {
      const int length = LongestSpan(configuration, n);
      line += fmt::format(" {} |", length == 0 ? "none" : std::to_string(length));
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> AccuracyTables::All() {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& title, const std::vector<std::string>& table) {
    lines.insert(lines.end(), {"", title + ":", ""});
    lines.insert(lines.end(), table.begin(), table.end());
  };
  add("Worst of all lengths and angles, against the method's own ideal, LSB", Overview());
  for (const Method method : {Method::kSlerp, Method::kSlerpIntensity}) {
    add(fmt::format("`{}` against the slerp, LSB", Name(method)), Full(method));
  }
  const std::string columns = "n = 1 / worst of n = 8, 32, 128; LSB";
  for (const Method method : {Method::kPhong, Method::kPhongTaylor, Method::kPhongDuff}) {
    add(fmt::format("`{}` against classic Phong: {}", Name(method), columns),
        ByAngleAndLength(method));
  }
  add("`slerp-direct` against the slerp: " + columns, ByAngleAndLength(Method::kSlerpDirect));
  for (const int bits : kFractionBits) {
    add(fmt::format("`slerp-paper` with {} bits against the slerp: {}", bits, columns),
        ByAngleAndLength(Method::kSlerpPaper, bits));
  }
  add(fmt::format("Against the other ideal, {} pixels, one lane: n = 1 / 8 / 32 / 128; LSB",
                  kPictureLength),
      OtherIdeal());
  add(fmt::format("Largest angle, of at most 179 degrees, with an error of at most {} LSB", kLimit),
      LargestAngles());
  add(fmt::format("Longest spans, of 8, 16 .. 2048 pixels, whose error is at most {} LSB at any "
                  "angle",
                  kLimit),
      LongestSpans());
  return lines;
}

}  // namespace shading::accuracy
