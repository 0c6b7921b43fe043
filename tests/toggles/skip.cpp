// SPDX-License-Identifier: Apache-2.0
#include "tests/toggles/skip.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "model/choice/method_choice.h"
#include "model/raster/front_end.h"

namespace shading::test {
namespace {

constexpr RangeCosine kFull = RangeCosine::FromRaw(int64_t{1} << RangeCosine::kFraction);
constexpr RangeCosine kNothing = RangeCosine::FromRaw(0);

// The cheapest sure method behind flat.
Method NextAfterFlat(LightRange range, const ChoiceLimit& limit, Lighting lighting) {
  if (range.turn.raw() == 0) range.turn = Turn::FromRaw(1);  // logarithms need a turn
  for (const MethodChoice::Bound& bound : MethodChoice::BoundsOf(range, limit, lighting)) {
    const bool sure = bound.allowed && MethodChoice::LogAdd(bound.diffuse, bound.specular) <= 0;
    if (sure && bound.method != Method::kFlat) return bound.method;
  }
  return MethodChoice::ExactOf(range);
}

Choice ChooseWithout(Skip off, LightRange range, const ChoiceLimit& limit, Lighting lighting) {
  Choice choice = MethodChoice::Of(range, limit, lighting);
  const bool lit = LightsPixels(choice.method);
  switch (off) {
    case Skip::kNone:
    case Skip::kBackFaces: break;
    case Skip::kAmbient:
      if (!choice.ambient) break;
      range.n_dot_l_low = range.n_dot_l_high = kFull;
      choice = MethodChoice::Of(range, limit, lighting);
      break;
    case Skip::kConstant:
      if (choice.method == Method::kFlat && !choice.ambient) {
        choice.method = NextAfterFlat(range, limit, lighting);
      }
      break;
    case Skip::kDark:
      if (lit) choice.dark = false;
      break;
    case Skip::kUnnormalised:
      if (lit) choice.method = MethodChoice::ExactOf(range);
      break;
    case Skip::kBlack: choice.channels = 7; break;
    case Skip::kAll: choice = ChoiceOf(MethodChoice::ExactOf(range)); break;
  }
  return choice;
}

// Between methods by the turn alone: 255 kd = 16 T, 255 ks < T / 4, which is not dark on the peak.
ChoiceLimit LimitWith(uint8_t channels) {
  ChoiceLimit limit;
  limit.diffuse = Log::FromRaw(4 << Log::kFraction);
  limit.specular = Log::FromRaw(-(2 << Log::kFraction) - 1);
  limit.shininess_log = Log::FromRaw(0);
  limit.shininess = Shininess::FromRaw(int64_t{1} << Shininess::kFraction);
  limit.below_full = limit.below_full_dark = true;
  limit.channels = channels;
  return limit;
}

// A range for which method_choice chooses what is wanted.
LightRange RangeFor(const Choice& wanted, Lighting lighting) {
  const ChoiceLimit limit = LimitWith(wanted.channels);
  LightRange range;
  range.n_dot_l_high = wanted.ambient ? kNothing : kFull;
  range.specular_low = range.specular_high = wanted.dark ? kNothing : kFull;
  // Turns as floating-point numbers of 5 bits; a terminator keeps quad from being chosen.
  for (const RangeCosine low : {kFull, RangeCosine::FromRaw(-kFull.raw())}) {
    range.n_dot_l_low = wanted.ambient ? kNothing : low;
    for (int exponent = 0; exponent <= Turn::kWidth; ++exponent) {
      for (int64_t mantissa = 0; mantissa < 32; ++mantissa) {
        const int64_t turn = exponent == 0 ? 0 : (32 + mantissa) << exponent >> 6;
        range.turn = Turn::FromRaw(turn);
        if (MethodChoice::Of(range, limit, lighting) == wanted) return range;
      }
    }
  }
  throw std::runtime_error("no range for " + std::string(Name(wanted.method)) +
                           (wanted.dark ? ", no highlight" : ""));
}

}  // namespace

FrameWork WorkWith(const TriangleList& list, Tolerance tolerance, const Choose& choose) {
  std::vector<Choice> choices;  // of each triangle that is drawn
  FrontEndOptions options;
  options.tolerance = tolerance;
  options.choose = [&](const LightRange& range, const ChoiceLimit& limit) {
    choices.push_back(choose(range, limit));
    return choices.back();
  };
  FrameWork work = FrontEnd::Run(list, Method::kAuto, options);
  for (ChoiceLimit& limit : work.limits) limit = LimitWith(limit.channels);
  for (size_t t = 0; t < work.triangles.size(); ++t) {
    TriangleState& triangle = work.triangles[t];
    triangle.range = RangeFor(choices[t], list.frame.lighting);
    // A channel is of the material, not of the triangle.
    work.limits[static_cast<size_t>(triangle.material)].channels = choices[t].channels;
  }
  return work;
}

FrameWork WorkWithout(const TriangleList& list, Tolerance tolerance, Skip off) {
  TriangleList drawn = list;
  if (off == Skip::kBackFaces) drawn.frame.cull = Cull::kNone;
  return WorkWith(drawn, tolerance, [&](const LightRange& range, const ChoiceLimit& limit) {
    return ChooseWithout(off, range, limit, list.frame.lighting);
  });
}

}  // namespace shading::test
