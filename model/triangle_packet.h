// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/fixed/fixed.h"

namespace shading {

// The bit-exact input of the shading unit: everything after these values is hardware.
using ScreenCoord = S<13, 8>;      // pixels; y runs down; guard band of +-8192 pixels
using VertexDepth = U<0, 24>;      // [0, 1), smaller is nearer
using NormalComponent = S<1, 22>;  // component of a unit vector
using Reflectance = U<1, 16>;      // coefficient times light colour, 0..1
using Shininess = U<9, 7>;         // exponent n, 1..256

using DepthSlope = U<0, 24>;       // 1 / distance of depth z is in proportion to 1 - slope z

using Vector3 = std::array<NormalComponent, 3>;
using Rgb = std::array<Reflectance, 3>;

struct Material {
  Rgb ambient, diffuse, specular;
  Shininess shininess = Shininess::FromRaw(int64_t{1} << Shininess::kFraction);
};

enum class Lighting { kBlinn, kPhong };  // specular cosine: N.H or R.V
enum class Cull { kBack, kNone };

// Light and viewer are at infinity, so these vectors are constants of the frame. Unit length, in
// camera space: x right, y up, z towards the viewer.
struct FrameState {
  int width = 0, height = 0;  // pixels, 1..4096
  Vector3 light, half, view;
  Lighting lighting = Lighting::kBlinn;
  Cull cull = Cull::kBack;
  DepthSlope depth_slope;  // 0 without perspective
  std::vector<Material> materials;
};

// One triangle in screen space. Front faces are counter-clockwise as seen on the screen.
struct TrianglePacket {
  std::array<ScreenCoord, 3> x, y;
  std::array<VertexDepth, 3> z;
  std::array<Vector3, 3> n;  // unit length within 2^-10
  int material = 0;
};

// A frame as it enters the shading unit, from a scene, a .jsonl file or a generator.
struct TriangleList {
  FrameState frame;
  std::vector<TrianglePacket> triangles;
};

}  // namespace shading
