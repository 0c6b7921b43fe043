// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>
#include <verilated_fst_c.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include "tb/dut/pins.h"
#include "tb/rtl_shading_unit.h"
#include "tb/wave_view.h"

namespace shading::tb {

// Pins of one build of shading_unit. Top is a Verilated class.
template <typename Top, int kLanes>
class ShadingUnitDut : public RtlShadingUnit {
 public:
  RtlResult Run(const FrameWork& work, const FlowPattern& source, const FlowPattern& sink,
                PixelConsumer* consumer, const Observation& observation) override {
    if (!clean_ || !observation.trace.empty()) Reset(observation);
    clean_ = false;
    loads_ = 0;
    Feed feed{&work, &source};
    Batch batch(consumer);
    RtlResult result;
    if (LightsPixels(work.method)) WriteMaterials(work);
    top_->frame_valid_i = 1;
    DriveFrame(work.method, work.tolerance, work.light, top_->frame_i);
    const int64_t patience = 4 * (source.longest_gap() + sink.longest_gap()) + 64 + kMaxScreen;
    int64_t deadline = patience;
    for (int64_t cycle = 0; !result.finished && result.failure.empty(); ++cycle) {
      top_->pixel_ready_i = sink.At(cycle);
      Offer(&feed, cycle);
      Phase(0, cycle);
      const bool taken = Observe(&feed, &batch, cycle, &result);
      if (taken) deadline = cycle + patience;
      if (observation.probe_span >= 0) Probe(observation.probe_span, &result);
      if (cycle == 0 && !top_->frame_ready_o)
        result.failure = "the unit was not empty when its frame came";
      if (cycle > deadline) result.failure = Stuck(feed, cycle);
      if (batch.stop) result.failure = "stopped by the consumer";
      result.finished = cycle > 0 && !taken && feed.Done() && top_->frame_ready_o;
      result.cycles = cycle;
      Phase(1, cycle);
      Withdraw();
    }
    batch.Flush();
    if (trace_) WriteWaveView(observation.trace, kLanes);
    trace_.reset();
    clean_ = result.finished;
    result.counters = ReadCounters();
    return result;
  }

 private:
  // Commands still to be offered.
  struct Feed {
    const FrameWork* work;
    const FlowPattern* source;
    size_t triangle = 0, span = 0;
    bool Done() const { return triangle == work->triangles.size() && span == work->spans.size(); }
  };

  // Pixels on their way to the consumer.
  struct Batch {
    explicit Batch(PixelConsumer* to) : consumer(to) {}
    PixelConsumer* consumer;
    size_t count = 0;
    bool stop = false;
    std::array<TimedPixel, 1024> pixels;

    void Add(const TimedPixel& pixel) {
      pixels[count++] = pixel;
      if (count == pixels.size()) Flush();
    }
    void Flush() {
      if (count > 0) stop |= !consumer->Consume(pixels.data(), count);
      count = 0;
    }
  };

  void Reset(const Observation& observation) {
    top_.reset();  // before the context that it lives in
    context_ = std::make_unique<VerilatedContext>();
    context_->traceEverOn(!observation.trace.empty());
    top_ = std::make_unique<Top>(context_.get());
    top_->rst_ni = 0;
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
    top_->rst_ni = 1;
    observation_ = observation;
    if (observation.trace.empty()) return;
    trace_ = std::make_unique<VerilatedFstC>();
    top_->trace(trace_.get(), 99);
    trace_->open(observation.trace.c_str());
    if (!trace_->isOpen()) {
      throw std::runtime_error(observation.trace +
                               ": cannot be written; name a folder that exists");
    }
  }

  void Offer(Feed* feed, int64_t cycle) {
    if (cycle == 0) return;
    if (!top_->triangle_valid_i && feed->triangle < feed->work->triangles.size() &&
        feed->source->At(cycle + FlowPattern::kTriangleLead)) {
      DriveTriangle(feed->work->triangles[feed->triangle], top_->triangle_i);
      top_->triangle_valid_i = 1;
    }
    if (!top_->span_valid_i && feed->span < feed->work->spans.size() && feed->source->At(cycle)) {
      DriveSpan(feed->work->spans[feed->span], top_->span_i);
      top_->span_valid_i = 1;
    }
  }

