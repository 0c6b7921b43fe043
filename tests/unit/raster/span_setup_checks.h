// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tb/dut/span_setup_dut.h"
#include "tests/unit/raster/span_setup_timing.h"

namespace shading {

inline tb::SpanSetupDut::Flows AlwaysFlows() {
  return {FlowPattern::Always(), FlowPattern::Always(), FlowPattern::Always()};
}

template <typename Value>
void ExpectSeed(const BasicSeed<Value>& rtl, const BasicSeed<Value>& model) {
  ASSERT_EQ(rtl.first.raw(), model.first.raw());
  ASSERT_EQ(rtl.second.raw(), model.second.raw());
  ASSERT_EQ(rtl.difference.raw(), model.difference.raw());
  ASSERT_EQ(rtl.curvature.raw(), model.curvature.raw());
}

// Fields that the method does not use are free in the RTL.
inline void ExpectChannel(Method method, const SpanSeed& rtl, const SpanSeed& model, size_t ch) {
  if (method == Method::kFlat) {
    ASSERT_EQ(rtl.channel[ch].first.raw(), model.channel[ch].first.raw());
  } else if (IsPointForm(method)) {
    const SurfacePoint &r = rtl.point[ch], &m = model.point[ch];
    ASSERT_EQ(r.x, m.x);
    ASSERT_EQ(r.y, m.y);
    const Surface &s = r.surface, &t = m.surface;
    ASSERT_TRUE(s.a == t.a && s.b == t.b && s.c == t.c && s.d == t.d && s.e == t.e && s.f == t.f);
  } else {
    ExpectSeed(rtl.channel[ch], model.channel[ch]);
  }
  if (method != Method::kQuadSplit) return;
  ASSERT_EQ(rtl.split[ch].ambient.raw(), model.split[ch].ambient.raw());
  ExpectSeed(rtl.split[ch].specular, model.split[ch].specular);
}

inline void ExpectCosines(const Choice& choice, const SpanSeed& rtl, const SpanSeed& model) {
  ASSERT_EQ(rtl.material, model.material);
  for (size_t i = 0; i < CurvesOf(choice.method); ++i) {
    if (i != 1 || !choice.dark) ExpectSeed(rtl.curve[i], model.curve[i]);
  }
}

inline void ExpectSeeds(const tb::SpanSetupDut::Work& work,
                        const tb::SpanSetupDut::Result& result) {
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.seeds.size(), work.spans.size());
  size_t triangle = 0;
  for (size_t i = 0; i < work.spans.size(); ++i) {
    const SpanSeed& rtl = result.seeds[i].seed;
    const Choice choice = work.Of(triangle);
    const SpanSeed model =
        SpanSetup::Seed(choice.method, work.triangles[triangle], work.spans[i]);
    ASSERT_EQ(result.seeds[i].choice, tb::SpanSetupDut::BitsOf(choice)) << "span " << i;
    ASSERT_EQ(rtl.x, model.x) << "span " << i;
    ASSERT_EQ(rtl.y, model.y) << "span " << i;
    ASSERT_EQ(rtl.length, model.length) << "span " << i;
    ASSERT_EQ(rtl.z.raw(), model.z.raw()) << "span " << i;
    ASSERT_EQ(rtl.dz_dx.raw(), model.dz_dx.raw()) << "span " << i;
    const bool cosines = InterpolatesCosines(choice.method);
    if (cosines) ExpectCosines(choice, rtl, model);
    for (size_t ch = 0; ch < kChannels && !cosines; ++ch) {
      SCOPED_TRACE("span " + std::to_string(i) + " channel " + std::to_string(ch));
      ExpectChannel(choice.method, rtl, model, ch);
      if (testing::Test::HasFatalFailure()) return;
    }
    if (work.spans[i].last) ++triangle;
  }
}

inline void ExpectRun(tb::SpanSetupDut* rtl, const tb::SpanSetupDut::Work& work,
                      const tb::SpanSetupDut::Flows& flows) {
  const tb::SpanSetupDut::Result result = rtl->Run(work, flows);
  ExpectSeeds(work, result);
  if (!testing::Test::HasFatalFailure()) ExpectCycles(work, flows, result);
}

}  // namespace shading
