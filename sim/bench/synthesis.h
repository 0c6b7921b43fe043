// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/shading_types.h"

namespace shading::sim {

// What a module costs on an ECP5.
struct CellCount {
  int64_t lut4 = 0, flip_flops = 0, carry = 0, multipliers = 0;
  int64_t path = 0;  // longest, register to register, in levels of LUT4; 0: not measured
};

// The JSON that scripts/synth.sh --json writes.
struct Synthesis {
  std::string tool, target;
  int64_t multiplier_lut4 = 0;  // an 18 x 18 multiplier built of LUT4 and carry cells
  struct Unit {
    std::string name;
    CellCount cells;
  };
  struct Build {
    Method method = Method::kFlat;
    int lanes = 1;
    CellCount cells;
  };
  std::vector<Unit> units;
  std::vector<Build> builds;  // whole shading units with one method

  const Unit* FindUnit(const std::string& name) const;
  // One number: LUT4 + flip-flops + 2 a carry cell + multiplier_lut4 a multiplier.
  double Area(const CellCount& cells) const;
  std::optional<double> Area(Method method, int lanes) const;
};

// Throws std::runtime_error, one line, for a file that is there and no such JSON; builds of methods
// that this program does not have are left out. nullopt where there is no file.
std::optional<Synthesis> ReadSynthesis(const std::string& path);

}  // namespace shading::sim
