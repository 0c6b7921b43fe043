// SPDX-License-Identifier: Apache-2.0
#include "model/raster/front_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/ideal/flat.h"
#include "model/ideal/quadratic.h"
#include "model/light/mean_cosines.h"
#include "model/raster/surface_fit.h"
#include "model/shading_unit.h"
#include "tb/stimulus/random_triangles.h"
#include "tests/unit/raster/packet_stimulus.h"

namespace shading {
namespace {

// Codes that the light of a middle or a face may be off: cosines within 64.5 ulp of S1.30
// (mean_cosines down to |sum| = 2^-5), R.V within 260, magnified by n = 256 and 255 codes.
constexpr double kMeanLight = 256 * 255 * 262 * 0x1p-30;
constexpr double kVertexLight = 12.5 * 0x1p-16;
constexpr double kLebesgue = 5.0 / 3;  // six nodes of one error move the quadratic by this much

double QuadBound(const FrameState& frame) {
  const double u = frame.width - 1, v = frame.height - 1;
  return (u * u + u * v + v * v + u + v + 1) * 0x1p-27 + 2295 * (u + v + 1) * 0x1p-34 +
         kLebesgue * kMeanLight;
}
double GouraudBound(const FrameState& frame) {
  return (frame.width + frame.height - 1) * (0x1p-27 + 510 * 0x1p-34) + kVertexLight;
}
double FlatBound(const FrameState&) { return kMeanLight; }

struct PictureError {
  double code = 0;   // beyond half a code of rounding
  double depth = 0;  // ulp of U0.24
  int64_t pixels = 0;

  template <typename Ideal>
  void Compare(const Pixel& pixel, const Ideal& ideal, const TrianglePacket& packet) {
    const ideal::Rgb real = ideal::Clamped(ideal.At(pixel.x + 0.5, pixel.y + 0.5));
    const std::array<int, kChannels> actual = {pixel.r, pixel.g, pixel.b};
    for (size_t ch = 0; ch < kChannels; ++ch) {
      code = std::max(code, std::abs(actual[ch] - real[ch]) - 0.5);
    }
    const ExactTriangle exact(packet);
    Int128 z = 0;
    for (size_t i = 0; i < 3; ++i) z += exact.Weight(i, pixel.x, pixel.y) * packet.z[i].raw();
    const Int128 off = pixel.z * exact.area() - z;
    depth = std::max(depth, std::abs(static_cast<double>(off) / static_cast<double>(exact.area())));
    ++pixels;
  }
};

// The whole frame through front end and shading unit against the closed form of its method.
template <typename Ideal>
PictureError CompareFrame(const TriangleList& list, Method method) {
  PictureError error;
  const FrameWork work = FrontEnd::Run(list, method);
  ShadingUnit unit(work, 1, FlowPattern::Always(), FlowPattern::Always());
  std::vector<Pixel> pixels(kMaxScreen);
  size_t span = 0;
  for (size_t t = 0; t < work.triangles.size(); ++t) {
    const TrianglePacket& packet = list.triangles[work.packet[t]];
    const Ideal ideal(list.frame, packet);
    unit.Triangle(work.triangles[t]);
    do {
      unit.Span(work.spans[span], pixels.data());
      for (int i = 0; i < work.spans[span].length; ++i) {
        error.Compare(pixels[static_cast<size_t>(i)], ideal, packet);
      }
    } while (!work.spans[span++].last);
  }
  EXPECT_EQ(span, work.spans.size());
  EXPECT_EQ(error.pixels, work.pixels);
  return error;
}

template <typename Ideal>
void ExpectPicturesWithinBound(Method method, double (*bound)(const FrameState&)) {
  double worst = 0, depth = 0;
  int64_t pixels = 0;
  for (uint32_t seed = 0; seed < 60; ++seed) {
    TriangleList list = tb::RandomTriangles(seed, 600);
    if (seed % 10 == 0) list.frame.width = list.frame.height = 2048;
    const PictureError error = CompareFrame<Ideal>(list, method);
    EXPECT_LE(error.code, bound(list.frame)) << "seed " << seed;
    EXPECT_LE(error.depth, 0.75) << "half an ulp of rounding, a quarter of set-up; seed " << seed;
    worst = std::max(worst, error.code);
    depth = std::max(depth, error.depth);
    pixels += error.pixels;
  }
  EXPECT_GT(pixels, 1000000);
  testing::Test::RecordProperty("worst_error_microcodes", static_cast<int>(worst * 1e6));
  testing::Test::RecordProperty("worst_depth_milliulp", static_cast<int>(depth * 1000));
}

TEST(FrontEnd, QuadPictureWithinErrorBound) {
  ExpectPicturesWithinBound<ideal::Quadratic>(Method::kQuad, QuadBound);
}
TEST(FrontEnd, GouraudPictureWithinErrorBound) {
  ExpectPicturesWithinBound<ideal::Gouraud>(Method::kGouraud, GouraudBound);
}
TEST(FrontEnd, FlatPictureWithinErrorBound) {
  ExpectPicturesWithinBound<ideal::Flat>(Method::kFlat, FlatBound);
}

TEST(FrontEnd, SkipCountersAddUpToPackets) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    const TriangleList list = tb::RandomTriangles(seed, 1000);
    const FrameWork work = FrontEnd::Run(list, Method::kQuad);
    const int64_t drawn = static_cast<int64_t>(work.triangles.size());
    ASSERT_EQ(work.skipped.total() + drawn, 1000);
    ASSERT_EQ(work.packet.size(), work.triangles.size());
    ASSERT_TRUE(std::adjacent_find(work.packet.begin(), work.packet.end(),
                                   std::greater_equal<>()) == work.packet.end());
    int64_t pixels = 0, last = 0, degenerate = 0, back = 0;
    for (const SpanCommand& span : work.spans) pixels += span.length, last += span.last;
    for (const TrianglePacket& p : list.triangles) {
      const Int128 area = Cross({p.x[0].raw(), p.y[0].raw()}, {p.x[1].raw(), p.y[1].raw()},
                                {p.x[2].raw(), p.y[2].raw()});
      degenerate += area == 0;
      back += area > 0 && list.frame.cull == Cull::kBack;
    }
    ASSERT_EQ(work.pixels, pixels);
    ASSERT_EQ(last, drawn);
    ASSERT_EQ(work.skipped.degenerate, degenerate);
    ASSERT_EQ(work.skipped.back_facing, back);
  }
}

