// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace shading::tb {

// Writes FILE.gtkw beside the waveform FILE.fst: the streams of the shading unit and the fields of
// its pixels, ready to look at with `gtkwave FILE.gtkw`. Returns the name of the file.
std::string WriteWaveView(const std::string& waveform, int lanes);

}  // namespace shading::tb
