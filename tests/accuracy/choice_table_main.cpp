// SPDX-License-Identifier: Apache-2.0
//
// Prints the tables of docs/units/choice/method_choice.md: what the search finds beside the
// constants of method_choice, the angles that it allows, and the tolerance that chosen methods
// take.
#include <fmt/core.h>

#include <cmath>
#include <string_view>

#include "model/choice/method_choice_table.h"
#include "tests/accuracy/choice_constant.h"
#include "tests/accuracy/choice_triangle.h"

namespace shading::accuracy {
namespace {

using Light = ChoiceConstant::Light;

constexpr std::array kMethods = {Method::kFlat, Method::kGouraud, Method::kQuad,
                                 Method::kQuadCosine};

void PrintRow(const ChoiceConstant& constant, int entry, const ChoiceEffort& effort) {
  const double found = WorstConstant(constant, effort);
  fmt::print(" {:.1f} / {} ({:.2f}) |", 32 * found, entry, std::exp2(entry / 32.0 - found));
}

void PrintDiffuse(const ChoiceEffort& effort) {
  using namespace choice_table;
  fmt::print("\n| method | lit: found / constant (ratio) | terminator |\n|---|--:|--:|\n");
  constexpr std::array kLit = {kFlatDiffuse, kGouraudDiffuse, kQuadDiffuse, kQuadCosineDiffuse};
  for (size_t m = 0; m < kMethods.size(); ++m) {
    fmt::print("| {} |", Name(kMethods[m]));
    PrintRow({kMethods[m], Light::kLit}, kLit[m], effort);
    const bool fits = kMethods[m] == Method::kGouraud || kMethods[m] == Method::kQuad;
    if (fits) {
      PrintRow({kMethods[m], Light::kTerminator},
               kMethods[m] == Method::kQuad ? kQuadKink : kGouraudKink, effort);
    }
    fmt::print("{}\n", fits ? "" : " |");
  }
}

void PrintSpecular(Lighting lighting, const ChoiceEffort& effort) {
  using namespace choice_table;
  const std::array<const Table*, 4> tables = {&kFlatSpecular, &kGouraudSpecular, &kQuadSpecular,
                                              &kCosineSpecular};
  const bool phong = lighting == Lighting::kPhong;
  fmt::print("\n{}\n\n| k |", phong ? "R.V" : "N.H");
  for (size_t m = phong ? 3 : 0; m < kMethods.size(); ++m) fmt::print(" {} |", Name(kMethods[m]));
  fmt::print("\n|--:|{}\n", phong ? "--:|" : "--:|--:|--:|--:|");
  for (int k = 0; k < 16; ++k) {
    fmt::print("| {} |", k);
    for (size_t m = phong ? 3 : 0; m < kMethods.size(); ++m) {
      const int entry = (*tables[m])[static_cast<size_t>(k)] + (phong ? kReflected : 0);
      PrintRow({kMethods[m], Light::kHighlight, lighting, k}, entry, effort);
    }
    fmt::print("\n");
  }
}

void PrintDegrees(const ChoiceEffort& effort) {
  fmt::print("\n| method | diffuse | n = 8 | 32 | 128 |\n|---|--:|--:|--:|--:|\n");
  for (const Method method : kMethods) {
    fmt::print("| {} |", Name(method));
    for (const int n : {0, 8, 32, 128}) {
      fmt::print(" {:.3g} / {:.3g} |", AllowedDegrees(method, n),
                 SearchedDegrees(method, n, effort));
    }
    fmt::print("\n");
  }
}

void PrintShares(int materials) {
  fmt::print("\n| light | method | T = 1/2 | 1 | 2 | 4 |\n|---|---|--:|--:|--:|--:|\n");
  for (const Lighting lighting : {Lighting::kBlinn, Lighting::kPhong}) {
    for (const Method method : kMethods) {
      fmt::print("| {} | {} |", lighting == Lighting::kBlinn ? "N.H" : "R.V", Name(method));
      for (const double tolerance : {0.5, 1.0, 2.0, 4.0}) {
        fmt::print(" {:.2f}, {:.2f} |", WorstShare(method, lighting, tolerance, false, materials),
                   WorstShare(method, lighting, tolerance, true, materials));
      }
      fmt::print("\n");
    }
  }
}

}  // namespace
}  // namespace shading::accuracy

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  using namespace shading::accuracy;
  const ChoiceEffort effort = quick ? ChoiceEffort{40, 300} : ChoiceEffort{250, 700};
  PrintDiffuse(effort);
  PrintSpecular(shading::Lighting::kBlinn, effort);
  PrintSpecular(shading::Lighting::kPhong, effort);
  PrintDegrees({quick ? 10 : 40, 400});
  PrintShares(quick ? 20 : 300);
}