// Front-facing, legs of `size` down and right of (x, y); raw coordinates.
TrianglePacket RightAngle(int64_t x, int64_t y, int64_t size) {
  return PacketOf({Point{x, y}, {x, y + size}, {x + size, y}});
}

// One triangle for each way not to be drawn, the last two by box and by walk.
std::vector<TrianglePacket> Undrawn() {
  TrianglePacket back = RightAngle(1000, 1000, 2000);
  std::swap(back.x[1], back.x[2]);
  std::swap(back.y[1], back.y[2]);
  return {back, RightAngle(1000, 1000, 0), RightAngle(-5000, 1000, 2000),
          RightAngle(2560 + 129, 2560 + 129, 90), RightAngle(2560, 2560, 140)};
}

TEST(FrontEnd, EachReasonIsCountedOnce) {
  TriangleList list = tb::RandomTriangles(1, 0);
  list.frame.width = list.frame.height = 64;
  list.frame.cull = Cull::kBack;
  list.triangles = Undrawn();
  list.triangles.push_back(RightAngle(1000, 1000, 2000));
  const FrameWork work = FrontEnd::Run(list, Method::kQuad);
  EXPECT_EQ(work.skipped.back_facing, 1);
  EXPECT_EQ(work.skipped.degenerate, 1);
  EXPECT_EQ(work.skipped.off_screen, 1);
  EXPECT_EQ(work.skipped.empty, 2);
  EXPECT_EQ(work.packet, std::vector<uint32_t>{5});
  ASSERT_EQ(work.triangles.size(), 1u);
  EXPECT_EQ(work.triangles[0].origin_x, work.spans[0].x);
  EXPECT_EQ(work.triangles[0].origin_y, work.spans[0].y);
}

