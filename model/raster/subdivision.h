// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/triangle_packet.h"
#include "model/unit_contract.h"

namespace shading {

// Splits a triangle whose vertex normals turn too far for a surface of second order, paper 003:
// every edge whose normals differ by more than a limit is halved, and the triangle cut into two,
// three or four, until no edge is over the limit. Whether an edge is halved depends on its two ends
// alone, so neighbours agree and no seam opens.
//
//   N(1/2) = (Na + Nb) / |Na + Nb|,  paper 002 (1)
//
// Positions and depths of a middle are the mean, halves down to 2^-8 pixels and 2^-24: an outline
// may move by 1/512 pixel. Normals are rounded to nearest S1.22. Edges of opposed normals (|Na +
// Nb| < 2^-5) and of less than two units of 2^-8 pixels stay whole; a triangle is cut at most
// kDeepest times.
class Subdivision {
 public:
  static constexpr UnitContract kContract = {"subdivision",
                                             "raster",
                                             0,
                                             0,
                                             "vertices S13.8, depth U0.24, normals S1.22",
                                             "the same",
                                             0.5,
                                             "in each format's ulp, normals of unit length"};
  static constexpr int kDeepest = 6;

  // Limit on |Na - Nb|^2 in 2^-44: at least 2^44 4 sin^2(s / 2) for an angle s.
  explicit Subdivision(int64_t limit) : limit_(limit) {}

  bool TurnsTooFar(const TrianglePacket& packet) const;

  // Appends the pieces, at least one, in an order that depends on the triangle alone.
  void Split(const TrianglePacket& packet, std::vector<TrianglePacket>* pieces) const {
    Split(packet, 0, pieces);
  }

 private:
  void Split(const TrianglePacket& packet, int depth, std::vector<TrianglePacket>* pieces) const;

  int64_t limit_;
};

}  // namespace shading
