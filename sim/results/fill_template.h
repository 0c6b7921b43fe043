// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace shading::sim {

// Markdown by the name that stands for it.
using Sections = std::map<std::string, std::string>;

// The text with every line {{name}} replaced by that section. Throws std::runtime_error, one line,
// for a name that is no section and for a section that the text has no line for.
std::string FillTemplate(const std::string& text, const Sections& sections);

}  // namespace shading::sim
