// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "model/ideal/phong.h"
#include "model/ideal/slerp.h"
#include "model/raster/front_end.h"
#include "model/shading_unit.h"
#include "tb/stimulus/random_triangles.h"

namespace shading {
namespace {

constexpr int kFrames = 6;
constexpr int kTriangles = 300;
// Half a code of rounding, and what accuracy_test bounds for shininess 256.
constexpr double kBound = 0.5 + 0.45;
// Adaptive: the default tolerance, for diffuse and for specular light.
constexpr double kAdaptiveBound = kBound + 2 * 0.5;

// Largest distance of the displayed codes of a triangle's spans from the ideal, in codes.
template <typename Ideal>
double WorstOf(const Ideal& ideal, const Pixel* pixels, int length) {
  double worst = 0;
  for (const Pixel* pixel = pixels; pixel < pixels + length; ++pixel) {
    const ideal::Rgb exact = ideal::Clamped(ideal.At(pixel->x + 0.5, pixel->y + 0.5));
    const std::array<int, 3> code = {pixel->r, pixel->g, pixel->b};
    for (size_t ch = 0; ch < exact.size(); ++ch) {
      worst = std::max(worst, std::abs(code[ch] - exact[ch]));
    }
  }
  return worst;
}

// Slivers, needles, opposed normals, spans across the whole screen: nothing is left out.
template <typename Ideal>
void ExpectWithinBound(Method method, int lanes) {
  const double bound = method == Method::kAdaptive ? kAdaptiveBound : kBound;
  int64_t pixels_seen = 0;
  for (uint32_t seed = 1; seed <= kFrames; ++seed) {
    const TriangleList list = tb::RandomTriangles(seed, kTriangles);
    const FrameWork work = FrontEnd::Run(list, method);
    ShadingUnit unit(work, lanes, FlowPattern::Always(), FlowPattern::Always());
    std::vector<Pixel> pixels(kMaxScreen);
    auto span = work.spans.begin();
    for (size_t t = 0; t < work.triangles.size(); ++t) {
      unit.Triangle(work.triangles[t]);
      const Ideal ideal(list.frame, list.triangles[work.packet[t]]);
      for (bool last = false; !last; ++span) {
        last = span->last;
        unit.Span(*span, pixels.data());
        pixels_seen += span->length;
        ASSERT_LE(WorstOf(ideal, pixels.data(), span->length), bound)
            << "seed " << seed << " triangle " << work.packet[t] << " row " << span->y;
      }
    }
    EXPECT_EQ(span, work.spans.end());
  }
  EXPECT_GT(pixels_seen, 50000);
}

class Picture : public testing::TestWithParam<std::tuple<Method, int>> {};

TEST_P(Picture, WithinBoundOfTheClosedForm) {
  const auto [method, lanes] = GetParam();
  switch (method) {
    case Method::kPhong:
    case Method::kPhongSurface:
    case Method::kPhongDuff: return ExpectWithinBound<ideal::Phong>(method, lanes);
    case Method::kPhongTaylor: return ExpectWithinBound<ideal::PhongTaylor>(method, lanes);
    default: return ExpectWithinBound<ideal::Slerp>(method, lanes);
  }
}

INSTANTIATE_TEST_SUITE_P(
    LitMethods, Picture,
    testing::Combine(testing::Values(Method::kPhongSurface, Method::kPhong, Method::kPhongTaylor,
                                     Method::kPhongDuff, Method::kSlerp, Method::kSlerpPaper,
                                     Method::kSlerpIntensity, Method::kSlerpDirect,
                                     Method::kAdaptive),
                     testing::Values(1, kMaxLanes)),
    [](const auto& test) {
      std::string name(Name(std::get<0>(test.param)));
      std::replace(name.begin(), name.end(), '-', '_');
      return name + "_lanes_" + std::to_string(std::get<1>(test.param));
    });

}  // namespace
}  // namespace shading
