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
inline constexpr int kSlerpDiffuse = -131;       // 3

// Errors of the highlight, entry k for one of at most 2^-k: over 255 ks and the power 1, 2, 3 of
// sqrt(n) l, and over 255 ks sqrt(n) l^3.
inline constexpr Table kFlatSpecular = {-1,   -2,   -23,  -50,  -76,  -106, -136, -168,
                                        -200, -231, -262, -294, -327, -363, -391, -427};
inline constexpr Table kGouraudSpecular = {-55,  -80,  -80,  -94,  -119, -143, -169, -196,
                                           -225, -254, -284, -314, -346, -376, -407, -439};
inline constexpr Table kQuadSpecular = {-161, -163, -202, -202, -202, -232, -253, -276,
                                        -300, -326, -352, -379, -407, -435, -464, -494};
inline constexpr Table kCosineSpecular = {-146, -155, -175, -201, -228, -256, -286, -316,
                                          -347, -378, -410, -441, -473, -507, -538, -573};
inline constexpr Table kSlerpSpecular = {-151, -162, -182, -208, -235, -264, -295, -325,
                                         -356, -387, -418, -452, -485, -518, -548, -581};
// R.V turns twice as fast.
inline constexpr int kReflected = 32;
// quad-cosine bends under a peak where sqrt(n) l is more than this.
inline constexpr int kWide = 20;

// log2(1 + 2^-d), d in quarters, rounded up.
inline constexpr std::array<int, 32> kSum = {32, 29, 25, 22, 19, 17, 14, 13, 11, 9, 8,
                                             7,  6,  5,  4,  4,  3,  3,  2,  2,  2, 2,
                                             2,  1,  1,  1,  1,  1,  1,  1,  1,  1};

}  // namespace shading::choice_table
