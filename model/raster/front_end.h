// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/frame_work.h"
#include "model/light/vertex_light.h"
#include "model/raster/triangle_setup.h"
#include "model/triangle_packet.h"

namespace shading {

// Triangle packets to the commands of the shading unit, integers only: set-up, span walk, vertex
// lighting and surface fit. A triangle that covers no pixel is counted, and neither lit nor fitted.
class FrontEnd {
 public:
  FrontEnd(const FrameState& frame, Method method);

  // Throws std::length_error when a method that interpolates normals meets more than kMaxMaterials.
  static FrameWork Run(const TriangleList& list, Method method);

  // A frame without triangles.
  FrameWork Begin() const;

  // Appends the triangle and its spans to `work`, or counts why not.
  void Add(const TrianglePacket& packet, uint32_t index, FrameWork* work) const;

 private:
  std::array<Surface, kChannels> Fit(const TrianglePacket& packet, const TriangleGeometry& geometry,
                                     const SpanCommand& first) const;

  const FrameState& frame_;
  Method method_;
  VertexLight light_;
};

}  // namespace shading
