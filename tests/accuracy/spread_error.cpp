// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/spread_error.h"

#include <algorithm>
#include <cmath>

namespace shading::accuracy {
namespace {

using ideal::Dot;
using ideal::Vector;

double Power(double base, int exponent) {
  double power = 1;
  for (; exponent > 0; exponent >>= 1, base *= base) {
    if (exponent & 1) power *= base;
  }
  return power;
}

struct Cosines {
  double n_dot_l, n_dot_h;
};

Cosines CosinesOf(const Vector& normal, const SpreadCase& at) {
  return {Dot(normal, at.light), Dot(normal, at.half)};
}

double Diffuse(const SpreadLight& light, double n_dot_l) { return 255 * light.diffuse * n_dot_l; }
double Specular(const SpreadLight& light, double n_dot_h) {
  return 255 * light.specular * Power(std::clamp(n_dot_h, 0.0, 1.0), light.shininess);
}
double Lit(const SpreadLight& light, const Cosines& cosines) {
  return Diffuse(light, std::clamp(cosines.n_dot_l, 0.0, 1.0)) + Specular(light, cosines.n_dot_h);
}

Vector Weighted(const SpreadCase& at) {
  Vector sum = {};
  for (size_t i = 0; i < 3; ++i) sum = ideal::Sum(sum, ideal::Scaled(at.weight[i], at.normal[i]));
  return sum;
}

// Cosines of corners and of middles, each opposite its corner.
struct Nodes {
  std::array<Cosines, 3> corner, middle;
};

Nodes NodesOf(const SpreadCase& at) {
  Nodes nodes;
  for (size_t i = 0; i < 3; ++i) nodes.corner[i] = CosinesOf(at.normal[i], at);
  for (size_t k = 0; k < 3; ++k) {
    const Vector sum = ideal::Sum(at.normal[(k + 1) % 3], at.normal[(k + 2) % 3]);
    const Cosines& a = nodes.corner[(k + 1) % 3];
    const Cosines& b = nodes.corner[(k + 2) % 3];
    const double length = std::sqrt(Dot(sum, sum));
    nodes.middle[k] = {(a.n_dot_l + b.n_dot_l) / length, (a.n_dot_h + b.n_dot_h) / length};
  }
  return nodes;
}

template <typename ValueOf>
double Linear(const Nodes& nodes, const SpreadCase& at, const ValueOf& value) {
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += at.weight[i] * value(nodes.corner[i]);
  return sum;
}

// By the shape functions w (2w - 1) of a corner and 4 w w' of a middle.
template <typename ValueOf>
double Quadratic(const Nodes& nodes, const SpreadCase& at, const ValueOf& value) {
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const double w = at.weight[i];
    sum += w * (2 * w - 1) * value(nodes.corner[i]);
    sum += 4 * at.weight[(i + 1) % 3] * at.weight[(i + 2) % 3] * value(nodes.middle[i]);
  }
  return sum;
}

double Shown(Method method, const SpreadLight& light, const SpreadCase& at) {
  const Nodes nodes = NodesOf(at);
  const auto lit = [&](const Cosines& c) { return Lit(light, c); };
  const auto n_dot_l = [](const Cosines& c) { return c.n_dot_l; };
  const auto n_dot_h = [](const Cosines& c) { return c.n_dot_h; };
  const auto specular = [&](const Cosines& c) { return Specular(light, c.n_dot_h); };
  switch (method) {
    case Method::kGouraud: return Linear(nodes, at, lit);
    case Method::kQuadSplit:
      return std::max(0.0, Diffuse(light, Quadratic(nodes, at, n_dot_l))) +
             std::max(0.0, Quadratic(nodes, at, specular));
    case Method::kQuadCosine:
      return Lit(light, {Quadratic(nodes, at, n_dot_l), Quadratic(nodes, at, n_dot_h)});
    default: return Quadratic(nodes, at, lit);
  }
}

}  // namespace

SpreadCodes CodesOf(Method method, const SpreadLight& light, const SpreadCase& at) {
  const double full = 255 * std::max(1.0, light.diffuse + light.specular);
  return {Lit(light, CosinesOf(ideal::Normalised(Weighted(at)), at)),
          std::clamp(Shown(method, light, at), 0.0, full)};
}

double SpreadError(Method method, const SpreadLight& light, const SpreadCase& at) {
  if (light.lit) {
    for (const Vector& normal : at.normal) {
      if (Dot(normal, at.light) < 0 || Dot(normal, at.half) < 0) return -1;
    }
  }
  const SpreadCodes codes = CodesOf(method, light, at);
  return std::abs(codes.shown - codes.exact);
}

}  // namespace shading::accuracy
