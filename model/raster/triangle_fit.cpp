// SPDX-License-Identifier: Apache-2.0
#include "model/raster/triangle_fit.h"

#include <algorithm>
#include <optional>

#include "model/choice/method_choice.h"
#include "model/light/mean_cosines.h"
#include "model/raster/surface_fit.h"

namespace shading {
namespace {

// Halves up; keeps the format.
template <typename Value>
Value Mean(Value a, Value b) {
  return Value::FromRaw((a.raw() + b.raw() + 1) >> 1);
}

// |sum of the normals / 2^halvings|^2, rounded to nearest, saturated below 2.
template <size_t kCount>
LengthSquare SquareOf(const std::array<Vector3, kCount>& normals, int halvings) {
  int64_t square = 0;
  for (size_t c = 0; c < 3; ++c) {
    int64_t sum = 0;
    for (const Vector3& normal : normals) sum += normal[c].raw();
    square += sum * sum;
  }
  const int64_t half = halvings == 0 ? 0 : int64_t{1} << (2 * halvings - 1);
  constexpr int64_t kMost = (int64_t{1} << (LengthSquare::kWidth - 1)) - 1;
  return LengthSquare::FromRaw(std::min((square + half) >> (2 * halvings), kMost));
}

// Of one channel or cosine, from what `value` reads at each corner and each defined middle.
template <typename Value, typename Item, typename Read>
Nodes<Value> NodesOf(const std::array<Item, 3>& corner,
                     const std::array<std::optional<Item>, 3>& middle, const Read& read) {
  Nodes<Value> nodes;
  for (size_t i = 0; i < 3; ++i) nodes.corner[i] = read(corner[i]);
  for (size_t k = 0; k < 3; ++k) {
    nodes.middle[k] =
        middle[k] ? read(*middle[k]) : Mean(nodes.corner[(k + 1) % 3], nodes.corner[(k + 2) % 3]);
  }
  return nodes;
}

// What `shade` makes of the cosines.
template <typename Item, typename Shade>
std::array<std::optional<Item>, 3> ShadeMiddles(
    const std::array<std::optional<LightCosines>, 3>& middle, const Shade& shade) {
  std::array<std::optional<Item>, 3> items;
  for (size_t k = 0; k < 3; ++k) {
    if (middle[k]) items[k] = shade(*middle[k]);
  }
  return items;
}

}  // namespace

struct TriangleFit::Corners {
  std::array<Vector3, 3> normal;
  std::array<LightCosines, 3> cosines;

