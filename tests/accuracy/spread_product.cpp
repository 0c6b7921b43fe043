// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/spread_product.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/ideal/gouraud.h"
#include "model/ideal/node_surface.h"
#include "model/ideal/phong.h"
#include "model/ideal/quadratic.h"
#include "model/raster/front_end.h"
#include "model/shading_unit.h"

namespace shading::accuracy {
namespace {

constexpr std::array<double, 3> kX = {28, 228, 111}, kY = {41, 60, 225};  // pixels
constexpr int kScreen = 256;
constexpr double kInwards = 0.004;  // of the way to the middle of the triangle

Vector3 Quantised(const ideal::Vector& v) {
  return {NormalComponent::Round(v[0]), NormalComponent::Round(v[1]), NormalComponent::Round(v[2])};
}

// Moves the triangle so that the point of the case is the centre of a pixel.
double Offset(const std::array<double, 3>& corner, const SpreadCase& at) {
  double place = 0;
  for (size_t i = 0; i < 3; ++i) {
    place += ((1 - kInwards) * at.weight[i] + kInwards / 3) * corner[i];
  }
  return std::floor(place) + 0.5 - place;
}

TriangleList ListOf(const SpreadLight& light, const SpreadCase& at) {
  TriangleList list;
  list.frame.width = list.frame.height = kScreen;
  list.frame.cull = Cull::kNone;
  list.frame.light = Quantised(at.light);
  list.frame.half = Quantised(at.half);
  list.frame.view = Quantised({0, 0, 1});
  Material material;
  material.diffuse.fill(Reflectance::Round(light.diffuse));
  material.specular.fill(Reflectance::Round(light.specular));
  material.shininess = Shininess::FromRaw(int64_t{light.shininess} << Shininess::kFraction);
  list.frame.materials.push_back(material);
  TrianglePacket packet;
  for (size_t i = 0; i < 3; ++i) {
    packet.x[i] = ScreenCoord::Round(kX[i] + Offset(kX, at));
    packet.y[i] = ScreenCoord::Round(kY[i] + Offset(kY, at));
    packet.n[i] = Quantised(at.normal[i]);
  }
  list.triangles.push_back(packet);
  return list;
}

void Keep(double error, double* most) { *most = std::max(*most, std::abs(error)); }

template <typename ClosedForm>
ProductErrors Measure(Method method, const TriangleList& list) {
  const ideal::Phong exact(list.frame, list.triangles[0]);
  const ClosedForm closed_form(list.frame, list.triangles[0]);
  const FrameWork work = FrontEnd::Run(list, method);
  ShadingUnit unit(work, 1, FlowPattern::Always(), FlowPattern::Always());
  ProductErrors errors;
  std::vector<Pixel> pixels(kScreen);
  for (const TriangleState& triangle : work.triangles) unit.Triangle(triangle);
  for (const SpanCommand& span : work.spans) {
    unit.Span(span, pixels.data());
    for (int i = 0; i < span.length; ++i) {
      const Pixel& pixel = pixels[static_cast<size_t>(i)];
      const double phong = exact.At(pixel.x + 0.5, pixel.y + 0.5)[0];
      const double form = std::clamp(closed_form.At(pixel.x + 0.5, pixel.y + 0.5)[0], 0.0, 255.0);
      Keep(form - phong, &errors.closed_form);
      Keep(pixel.r - phong, &errors.codes);
      Keep(pixel.r - form, &errors.unit);
    }
  }
  errors.pixels = work.pixels;
  return errors;
}

}  // namespace

ProductErrors ProductErrorsOf(Method method, const SpreadLight& light, const SpreadCase& at) {
  const TriangleList list = ListOf(light, at);
  switch (method) {
    case Method::kGouraud: return Measure<ideal::Gouraud>(method, list);
    case Method::kQuadSplit: return Measure<ideal::QuadSplit>(method, list);
    case Method::kQuadCosine: return Measure<ideal::QuadCosine>(method, list);
    default: return Measure<ideal::Quadratic>(method, list);
  }
}

}  // namespace shading::accuracy
