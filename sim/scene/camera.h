// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/triangle_packet.h"
#include "sim/scene/scene.h"

namespace shading::sim {

struct ViewOptions {
  int width = 640, height = 480;  // pixels, 1..4096
  bool perspective = false;       // else orthographic
  double yaw = 0, pitch = 0;      // degrees: the scene turns about y, then about x
  Vec3 light = {0.4, 0.5, 0.8};   // towards the light, camera space, any length
  Lighting lighting = Lighting::kBlinn;
  Cull cull = Cull::kBack;
};

// Camera space is x right, y up, z towards the viewer. The scene's bounding sphere fills the
// shorter side of the screen but for a margin of 5 %; perspective has a vertical field of view of
// 45 degrees and stands outside the sphere, so that nothing is ever clipped. Depth is affine on
// the screen: 0 at the nearest and 1 at the farthest point of the sphere.
// The packets are the scene rounded to the unit's formats; triangles that face away, have no area
// or miss every pixel stay in the list. Throws std::runtime_error for an option out of range, a
// light that gives no half vector, and vertices that are not finite or have no normal.
TriangleList Project(const Scene& scene, const ViewOptions& options);

}  // namespace shading::sim
