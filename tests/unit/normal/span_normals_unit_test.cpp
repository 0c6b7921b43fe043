// SPDX-License-Identifier: Apache-2.0
#include "model/normal/span_normals.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/normal/span_normals_checks.h"

namespace shading {
namespace {

// Triangles whose normals turn by at most 60 degrees: the unit vectors of what kLinear has.
TEST(SpanNormals, UnitWithinErrorBound) {
  std::mt19937 random(14);
  const FrameState frame = SpanFrame(4096, 4096);
  CornerGenerator corners(15, frame.width, frame.height);
  double worst = 0;
  Attached t;
  for (int i = 0; i < 3000; ++i) {
    TrianglePacket packet = AnyTriangle(&corners, random);
    packet.n[1] = Near(packet.n[0], 0.4, random);
    packet.n[2] = Near(packet.n[0], 0.4, random);
    if (!t.Make(packet, frame, Interpolation::kUnit)) continue;
    const ExactTriangle exact(t.packet);
    for (size_t k = 0; k < t.spans.size(); k += 1 + t.spans.size() / 8) {
      const SpanCommand& span = t.spans[k];
      for (const int end : {0, 1}) {
        const auto weight = exact.Weights(span.x + (end ? span.length - 1 : 0), span.y);
        std::array<Real, 3> n = {};
        Real square = 0;
        for (size_t c = 0; c < 3; ++c) {
          for (size_t v = 0; v < 3; ++v) {
            n[c] += static_cast<Real>(weight[v]) * static_cast<Real>(t.packet.n[v][c].raw());
          }
          square += n[c] * n[c];
        }
        for (size_t c = 0; c < 3; ++c) {
          const Real expected = std::ldexp(n[c] / std::sqrt(square), 30);
          const auto actual = span.normal[static_cast<size_t>(end)][c].raw();
          worst =
              std::max(worst, static_cast<double>(std::abs(expected - static_cast<Real>(actual))));
        }
      }
    }
  }
  EXPECT_LE(worst, 0.6);
  EXPECT_GT(worst, 0.49);
  std::printf("unit %.4f ulp\n", worst);
}

}  // namespace
}  // namespace shading
