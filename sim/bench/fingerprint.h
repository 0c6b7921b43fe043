// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/triangle_packet.h"

namespace shading::sim {

// 64 bits, FNV-1a, as hexadecimal digits. Of the triangles and the frame's light, materials, size:
std::string Fingerprint(const TriangleList& list);

// Of the file of the running program; "unknown" where the system does not show it.
std::string ProgramFingerprint();

}  // namespace shading::sim
