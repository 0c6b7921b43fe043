// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "model/frame_work.h"
#include "model/raster/subdivision.h"
#include "model/raster/triangle_fit.h"
#include "model/raster/triangle_setup.h"
#include "model/triangle_packet.h"

namespace shading {

// What to do with a triangle whose normals turn too far for the tolerance.
enum class Subdivide { kNever, kReport, kSplit };

struct FrontEndOptions {
  Tolerance tolerance = Tolerance::FromRaw(int64_t{1} << (Tolerance::kFraction - 1));  // 1/2 code
  Subdivide subdivide = Subdivide::kNever;
  // Auto: chooses in place of MethodChoice::Of. The shading unit goes by range and limit of the
  // triangle: the caller of Run changes these in its FrameWork until they give the same choice.
  std::function<Choice(const LightRange&, const ChoiceLimit&)> choose;
};

// Triangle packets to the commands of the shading unit, integers only: set-up, span walk, vertex
// lighting and surface fit. A packet that is not drawn is counted, and neither lit nor fitted. In
// auto frames a triangle gets what the method chosen for it needs.
class FrontEnd {
 public:
  FrontEnd(const FrameState& frame, Method method, const FrontEndOptions& options = {});

  // Throws std::length_error when a method that lights every pixel meets more than kMaxMaterials.
  static FrameWork Run(const TriangleList& list, Method method,
                       const FrontEndOptions& options = {});

  // A frame without triangles.
  FrameWork Begin() const;

  // Appends the triangle, or what it is split into, and its spans to `work`, or counts why not.
  void Add(const TrianglePacket& packet, uint32_t index, FrameWork* work) const;

 private:
  // False when it covers no pixel.
  bool Draw(const TrianglePacket& packet, const TriangleGeometry& geometry, uint32_t index,
            FrameWork* work) const;
  // How the triangle is shaded; fills what the choice goes by.
  Choice Choose(const TrianglePacket& packet, TriangleState* triangle) const;
  // Footprint and folded normals of the triangle whose spans begin at `first`.
  void SetFootprint(const TrianglePacket& packet, const TriangleGeometry& geometry, size_t first,
                    TriangleState* triangle, FrameWork* work) const;

  const FrameState& frame_;
  Method method_;
  FrontEndOptions options_;
  TriangleFit fit_;
  std::vector<ChoiceLimit> limits_;       // auto: of each material
  std::vector<Subdivision> subdivision_;  // of each material; none where nothing is subdivided
};

}  // namespace shading
