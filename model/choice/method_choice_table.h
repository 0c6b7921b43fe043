// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace shading::choice_table {

// Twins of the localparams in rtl/choice/method_choice_table.sv, all log2 in 2^-5.
using Table = std::array<int, 16>;

// Diffuse errors over 255 kd l^k.
inline constexpr int kFlatDiffuse = 40;
inline constexpr int kGouraudDiffuse = -56;
inline constexpr int kGouraudKink = -28;  // with a terminator, over l
inline constexpr int kQuadDiffuse = -150;
inline constexpr int kQuadKink = -70;
inline constexpr int kQuadCosineDiffuse = -150;
inline constexpr int kSlerpDiffuse = -140;

// Highlight's errors over 255 ks (n l^2)^(k / 2); entry k for highlights of at most 2^-k.
inline constexpr Table kFlatSpecular = {30, 28, 14, -4, -24, -48, -72, -98,
                                        -125, -152, -180, -208, -236, -264, -292, -320};
inline constexpr Table kGouraudSpecular = {-50, -50, -60, -70, -84, -104, -126, -150,
                                           -176, -202, -230, -258, -286, -314, -342, -370};
inline constexpr Table kQuadSpecular = {-180, -180, -184, -190, -200, -216, -236, -258,
                                        -282, -308, -334, -360, -388, -416, -444, -472};
// Over sqrt(n) l^3 and over n l^4.
inline constexpr Table kCosineSpecular = {-170, -172, -182, -200, -220, -244, -268, -294,
                                          -320, -346, -374, -400, -428, -456, -484, -512};
inline constexpr Table kCosineBend = {-190, -210, -230, -260, -290, -320, -350, -380,
                                      -410, -440, -470, -500, -530, -560, -590, -620};
inline constexpr Table kSlerpSpecular = {-150, -152, -162, -180, -200, -224, -248, -274,
                                         -300, -326, -354, -380, -408, -436, -464, -492};
// R.V turns twice as fast.
inline constexpr int kCosineReflected = 64;
inline constexpr int kBendReflected = 64;
inline constexpr int kSlerpReflected = 32;

// log2(1 + 2^-d), d in quarters, rounded up.
inline constexpr std::array<int, 32> kSum = {32, 29, 25, 22, 19, 17, 14, 13, 11, 9, 8,
                                             7,  6,  5,  4,  4,  3,  3,  2,  2,  2, 2,
                                             1,  1,  1,  1,  1,  1,  1,  1,  1,  1};

}  // namespace shading::choice_table