  // What the coming clock edge will transfer. A taken command leaves its port after the edge.
  bool Observe(Feed* feed, Batch* batch, int64_t cycle, RtlResult* result) {
    take_triangle_ = top_->triangle_valid_i && top_->triangle_ready_o;
    take_span_ = top_->span_valid_i && top_->span_ready_o;
    const bool take_pixel = top_->pixel_valid_o && top_->pixel_ready_i;
    if (take_triangle_) ++feed->triangle;
    if (take_span_) ++feed->span;
    if (take_pixel) TakePixels(batch, cycle, result);
    return take_triangle_ || take_span_ || take_pixel;
  }

  void TakePixels(Batch* batch, int64_t cycle, RtlResult* result) {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (kLanes > 1 && !(top_->pixel_mask_o >> lane & 1)) continue;
      batch->Add({ReadPixel(top_->pixel_o, lane), cycle});
      ++result->pixels;
    }
  }

  // Before the frame, one a cycle.
  void WriteMaterials(const FrameWork& work) {
    top_->material_valid_i = 1;
    for (size_t i = 0; i < work.materials.size(); ++i) {
      top_->material_index_i = static_cast<uint8_t>(i);
      DriveMaterial(work.materials[i], top_->material_i);
      if (i < work.limits.size()) DriveLimit(work.limits[i], top_->limit_i);
      for (const bool level : {false, true}) {
        top_->clk_i = level;
        top_->eval();
      }
    }
    top_->material_valid_i = 0;
  }

  // Lets the logic settle at one clock level: 0 before the edge, 1 after it.
  void Phase(uint8_t level, int64_t cycle) {
    top_->clk_i = level;
    top_->eval();
    if (trace_ && cycle >= observation_.first && cycle <= observation_.last) {
      trace_->dump(static_cast<uint64_t>(2 * cycle + level));
    }
  }

  // Taken commands leave their ports.
  void Withdraw() {
    top_->frame_valid_i = 0;
    if (take_triangle_) top_->triangle_valid_i = 0;
    if (take_span_) top_->span_valid_i = 0;
  }

  void Probe(int64_t span, RtlResult* result) {
    if (!top_->rootp->shading_unit__DOT__load) return;
    if (loads_++ != span) return;
    result->probe = ReadSeed(top_->rootp->shading_unit__DOT__seed);
    ReadCosines(&*result->probe);
    result->probe->normal = ReadNormalSeed<kLanes>(top_->rootp->shading_unit__DOT__quantity,
                                                   top_->rootp->shading_unit__DOT__kappa);
  }

  void ReadCosines(SpanSeed* seed) const {
    BitReader<decltype(top_->rootp->shading_unit__DOT__curve)> bits(
        top_->rootp->shading_unit__DOT__curve);
    for (CurveSeed& curve : seed->curve) curve = TakeSeed<CosineAcc>(bits);
  }

  std::string Stuck(const Feed& feed, int64_t cycle) const {
    return "nothing moved until cycle " + std::to_string(cycle) + ": " +
           std::to_string(feed.triangle) + " of " + std::to_string(feed.work->triangles.size()) +
           " triangles and " + std::to_string(feed.span) + " of " +
           std::to_string(feed.work->spans.size()) + " spans taken";
  }

  Counters ReadCounters() const {
    BitReader<decltype(top_->counters_o)> bits(top_->counters_o);
    Counters counters;
    counters.samples_saved = static_cast<int64_t>(bits.Take(32));
    counters.samples_excluded = static_cast<int64_t>(bits.Take(32));
    counters.samples_taken = static_cast<int64_t>(bits.Take(32));
    counters.black = static_cast<int64_t>(bits.Take(32));
    counters.unnormalised = static_cast<int64_t>(bits.Take(32));
    counters.dark = static_cast<int64_t>(bits.Take(32));
    counters.constant = static_cast<int64_t>(bits.Take(32));
    counters.ambient = static_cast<int64_t>(bits.Take(32));
    counters.skipped = static_cast<int64_t>(bits.Take(32));
    counters.normalised = static_cast<int64_t>(bits.Take(32));
    counters.no_highlight = static_cast<int64_t>(bits.Take(32));
    counters.unlit = static_cast<int64_t>(bits.Take(32));
    counters.setup = static_cast<int64_t>(bits.Take(32));
    counters.stall = static_cast<int64_t>(bits.Take(32));
    counters.pixels = static_cast<int64_t>(bits.Take(32));
    return counters;
  }

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Top> top_;
  std::unique_ptr<VerilatedFstC> trace_;
  bool take_triangle_ = false;
  bool take_span_ = false;
  bool clean_ = false;  // reset, and empty since
  int64_t loads_ = 0;   // seeds that the pixel walker took
  Observation observation_;
};

}  // namespace shading::tb
