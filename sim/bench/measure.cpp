// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/choice/method_choice.h"
#include "model/raster/front_end.h"
#include "sim/bench/thread_stopwatch.h"
#include "tb/rtl_shading_unit.h"

namespace shading::sim {
namespace {

[[noreturn]] void Fail(const std::string& what, const std::string& how) {
  throw std::runtime_error(fmt::format("{}: {}; run shadesim verify", what, how));
}

// Pixels into a picture; when the first and the last left, and in how many cycles any did.
class TimedPicture : public tb::PixelConsumer {
 public:
  TimedPicture(const FrameWork& work, FrameBuffer* picture) : picture_(work, picture) {}

  bool Consume(const TimedPixel* pixels, size_t count) override {
    for (size_t i = 0; i < count; ++i) {
      if (first_ < 0) first_ = pixels[i].cycle;
      busy_ += pixels[i].cycle != last_;
      last_ = pixels[i].cycle;
    }
    return picture_.Consume(pixels, count);
  }

  int64_t first() const { return first_; }
  int64_t last() const { return last_; }
  int64_t busy() const { return busy_; }

 private:
  PictureConsumer picture_;
  int64_t first_ = -1, last_ = -1, busy_ = 0;
};

void RunRtl(const FrameWork& work, FrameBuffer* picture, Cell* cell) {
  const auto rtl = tb::RtlShadingUnit::Create(work.method, cell->key.lanes);
  TimedPicture consumer(work, picture);
  const ThreadStopwatch watch;
  const FlowPattern always = FlowPattern::Always();
  const tb::RtlResult result = rtl->Run(work, always, always, &consumer, {});
  cell->rtl_seconds = watch.Seconds();
  if (!result.finished || result.pixels != work.pixels) {
    Fail(cell->key.Text(), fmt::format("the RTL gave {} of {} pixels", result.pixels, work.pixels));
  }
  cell->cycles = result.cycles;
  cell->busy = consumer.busy();
  cell->stall = result.counters.stall;
  cell->fill = consumer.first() + (result.cycles - 1 - consumer.last());
  cell->setup = result.cycles - cell->busy - cell->stall - cell->fill;
  cell->work.normalisations = result.counters.normalised;
  cell->work.samples = result.counters.samples_taken;
  cell->work.highlights =
      LightsPixels(work.method) ? work.pixels - result.counters.no_highlight : 0;
}

// Processor seconds of a run of the model, and the cycles it counts.
double RunModel(const FrameWork& work, int lanes, FrameBuffer* picture, int64_t* cycles) {
  const ThreadStopwatch watch;
  const FlowPattern always = FlowPattern::Always();
  ShadingUnit model(work, lanes, always, always);
  std::vector<Pixel> pixels(kMaxScreen);
  size_t triangle = 0;
  *cycles = 1;
  ForEachSpan(
      work,
      [&](size_t t) {
        triangle = t;
        model.Triangle(work.triangles[t]);
      },
      [&](const SpanCommand& span) {
        *cycles = model.Span(span, pixels.data()).last_left + 1;
        if (picture == nullptr) return true;
        for (int i = 0; i < span.length; ++i) {
          picture->Put(pixels[static_cast<size_t>(i)], static_cast<int32_t>(work.packet[triangle]));
        }
        return true;
      });
  return watch.Seconds();
}

bool SamePicture(const FrameBuffer& a, const FrameBuffer& b) {
  for (size_t at = 0; at < a.size(); ++at) {
    if (a.code(at) != b.code(at) || a.triangle(at) != b.triangle(at)) return false;
  }
  return true;
}

}  // namespace

uint32_t SureMethods(const FrameWork& work) {
  const auto bit = [](Method method) { return 1U << static_cast<unsigned>(method); };
  // phong is exact, too.
  uint32_t sure = ~0U;
  for (const TriangleState& triangle : work.triangles) {
    uint32_t good = bit(Method::kPhongDuff) | bit(Method::kPhong);
    good |= bit(MethodChoice::ExactOf(triangle.range));
    for (const MethodChoice::Bound& b :
         MethodChoice::BoundsOf(triangle.range, work.limits[static_cast<size_t>(triangle.material)],
                                work.light.lighting)) {
      if (b.allowed && MethodChoice::LogAdd(b.diffuse, b.specular) <= 0) good |= bit(b.method);
    }
    if (triangle.range.turn.raw() == 0) good |= bit(Method::kFlat);
    sure &= good;
  }
  return sure;
}

TriangleList WithShininess(TriangleList list, int n) {
  for (Material& material : list.frame.materials) {
    material.shininess = Shininess::FromRaw(int64_t{n} << Shininess::kFraction);
  }
  return list;
}

Cell MeasureCell(const TriangleList& list, const CellKey& key, int repeats, FrameBuffer* picture,
                 IdealCache* ideals) {
  Cell cell;
  cell.key = key;
  cell.packets = static_cast<int64_t>(list.triangles.size());
  FrontEndOptions options;
  if (UsesTolerance(key.method)) options.tolerance = Tolerance::Round(key.tolerance);
  FrameWork work;
  for (int k = 0; k < repeats; ++k) {
    const ThreadStopwatch watch;
    work = FrontEnd::Run(list, key.method, options);
    const double seconds = watch.Seconds();
    cell.front_end_seconds = k == 0 ? seconds : std::min(cell.front_end_seconds, seconds);
  }
  cell.work.triangles = static_cast<int64_t>(work.triangles.size());
  cell.work.spans = static_cast<int64_t>(work.spans.size());
  cell.work.pixels = work.pixels;
  if (key.method == Method::kAuto) {
    cell.work.share = work.share;
    cell.sure = SureMethods(work);
  }
  if (work.pixels == 0) {
    throw std::runtime_error(
        fmt::format("{}: covers no pixel; show it larger or leave it out", key.scene));
  }
  RunRtl(work, picture, &cell);

  FrameBuffer expected(picture->width(), picture->height());
  int64_t cycles = 0;
  RunModel(work, key.lanes, &expected, &cycles);
  if (cycles != cell.cycles || !SamePicture(expected, *picture)) {
    Fail(key.Text(), "RTL and model differ");
  }
  for (int k = 0; k < repeats; ++k) {
    const double seconds = RunModel(work, key.lanes, nullptr, &cycles);
    cell.model_seconds = k == 0 ? seconds : std::min(cell.model_seconds, seconds);
  }
  cell.phong = ideals->ErrorOf(key, Method::kPhong, *picture, list);
  cell.closed_form = ideals->ErrorOf(key, key.method, *picture, list);
  return cell;
}

}  // namespace shading::sim