TEST(FrontEnd, UncoveredTrianglesAreNotLit) {
  TriangleList list;
  list.frame = Screen(64, 64, Cull::kBack);
  list.triangles = Undrawn();
  ASSERT_TRUE(list.frame.materials.empty()) << "lighting would have to look one up";
  for (const Method method : kSurfaceMethods) {
    const FrameWork work = FrontEnd::Run(list, method);
    EXPECT_EQ(work.skipped.total(), 5);
    EXPECT_TRUE(work.triangles.empty() && work.spans.empty());
  }
}

Vector3 Along(size_t axis, int64_t sign) {
  Vector3 v;
  v[axis] = NormalComponent::FromRaw(sign << NormalComponent::kFraction);
  return v;
}

// Light of the nodes of a front face, whose corners are vertices 0, 2, 1, when the normals of
// vertices 0 and 2 are opposed.
std::array<SurfaceNodes, kChannels> OpposedNodes(const TrianglePacket& packet,
                                                 const FrameState& frame) {
  const VertexLight light(frame);
  const Material& material = frame.materials[0];
  const auto cosines = [&](size_t i) { return light.Cosines(packet.n[i]); };
  const auto bisected = [&](size_t i, size_t j) {
    const auto mean = MeanCosines::Of<2>({packet.n[i], packet.n[j]}, {cosines(i), cosines(j)});
    return light.Shade(mean.value(), material);
  };
  std::array<std::array<Intensity, 3>, 3> corner;
  for (size_t i = 0; i < 3; ++i) corner[i] = light.Shade(cosines(i), material);
  const auto middle_12 = bisected(1, 2), middle_01 = bisected(0, 1);
  std::array<SurfaceNodes, kChannels> nodes;
  for (size_t ch = 0; ch < kChannels; ++ch) {
    const int64_t ends = corner[0][ch].raw() + corner[2][ch].raw();
    nodes[ch] = {{corner[0][ch], corner[2][ch], corner[1][ch]},
                 {middle_12[ch], middle_01[ch], Intensity::FromRaw((ends + 1) / 2)}};
  }
  return nodes;
}

TEST(FrontEnd, OpposedNormalsGiveMeanOfEndIntensities) {
  int odd = 0;
  for (uint32_t seed = 0; seed < 40; ++seed) {
    TriangleList list = tb::RandomTriangles(seed, 0);
    list.frame.width = list.frame.height = 64;
    TrianglePacket packet = RightAngle(1000, 1000, 4000);
    packet.n = {Along(2, 1), Along(0, 1), Along(2, -1)};
    list.triangles = {packet};
    const FrameWork work = FrontEnd::Run(list, Method::kQuad);
    ASSERT_EQ(work.triangles.size(), 1u);
    TriangleGeometry geometry;
    TriangleSetup::Setup(packet, list.frame, &geometry);
    const auto plane = TriangleSetup::Barycentrics(geometry, work.spans[0].x, work.spans[0].y);
    const auto nodes = OpposedNodes(packet, list.frame);
    for (size_t ch = 0; ch < kChannels; ++ch) {
      odd += (nodes[ch].corner[0].raw() + nodes[ch].corner[1].raw()) % 2 != 0;
      EXPECT_TRUE(Same(work.triangles[0].surface[ch], SurfaceFit::Quadratic(plane, nodes[ch])));
    }
  }
  EXPECT_GT(odd, 0) << "halves must occur";
}

TEST(FrontEnd, FlatIsLightOfFaceNormal) {
  for (uint32_t seed = 0; seed < 12; ++seed) {
    const TriangleList list = tb::RandomTriangles(seed, 300);
    const FrameWork work = FrontEnd::Run(list, Method::kFlat);
    const VertexLight light(list.frame);
    for (size_t t = 0; t < work.triangles.size(); ++t) {
      const TrianglePacket& packet = list.triangles[work.packet[t]];
      const auto face = MeanCosines::OfFace(
          packet.n,
          {light.Cosines(packet.n[0]), light.Cosines(packet.n[1]), light.Cosines(packet.n[2])});
      const auto color =
          light.Shade(face, list.frame.materials[static_cast<size_t>(packet.material)]);
      for (size_t ch = 0; ch < kChannels; ++ch) {
        ASSERT_TRUE(Same(work.triangles[t].surface[ch], SurfaceFit::Constant(color[ch])));
      }
    }
  }
}

}  // namespace
}  // namespace shading
