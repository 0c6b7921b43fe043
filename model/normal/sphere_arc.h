// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/normal/arc_math.h"
#include "model/triangle_packet.h"

namespace shading {

// The shorter great arc between two unit vectors, at uniform speed: paper 000 (2), in the form that
// is well conditioned at 0 and at 180 degrees,
//
//   N(w) = (Na + Nb)/|Na + Nb| cos((w - 1/2) psi) + (Nb - Na)/|Nb - Na| sin((w - 1/2) psi)
//   psi  = 2 atan2(|Nb - Na|, |Na + Nb|)
//
// All in S3.60. N is unit within 2^-33, and within 2^-57 / |Na + Nb| of the arc.
//
// Opposed vectors, |Na + Nb| < 2^-24, leave the plane of the arc open: it turns through
// Perpendicular(Nb - Na), and its ends are Na and Nb within 2^-25.
class SphereArc {
 public:
  static constexpr int64_t kLeastSum = int64_t{1} << (kArcFraction - 24);

  SphereArc() = default;
  SphereArc(const ArcVector& a, const ArcVector& b);

  ArcVector At(int64_t w) const;                      // U0.60, 0..1
  int64_t half_angle() const { return half_angle_; }  // psi / 2 in quarter turns, 0..1

 private:
  ArcVector middle_ = {}, across_ = {};  // unit and perpendicular; across_ is 0 for a point
  int64_t half_angle_ = 0;
};

// The unit vector along a packet's normal; {0, 0, 1} for zero.
ArcVector UnitOf(const Vector3& normal);

// Unit vector at right angles to v, the same for -v: the part that v leaves of the axis of its
// smallest component. Components within 2^-20 of the smallest count as equal, the first one wins.
ArcVector Perpendicular(const ArcVector& v);

}  // namespace shading
