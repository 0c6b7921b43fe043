// SPDX-License-Identifier: Apache-2.0
#include "model/normal/sphere_arc.h"

#include <algorithm>
#include <cstdlib>

namespace shading {
namespace {

Root LengthOf(const ArcVector& v) { return RootOf(static_cast<Uint128>(WideDot(v, v))); }

// v without its part along the unit vector `axis`.
ArcVector Rejected(const ArcVector& v, const ArcVector& axis) {
  const int64_t along = RoundShift(WideDot(v, axis), kArcFraction);
  ArcVector rest;
  for (size_t c = 0; c < 3; ++c) rest[c] = v[c] - ArcProduct(along, axis[c]);
  return rest;
}

}  // namespace

ArcVector UnitOf(const Vector3& normal) {
  ArcVector v;  // halved: the square of any packet's normal stays below 4
  for (size_t c = 0; c < 3; ++c) {
    v[c] = normal[c].raw() * (int64_t{1} << (kArcFraction - 1 - NormalComponent::kFraction));
  }
  const Root length = LengthOf(v);
  return length.root == 0 ? ArcVector{0, 0, kArcOne} : ScaledBy(v, length);
}

ArcVector Perpendicular(const ArcVector& v) {
  const int64_t least = std::min({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  constexpr int64_t kTie = int64_t{1} << (kArcFraction - 20);
  size_t axis = 0;
  while (std::abs(v[axis]) > least + kTie) ++axis;
  ArcVector unit = {};
  unit[axis] = kArcOne;
  const ArcVector rest = Rejected(unit, ScaledBy(v, LengthOf(v)));
  return ScaledBy(rest, LengthOf(rest));
}

SphereArc::SphereArc(const ArcVector& a, const ArcVector& b) {
  ArcVector sum, difference;
  for (size_t c = 0; c < 3; ++c) {
    sum[c] = a[c] + b[c];
    difference[c] = b[c] - a[c];
  }
  const Root chord = LengthOf(difference);
  across_ = ScaledBy(difference, chord);
  // Ends of unequal length tilt a short sum towards the difference.
  if (chord.root > kArcOne) sum = Rejected(sum, across_);
  const Root length = LengthOf(sum);
  half_angle_ = QuarterTurnsOf(chord.root, length.root);
  middle_ = length.root < kLeastSum ? Perpendicular(difference) : ScaledBy(sum, length);
}

ArcVector SphereArc::At(int64_t w) const {
  const SineCosine turn = SineCosineOf(ArcProduct(2 * w - kArcOne, half_angle_));
  ArcVector normal;
  for (size_t c = 0; c < 3; ++c) {
    normal[c] = RoundShift(
        static_cast<Int128>(middle_[c]) * turn.cosine + static_cast<Int128>(across_[c]) * turn.sine,
        kArcFraction);
  }
  return normal;
}

}  // namespace shading
