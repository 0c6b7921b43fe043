// SPDX-License-Identifier: Apache-2.0
#include "sim/picture_error.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "model/ideal/flat.h"
#include "model/ideal/footprint.h"
#include "model/ideal/gouraud.h"
#include "model/ideal/node_surface.h"
#include "model/ideal/phong.h"
#include "model/ideal/quadratic.h"
#include "model/ideal/slerp.h"

namespace shading::sim {
namespace {

// Points of a pixel's footprint are kDiscRings^2; Footprint::kRings^2 would take minutes.
constexpr int kDiscRings = 12;

// Up to a factor; nothing without perspective.
ideal::Footprint::Distances DistancesOf(const FrameState& frame, const TrianglePacket& packet) {
  if (frame.depth_slope.raw() == 0) return {};
  const auto distance = [&](size_t i) {
    return 1 / (1 - frame.depth_slope.ToReal() * packet.z[i].ToReal());
  };
  return {{distance(0), distance(1), distance(2)}};
}

struct SeamlessFootprint : ideal::Footprint {
  SeamlessFootprint(const FrameState& frame, const TrianglePacket& packet)
      : Footprint(frame, packet, DistancesOf(frame, packet),
                  ideal::Disc::Within(packet, kDiscRings)) {}
};
struct EnlargedFootprint : ideal::PaperFootprint {
  EnlargedFootprint(const FrameState& frame, const TrianglePacket& packet)
      : PaperFootprint(frame, packet, DistancesOf(frame, packet),
                       {ideal::Disc::kPixel, kDiscRings}) {}
};

// Calls visit(pixel, ideal colour) for every covered pixel. A triangle is prepared once.
template <typename Ideal, typename Visit>
void ForEachPixel(const FrameBuffer& picture, const TriangleList& list, const Visit& visit) {
  std::vector<std::unique_ptr<Ideal>> prepared(list.triangles.size());
  size_t at = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x, ++at) {
      if (picture.triangle(at) == FrameBuffer::kNobody) continue;
      const auto triangle = static_cast<size_t>(picture.triangle(at));
      auto& ideal = prepared[triangle];
      if (!ideal) ideal = std::make_unique<Ideal>(list.frame, list.triangles[triangle]);
      visit(at, ideal::Clamped(ideal->At(x + 0.5, y + 0.5)));
    }
  }
}

template <typename Visit>
void ForEachPixel(const FrameBuffer& picture, const TriangleList& list, Method method,
                  const Visit& visit) {
  switch (ClosedFormOf(method)) {
    case Method::kQuadFootprint:
      return ForEachPixel<ideal::QuadraticFootprint>(picture, list, visit);
    case Method::kQuad: return ForEachPixel<ideal::Quadratic>(picture, list, visit);
    case Method::kSlerp: return ForEachPixel<ideal::Slerp>(picture, list, visit);
    case Method::kFlat: return ForEachPixel<ideal::Flat>(picture, list, visit);
    case Method::kGouraud: return ForEachPixel<ideal::Gouraud>(picture, list, visit);
    case Method::kQuadSplit: return ForEachPixel<ideal::QuadSplit>(picture, list, visit);
    case Method::kQuadCosine: return ForEachPixel<ideal::QuadCosine>(picture, list, visit);
    case Method::kPhongTaylor: return ForEachPixel<ideal::PhongTaylor>(picture, list, visit);
    case Method::kFootprint: return ForEachPixel<SeamlessFootprint>(picture, list, visit);
    case Method::kFootprintPaper: return ForEachPixel<EnlargedFootprint>(picture, list, visit);
    default: return ForEachPixel<ideal::Phong>(picture, list, visit);
  }
}

class ErrorSum {
 public:
  explicit ErrorSum(const FrameBuffer& picture) : picture_(picture) {}

  void operator()(size_t at, const ideal::Rgb& exact) {
    for (size_t ch = 0; ch < exact.size(); ++ch) {
      const double error = std::abs(picture_.code(at)[ch] - exact[ch]);
      max_ = std::max(max_, error);
      squares_ += error * error;
      ++count_;
    }
  }
  PictureError Result() const {
    const double rms = count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0;
    return {max_, rms, 20 * std::log10(255 / rms)};
  }

 private:
  const FrameBuffer& picture_;
  double max_ = 0, squares_ = 0;
  int64_t count_ = 0;
};

}  // namespace

Method ClosedFormOf(Method method) {
  if (method == Method::kQuadFootprint) return method;
  if (IsQuadRow(method)) return Method::kQuad;
  if (IsSpherical(method)) return Method::kSlerp;
  switch (method) {
    case Method::kFlat:
    case Method::kGouraud:
    case Method::kQuadSplit:
    case Method::kQuadCosine:
    case Method::kPhongTaylor:
    case Method::kFootprint:
    case Method::kFootprintPaper: return method;
    default: return Method::kPhong;
  }
}

IdealPicture::IdealPicture(const FrameBuffer& covered, const TriangleList& list, Method method)
    : triangle_(covered.size()) {
  for (size_t at = 0; at < covered.size(); ++at) triangle_[at] = covered.triangle(at);
  ForEachPixel(covered, list, method,
               [this](size_t, const ideal::Rgb& exact) { exact_.push_back(exact); });
}

bool IdealPicture::Fits(const FrameBuffer& picture) const {
  if (picture.size() != triangle_.size()) return false;
  for (size_t at = 0; at < triangle_.size(); ++at) {
    if (picture.triangle(at) != triangle_[at]) return false;
  }
  return true;
}

PictureError IdealPicture::ErrorOf(const FrameBuffer& picture) const {
  ErrorSum sum(picture);
  auto exact = exact_.begin();
  for (size_t at = 0; at < triangle_.size(); ++at) {
    if (triangle_[at] != FrameBuffer::kNobody) sum(at, *exact++);
  }
  return sum.Result();
}

size_t IdealPicture::bytes() const {
  return triangle_.size() * sizeof(triangle_[0]) + exact_.size() * sizeof(ideal::Rgb);
}

PictureError ErrorAgainstPhong(const FrameBuffer& picture, const TriangleList& list) {
  return ErrorAgainstClosedForm(picture, list, Method::kPhong);
}

PictureError ErrorAgainstClosedForm(const FrameBuffer& picture, const TriangleList& list,
                                    Method method) {
  ErrorSum sum(picture);
  ForEachPixel(picture, list, method, [&](size_t at, const ideal::Rgb& exact) { sum(at, exact); });
  return sum.Result();
}

Image ErrorMap(const FrameBuffer& picture, const TriangleList& list) {
  Image map = picture.ToImage();
  ForEachPixel<ideal::Phong>(picture, list, [&](size_t at, const ideal::Rgb& exact) {
    double error = 0;
    for (size_t ch = 0; ch < exact.size(); ++ch) {
      error = std::max(error, std::abs(picture.code(at)[ch] - exact[ch]));
    }
    const auto ramp = [error](double from, double to) {
      return static_cast<uint8_t>(
          std::lround(255 * std::clamp((error - from) / (to - from), 0., 1.)));
    };
    map.code[at] = {ramp(0, 4), ramp(4, 8), ramp(8, 16)};
  });
  return map;
}

void ShadeIdeally(const TriangleList& list, Method method, FrameBuffer* picture) {
  ForEachPixel(*picture, list, method, [&](size_t at, const ideal::Rgb& exact) {
    std::array<uint8_t, 3> code;
    for (size_t ch = 0; ch < code.size(); ++ch) {
      code[ch] = static_cast<uint8_t>(std::lround(exact[ch]));
    }
    picture->SetCode(at, code);
  });
}

}  // namespace shading::sim
