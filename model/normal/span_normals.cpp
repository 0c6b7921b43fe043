// SPDX-License-Identifier: Apache-2.0
#include "model/normal/span_normals.h"

#include <cassert>
#include <cstddef>

#include "model/normal/edge_normals.h"

namespace shading {
namespace {

constexpr int kPlaneFraction = 48;

SpanNormalComponent Rounded(int64_t value, int fraction) {
  return SpanNormalComponent::FromRaw(RoundShift(value, fraction - SpanNormalComponent::kFraction));
}

int LastPixel(const SpanCommand& span) { return span.x + span.length - 1; }

// One component of the packet's normals, counted from pixel (x, y) of the screen.
Plane NormalPlane(const TriangleGeometry& geometry, const TrianglePacket& packet, size_t component,
                  int x, int y) {
  const int64_t column = x - geometry.box_x, row = y - geometry.box_y;
  Int128 at_origin = 0, dx = 0, dy = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Edge& edge = geometry.edge[i];
    const Int128 n = packet.n[static_cast<size_t>(geometry.corner[i])][component].raw();
    at_origin += n * (edge.w0 + column * edge.dx + row * edge.dy);
    dx += n * edge.dx;
    dy += n * edge.dy;
  }
  const auto quantise = [&](Int128 sum) {
    constexpr int64_t kScale = int64_t{1} << (kPlaneFraction - NormalComponent::kFraction);
    return static_cast<uint64_t>(RoundDivide(sum * kScale, geometry.area));
  };
  return {quantise(at_origin), quantise(dx), quantise(dy)};
}

SpanNormal Rounded(const ArcVector& v) {
  return {Rounded(v[0], kArcFraction), Rounded(v[1], kArcFraction), Rounded(v[2], kArcFraction)};
}

void AttachLinear(const TriangleGeometry& geometry, const TrianglePacket& packet, size_t first_span,
                  std::vector<SpanCommand>* spans) {
  const int x = (*spans)[first_span].x, y = (*spans)[first_span].y;
  for (size_t c = 0; c < 3; ++c) {
    const Plane plane = NormalPlane(geometry, packet, c, x, y);
    for (size_t i = first_span; i < spans->size(); ++i) {
      SpanCommand& span = (*spans)[i];
      const auto at = [&](int pixel) {
        return Rounded(static_cast<int64_t>(plane.At(pixel - x, span.y - y)), kPlaneFraction);
      };
      span.normal[0][c] = at(span.x);
      span.normal[1][c] = at(LastPixel(span));
    }
  }
}

// S2.60
int64_t Dot(const std::array<SpanNormal, 2>& ends) {
  int64_t sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += ends[0][c].raw() * ends[1][c].raw();
  return sum;
}

// Cuts the first span into [0, k) and [k, length) and returns the second; they want the normals at
// their new ends. The arc runs at uniform speed, so the middle pixel is next to the bisector and
// the larger part spans length / 2 of the length - 1 steps.
SpanCommand Split(SpanCommand* span, DepthAcc dz_dx) {
  const int k = span->length / 2;
  SpanCommand rest = *span;
  rest.x += k;
  rest.length -= k;
  rest.z = DepthAcc::Wrap(span->z.raw() + k * dz_dx.raw());
  span->length = k;
  span->last = false;
  return rest;
}

int64_t AttachSpherical(const TriangleGeometry& geometry, const TrianglePacket& packet,
                        size_t first_span, DepthAcc dz_dx, std::vector<SpanCommand>* spans) {
  // -2^-8: 90 degrees and the roundings.
  [[maybe_unused]] constexpr int64_t kLeastDot = -(int64_t{1} << 52);
  RowEnds ends(geometry, packet);
  std::vector<size_t> cut;        // spans to split
  std::vector<SpanCommand> rest;  // their second parts
  for (size_t i = first_span; i < spans->size(); ++i) {
    SpanCommand& span = (*spans)[i];
    const SphereArc arc = ends.Row(span.y);
    const auto at = [&](int pixel) { return Rounded(arc.At(ends.Weight(pixel))); };
    span.normal[0] = at(span.x);
    span.normal[1] = span.length > 1 ? at(LastPixel(span)) : span.normal[0];
    if (Dot(span.normal) >= 0) continue;
    cut.push_back(i);
    rest.push_back(Split(&span, dz_dx));
    span.normal[1] = at(LastPixel(span));
    rest.back().normal[0] = at(rest.back().x);
    assert(Dot(span.normal) >= kLeastDot && Dot(rest.back().normal) >= kLeastDot);
  }
  // Second parts move in behind the first ones, from the last to the first.
  size_t from = spans->size();
  spans->resize(from + cut.size());
  for (size_t pending = cut.size(); pending > 0;) {
    --from;
    if (from == cut[pending - 1]) {
      (*spans)[from + pending] = rest[pending - 1];
      --pending;
    }
    (*spans)[from + pending] = (*spans)[from];
  }
  return static_cast<int64_t>(cut.size());
}

}  // namespace

int64_t SpanNormals::Attach(const TriangleGeometry& geometry, const TrianglePacket& packet,
                            Interpolation interpolation, size_t first_span, DepthAcc dz_dx,
                            std::vector<SpanCommand>* spans) {
  if (first_span >= spans->size()) return 0;
  if (interpolation == Interpolation::kSpherical) {
    return AttachSpherical(geometry, packet, first_span, dz_dx, spans);
  }
  AttachLinear(geometry, packet, first_span, spans);
  return 0;
}

}  // namespace shading
