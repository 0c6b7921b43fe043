// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace shading {

// docs/register_map.md, from the register map.
std::string RegisterMapPage();

}  // namespace shading
