// SPDX-License-Identifier: Apache-2.0
#include "model/raster/front_end.h"

#include <stdexcept>
#include <string>

#include "model/normal/span_normals.h"
#include "model/raster/span_walker.h"
#include "model/raster/turn_limit.h"

namespace shading {
namespace {

void Count(Verdict verdict, SkipCounts* skipped) {
  switch (verdict) {
    case Verdict::kDraw: break;
    case Verdict::kBackFacing: ++skipped->back_facing; break;
    case Verdict::kDegenerate: ++skipped->degenerate; break;
    case Verdict::kOffScreen: ++skipped->off_screen; break;
    case Verdict::kEmpty: ++skipped->empty; break;
  }
}

}  // namespace

FrontEnd::FrontEnd(const FrameState& frame, Method method, const FrontEndOptions& options)
    : frame_(frame), method_(method), options_(options), fit_(frame, method, options.footprint) {
  if (options.subdivide == Subdivide::kNever) return;
  for (const Material& material : frame.materials) {
    subdivision_.emplace_back(TurnLimit(method, material, options.tolerance));
  }
}

FrameWork FrontEnd::Run(const TriangleList& list, Method method, const FrontEndOptions& options) {
  const FrontEnd front_end(list.frame, method, options);
  FrameWork work = front_end.Begin();
  for (size_t i = 0; i < list.triangles.size(); ++i) {
    front_end.Add(list.triangles[i], static_cast<uint32_t>(i), &work);
  }
  return work;
}

FrameWork FrontEnd::Begin() const {
  FrameWork work;
  work.method = method_;
  work.tolerance = options_.tolerance;
  if (!LightsPixels(method_)) return work;
  if (frame_.materials.size() > kMaxMaterials) {
    throw std::length_error("the scene has " + std::to_string(frame_.materials.size()) +
                            " materials; methods that light every pixel hold " +
                            std::to_string(kMaxMaterials));
  }
  work.light = LightOf(frame_);
  work.materials = frame_.materials;
  return work;
}

void FrontEnd::Add(const TrianglePacket& packet, uint32_t index, FrameWork* work) const {
  const bool too_far =
      !subdivision_.empty() &&
      subdivision_[static_cast<size_t>(packet.material)].TurnsTooFar(packet);
  if (!too_far) return AddWhole(packet, index, work);
  ++work->over_limit;
  if (options_.subdivide == Subdivide::kReport) return AddWhole(packet, index, work);
  std::vector<TrianglePacket> pieces;
  subdivision_[static_cast<size_t>(packet.material)].Split(packet, &pieces);
  work->pieces += static_cast<int64_t>(pieces.size());
  for (const TrianglePacket& piece : pieces) AddWhole(piece, index, work);
}

void FrontEnd::AddWhole(const TrianglePacket& packet, uint32_t index, FrameWork* work) const {
  TriangleGeometry geometry;
  const Verdict verdict = TriangleSetup::Setup(packet, frame_, &geometry);
  Count(verdict, &work->skipped);
  if (verdict != Verdict::kDraw) return;

  const size_t first = work->spans.size();
  const Plane depth = TriangleSetup::DepthPlane(geometry, packet);
  const int64_t pixels = SpanWalker::Walk(geometry, depth, &work->spans);
  if (pixels == 0) {
    Count(Verdict::kEmpty, &work->skipped);
    return;
  }

  const SpanCommand origin = work->spans[first];
  TriangleState triangle;
  triangle.origin_x = origin.x;
  triangle.origin_y = origin.y;
  triangle.dz_dx = DepthAcc::Wrap(static_cast<int64_t>(depth.dx));
  triangle.material = packet.material;
  if (InterpolatesNormals(method_)) {
    using Interpolation = SpanNormals::Interpolation;
    work->split_spans += SpanNormals::Attach(
        geometry, packet, IsSpherical(method_) ? Interpolation::kSpherical : Interpolation::kLinear,
        first, triangle.dz_dx, &work->spans);
  } else {
    fit_.Fit(packet, geometry, origin.x, origin.y, &triangle);
  }
  work->triangles.push_back(triangle);
  work->packet.push_back(index);
  work->pixels += pixels;
}

}  // namespace shading
