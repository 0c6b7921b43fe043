// SPDX-License-Identifier: Apache-2.0
#include "model/raster/surface_fit.h"

#include <algorithm>

#include "model/fixed/wide_integer.h"

namespace shading {
namespace {

constexpr int kBarycentric = TriangleSetup::kBarycentricFraction;
constexpr uint64_t kHalfCode = uint64_t{1} << (IntensityAcc::kFraction - 1);

// Sign-extends, so that products are exact modulo 2^128.
Uint128 Wide(uint64_t value) {
  return static_cast<Uint128>(static_cast<Int128>(static_cast<int64_t>(value)));
}
template <typename Value>
Uint128 Raw(Value value) {
  return static_cast<Uint128>(static_cast<Int128>(value.raw()));
}

// A sum of two barycentrics and a node's value each, to a coefficient.
template <typename Coefficient, typename Node>
Coefficient RoundSum(Uint128 sum, uint64_t bias = 0) {
  constexpr int kShift = 2 * kBarycentric + Node::kFraction - Coefficient::kFraction;
  const Uint128 rounded = (sum + (Uint128{1} << (kShift - 1))) >> kShift;
  return Coefficient::Wrap(static_cast<int64_t>(static_cast<uint64_t>(rounded) + bias));
}

template <typename Coefficient, typename Node>
BasicSurface<Coefficient> FitQuadratic(const std::array<Plane, 3>& barycentric,
                                       const Nodes<Node>& nodes, uint64_t bias) {
  Uint128 a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;
  for (size_t k = 0; k < 3; ++k) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Plane& li = barycentric[i];
    const Plane& lj = barycentric[j];
    // 4 e_ij, exact: the middle opposite corner k.
    const Uint128 bend =
        4 * Raw(nodes.middle[k]) - 2 * (Raw(nodes.corner[i]) + Raw(nodes.corner[j]));
    a += bend * Wide(li.dx) * Wide(lj.dx);
    b += bend * Wide(li.dy) * Wide(lj.dy);
    c += bend * (Wide(li.dx) * Wide(lj.dy) + Wide(lj.dx) * Wide(li.dy));
    d += bend * (Wide(li.dx) * Wide(lj.at_origin) + Wide(lj.dx) * Wide(li.at_origin));
    e += bend * (Wide(li.dy) * Wide(lj.at_origin) + Wide(lj.dy) * Wide(li.at_origin));
    f += bend * Wide(li.at_origin) * Wide(lj.at_origin);

    const Uint128 value = Raw(nodes.corner[k]) << kBarycentric;
    d += value * Wide(barycentric[k].dx);
    e += value * Wide(barycentric[k].dy);
    f += value * Wide(barycentric[k].at_origin);
  }
  return {RoundSum<Coefficient, Node>(a), RoundSum<Coefficient, Node>(b),
          RoundSum<Coefficient, Node>(c), RoundSum<Coefficient, Node>(d),
          RoundSum<Coefficient, Node>(e), RoundSum<Coefficient, Node>(f, bias)};
}

template <typename Coefficient, typename Node>
BasicSurface<Coefficient> FitPlane(const std::array<Plane, 3>& barycentric,
                                   const std::array<Node, 3>& corner, uint64_t bias) {
  Uint128 d = 0, e = 0, f = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Uint128 value = Raw(corner[i]) << kBarycentric;
    d += Wide(barycentric[i].dx) * value;
    e += Wide(barycentric[i].dy) * value;
    f += Wide(barycentric[i].at_origin) * value;
  }
  const auto round = RoundSum<Coefficient, Node>;
  return {{}, {}, {}, round(d, 0), round(e, 0), round(f, bias)};
}

}  // namespace

Surface SurfaceFit::Constant(Intensity value) {
  constexpr int kAlign = IntensityAcc::kFraction - Intensity::kFraction;
  Surface surface;
  surface.f = IntensityAcc::Wrap(value.raw() * (1 << kAlign) + static_cast<int64_t>(kHalfCode));
  return surface;
}

Surface SurfaceFit::Linear(const std::array<Plane, 3>& barycentric,
                           const std::array<Intensity, 3>& corner) {
  return FitPlane<IntensityAcc>(barycentric, corner, kHalfCode);
}

Surface SurfaceFit::Quadratic(const std::array<Plane, 3>& barycentric, const SurfaceNodes& nodes) {
  return FitQuadratic<IntensityAcc>(barycentric, nodes, kHalfCode);
}

Surface SurfaceFit::Term(const std::array<Plane, 3>& barycentric,
                         const Nodes<SignedIntensity>& nodes) {
  return FitQuadratic<IntensityAcc>(barycentric, nodes, 0);
}

// With edge functions w_i, lambda_i = w_i / area: A + B = sum 4 e_ij (dw_i . dw_j) / area^2.
IntensityAcc SurfaceFit::FootprintMean(const TriangleGeometry& geometry,
                                       const SurfaceNodes& nodes) {
  Int128 sum = 0, longest = 0;
  for (size_t k = 0; k < 3; ++k) {
    const Edge& i = geometry.edge[(k + 1) % 3];
    const Edge& j = geometry.edge[(k + 2) % 3];
    const int64_t bend = 4 * nodes.middle[k].raw() -
                         2 * (nodes.corner[(k + 1) % 3].raw() + nodes.corner[(k + 2) % 3].raw());
    sum += bend * (static_cast<Int128>(i.dx) * j.dx + static_cast<Int128>(i.dy) * j.dy);
    longest =
        std::max(longest, static_cast<Int128>(i.dx) * i.dx + static_cast<Int128>(i.dy) * i.dy);
  }
  // 1/12 of it; with r |dw| / area limited to 1/2, 1/16 of the one for r = area / |dw|.
  const Int128 whole = 12 * static_cast<Int128>(geometry.area) * geometry.area;
  const Int128 divisor = std::max(whole, 16 * longest);
  constexpr int kAlign = IntensityAcc::kFraction - Intensity::kFraction;
  return IntensityAcc::FromRaw(
      static_cast<int64_t>(FloorDivide<Int128>(2 * sum * (1 << kAlign) + divisor, 2 * divisor)));
}

CosineSurface SurfaceFit::OfCosine(const std::array<Plane, 3>& barycentric,
                                   const Nodes<Cosine>& nodes) {
  return FitQuadratic<CosineAcc>(barycentric, nodes, 0);
}

CosineSurface SurfaceFit::PlaneOfCosine(const std::array<Plane, 3>& barycentric,
                                        const std::array<Cosine, 3>& corner) {
  return FitPlane<CosineAcc>(barycentric, corner, 0);
}

CosineSurface SurfaceFit::OfSquare(const std::array<Plane, 3>& barycentric,
                                   const Nodes<LengthSquare>& nodes) {
  return FitQuadratic<CosineAcc>(barycentric, nodes, 0);
}

}  // namespace shading
