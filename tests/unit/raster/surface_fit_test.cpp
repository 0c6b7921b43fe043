// SPDX-License-Identifier: Apache-2.0
#include "model/raster/surface_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/raster/fitted_surface.h"

namespace shading {
namespace {

struct Worst {
  double error = 0;     // codes
  double fraction = 0;  // of the bound at the same pixel
  double low = 0, high = 0;

  void Note(double off, double bound) {
    error = std::max(error, off);
    fraction = std::max(fraction, off / bound);
  }
};

// Every covered pixel through the recurrence of quad_surface, in 36 bits.
void TryEveryPixel(const Fitted& fitted, Worst* worst) {
  for (const SpanCommand& span : fitted.spans()) {
    const SpanSeed seed = fitted.Seed(span.x, span.y);
    for (size_t ch = 0; ch < kChannels; ++ch) {
      const ChannelSeed& s = seed.channel[ch];
      IntensityAcc now = s.first, next = s.second;
      for (int x = span.x; x < span.x + span.length; ++x) {
        worst->Note(fitted.Error(ch, now, x, span.y), fitted.Bound(x, span.y));
        worst->low = std::min(worst->low, now.ToReal() - 0.5);
        worst->high = std::max(worst->high, now.ToReal() - 0.5);
        const IntensityAcc ahead =
            IntensityAcc::Wrap(2 * next.raw() - now.raw() + s.curvature.raw());
        now = next;
        next = ahead;
      }
    }
  }
}

// The far pixels of triangles over the whole screen, many node values each.
Worst SearchFarPixels(int size, int triangles, int nodes) {
  const FrameState frame = Screen(size, size);
  CornerGenerator random(static_cast<uint32_t>(size), size, size);
  Worst worst;
  for (int n = 0; n < triangles; ++n) {
    Fitted fitted(n % 4 ? random.WholeScreen() : random.Sliver(), frame);
    if (fitted.empty()) continue;
    std::vector<std::array<int, 2>> far;
    ForFarPixels(fitted.spans(), [&](int x, int y) { far.push_back({x, y}); });
    const size_t kept = std::min<size_t>(far.size(), 4);
    std::partial_sort(far.begin(), far.begin() + static_cast<std::ptrdiff_t>(kept), far.end(),
                      [&](const auto& a, const auto& b) {
                        return fitted.Bound(a[0], a[1]) > fitted.Bound(b[0], b[1]);
                      });
    for (int i = 0; i < nodes; ++i) {
      fitted.FitAll(&random);
      for (size_t p = 0; p < kept; ++p) {
        const auto [x, y] = far[p];
        const SpanSeed seed = fitted.Seed(x, y);
        for (size_t ch = 0; ch < kChannels; ++ch) {
          worst.Note(fitted.Error(ch, seed.channel[ch].first, x, y), fitted.Bound(x, y));
        }
      }
    }
  }
  return worst;
}

TEST(SurfaceFit, QuadWithinErrorBoundOnWidestScreen) {
  const Worst worst = SearchFarPixels(kMaxScreen, 600, 600);
  RecordProperty("worst_error_millicodes", static_cast<int>(worst.error * 1000));
  RecordProperty("worst_permille_of_bound", static_cast<int>(worst.fraction * 1000));
  EXPECT_LE(worst.error, SurfaceFit::kContract.max_error_ulp);
  EXPECT_LE(worst.fraction, 1);
  EXPECT_GT(worst.error, 0.3) << "the search is blind";
}

TEST(SurfaceFit, QuadWithinErrorBoundOnHalfThatScreen) {
  const Worst worst = SearchFarPixels(kMaxScreen / 2, 600, 600);
  RecordProperty("worst_error_millicodes", static_cast<int>(worst.error * 1000));
  EXPECT_LE(worst.error, 0.11);
  EXPECT_LE(worst.fraction, 1);
}

TEST(SurfaceFit, EveryPixelOfRandomTriangles) {
  constexpr std::array<std::array<int, 2>, 4> kScreens = {
      {{64, 48}, {4096, 16}, {16, 4096}, {400, 300}}};
  Worst worst;
  for (uint32_t i = 0; i < kScreens.size(); ++i) {
    const FrameState frame = Screen(kScreens[i][0], kScreens[i][1]);
    CornerGenerator random(i, frame.width, frame.height);
    for (int n = 0; n < 500; ++n) {
      Fitted fitted(random.Any(), frame);
      if (fitted.empty()) continue;
      fitted.FitAll(&random);
      TryEveryPixel(fitted, &worst);
    }
  }
  EXPECT_LE(worst.fraction, 1);
  EXPECT_LT(worst.low, -84) << "the undershoot of three dark middles is -85";
  EXPECT_GT(worst.high, 339) << "the overshoot of three bright middles is 340";
  EXPECT_GE(worst.low, -85.4);
  EXPECT_LE(worst.high, 340.4);
}

TEST(SurfaceFit, EveryPixelOfWidestScreen) {
  CornerGenerator random(3, kMaxScreen, kMaxScreen);
  Fitted fitted({Point{-300, -90000}, Point{kGuardBand, kGuardBand - 7}, Point{-4000, kGuardBand}},
                Screen(kMaxScreen, kMaxScreen));
  ASSERT_EQ(fitted.spans().size(), 4096u);
  fitted.FitAll(&random);
  Worst worst;
  TryEveryPixel(fitted, &worst);
  RecordProperty("worst_error_millicodes", static_cast<int>(worst.error * 1000));
  EXPECT_LE(worst.fraction, 1);
}

TEST(SurfaceFit, SliversWrapAndStayRight) {
  const FrameState frame = Screen(kMaxScreen, kMaxScreen);
  CornerGenerator random(4, kMaxScreen, kMaxScreen);
  Worst worst;
  int wrapped = 0;
  for (int n = 0; n < 20000; ++n) {
    Fitted fitted(random.Sliver(), frame);
    if (fitted.empty()) continue;
    fitted.FitAll(&random);
    TryEveryPixel(fitted, &worst);
    const TriangleGeometry& g = fitted.geometry();
    const double a0 = static_cast<double>(g.edge[0].dx) / static_cast<double>(g.area);
    wrapped += std::abs(a0 * a0) > 1024;
  }
  EXPECT_GT(wrapped, 100) << "A is of the order of a0^2 codes, far outside S9.26";
  EXPECT_LE(worst.fraction, 1);
}

TEST(SurfaceFit, GouraudWithinErrorBound) {
  const FrameState frame = Screen(kMaxScreen, kMaxScreen);
  CornerGenerator random(5, kMaxScreen, kMaxScreen);
  Worst worst;
  for (int n = 0; n < 4000; ++n) {
    Fitted fitted(n % 2 ? random.WholeScreen() : random.Sliver(), frame);
    if (fitted.empty()) continue;
    fitted.Fit(0, NodeValues::Draw(&random).Straight(), Method::kGouraud);
    ForFarPixels(fitted.spans(), [&](int x, int y) {
      const SpanSeed seed = fitted.Seed(x, y, Method::kGouraud);
      worst.Note(fitted.Error(0, seed.channel[0].first, x, y), fitted.LinearBound(x, y));
    });
  }
  RecordProperty("worst_error_microcodes", static_cast<int>(worst.error * 1e6));
  EXPECT_LE(worst.fraction, 1);
  EXPECT_LE(worst.error, 0.0021);
}

TEST(SurfaceFit, EqualNodesAreExactlyConstantAndStraightEdgesExactlyLinear) {
  CornerGenerator random(6, 640, 480);
  for (int n = 0; n < 5000; ++n) {
    Fitted fitted(random.Any(), Screen(640, 480));
    if (fitted.empty()) continue;
    const int64_t v = random.Integer(0, kFullCodes);
    fitted.Fit(0, {{v, v, v}, {v, v, v}});
    ASSERT_TRUE(Same(fitted.surface(0), SurfaceFit::Constant(Intensity::FromRaw(v))));
    fitted.Fit(1, {{v, v, v}, {}}, Method::kGouraud);
    ASSERT_TRUE(Same(fitted.surface(1), fitted.surface(0)));
    const NodeValues straight = NodeValues::Draw(&random).Straight();
    fitted.Fit(0, straight, Method::kQuad);
    fitted.Fit(1, straight, Method::kGouraud);
    ASSERT_TRUE(Same(fitted.surface(0), fitted.surface(1)));
  }
}

TEST(SurfaceFit, ConstantIsItsValueAndHalfCode) {
  const Surface surface = SurfaceFit::Constant(Intensity::FromRaw(kFullCodes));
  EXPECT_EQ(surface.f.ToReal(), 255.5);
  EXPECT_TRUE(Same(surface, {{}, {}, {}, {}, {}, surface.f}));
}

}  // namespace
}  // namespace shading
