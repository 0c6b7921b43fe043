// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace shading::accuracy {

// What the paper's enlarged triangle does to the normals of triangles whose vertex normals lie up
// to `spread` degrees apart, searched over shapes of triangles.
struct SeamErrors {
  double moved = 0;  // degrees: from Phong's normal at any point of the triangle
  double edge = 0;   // degrees: between the two triangles of a shared edge, on it
};
SeamErrors SearchSeams(double spread, int trials);

// Largest change of a full-scale highlight, or of the diffuse light for n = 1, when the normal
// turns by so many degrees; codes.
double LightChange(double degrees, int n);

}  // namespace shading::accuracy
