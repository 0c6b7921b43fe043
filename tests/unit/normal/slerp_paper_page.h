// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

namespace shading {

inline constexpr int kBoundedLength = 2048;  // pixels for which the contract states its error

// The tables of the page: largest error on 60 arcs, in units of 2^-F.
inline constexpr std::array<int, 5> kLengths = {16, 64, 256, 1024, kBoundedLength};
struct PageRow {
  int fraction_bits;
  std::array<int, 5> worst;   // of kLengths
  const char* of_full_scale;  // the last of them
};
inline constexpr std::array<PageRow, 5> kOneLanePage = {
    {{16, {64, 814, 9928, 34052, 46993}, " 0.72 |"},
     {20, {65, 1407, 6995, 215911, 726255}, " 0.69 |"},
     {24, {60, 917, 15073, 295300, 1157012}, " 0.069 |"},
     {30, {57, 1182, 22962, 268793, 1397237}, " 0.0013 |"},
     {38, {501, 1004, 15344, 236146, 1001485}, " 3.6e-6 |"}}};
inline constexpr std::array<PageRow, 5> kFourLanesPage = {
    {{16, {43, 1042, 9353, 34052, 46993}, ""},
     {20, {46, 1223, 9398, 296565, 751646}, ""},
     {24, {42, 1110, 18618, 336969, 930934}, ""},
     {30, {45, 1079, 17145, 316821, 1161589}, ""},
     {38, {262, 1598, 19514, 366891, 1273862}, ""}}};

inline std::string LineOf(const PageRow& row) {
  std::string line = "| " + std::to_string(row.fraction_bits) + " |";
  for (const int worst : row.worst) line += " " + std::to_string(worst) + " |";
  return line + row.of_full_scale + "\n";
}

}  // namespace shading
