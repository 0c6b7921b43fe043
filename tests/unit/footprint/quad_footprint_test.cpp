// SPDX-License-Identifier: Apache-2.0
//
// The footprint's constant of a quadratic surface, against the mean of the surface itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/ideal/quadratic.h"
#include "model/raster/front_end.h"
#include "tests/unit/footprint/footprint_stimulus.h"

namespace shading {
namespace {

Rgb Grey(double value) {
  return {Reflectance::Round(value), Reflectance::Round(value), Reflectance::Round(value)};
}

FrameState Frame() {
  FrameState frame = Screen(512, 512);
  frame.light = Quantised(0.3, 0.4, 0.8);
  frame.view = Quantised(0, 0, 1);
  frame.half = Quantised(0.3, 0.4, 1.74);
  frame.materials.push_back({Grey(0.1), Grey(0.5), Grey(0.4), Shininess::Round(24)});
  return frame;
}

FrameWork Work(const FrameState& frame, const TrianglePacket& packet, bool footprint) {
  return FrontEnd::Run({frame, {packet}}, footprint ? Method::kQuadFootprint : Method::kQuad);
}

double ShortestAltitude(const TrianglePacket& packet) {
  std::array<double, 6> at;
  for (size_t i = 0; i < 3; ++i) {
    at[2 * i] = packet.x[i].ToReal();
    at[2 * i + 1] = packet.y[i].ToReal();
  }
  const double area =
      std::abs((at[2] - at[0]) * (at[5] - at[1]) - (at[4] - at[0]) * (at[3] - at[1]));
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    longest = std::max(longest, std::hypot(at[2 * j] - at[2 * i], at[2 * j + 1] - at[2 * i + 1]));
  }
  return area / longest;
}

TEST(QuadFootprint, ConstantIsTheMeanOverTheDisc) {
  std::mt19937 random(1);
  const FrameState frame = Frame();
  double worst = 0, largest = 0;
  for (int i = 0; i < 2000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(std::ldexp(60, -(i % 5)), random));
    packet.n = NormalsWithin(0.6, random);
    const FrameWork plain = Work(frame, packet, false), mean = Work(frame, packet, true);
    if (plain.triangles.empty()) continue;
    const double radius = std::min(ideal::Footprint::kRadius, ShortestAltitude(packet) / 2);
    const ideal::Quadratic quadratic(frame, packet);
    ideal::Rgb sum = {};
    constexpr int kSpokes = 64, kRings = 64;
    for (int p = 0; p < kSpokes * kRings; ++p) {
      const double r = radius * std::sqrt((p / kSpokes + 0.5) / kRings);
      const double angle = 2 * std::acos(-1) * (p % kSpokes) / kSpokes;
      sum = ideal::Sum(sum,
                       quadratic.AtUnclamped(256 + r * std::cos(angle), 256 + r * std::sin(angle)));
    }
    const ideal::Rgb centre = quadratic.AtUnclamped(256, 256);
    for (size_t c = 0; c < 3; ++c) {
      const double expected = sum[c] / (kSpokes * kRings) - centre[c];
      const double actual = IntensityAcc::Wrap(mean.triangles[0].surface[c].f.raw() -
                                               plain.triangles[0].surface[c].f.raw())
                                .ToReal();
      worst = std::max(worst, std::abs(actual - expected));
      largest = std::max(largest, std::abs(expected));
      EXPECT_EQ(mean.triangles[0].surface[c].a, plain.triangles[0].surface[c].a);
    }
  }
  std::printf("constant of up to %.1f codes, %.5f codes off\n", largest, worst);
  EXPECT_GT(largest, 5) << "nothing to see";
  EXPECT_LT(worst, 0.0005);  // the nodes' light is 12.5 2^-16 codes off
}

TEST(QuadFootprint, SliversStayInRange) {
  std::mt19937 random(2);
  CornerGenerator corners(3, 512, 512);
  FrameState frame = Frame();
  frame.materials[0] = {Grey(0), Grey(0), Grey(1), Shininess::Round(24)};
  double largest = 0;
  for (int i = 0; i < 50000; ++i) {
    TrianglePacket packet = PacketOf(i % 2 ? corners.Sliver() : corners.Any());
    packet.n = AnyNormals(&corners, random);
    const FrameWork plain = Work(frame, packet, false), mean = Work(frame, packet, true);
    if (plain.triangles.empty()) continue;
    const double added = IntensityAcc::Wrap(mean.triangles[0].surface[0].f.raw() -
                                            plain.triangles[0].surface[0].f.raw())
                             .ToReal();
    largest = std::max(largest, std::abs(added));
  }
  std::printf("at most %.1f codes\n", largest);
  EXPECT_LE(largest, 0.75 * 255);
  EXPECT_GT(largest, 50) << "the search is blind";
}

}  // namespace
}  // namespace shading
