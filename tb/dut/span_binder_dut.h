// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "Vspan_binder.h"
#include "Vspan_binder_span_binder.h"
#include "model/flow_pattern.h"
#include "tb/dut/command_ports.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of span_binder as triangles and spans in, runs out. The only file that includes
// Vspan_binder.h.
class SpanBinderDut {
 public:
  static constexpr int kLatency = Vspan_binder_span_binder::Latency;

  // span_footprint_t of a span.
  static std::vector<uint32_t> FootprintBits(const TriangleState& triangle,
                                             const SpanCommand& span) {
    BitPacker<kFootprintWords> bits;
    for (const Margin value : span.margin) bits.Put(value);
    PutFootprint(triangle.footprint, bits);
    std::array<uint32_t, kFootprintWords> words;
    bits.Store(words);
    return {words.begin(), words.end()};
  }

  // Choice and kind of set-up that go in with triangle k: bits that differ from one to the next.
  static uint16_t ChoiceOf(size_t k) { return static_cast<uint16_t>((k * 619 + 37) & 0x3ff); }
  static uint8_t KindOf(size_t k) { return static_cast<uint8_t>((k * 5 + 3) & 7); }

  // The spans follow the order of the triangles; span.last ends a triangle.
  struct Work {
    std::vector<TriangleState> triangles;
    std::vector<SpanCommand> spans;
  };
  struct Flows {
    FlowPattern triangle, span, run;
  };
  struct BoundRun {
    SpanSeed run;
    std::array<SpanNormal, 2> normal;
    AngleLimit limit;
    uint32_t choice, kind;            // as driven: see ChoiceOf and KindOf
    std::vector<uint32_t> footprint;  // bits of span_footprint_t
    int64_t offered;  // first cycle with run_valid_o
    int64_t taken;
  };
  struct Result {
    std::vector<int64_t> triangles;  // cycle in which each is taken
    std::vector<int64_t> spans;
    std::vector<BoundRun> runs;
    std::vector<bool> busy;  // busy_o of each cycle
    std::string failure;     // empty when every run was taken and no triangle is left
  };

  SpanBinderDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Vspan_binder>(context_.get())),
        commands_(top_.get()) {
    Reset();
  }

  void Reset() {
    commands_.Clear();
    top_->run_ready_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

  // Offers the commands in order: each appears in a willing cycle of its pattern and stays until
  // taken. Ends when all runs are taken; fails when nothing moves for longer than the patterns
  // allow, or after `limit` cycles.
  Result Run(const Work& work, const Flows& flows, int64_t limit = int64_t{1} << 40) {
    Result result;
    const int64_t patience = 16 + 2 * (flows.triangle.longest_gap() + flows.span.longest_gap() +
                                       flows.run.longest_gap());
    int64_t deadline = patience;
    held_ = false;
    for (int64_t cycle = 0; result.runs.size() < work.spans.size(); ++cycle) {
      Offer(work, flows, cycle, result);
      Settle();
      if (Observe(cycle, &result)) deadline = cycle + patience;
      if (cycle > deadline || cycle >= limit) {
        result.failure = "unfinished in cycle " + std::to_string(cycle);
      }
      if (!result.failure.empty()) return result;
      Tick();
      commands_.Withdraw();
    }
    Settle();
    if (top_->busy_o || top_->run_valid_o) result.failure = "not empty after the last run";
    return result;
  }

 private:
  static constexpr int kRunWords = 5, kNormalWords = 6, kFootprintWords = 27;

  void Offer(const Work& work, const Flows& flows, int64_t cycle, const Result& result) {
    commands_.Offer(work.triangles, result.triangles.size(), flows.triangle.At(cycle), work.spans,
                    result.spans.size(), flows.span.At(cycle));
    top_->choice_i = ChoiceOf(result.triangles.size());
    top_->kind_i = KindOf(result.triangles.size());
    top_->run_ready_i = flows.run.At(cycle);
  }

  bool Observe(int64_t cycle, Result* result) {
    commands_.Observe();
    const bool take_run = top_->run_valid_o && top_->run_ready_i;
    if (commands_.take_triangle()) result->triangles.push_back(cycle);
    if (commands_.take_span()) result->spans.push_back(cycle);
    result->busy.push_back(top_->busy_o);
    CheckHeld(cycle, result);
    if (take_run != commands_.take_span()) {
      result->failure = "run and span part in cycle " + std::to_string(cycle);
    }
    if (take_run) result->runs.push_back(ReadRun(cycle));
    return commands_.take_triangle() || take_run;
  }

  // A run on offer may neither go nor change until it is taken.
  void CheckHeld(int64_t cycle, Result* result) {
    std::vector<uint32_t> words;
    for (int word = 0; word < kRunWords; ++word) words.push_back(top_->run_o[word]);
    for (int word = 0; word < kNormalWords; ++word) words.push_back(top_->normal_o[word]);
    words.push_back(top_->limit_o);
    for (int word = 0; word < kFootprintWords; ++word) words.push_back(top_->footprint_o[word]);
    if (held_ && (!top_->run_valid_o || words != held_words_)) {
      result->failure = "the run on offer changed in cycle " + std::to_string(cycle);
    }
    if (!held_ && top_->run_valid_o) offered_ = cycle;
    held_ = top_->run_valid_o && !top_->run_ready_i;
    held_words_ = words;
  }

  BoundRun ReadRun(int64_t cycle) const {
    BoundRun bound;
    BitReader bits(top_->run_o);
    bound.run.material = static_cast<int>(bits.Take(kMaterialWidth));
    bound.run.dz_dx = bits.TakeSigned<DepthAcc>();
    bound.run.z = bits.TakeSigned<DepthAcc>();
    bound.run.length = static_cast<int>(bits.Take(kLengthWidth));
    bound.run.y = static_cast<int>(bits.Take(kCoordWidth));
    bound.run.x = static_cast<int>(bits.Take(kCoordWidth));
    bound.kind = static_cast<uint32_t>(bits.Take(3));
    bound.choice = static_cast<uint32_t>(bits.Take(10));
    BitReader components(top_->normal_o);
    for (SpanNormal& normal : bound.normal) {
      for (auto& component : normal) component = components.TakeSigned<SpanNormalComponent>();
    }
    bound.limit = AngleLimit::FromRaw(top_->limit_o);
    for (int word = 0; word < kFootprintWords; ++word) {
      bound.footprint.push_back(top_->footprint_o[word]);
    }
    bound.offered = offered_;
    bound.taken = cycle;
    return bound;
  }

  void Settle() {
    top_->clk_i = 0;
    top_->eval();
  }
  void Tick() {
    Settle();
    top_->clk_i = 1;
    top_->eval();
  }

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Vspan_binder> top_;
  CommandPorts<Vspan_binder> commands_;
  bool held_ = false;                 // the run on offer was not taken
  int64_t offered_ = 0;               // since when it is on offer
  std::vector<uint32_t> held_words_;  // its bits
};

}  // namespace shading::tb