  // Opposite each corner; nullopt as in MeanCosines.
  std::array<std::optional<LightCosines>, 3> Middles() const {
    std::array<std::optional<LightCosines>, 3> middle;
    for (size_t k = 0; k < 3; ++k) {
      const size_t i = (k + 1) % 3, j = (k + 2) % 3;
      middle[k] = MeanCosines::Of<2>({normal[i], normal[j]}, {cosines[i], cosines[j]});
    }
    return middle;
  }
};

TriangleFit::Corners TriangleFit::CornersOf(const TrianglePacket& packet,
                                            const std::array<int, 3>& corner) const {
  Corners corners;
  for (size_t i = 0; i < 3; ++i) {
    corners.normal[i] = packet.n[static_cast<size_t>(corner[i])];
    corners.cosines[i] = light_.Cosines(corners.normal[i]);
  }
  return corners;
}

LightRange TriangleFit::Range(const TrianglePacket& packet) const {
  const Corners corners = CornersOf(packet, {0, 1, 2});
  return MethodChoice::RangeOf(corners.normal, corners.cosines, light_state_);
}

void TriangleFit::Fit(const TrianglePacket& packet, const TriangleGeometry& geometry,
                      const Choice& choice, int x, int y, TriangleState* triangle) const {
  Material material = frame_.materials[static_cast<size_t>(packet.material)];
  if (choice.ambient) {
    for (size_t ch = 0; ch < kChannels; ++ch) {
      triangle->surface[ch] = SurfaceFit::Constant(VertexLight::Ambient(material, ch));
    }
    return;
  }
  if (choice.dark) material.specular = {};
  const Corners corners = CornersOf(packet, geometry.corner);
  if (choice.method == Method::kFlat) {
    const auto color = light_.Shade(MeanCosines::OfFace(corners.normal, corners.cosines), material);
    for (size_t ch = 0; ch < kChannels; ++ch) {
      triangle->surface[ch] = SurfaceFit::Constant(color[ch]);
    }
    return;
  }
  const auto plane = TriangleSetup::Barycentrics(geometry, x, y);
  if (choice.method == Method::kQuadSplit) return FitTerms(corners, material, plane, triangle);
  if (choice.method == Method::kQuadCosine) return FitCosines(corners, plane, triangle);
  if (choice.method == Method::kPhongSurface) return FitNormal(corners, plane, triangle);
  FitIntensities(choice.method, corners, material, geometry, plane, triangle);
}

void TriangleFit::FitIntensities(Method method, const Corners& corners, const Material& material,
                                 const TriangleGeometry& geometry,
                                 const std::array<Plane, 3>& plane, TriangleState* triangle) const {
  using Color = std::array<Intensity, kChannels>;
  const auto shade = [&](const LightCosines& cosines) { return light_.Shade(cosines, material); };
  std::array<Color, 3> corner;
  for (size_t i = 0; i < 3; ++i) corner[i] = shade(corners.cosines[i]);
  if (method == Method::kGouraud) {
    for (size_t ch = 0; ch < kChannels; ++ch) {
      triangle->surface[ch] =
          SurfaceFit::Linear(plane, {corner[0][ch], corner[1][ch], corner[2][ch]});
    }
    return;
  }
  const auto middle = ShadeMiddles<Color>(corners.Middles(), shade);
  for (size_t ch = 0; ch < kChannels; ++ch) {
    const auto read = [ch](const Color& color) { return color[ch]; };
    const SurfaceNodes nodes = NodesOf<Intensity>(corner, middle, read);
    Surface& surface = triangle->surface[ch];
    surface = SurfaceFit::Quadratic(plane, nodes);
    if (method != Method::kQuadFootprint) continue;
    surface.f =
        IntensityAcc::Wrap(surface.f.raw() + SurfaceFit::FootprintMean(geometry, nodes).raw());
  }
}

void TriangleFit::FitTerms(const Corners& corners, const Material& material,
                           const std::array<Plane, 3>& plane, TriangleState* triangle) const {
  using Terms = VertexLight::Terms;
  const auto shade = [&](const LightCosines& c) { return light_.ShadeTerms(c, material); };
  std::array<Terms, 3> corner;
  for (size_t i = 0; i < 3; ++i) corner[i] = shade(corners.cosines[i]);
  const auto middle = ShadeMiddles<Terms>(corners.Middles(), shade);
  for (size_t ch = 0; ch < kChannels; ++ch) {
    const auto diffuse = [ch](const Terms& terms) { return terms.diffuse[ch]; };
    const auto specular = [ch](const Terms& terms) { return terms.specular[ch]; };
    triangle->surface[ch] =
        SurfaceFit::Term(plane, NodesOf<SignedIntensity>(corner, middle, diffuse));
    triangle->specular[ch] =
        SurfaceFit::Term(plane, NodesOf<SignedIntensity>(corner, middle, specular));
    triangle->ambient[ch] = SurfaceFit::Constant(VertexLight::Ambient(material, ch)).f;
  }
}

void TriangleFit::FitCosines(const Corners& corners, const std::array<Plane, 3>& plane,
                             TriangleState* triangle) const {
  const auto middle = corners.Middles();
  const auto n_dot_l = [](const LightCosines& c) { return c.n_dot_l; };
  const auto n_dot_h_or_v = [](const LightCosines& c) { return c.n_dot_h_or_v; };
  triangle->curve[0] =
      SurfaceFit::OfCosine(plane, NodesOf<Cosine>(corners.cosines, middle, n_dot_l));
  triangle->curve[1] =
      SurfaceFit::OfCosine(plane, NodesOf<Cosine>(corners.cosines, middle, n_dot_h_or_v));
}

// Of the linear normal N: N.L and N.H or N.V, planes, and |N|^2.
void TriangleFit::FitNormal(const Corners& corners, const std::array<Plane, 3>& plane,
                            TriangleState* triangle) {
  std::array<Cosine, 3> n_dot_l, n_dot_h_or_v;
  Nodes<LengthSquare> square;
  for (size_t i = 0; i < 3; ++i) {
    n_dot_l[i] = corners.cosines[i].n_dot_l;
    n_dot_h_or_v[i] = corners.cosines[i].n_dot_h_or_v;
    square.corner[i] = SquareOf<1>({corners.normal[i]}, 0);
    square.middle[i] = SquareOf<2>({corners.normal[(i + 1) % 3], corners.normal[(i + 2) % 3]}, 1);
  }
  triangle->curve[0] = SurfaceFit::PlaneOfCosine(plane, n_dot_l);
  triangle->curve[1] = SurfaceFit::PlaneOfCosine(plane, n_dot_h_or_v);
  triangle->curve[2] = SurfaceFit::OfSquare(plane, square);
}

}  // namespace shading
