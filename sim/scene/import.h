// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sim/scene/scene.h"

namespace shading::sim {

// A mesh file in any format that assimp reads: triangles in world space with a normal per vertex.
// - Polygons are triangulated; points and lines are dropped.
// - Normals: the file's. Where it has none, and for STL, whose normals are those of the facets,
//   smoothed across edges below 60 degrees. A normal of length zero is replaced by the mean of the
//   faces around the vertex.
// - A mirrored node turns its faces round, so that outside stays outside.
// - Materials: see import_material.h. Textures and vertex colours are not used.
// Throws std::runtime_error, one line that names the file and the remedy: no such file, not
// readable, no triangles, positions, normals or colours that are not finite, no usable normal.
Scene ImportMesh(const std::string& path);

}  // namespace shading::sim
