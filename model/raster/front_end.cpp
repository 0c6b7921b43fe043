// SPDX-License-Identifier: Apache-2.0
#include "model/raster/front_end.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/choice/method_choice.h"
#include "model/footprint/footprint_setup.h"
#include "model/normal/adaptive_normalizer.h"
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

// What adaptive_normalizer may leave unnormalised.
AngleLimit LimitOf(const Material& material, Tolerance tolerance, Lighting lighting) {
  const bool specular =
      std::any_of(material.specular.begin(), material.specular.end(),
                  [](const Reflectance reflectance) { return reflectance.raw() > 0; });
  return AdaptiveNormalizer::LimitOf(tolerance, material.shininess, specular, lighting);
}

}  // namespace

FrontEnd::FrontEnd(const FrameState& frame, Method method, const FrontEndOptions& options)
    : frame_(frame), method_(method), options_(options), fit_(frame) {
  if (method == Method::kAuto) {
    for (const Material& material : frame.materials) {
      limits_.push_back(MethodChoice::LimitOf(material, options.tolerance));
    }
  }
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
  work.limits = limits_;
  return work;
}

void FrontEnd::Add(const TrianglePacket& packet, uint32_t index, FrameWork* work) const {
  TriangleGeometry geometry;
  const Verdict verdict = TriangleSetup::Setup(packet, frame_, &geometry);
  if (verdict != Verdict::kDraw) return Count(verdict, &work->skipped);
  const Subdivision* subdivision =
      subdivision_.empty() ? nullptr : &subdivision_[static_cast<size_t>(packet.material)];
  const bool too_far = subdivision != nullptr && subdivision->TurnsTooFar(packet);
  work->over_limit += too_far;
  bool drawn = false;
  if (too_far && options_.subdivide == Subdivide::kSplit) {
    std::vector<TrianglePacket> pieces;
    subdivision->Split(packet, &pieces);
    for (const TrianglePacket& piece : pieces) {
      if (TriangleSetup::Setup(piece, frame_, &geometry) != Verdict::kDraw) continue;
      const bool piece_drawn = Draw(piece, geometry, index, work);
      work->pieces += piece_drawn;
      drawn |= piece_drawn;
    }
  } else {
    drawn = Draw(packet, geometry, index, work);
  }
  if (!drawn) Count(Verdict::kEmpty, &work->skipped);
}

bool FrontEnd::Draw(const TrianglePacket& packet, const TriangleGeometry& geometry, uint32_t index,
                    FrameWork* work) const {
  const size_t first = work->spans.size();
  const Plane depth = TriangleSetup::DepthPlane(geometry, packet);
  const int64_t pixels = SpanWalker::Walk(geometry, depth, &work->spans);
  if (pixels == 0) return false;

  const SpanCommand origin = work->spans[first];
  TriangleState triangle;
  triangle.origin_x = origin.x;
  triangle.origin_y = origin.y;
  triangle.dz_dx = DepthAcc::Wrap(static_cast<int64_t>(depth.dx));
  triangle.material = packet.material;
  const Choice choice = Choose(packet, &triangle);
  if (IsAdaptive(method_)) {
    triangle.limit = LimitOf(frame_.materials[static_cast<size_t>(packet.material)],
                             options_.tolerance, frame_.lighting);
  }
  if (IsFootprint(method_)) {
    SetFootprint(packet, geometry, first, &triangle, work);
  } else if (InterpolatesNormals(choice.method)) {
    using Interpolation = SpanNormals::Interpolation;
    work->split_spans += SpanNormals::Attach(
        geometry, packet,
        IsSpherical(choice.method) ? Interpolation::kSpherical : Interpolation::kLinear,
        first, triangle.dz_dx, &work->spans);
  } else {
    fit_.Fit(packet, geometry, choice, origin.x, origin.y, &triangle);
  }
  work->triangles.push_back(triangle);
  work->packet.push_back(index);
  work->pixels += pixels;
  MethodShare& share = work->share[static_cast<size_t>(choice.method)];
  ++share.triangles;
  share.spans += static_cast<int64_t>(work->spans.size() - first);
  share.pixels += pixels;
  return true;
}

Choice FrontEnd::Choose(const TrianglePacket& packet, TriangleState* triangle) const {
  if (method_ != Method::kAuto) return ChoiceOf(method_);
  triangle->range = fit_.Range(packet);
  const ChoiceLimit& limit = limits_[static_cast<size_t>(packet.material)];
  return options_.choose ? options_.choose(triangle->range, limit)
                         : MethodChoice::Of(triangle->range, limit, frame_.lighting);
}

void FrontEnd::SetFootprint(const TrianglePacket& packet, const TriangleGeometry& geometry,
                            size_t first, TriangleState* triangle, FrameWork* work) const {
  FootprintSetup::Options options;
  options.form =
      method_ == Method::kFootprintPaper ? FootprintForm::kPaper : FootprintForm::kSeamless;
  options.tolerance = options_.tolerance;
  const FootprintSetup::Result result = FootprintSetup(options).Of(
      packet, geometry, frame_.materials[static_cast<size_t>(packet.material)], triangle->origin_x,
      triangle->origin_y, FootprintSetup::WeightsOf(packet.z, frame_.depth_slope));
  triangle->footprint = result.footprint;
  TrianglePacket folded = packet;
  folded.n = result.vertex;
  SpanNormals::Attach(geometry, folded, SpanNormals::Interpolation::kLinear, first, triangle->dz_dx,
                      &work->spans);
  if (options.form == FootprintForm::kSeamless) return;
  for (size_t i = first; i < work->spans.size(); ++i) {
    SpanCommand& span = work->spans[i];
    span.margin = result.At(span.x - triangle->origin_x, span.y - triangle->origin_y);
  }
}

}  // namespace shading
