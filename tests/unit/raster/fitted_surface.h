// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "model/raster/span_setup.h"
#include "model/raster/span_walker.h"
#include "model/raster/surface_fit.h"
#include "tests/unit/raster/packet_stimulus.h"

namespace shading {

inline constexpr int64_t kFullCodes = int64_t{255} << Intensity::kFraction;
inline constexpr int64_t kHalfCode = int64_t{1} << (IntensityAcc::kFraction - 1);

// Node values by vertex of the packet; middle k is opposite vertex k.
struct NodeValues {
  std::array<int64_t, 3> corner, middle;  // raw U8.16

  static NodeValues Draw(CornerGenerator* random) {
    const bool extreme = random->Integer(0, 1);
    const auto draw = [&] {
      return extreme ? random->Integer(0, 1) * kFullCodes : random->Integer(0, kFullCodes);
    };
    return {{draw(), draw(), draw()}, {draw(), draw(), draw()}};
  }
  // Straight edges: what `gouraud` interpolates.
  NodeValues Straight() const {
    NodeValues nodes = *this;
    for (int64_t& value : nodes.corner) value &= ~int64_t{1};
    for (size_t k = 0; k < 3; ++k) {
      nodes.middle[k] = (nodes.corner[(k + 1) % 3] + nodes.corner[(k + 2) % 3]) / 2;
    }
    return nodes;
  }
  // The surface times area^2 in 2^-16 codes, from the six basis functions of the nodes.
  Int128 Exact(const std::array<Int128, 3>& w, Int128 area) const {
    Int128 sum = 0;
    for (size_t k = 0; k < 3; ++k) {
      sum += w[k] * (2 * w[k] - area) * corner[k] + 4 * w[(k + 1) % 3] * w[(k + 2) % 3] * middle[k];
    }
    return sum;
  }
};

// One triangle with three channels of node values, set up for a screen.
class Fitted {
 public:
  Fitted(const Corners& corner, const FrameState& frame) : exact_(PacketOf(corner)) {
    if (TriangleSetup::Setup(PacketOf(corner), frame, &geometry_) != Verdict::kDraw) return;
    SpanWalker::Walk(geometry_, {}, &spans_);
    if (spans_.empty()) return;
    triangle_.origin_x = spans_[0].x;
    triangle_.origin_y = spans_[0].y;
    plane_ = TriangleSetup::Barycentrics(geometry_, spans_[0].x, spans_[0].y);
  }

  void Fit(size_t channel, const NodeValues& nodes, Method method = Method::kQuad) {
    nodes_[channel] = nodes;
    SurfaceNodes turned;
    for (size_t i = 0; i < 3; ++i) {
      const size_t v = static_cast<size_t>(geometry_.corner[i]);
      turned.corner[i] = Intensity::FromRaw(nodes.corner[v]);
      turned.middle[i] = Intensity::FromRaw(nodes.middle[v]);
    }
    triangle_.surface[channel] = method == Method::kQuad
                                     ? SurfaceFit::Quadratic(plane_, turned)
                                     : SurfaceFit::Linear(plane_, turned.corner);
  }
  void FitAll(CornerGenerator* random) {
    for (size_t ch = 0; ch < kChannels; ++ch) Fit(ch, NodeValues::Draw(random));
  }

  // Off the exact surface, in codes: the accumulator of a covered pixel without the half code.
  double Error(size_t channel, IntensityAcc accumulator, int x, int y) const {
    const Int128 area = exact_.area();
    const Int128 exact = nodes_[channel].Exact(exact_.Weights(x, y), area);
    const Int128 error = (accumulator.raw() - kHalfCode) * area * area - exact * (1 << 10);
    const double size = static_cast<double>(area);
    return std::ldexp(std::abs(static_cast<double>(error) / size / size), -IntensityAcc::kFraction);
  }
  SpanSeed Seed(int x, int y, Method method = Method::kQuad) const {
    return SpanSetup::Seed(method, triangle_, {x, y, 1, {}, false});
  }

  // The proof, at one pixel: 6 coefficients within 2^-27, two barycentrics within
  // (x + y + 1) 2^-34 whose effect grows to 9 * 255.
  double Bound(int x, int y) const {
    const double u = std::abs(x - triangle_.origin_x), v = y - triangle_.origin_y;
    return (u * u + u * v + v * v + u + v + 1) * 0x1p-27 + 2295 * (u + v + 1) * 0x1p-34 + 1e-7;
  }
  double LinearBound(int x, int y) const {
    const double steps = std::abs(x - triangle_.origin_x) + y - triangle_.origin_y + 1;
    return steps * 0x1p-27 + 2 * 255 * steps * 0x1p-34;
  }

  bool empty() const { return spans_.empty(); }
  const std::vector<SpanCommand>& spans() const { return spans_; }
  const Surface& surface(size_t channel) const { return triangle_.surface[channel]; }
  const TriangleGeometry& geometry() const { return geometry_; }

 private:
  ExactTriangle exact_;
  TriangleGeometry geometry_;
  std::vector<SpanCommand> spans_;
  TriangleState triangle_;
  std::array<Plane, 3> plane_;
  std::array<NodeValues, kChannels> nodes_;
};

}  // namespace shading
