// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/triangle_packet.h"

namespace shading::sim {

// A frame as JSON lines: a header, then one triangle a line. Coordinates, depths and normals are
// the integers that enter the shading unit; vectors and coefficients are the exact real values of
// their fixed-point numbers.
//   {"format":"shadesim-triangles","version":1,"width":640,"height":480,"xy_fraction_bits":8,
//    "z_fraction_bits":24,"normal_fraction_bits":22,"lighting":"blinn","cull":"back",
//    "depth_slope":0,"light":[x,y,z],"half":[x,y,z],"view":[x,y,z],
//    "materials":[{"ambient":[r,g,b],"diffuse":[r,g,b],"specular":[r,g,b],"shininess":n}]}
//   {"x":[i,i,i],"y":[i,i,i],"z":[i,i,i],"n":[[i,i,i],[i,i,i],[i,i,i]],"m":0}
// "lighting" (blinn or phong), "cull" (back or none) and "depth_slope" (S of U0.24: 1 / distance of
// depth z is in proportion to 1 - S z, for footprints) may be absent: blinn, back, 0.

// Strict: every key, type, range and unit length (|n|^2 within 2^-10 of 1) is checked, and keys
// that the format does not know are refused. Real numbers are rounded to the unit's formats. Throws
// std::runtime_error, one line: FILE:LINE: what is wrong; remedy.
TriangleList ReadPackets(const std::string& path);

// Whole or absent, see AtomicFile. Throws std::runtime_error.
void WritePackets(const std::string& path, const TriangleList& list);

}  // namespace shading::sim
