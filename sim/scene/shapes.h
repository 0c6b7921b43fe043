// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/scene/scene.h"

namespace shading::sim {

// Parametric shapes about the origin with exact normals and front faces outside. All triangles have
// material 0; the caller supplies the materials.

// Corners near the unit circle in z = 0, in n x n parts. The normal is the normalised linear
// interpolation of three tilted corner normals, so that a highlight lies inside.
Scene Triangle(int n);

// Unit sphere: n >= 2 latitude bands from pole to pole along y, 2n longitudes.
Scene Sphere(int n);

// Circle of radius 1 about z, tube of radius 0.4: n >= 3 rings of n sides.
Scene Torus(int n);

// z = x y / 2 over [-1, 1]^2 in n x n quads, seen from +z.
Scene Saddle(int n);

// z = 0 over [-1, 1]^2 in n x n quads, seen from +z; its normals lean outwards with x and y, by 20
// degrees at an edge's middle.
Scene Panel(int n);

// Radius 1/4 about the y axis, from y = -1 to 1, open: n >= 3 sides of n quads.
Scene Cylinder(int n);

struct Placement {
  double scale = 1;
  double yaw = 0, pitch = 0;  // degrees, about y and then about x
  Vec3 offset;
};

// Adds a scaled, rotated and shifted copy of the part, all of it of one new material.
void Append(const Scene& part, const Placement& placement, const SceneMaterial& material,
            Scene* scene);

}  // namespace shading::sim
