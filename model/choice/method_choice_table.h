// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace shading::choice_table {

// Twins of the localparams in rtl/choice/method_choice_table.sv, all log2 in 2^-5.
using Table = std::array<int, 16>;

// Diffuse errors over 255 kd l^k.
inline constexpr int kFlatDiffuse = 19;          // k = 1
inline constexpr int kGouraudDiffuse = -55;      // 2
inline constexpr int kGouraudKink = -26;         // 1, with a terminator
inline constexpr int kQuadDiffuse = -129;        // 3
inline constexpr int kQuadKink = -61;            // 1, with a terminator
inline constexpr int kQuadCosineDiffuse = -127;  // 3

// Errors of the highlight, entry k for one of at most 2^-k: over 255 ks and the power 1, 2, 3 of
// sqrt(n) l, and over 255 ks sqrt(n) l^3.
inline constexpr Table kFlatSpecular = {-1,   -2,   -21,  -42,  -68,  -95,  -124, -153,
                                        -182, -213, -243, -274, -305, -337, -369, -400};
inline constexpr Table kGouraudSpecular = {-55,  -79,  -79,  -91,  -111, -134, -158, -183,
                                           -209, -235, -263, -291, -320, -350, -379, -409};
inline constexpr Table kQuadSpecular = {-161, -163, -199, -199, -199, -226, -244, -265,
                                        -288, -311, -336, -361, -387, -414, -441, -470};
inline constexpr Table kCosineSpecular = {-146, -155, -174, -196, -222, -249, -278, -307,
                                          -337, -366, -397, -428, -459, -491, -522, -556};
// R.V turns twice as fast.
inline constexpr int kReflected = 32;
// quad-cosine bends under a peak where sqrt(n) l is more than this.
inline constexpr int kWide = 20;

// log2(1 + 2^-d), d in quarters, rounded up.
inline constexpr std::array<int, 32> kSum = {32, 29, 25, 22, 19, 17, 14, 13, 11, 9, 8,
                                             7,  6,  5,  4,  4,  3,  3,  2,  2,  2, 2,
                                             2,  1,  1,  1,  1,  1,  1,  1,  1,  1};

}  // namespace shading::choice_table
