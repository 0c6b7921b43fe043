// SPDX-License-Identifier: Apache-2.0
//
// Triangles that the front end splits for a tolerance, in displayed codes against exact
// Blinn-Phong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/ideal/phong.h"
#include "model/raster/front_end.h"
#include "model/raster/turn_limit.h"
#include "model/shading_unit.h"

namespace shading {
namespace {

constexpr int kScreen = 200;  // pixels
constexpr double kUnitBound = 0.5 + ShadingUnit::kContract.max_error_ulp;

// Within `degrees` of the axis to the viewer.
Vector3 Leaning(double degrees, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double turn = degrees * std::sqrt(unit(random)) * std::acos(-1.0) / 180;
  const double around = 2 * std::acos(-1.0) * unit(random);
  return {NormalComponent::Round(std::sin(turn) * std::cos(around)),
          NormalComponent::Round(std::sin(turn) * std::sin(around)),
          NormalComponent::Round(std::cos(turn))};
}

// A large triangle. Normals, L and H lean at most 40 degrees, so that N.L and N.H are positive
// everywhere, and kd + ks = 1: what the rule asks for.
TriangleList RandomList(int shininess, std::mt19937& random) {
  TriangleList list;
  list.frame.width = list.frame.height = kScreen;
  list.frame.cull = Cull::kNone;
  list.frame.light = Leaning(40, random);
  list.frame.half = Leaning(40, random);
  list.frame.view = Leaning(0, random);
  Material material;
  const double diffuse = 0.25 * static_cast<double>(random() % 5);
  material.diffuse.fill(Reflectance::Round(diffuse));
  material.specular.fill(Reflectance::Round(1 - diffuse));
  material.shininess = Shininess::FromRaw(int64_t{shininess} << Shininess::kFraction);
  list.frame.materials.push_back(material);
  constexpr std::array<double, 3> kX = {11, 187, 93}, kY = {17, 38, 191};
  TrianglePacket packet;
  for (size_t i = 0; i < 3; ++i) {
    packet.x[i] = ScreenCoord::Round(kX[i]);
    packet.y[i] = ScreenCoord::Round(kY[i]);
    packet.n[i] = Leaning(40, random);
  }
  list.triangles.push_back(packet);
  return list;
}

std::vector<Pixel> PixelsOf(const TriangleList& list, Method method,
                            const FrontEndOptions& options) {
  const FrameWork work = FrontEnd::Run(list, method, options);
  ShadingUnit unit(work, 1, FlowPattern::Always(), FlowPattern::Always());
  std::vector<Pixel> pixels, span_pixels(kScreen);
  auto triangle = work.triangles.begin();
  bool last = true;
  for (const SpanCommand& span : work.spans) {
    if (last) unit.Triangle(*triangle++);
    last = span.last;
    unit.Span(span, span_pixels.data());
    pixels.insert(pixels.end(), span_pixels.begin(), span_pixels.begin() + span.length);
  }
  return pixels;
}

double WorstOf(const std::vector<Pixel>& pixels, const TriangleList& list) {
  const ideal::Phong phong(list.frame, list.triangles[0]);
  double worst = 0;
  for (const Pixel& pixel : pixels) {
    const ideal::Rgb exact = ideal::Clamped(phong.At(pixel.x + 0.5, pixel.y + 0.5));
    worst = std::max(worst, std::abs(pixel.r - exact[0]));
  }
  return worst;
}

struct Found {
  double split = 0, whole = 0;  // largest errors, codes
  size_t pieces = 0;
};

// The picture of the split triangle is that of its pieces, and each of them keeps the tolerance.
Found Measure(const TriangleList& list, Method method, const FrontEndOptions& options) {
  const Subdivision subdivision(TurnLimit(method, list.frame.materials[0], options.tolerance));
  std::vector<TrianglePacket> pieces;
  subdivision.Split(list.triangles[0], &pieces);
  Found found{0, WorstOf(PixelsOf(list, method, {}), list), pieces.size()};
  std::vector<Pixel> all;
  for (const TrianglePacket& piece : pieces) {
    EXPECT_FALSE(subdivision.TurnsTooFar(piece)) << "more cuts than there may be";
    TriangleList one = list;
    one.triangles = {piece};
    const std::vector<Pixel> pixels = PixelsOf(one, method, {});
    found.split = std::max(found.split, WorstOf(pixels, one));
    all.insert(all.end(), pixels.begin(), pixels.end());
  }
  const std::vector<Pixel> split = PixelsOf(list, method, options);
  EXPECT_GT(split.size(), 10000u);
  EXPECT_TRUE(std::equal(
      split.begin(), split.end(), all.begin(), all.end(), [](const Pixel& a, const Pixel& b) {
        return a.x == b.x && a.y == b.y && a.r == b.r && a.g == b.g && a.b == b.b;
      }));
  return found;
}

// The largest of twelve triangles.
Found MeasureAll(Method method, int shininess, double tolerance, std::mt19937& random) {
  FrontEndOptions options;
  options.tolerance = Tolerance::Round(tolerance);
  options.subdivide = Subdivide::kSplit;
  Found most;
  for (int i = 0; i < 12; ++i) {
    const Found found = Measure(RandomList(shininess, random), method, options);
    most = {std::max(most.split, found.split), std::max(most.whole, found.whole),
            std::max(most.pieces, found.pieces)};
  }
  return most;
}

TEST(Split, CodesStayWithinTheTolerance) {
  std::mt19937 random(1);
  for (const Method method :
       {Method::kGouraud, Method::kQuad, Method::kQuadSplit, Method::kQuadCosine}) {
    for (const int shininess : {8, 32}) {
      for (const double tolerance : {1.0, 4.0}) {
        const Found most = MeasureAll(method, shininess, tolerance, random);
        SCOPED_TRACE(testing::Message() << Name(method) << " n " << shininess << " tolerance "
                                        << tolerance << ", " << most.pieces << " pieces");
        EXPECT_LE(most.split, tolerance + kUnitBound);
        EXPECT_GT(most.split, 0.5 + 0.15 * tolerance) << "nothing came near the tolerance";
        EXPECT_GT(most.whole, tolerance + kUnitBound) << "nothing had to be split";
      }
    }
  }
}

}  // namespace
}  // namespace shading
