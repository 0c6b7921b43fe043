// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/footprint_flicker.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "model/raster/front_end.h"
#include "model/shading_unit.h"
#include "sim/frame_buffer.h"
#include "sim/picture_error.h"

namespace shading::accuracy {
namespace {

constexpr int kFine = 16;  // samples a side of a pixel

sim::FrameBuffer Shade(const TriangleList& list, Method method,
                       const FrontEndOptions& options = {}) {
  const FrameWork work = FrontEnd::Run(list, method, options);
  ShadingUnit unit(work, 1, FlowPattern::Always(), FlowPattern::Always());
  sim::FrameBuffer picture(list.frame.width, list.frame.height);
  std::vector<Pixel> pixels(kMaxScreen);
  size_t triangle = 0;
  const auto start = [&](size_t t) {
    triangle = t;
    unit.Triangle(work.triangles[t]);
  };
  ForEachSpan(work, start, [&](const SpanCommand& span) {
    unit.Span(span, pixels.data());
    for (int i = 0; i < span.length; ++i) {
      picture.Put(pixels[static_cast<size_t>(i)], static_cast<int32_t>(work.packet[triangle]));
    }
    return true;
  });
  return picture;
}

// Means of kFine x kFine pixels; covered where all of them are.
sim::Image Reduce(const sim::Image& fine) {
  constexpr int kCount = kFine * kFine;
  sim::Image image{fine.width / kFine, fine.height / kFine, {}, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::array<int, 3> sum = {};
      int covered = 0;
      for (int k = 0; k < kCount; ++k) {
        const auto at =
            static_cast<size_t>((y * kFine + k / kFine) * fine.width + x * kFine + k % kFine);
        covered += fine.covered[at] != 0;
        for (size_t c = 0; c < 3; ++c) sum[c] += fine.code[at][c];
      }
      std::array<uint8_t, 3> mean;
      for (size_t c = 0; c < 3; ++c) mean[c] = static_cast<uint8_t>((sum[c] + kCount / 2) / kCount);
      image.code.push_back(mean);
      image.covered.push_back(covered == kCount);
    }
  }
  return image;
}

void AddChanges(const Drawn& last, const Drawn& next, size_t at, FlickerTable* sum) {
  for (size_t c = 0; c < 3; ++c) {
    const auto change = [&](size_t d) { return next[d].code[at][c] - last[d].code[at][c]; };
    for (size_t d = 0; d < kDrawings; ++d) {
      (*sum)[d].change += std::abs(change(d));
      (*sum)[d].beyond_ellipse += std::abs(change(d) - change(kEllipseMean));
      (*sum)[d].beyond_sampled += std::abs(change(d) - change(kSupersampled));
    }
  }
}

}  // namespace

const std::array<const char*, kDrawings> kDrawingName = {
    "centre only", "footprint", "footprint, tolerance 0", "mean of the ellipse", "16 x 16 samples"};

Drawn DrawFrame(const Turning& turning, int frame) {
  sim::ViewOptions view = turning.view;
  view.yaw += frame * turning.yaw_step;
  const TriangleList list = sim::Project(turning.scene, view);
  Drawn drawn;
  drawn[kCentreOnly] = Shade(list, Method::kPhong).ToImage();
  FrontEndOptions finest;
  finest.tolerance = Tolerance();
  drawn[kFootprintFinest] = Shade(list, Method::kFootprint, finest).ToImage();
  sim::FrameBuffer footprint = Shade(list, Method::kFootprint);
  drawn[kFootprint] = footprint.ToImage();
  sim::ShadeIdeally(list, Method::kFootprint, &footprint);
  drawn[kEllipseMean] = footprint.ToImage();
  view.width *= kFine;
  view.height *= kFine;
  drawn[kSupersampled] = Reduce(Shade(sim::Project(turning.scene, view), Method::kPhong).ToImage());
  return drawn;
}

FlickerTable MeasureFlicker(const Turning& turning, int steps) {
  FlickerTable table = {};
  int64_t pixels = 0;
  Drawn last = DrawFrame(turning, 0);
  for (int frame = 1; frame <= steps; ++frame) {
    Drawn next = DrawFrame(turning, frame);
    for (size_t at = 0; at < next[kSupersampled].code.size(); ++at) {
      if (!last[kSupersampled].covered[at] || !next[kSupersampled].covered[at]) continue;
      ++pixels;
      AddChanges(last, next, at, &table);
    }
    last = std::move(next);
  }
  const double count = 3.0 * static_cast<double>(std::max<int64_t>(pixels, 1));
  for (Flicker& f : table) {
    for (double* sum : {&f.change, &f.beyond_ellipse, &f.beyond_sampled}) *sum /= count;
  }
  return table;
}

}  // namespace shading::accuracy
