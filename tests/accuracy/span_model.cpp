// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/span_model.h"

#include <cassert>
#include <cmath>

#include "model/normal/normal_setup.h"
#include "model/normal/normal_shader.h"
#include "model/normal/sphere_arc.h"
#include "tests/accuracy/ideal_span.h"

namespace shading::accuracy {
namespace {

template <int kLanes, typename Shader>
void Run(Shader shader, const LightState& light, int length, LightCosines* cosines) {
  for (int t = 0; t < length; t += kLanes, shader.Step()) {
    for (int lane = 0; lane < kLanes && t + lane < length; ++lane) {
      cosines[t + lane] = shader.At(static_cast<size_t>(lane), light);
    }
  }
}

std::vector<AdaptiveSegment> Segments(const Configuration& configuration, const SpanCommand& span) {
  AdaptiveNormalizer normalizer(AdaptiveKindOf(configuration.method), span.normal, span.length,
                                configuration.limit);
  std::vector<AdaptiveSegment> segments;
  AdaptiveSegment segment;
  while (normalizer.Next(&segment)) segments.push_back(segment);
  return segments;
}

template <int kLanes>
void RunMethod(const Configuration& configuration, const LightState& light, const SpanCommand& span,
               LightCosines* cosines) {
  if (IsAdaptive(configuration.method)) {
    const auto segments = Segments(configuration, span);
    const AdaptiveSegment* begin = segments.data();
    AdaptiveShader<kLanes> shader(begin, begin + segments.size());
    return Run<kLanes>(shader, light, span.length, cosines);
  }
  NormalSeed seed;
  NormalSetup::Seed(SetupKindOf(configuration.method), light, span, kLanes, &seed);
  const auto run = [&](auto shader) { Run<kLanes>(shader, light, span.length, cosines); };
  switch (configuration.method) {
    case Method::kPhong: return run(LinearShader<PhongDirect, kLanes>(seed));
    case Method::kPhongTaylor: return run(LinearShader<TaylorNormalizer, kLanes>(seed));
    case Method::kPhongDuff: return run(DuffShader<kLanes>(seed));
    case Method::kSlerp: return run(SlerpShader<kLanes>(seed));
    case Method::kSlerpPaper:
      return run(SlerpPaperShader<kLanes>(seed, configuration.fraction_bits));
    case Method::kSlerpDirect: return run(SlerpDirectShader<kLanes>(seed));
    case Method::kSlerpIntensity: return run(SlerpIntensityShader<kLanes>(seed));
    default: assert(false && "a method that interpolates normals");
  }
}

void RunPart(const Configuration& configuration, const LightState& light, const SpanCommand& part,
             LightCosines* cosines) {
  if (configuration.lanes == 1) {
    RunMethod<1>(configuration, light, part, cosines);
  } else {
    RunMethod<kMaxLanes>(configuration, light, part, cosines);
  }
}

bool BeyondRightAngle(const std::array<SpanNormal, 2>& ends) {
  int64_t sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += ends[0][c].raw() * ends[1][c].raw();
  return sum < 0;
}

// The vector of the front end's arc that an end was rounded from.
ArcVector ArcEnd(const SpanNormal& normal) {
  const Direction unit = Unit(ToReal(normal));
  ArcVector end;
  for (size_t c = 0; c < 3; ++c) end[c] = std::llround(std::ldexp(unit[c], kArcFraction));
  return end;
}

SpanNormal RoundedAt(const SphereArc& arc, int pixel, int last) {
  const ArcVector v = arc.At(ArcRatio(static_cast<Uint128>(pixel), static_cast<Uint128>(last)));
  SpanNormal normal;
  for (size_t c = 0; c < 3; ++c) {
    normal[c] = SpanNormalComponent::FromRaw(
        RoundShift(v[c], kArcFraction - SpanNormalComponent::kFraction));
  }
  return normal;
}

}  // namespace

std::string NameOf(const Configuration& configuration) {
  std::string name(Name(configuration.method));
  if (configuration.method == Method::kSlerpPaper) {
    name += " " + std::to_string(configuration.fraction_bits) + " bits";
  }
  return name + (configuration.lanes == 1 ? ", 1 lane" : ", 4 lanes");
}

void ModelCosines(const Configuration& configuration, const SpanCase& span,
                  std::vector<LightCosines>* cosines) {
  cosines->resize(static_cast<size_t>(span.length));
  LightState light;
  light.light = light.half_or_view = span.direction;
  SpanCommand whole;
  whole.length = span.length;
  whole.normal = span.normal;
  if (!IsSpherical(configuration.method) || !BeyondRightAngle(span.normal)) {
    return RunPart(configuration, light, whole, cosines->data());
  }
  const SphereArc arc(ArcEnd(span.normal[0]), ArcEnd(span.normal[1]));
  const int k = span.length / 2, last = span.length - 1;
  SpanCommand first = whole, second = whole;
  first.length = k;
  first.normal[1] = RoundedAt(arc, k - 1, last);
  second.length = span.length - k;
  second.normal[0] = RoundedAt(arc, k, last);
  RunPart(configuration, light, first, cosines->data());
  RunPart(configuration, light, second, cosines->data() + k);
}

}  // namespace shading::accuracy
