// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "Vspan_setup.h"
#include "Vspan_setup_span_setup.h"
#include "model/flow_pattern.h"
#include "tb/dut/command_ports.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of span_setup as triangles and spans in, seeds out. The only file that includes
// Vspan_setup.h.
class SpanSetupDut {
 public:
  static constexpr int kLatency = Vspan_setup_span_setup::Latency;
  static constexpr int kInterval = Vspan_setup_span_setup::Interval;

  // One frame. The spans follow the order of the triangles; span.last ends a triangle.
  struct Work {
    Method method = Method::kFlat;
    std::vector<TriangleState> triangles;
    std::vector<SpanCommand> spans;
    std::vector<Choice> choices;  // of each triangle; none: the method for all

    Choice Of(size_t triangle) const {
      return triangle < choices.size() ? choices[triangle] : ChoiceOf(method);
    }
  };
  struct Flows {
    FlowPattern triangle, span, seed;
  };
  struct TimedSeed {
    SpanSeed seed;
    uint16_t choice;  // choice_t
    int64_t offered;  // first cycle with seed_valid_o
    int64_t taken;
  };
  struct Result {
    std::vector<int64_t> triangles;  // cycle in which each is taken
    std::vector<int64_t> spans;
    std::vector<TimedSeed> seeds;
    std::vector<bool> inside, busy;  // span_inside_o and busy_o of each cycle
    std::string failure;             // empty when every seed was taken and the unit is empty
  };

  static uint16_t BitsOf(const Choice& choice) {
    BitPacker<1> bits;
    PutChoice(choice, bits);
    uint32_t word[1];
    bits.Store(word);
    return static_cast<uint16_t>(word[0]);
  }

  SpanSetupDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Vspan_setup>(context_.get())),
        commands_(top_.get()) {
    Reset();
  }

  void Reset() {
    commands_.Clear();
    top_->seed_ready_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

  // Offers the commands in order: each appears in a willing cycle of its pattern and stays until
  // taken. Ends when all seeds are taken; fails when nothing moves for longer than the patterns
  // allow, or after `limit` cycles.
  Result Run(const Work& work, const Flows& flows, int64_t limit = int64_t{1} << 40) {
    Result result;
    const int64_t patience = 16 + 2 * (flows.triangle.longest_gap() + flows.span.longest_gap() +
                                       flows.seed.longest_gap()) + kMaxScreen;
    int64_t deadline = patience;
    held_ = false;
    for (int64_t cycle = 0; result.seeds.size() < work.spans.size() || held_; ++cycle) {
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
    if (top_->busy_o || top_->seed_valid_o) result.failure = "not empty after the last seed";
    return result;
  }

 private:
  void Offer(const Work& work, const Flows& flows, int64_t cycle, const Result& result) {
    commands_.Offer(work.triangles, result.triangles.size(), flows.triangle.At(cycle), work.spans,
                    result.spans.size(), flows.span.At(cycle));
    top_->choice_i = BitsOf(work.Of(result.triangles.size()));
    top_->seed_ready_i = flows.seed.At(cycle);
  }

  bool Observe(int64_t cycle, Result* result) {
    commands_.Observe();
    const bool take_seed = top_->seed_valid_o && top_->seed_ready_i;
    if (commands_.take_triangle()) result->triangles.push_back(cycle);
    if (commands_.take_span()) result->spans.push_back(cycle);
    result->inside.push_back(top_->span_inside_o);
    result->busy.push_back(top_->busy_o);
    CheckHeld(cycle, result);
    if (take_seed) result->seeds.push_back({ReadOutputs(), top_->choice_o, offered_, cycle});
    return commands_.take_triangle() || commands_.take_span() || take_seed;
  }

  // A seed on offer may neither go nor change until it is taken.
  void CheckHeld(int64_t cycle, Result* result) {
    std::vector<uint32_t> words;
    for (int word = 0; word < kSeedWords; ++word) words.push_back(top_->seed_o[word]);
    if (held_ && (!top_->seed_valid_o || words != held_words_)) {
      result->failure = "the seed on offer changed in cycle " + std::to_string(cycle);
    }
    if (!held_ && top_->seed_valid_o) offered_ = cycle;
    held_ = top_->seed_valid_o && !top_->seed_ready_i;
    held_words_ = words;
  }

  SpanSeed ReadOutputs() const {
    SpanSeed seed = ReadSeed(top_->seed_o);
    seed.material = top_->material_o;
    BitReader<decltype(top_->split_o)> split(top_->split_o);
    for (SplitSeed& channel : seed.split) {
      channel.ambient = split.template TakeSigned<IntensityAcc>();
      channel.specular = TakeSeed<IntensityAcc>(split);
    }
    BitReader<decltype(top_->curve_o)> cosine(top_->curve_o);
    for (CurveSeed& curve : seed.curve) curve = TakeSeed<CosineAcc>(cosine);
    BitReader<decltype(top_->point_o)> point(top_->point_o);
    for (SurfacePoint& at : seed.point) {
      at.y = static_cast<int>(point.template TakeSigned<S<12, 0>>().raw());
      at.x = static_cast<int>(point.template TakeSigned<S<12, 0>>().raw());
      Surface& s = at.surface;
      for (IntensityAcc* value : {&s.f, &s.e, &s.d, &s.c, &s.b, &s.a}) {
        *value = point.template TakeSigned<IntensityAcc>();
      }
    }
    return seed;
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

  static constexpr int kSeedWords = 18;

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Vspan_setup> top_;
  CommandPorts<Vspan_setup> commands_;
  bool held_ = false;                 // the seed on offer was not taken
  int64_t offered_ = 0;               // since when it is on offer
  std::vector<uint32_t> held_words_;  // its bits
};

}  // namespace shading::tb
