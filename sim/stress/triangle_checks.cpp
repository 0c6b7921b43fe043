// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "model/ideal/lighting.h"
#include "model/raster/front_end.h"
#include "sim/stress/triangle_genes.h"

namespace shading::stress {
namespace {

constexpr int kSize = kMaxScreen;

std::vector<std::string> With(std::vector<std::string> genes,
                              const std::vector<std::string>& more) {
  genes.insert(genes.end(), more.begin(), more.end());
  return genes;
}

TrianglePacket DeepOf(const Genes& g) {
  TrianglePacket packet = CornersOf(g, kSize, kSize);
  for (size_t i = 0; i < 3; ++i)
    packet.z[i] = VertexDepth::FromRaw(std::llround(g[7 + i] * VertexDepth::kMaxRaw));
  return packet;
}

uint64_t Less(uint64_t raw, int narrow) {
  return static_cast<uint64_t>(Narrowed(static_cast<int64_t>(raw), narrow));
}

// The depth plane at covered pixels, half an ulp off, against sum w_i z_i / area.
double DepthError(const Genes& g, int narrow) {
  const TrianglePacket packet = DeepOf(g);
  TriangleGeometry geometry;
  if (TriangleSetup::Setup(packet, FrameOf(kSize, kSize), &geometry) != Verdict::kDraw) return 0;
  Plane plane = TriangleSetup::DepthPlane(geometry, packet);
  plane = {Less(plane.at_origin, narrow), Less(plane.dx, narrow), Less(plane.dy, narrow)};
  const ExactWeights exact(packet);
  Real worst = 0;
  for (const auto& [x, y] : FarPixels(exact, geometry)) {
    Int128 z = 0;
    for (size_t i = 0; i < 3; ++i) z += exact.At(i, x, y) * packet.z[i].raw();
    const uint64_t at = plane.At(x - geometry.box_x, y - geometry.box_y) - (uint64_t{1} << 13);
    const Int128 off = Int128{static_cast<int64_t>(at)} * exact.area() - (z << 14);
    Raise(&worst, std::abs(static_cast<Real>(off) / static_cast<Real>(exact.area())));
  }
  return static_cast<double>(std::ldexp(worst, -14));
}

Check Depths() {
  Check check = CheckOf(TriangleSetup::kContract, "2^-24", "depth plane S1.37");
  check.genes = With(kCorners, {"z0", "z1", "z2"});
  check.error = DepthError;
  check.triangle = [](const Genes& g) { return TriangleList{FrameOf(kSize, kSize), {DeepOf(g)}}; };
  check.starts = {{0.3, 0.4, 0.4, 0.4, 0.4, 0.9, 0.2, 0, 1, 0.5}};
  check.cost = 60;
  return check;
}

// Node values: below 1/4 and above 3/4 the ends of their range.
int64_t NodeOf(double gene) {
  return std::llround(std::clamp(2 * gene - 0.5, 0.0, 1.0) * (int64_t{255} << 16));
}

// A x^2 + B y^2 + C xy + D x + E y + F modulo 2^36, the half code taken off; 2^-26 codes.
int64_t At(const Surface& s, int x, int y, int narrow) {
  const auto term = [&](IntensityAcc c, int64_t by) { return Less(c.raw(), narrow) * by; };
  const int64_t u = x, v = y;
  const uint64_t sum = term(s.a, u * u) + term(s.b, v * v) + term(s.c, u * v) + term(s.d, u) +
                       term(s.e, v) + term(s.f, 1) - (uint64_t{1} << 25);
  return IntensityAcc::Wrap(static_cast<int64_t>(sum)).raw();
}

// The six basis functions of the nodes, weights over the area: codes in 2^-26.
template <typename Node>
Real Exact(const ExactWeights& exact, const std::array<Node, 6>& node, int x, int y) {
  const auto area = static_cast<Real>(exact.area());
  std::array<Real, 3> l;
  for (size_t i = 0; i < 3; ++i) l[i] = static_cast<Real>(exact.At(i, x, y)) / area;
  Real sum = 0;
  for (size_t k = 0; k < 3; ++k) {
    sum += l[k] * (2 * l[k] - 1) * static_cast<Real>(node[k]) +
           4 * l[(k + 1) % 3] * l[(k + 2) % 3] * static_cast<Real>(node[3 + k]);
  }
  return 1024 * sum;
}

double FitError(const Genes& g, int narrow) {
  const TrianglePacket packet = CornersOf(g, kSize, kSize);
  TriangleGeometry geometry;
  if (TriangleSetup::Setup(packet, FrameOf(kSize, kSize), &geometry) != Verdict::kDraw) return 0;
  const ExactWeights exact(packet);
  const auto far = FarPixels(exact, geometry);
  if (far.empty()) return 0;
  std::array<int64_t, 6> node;
  for (size_t i = 0; i < 6; ++i) node[i] = NodeOf(g[7 + i]);
  SurfaceNodes turned;
  for (size_t i = 0; i < 3; ++i) {
    const auto v = static_cast<size_t>(geometry.corner[i]);
    turned.corner[i] = Intensity::FromRaw(node[v]);
    turned.middle[i] = Intensity::FromRaw(node[3 + v]);
  }
  const auto [left, top] = far[0];
  const Surface surface =
      SurfaceFit::Quadratic(TriangleSetup::Barycentrics(geometry, left, top), turned);
  Real worst = 0;
  for (const auto& [x, y] : far) {
    const auto at = static_cast<Real>(At(surface, x - left, y - top, narrow));
    Raise(&worst, std::abs(at - Exact(exact, node, x, y)));
  }
  return static_cast<double>(std::ldexp(worst, -26));
}

Check Fit() {
  Check check = CheckOf(SurfaceFit::kContract, "codes", "coefficients S9.25");
  check.genes = With(kCorners, {"I0", "I1", "I2", "I12", "I20", "I01"});
  check.error = FitError;
  check.triangle = [](const Genes& g) {
    return TriangleList{FrameOf(kSize, kSize), {CornersOf(g, kSize, kSize)}};
  };
  check.starts = {{0.3, 0.4, 0.4, 0.4, 0.4, 0.9, 0.2, 0, 1, 0, 1, 0, 1}};
  check.cost = 60;
  return check;
}

// A shiny triangle whose vertices may be dark and the middles of its edges bright.
TriangleList ShinyOf(const Genes& g) {
  TriangleList list{FrameOf(kSize, kSize), {CornersOf(g, kSize, kSize)}};
  const Reflectance one = Reflectance::Round(1), none;
  Material& material = list.frame.materials[0];
  material.diffuse = {none, none, none};
  material.specular = {one, one, one};
  material.shininess = Shininess::Round(Geometric(1, 256, g[13]));
  list.triangles[0].n = NormalsOf(g, 7);
  return list;
}

// From packet to the sum that is truncated to a code: vertex light, fit, rows, columns; against the
// quadratic through the closed form of the light at the six nodes.
double WholeError(const Genes& g, int narrow) {
  const TriangleList list = ShinyOf(g);
  const TrianglePacket& packet = list.triangles[0];
  const FrameWork work = FrontEnd::Run(list, Method::kQuad);
  if (work.triangles.empty()) return 0;
  const ExactWeights exact(packet);
  const ideal::Light light(list.frame);
  std::array<Real, 6> node;
  for (size_t i = 0; i < 3; ++i) {
    const auto shade = [&](const ideal::Vector& n) {
      return static_cast<Real>(light.Shade(n, list.frame.materials[0])[0]) * 65536;
    };
    const ideal::Vector a = ideal::ToReal(packet.n[(i + 1) % 3]);
    const ideal::Vector b = ideal::ToReal(packet.n[(i + 2) % 3]);
    const auto mean = ideal::MeanNormal(ideal::Sum(a, b));
    node[i] = shade(ideal::ToReal(packet.n[i]));
    node[3 + i] = mean ? shade(*mean) : (shade(a) + shade(b)) / 2;
  }
  const TriangleState& state = work.triangles[0];
  TriangleGeometry geometry;
  TriangleSetup::Setup(packet, list.frame, &geometry);
  Real worst = 0;
  for (const auto& [x, y] : FarPixels(exact, geometry)) {
    const auto at =
        static_cast<Real>(At(state.surface[0], x - state.origin_x, y - state.origin_y, narrow));
    Raise(&worst, std::abs(at - Exact(exact, node, x, y)));
  }
  return static_cast<double>(std::ldexp(worst, -26));
}

Check Whole() {
  Check check = CheckOf(ShadingUnit::kContract, "codes", "coefficients S9.25");
  check.genes = With(With(kCorners, kNormals), {"shininess, logarithm of 1..256"});
  check.error = WholeError;
  check.triangle = ShinyOf;
  check.starts = {{0.3, 0.4, 0.4, 0.4, 0.4, 0.9, 0.2, 0, 0.8, 0.33, 0.8, 0.66, 0.8, 0.6}};
  check.cost = 250;
  return check;
}

}  // namespace

std::vector<Check> TriangleChecks() {
  std::vector<Check> checks = {Depths(), Fit(), Whole()};
  for (const auto family : {TriangleNormalChecks, PieceChecks}) {
    for (Check& check : family()) checks.push_back(std::move(check));
  }
  return checks;
}

}  // namespace shading::stress
