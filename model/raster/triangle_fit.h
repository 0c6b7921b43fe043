// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/vertex_light.h"
#include "model/raster/triangle_setup.h"
#include "model/triangle_packet.h"

namespace shading {

// Light at the nodes of a triangle and the surfaces through them: what the surface methods need of
// a triangle. Corners are the packet's vertices, middles the normalised means of two normals, paper
// 003; where opposed normals leave a middle undefined, it has the mean of the corners' values.
class TriangleFit {
 public:
  TriangleFit(const FrameState& frame, Method method)
      : frame_(frame), method_(method), light_(frame) {}

  // Fills the surfaces that the method uses, counted from pixel (x, y) of the screen.
  void Fit(const TrianglePacket& packet, const TriangleGeometry& geometry, int x, int y,
           TriangleState* triangle) const;

 private:
  struct Corners;
  void FitIntensities(const Corners& corners, const Material& material,
                      const TriangleGeometry& geometry, const std::array<Plane, 3>& plane,
                      TriangleState* triangle) const;
  void FitTerms(const Corners& corners, const Material& material, const std::array<Plane, 3>& plane,
                TriangleState* triangle) const;
  void FitCosines(const Corners& corners, const std::array<Plane, 3>& plane,
                  TriangleState* triangle) const;

  const FrameState& frame_;
  Method method_;
  VertexLight light_;
};

}  // namespace shading
