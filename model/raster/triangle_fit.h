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
  explicit TriangleFit(const FrameState& frame)
      : frame_(frame), light_state_(LightOf(frame)), light_(frame) {}

  // How far the normals turn, and the cosines at the vertices: what the choice goes by.
  LightRange Range(const TrianglePacket& packet) const;

  // Fills the surfaces that the method uses, counted from pixel (x, y) of the screen. A dark choice
  // has no highlight, an ambient one no light at all.
  void Fit(const TrianglePacket& packet, const TriangleGeometry& geometry, const Choice& choice,
           int x, int y, TriangleState* triangle) const;

 private:
  struct Corners;
  Corners CornersOf(const TrianglePacket& packet, const std::array<int, 3>& corner) const;
  void FitIntensities(Method method, const Corners& corners, const Material& material,
                      const TriangleGeometry& geometry, const std::array<Plane, 3>& plane,
                      TriangleState* triangle) const;
  void FitTerms(const Corners& corners, const Material& material, const std::array<Plane, 3>& plane,
                TriangleState* triangle) const;
  void FitCosines(const Corners& corners, const std::array<Plane, 3>& plane,
                  TriangleState* triangle) const;
  static void FitNormal(const Corners& corners, const std::array<Plane, 3>& plane,
                        TriangleState* triangle);

  const FrameState& frame_;
  LightState light_state_;
  VertexLight light_;
};

}  // namespace shading
