// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/builtin.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <string_view>

#include "sim/scene/shapes.h"

namespace shading::sim {
namespace {

constexpr std::string_view kPrefix = "builtin:";

// A body colour under a white highlight; ambient light is a tenth of the directional light.
SceneMaterial Plastic(Color body, double specular, double shininess) {
  SceneMaterial m;
  m.diffuse = body;
  for (size_t c = 0; c < 3; ++c) m.ambient[c] = 0.1 * body[c];
  m.specular = {specular, specular, specular};
  m.shininess = shininess;
  return m;
}

// A metal's highlight has the colour of the metal.
SceneMaterial Brass() {
  SceneMaterial m;
  m.ambient = {0.05, 0.035, 0.01};
  m.diffuse = {0.40, 0.28, 0.08};
  m.specular = {0.55, 0.42, 0.18};
  m.shininess = 24;
  return m;
}

Scene Mixed(int n) {
  Scene scene;
  Append(Saddle(n), {0.95, 20, -25, {0.10, 0.12, -0.62}}, Brass(), &scene);
  Append(Torus(2 * n), {0.72, 35, -55, {0.50, -0.32, 0.20}}, Plastic({0.10, 0.45, 0.40}, 0.05, 4),
         &scene);
  Append(Sphere(n), {0.66, 0, 0, {-0.58, 0.26, 0.20}}, Plastic({0.65, 0.08, 0.06}, 0.70, 120),
         &scene);
  Append(Sphere(n), {0.33, 0, 0, {0.50, -0.20, 0.38}}, Plastic({0.12, 0.20, 0.60}, 0.45, 20),
         &scene);
  return scene;
}

Scene Single(const Scene& shape, const Placement& placement, const SceneMaterial& material) {
  Scene scene;
  Append(shape, placement, material, &scene);
  return scene;
}

Scene Build(std::string_view name, int n) {
  if (name == "triangle") return Single(Triangle(n), {}, Plastic({0.10, 0.35, 0.60}, 0.45, 40));
  if (name == "sphere") return Single(Sphere(n), {}, Plastic({0.65, 0.10, 0.06}, 0.45, 50));
  if (name == "torus") {
    return Single(Torus(n), {1, 20, -50, {}}, Plastic({0.08, 0.45, 0.30}, 0.45, 30));
  }
  if (name == "saddle") return Single(Saddle(n), {1, 25, -35, {}}, Brass());
  if (name == "panel") return Single(Panel(n), {}, Plastic({0.12, 0.25, 0.45}, 0.70, 128));
  if (name == "cylinder") return Single(Cylinder(n), {}, Plastic({0.50, 0.20, 0.10}, 0.70, 128));
  return Mixed(n);
}

const BuiltinScene& Find(std::string_view name) {
  std::string known;
  for (const BuiltinScene& entry : kBuiltinScenes) {
    if (entry.name == name) return entry;
    known += fmt::format(" {}", entry.name);
  }
  throw std::runtime_error(fmt::format("builtin:{}: no such scene; use one of:{}", name, known));
}

int ParseSubdivision(std::string_view text, const BuiltinScene& entry) {
  int n = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, n);
  if (result.ec != std::errc() || result.ptr != end || n < entry.min_n || n > kMaxSubdivision) {
    throw std::runtime_error(
        fmt::format("builtin:{}:{}: the subdivision must be a whole number from {} to {}",
                    entry.name, text, entry.min_n, kMaxSubdivision));
  }
  return n;
}

}  // namespace

Scene MakeBuiltin(const std::string& spec) {
  std::string_view text = spec;
  if (text.substr(0, kPrefix.size()) == kPrefix) text.remove_prefix(kPrefix.size());
  const size_t colon = text.find(':');
  const BuiltinScene& entry = Find(text.substr(0, colon));
  const int n = colon == std::string_view::npos ? entry.default_n
                                                : ParseSubdivision(text.substr(colon + 1), entry);
  Scene scene = Build(entry.name, n);
  scene.name = fmt::format("builtin:{}:{}", entry.name, n);
  return scene;
}

}  // namespace shading::sim
