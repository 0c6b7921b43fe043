// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string_view>

#include "model/frame_work.h"
#include "model/triangle_packet.h"

namespace shading::test {

// What an auto frame leaves out; kNone and kAll for comparison.
enum class Skip { kNone, kBackFaces, kAmbient, kConstant, kDark, kUnnormalised, kBlack, kAll };
inline constexpr std::array<Skip, 8> kSkips = {
    Skip::kNone, Skip::kBackFaces,    Skip::kAmbient, Skip::kConstant,
    Skip::kDark, Skip::kUnnormalised, Skip::kBlack,   Skip::kAll};
inline constexpr std::array<std::string_view, kSkips.size()> kSkipNames = {
    "none",         "back faces",       "ambient only",   "one colour",
    "no highlight", "no normalisation", "black channels", "all but back faces"};

// An auto frame in which one skip is switched off:
//   kBackFaces      back faces are drawn
//   kAmbient        a triangle that no light reaches is chosen for as if N.L = 1 on it
//   kConstant       flat is not allowed: the next method that is sure
//   kDark           a method that lights pixels lights the highlight, too
//   kUnnormalised   phong-surface where quad-cosine would do
//   kBlack          every channel of every material counts
//   kAll            all of these but kBackFaces: an exact method, with its highlight
// kNone has the choices of auto.
FrameWork WorkWithout(const TriangleList& list, Tolerance tolerance, Skip off);

// An auto frame with other choices than those of auto. All its limits are alike, and each triangle
// has a range by which method_choice chooses what is wanted, in RTL and model. Throws
// std::runtime_error when no range does.
using Choose = std::function<Choice(const LightRange&, const ChoiceLimit&)>;
FrameWork WorkWith(const TriangleList& list, Tolerance tolerance, const Choose& choose);

}  // namespace shading::test
