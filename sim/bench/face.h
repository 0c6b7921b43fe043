// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/bench/results.h"

namespace shading::sim {

// A way to look at run time.
struct Face {
  enum class Kind { kCycles, kCyclesTimesArea, kProcessor, kSoftware };
  const char* name;   // a word or two
  const char* label;  // of an axis, with unit
  const char* what;   // a sentence
  Kind kind;
  int lanes;  // whose cells compete; 0: one and four lanes against each other

  // None where it is not known.
  std::optional<double> Cost(const Cell& cell, const Results& results) const;
};

extern const std::vector<Face> kFaces;

// Which error of a picture.
enum class ErrorKind { kRms, kMax };
double ErrorOf(const Cell& cell, ErrorKind kind);

// The cells that compete on a face, and which of them are on the front. Errors that agree when they
// are rounded to 0.01 LSB count as equal, and costs when they are rounded to steps of 1 %.
struct Contest {
  struct Entrant {
    const Cell* cell;
    double cost, error;  // per pixel; LSB against exact Blinn-Phong
    bool front = false;
  };
  std::vector<Entrant> entrants;
};
Contest Compare(const Results& results, const Face& face, const std::string& scene, int shininess,
                ErrorKind kind);

}  // namespace shading::sim
