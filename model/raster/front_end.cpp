// SPDX-License-Identifier: Apache-2.0
#include "model/raster/front_end.h"

#include <stdexcept>
#include <string>

#include "model/light/mean_cosines.h"
#include "model/normal/span_normals.h"
#include "model/raster/span_walker.h"
#include "model/raster/surface_fit.h"

namespace shading {
namespace {

using NodeColors = std::array<std::array<Intensity, kChannels>, 3>;

std::array<Intensity, 3> Channel(const NodeColors& colors, size_t ch) {
  return {colors[0][ch], colors[1][ch], colors[2][ch]};
}

// Halves up to the 2^-16 of a code: where opposed normals leave the middle undefined.
Intensity Mean(Intensity a, Intensity b) { return Intensity::FromRaw((a.raw() + b.raw() + 1) / 2); }

void Count(Verdict verdict, SkipCounts* skipped) {
  switch (verdict) {
    case Verdict::kDraw: break;
    case Verdict::kBackFacing: ++skipped->back_facing; break;
    case Verdict::kDegenerate: ++skipped->degenerate; break;
    case Verdict::kOffScreen: ++skipped->off_screen; break;
    case Verdict::kEmpty: ++skipped->empty; break;
  }
}

// Light at the middle of each edge, opposite each corner; nullopt as in MeanCosines.
NodeColors MiddleColors(const VertexLight& light, const Material& material,
                        const std::array<Vector3, 3>& normal,
                        const std::array<LightCosines, 3>& cosines, const NodeColors& corner) {
  NodeColors middle;
  for (size_t k = 0; k < 3; ++k) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const auto mean = MeanCosines::Of<2>({normal[i], normal[j]}, {cosines[i], cosines[j]});
    if (mean) {
      middle[k] = light.Shade(*mean, material);
    } else {
      for (size_t ch = 0; ch < kChannels; ++ch) middle[k][ch] = Mean(corner[i][ch], corner[j][ch]);
    }
  }
  return middle;
}

}  // namespace

FrontEnd::FrontEnd(const FrameState& frame, Method method)
    : frame_(frame), method_(method), light_(frame) {}

FrameWork FrontEnd::Run(const TriangleList& list, Method method) {
  const FrontEnd front_end(list.frame, method);
  FrameWork work = front_end.Begin();
  for (size_t i = 0; i < list.triangles.size(); ++i) {
    front_end.Add(list.triangles[i], static_cast<uint32_t>(i), &work);
  }
  return work;
}

FrameWork FrontEnd::Begin() const {
  FrameWork work;
  work.method = method_;
  if (!InterpolatesNormals(method_)) return work;
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
  if (InterpolatesNormals(method_)) {
    using Interpolation = SpanNormals::Interpolation;
    triangle.material = packet.material;
    work->split_spans += SpanNormals::Attach(
        geometry, packet, IsSpherical(method_) ? Interpolation::kSpherical : Interpolation::kLinear,
        first, triangle.dz_dx, &work->spans);
  } else {
    triangle.surface = Fit(packet, geometry, origin);
  }
  work->triangles.push_back(triangle);
  work->packet.push_back(index);
  work->pixels += pixels;
}

std::array<Surface, kChannels> FrontEnd::Fit(const TrianglePacket& packet,
                                             const TriangleGeometry& geometry,
                                             const SpanCommand& first) const {
  const Material& material = frame_.materials[static_cast<size_t>(packet.material)];
  std::array<Vector3, 3> normal;
  std::array<LightCosines, 3> cosines;
  for (size_t i = 0; i < 3; ++i) {
    normal[i] = packet.n[static_cast<size_t>(geometry.corner[i])];
    cosines[i] = light_.Cosines(normal[i]);
  }

  std::array<Surface, kChannels> surface;
  if (method_ == Method::kFlat) {
    const auto color = light_.Shade(MeanCosines::OfFace(normal, cosines), material);
    for (size_t ch = 0; ch < kChannels; ++ch) surface[ch] = SurfaceFit::Constant(color[ch]);
    return surface;
  }

  NodeColors corner;
  for (size_t i = 0; i < 3; ++i) corner[i] = light_.Shade(cosines[i], material);
  const auto plane = TriangleSetup::Barycentrics(geometry, first.x, first.y);
  if (method_ == Method::kGouraud) {
    for (size_t ch = 0; ch < kChannels; ++ch) {
      surface[ch] = SurfaceFit::Linear(plane, Channel(corner, ch));
    }
    return surface;
  }

  const NodeColors middle = MiddleColors(light_, material, normal, cosines, corner);
  for (size_t ch = 0; ch < kChannels; ++ch) {
    surface[ch] = SurfaceFit::Quadratic(plane, {Channel(corner, ch), Channel(middle, ch)});
  }
  return surface;
}

}  // namespace shading
