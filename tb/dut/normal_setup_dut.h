// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>
#include <string>
#include <vector>

#include "Vnormal_setup.h"
#include "Vnormal_setup4.h"
#include "Vnormal_setup4_normal_setup.h"
#include "Vnormal_setup_normal_setup.h"
#include "model/flow_pattern.h"
#include "model/normal/normal_setup.h"
#include "tb/bit_packer.h"
#include "tb/dut/light_pins.h"

namespace shading::tb {

// Pins of normal_setup as spans in, seeds out; Top is the build with kLanes lanes. The only file
// that includes Vnormal_setup*.h.
template <typename Top, int kLanes>
class NormalSetupDutOf {
 public:
  static constexpr int kLaneCount = kLanes;

  struct TimedSeed {
    NormalSeed seed;
    SpanCommand run;  // x, y, length and z as they left
    int64_t offered;  // first cycle with seed_valid_o
    int64_t taken;
  };
  struct Result {
    std::vector<int64_t> spans;  // cycle in which each is taken
    std::vector<TimedSeed> seeds;
    std::string failure;  // empty when every seed was taken and the unit is empty
  };

  NormalSetupDutOf()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
    Reset();
  }

  void Reset() {
    top_->span_valid_i = 0;
    top_->seed_ready_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

  // Span i is of kind i modulo their number.
  Result Run(const std::vector<SetupKind>& kinds, const LightState& light,
             const std::vector<SpanCommand>& spans, const FlowPattern& span_flow,
             const FlowPattern& seed_flow) {
    Result result;
    DriveLight(light, top_->light_i);
    const int64_t limit = 200 + static_cast<int64_t>(spans.size()) * 64;
    bool held = false;
    int64_t offered = 0;
    for (int64_t cycle = 0; result.seeds.size() < spans.size(); ++cycle) {
      if (!top_->span_valid_i && result.spans.size() < spans.size() && span_flow.At(cycle)) {
        DriveSpan(kinds[result.spans.size() % kinds.size()], spans[result.spans.size()]);
        top_->span_valid_i = 1;
      }
      top_->seed_ready_i = seed_flow.At(cycle);
      Settle();
      const bool take_span = top_->span_valid_i && top_->span_ready_o;
      if (take_span) result.spans.push_back(cycle);
      if (!held && top_->seed_valid_o) offered = cycle;
      if (held && !top_->seed_valid_o) result.failure = "a seed on offer went away";
      held = top_->seed_valid_o && !top_->seed_ready_i;
      if (top_->seed_valid_o && top_->seed_ready_i) {
        result.seeds.push_back({ReadSeed(), ReadRun(), offered, cycle});
      }
      if (cycle > limit) result.failure = "unfinished in cycle " + std::to_string(cycle);
      if (!result.failure.empty()) return result;
      Tick();
      if (take_span) {
        top_->span_valid_i = 0;
        for (int word = 0; word < 6; ++word) top_->normal_i[word] = ~top_->normal_i[word];
      }
    }
    Settle();
    if (top_->busy_o || top_->seed_valid_o) result.failure = "not empty after the last seed";
    return result;
  }

 private:
  void DriveSpan(const SetupKind& kind, const SpanCommand& span) {
    BitPacker<6> normals;
    for (const SpanNormal& normal : span.normal) {
      for (const SpanNormalComponent value : normal) normals.Put(value);
    }
    normals.Store(top_->normal_i);
    BitPacker<5> run;
    run.Put(span.x & 255, 8);  // material
    run.Put(span.z);           // dz_dx
    run.Put(span.z);
    run.Put(span.length, 13);
    run.Put(span.y, 12);
    run.Put(span.x, 12);
    run.Put(kind.spherical << 2 | kind.cosines << 1 | kind.length, 3);
    run.Put(span.y & 1023, 10);  // choice
    run.Store(top_->run_i);
  }
  SpanCommand ReadRun() const {
    BitReader bits(top_->run_o);
    SpanCommand run;
    bits.Take(48);
    run.z = bits.template TakeSigned<DepthAcc>();
    run.length = static_cast<int>(bits.Take(13));
    run.y = static_cast<int>(bits.Take(12));
    run.x = static_cast<int>(bits.Take(12));
    return run;
  }
  static Kappa KappaOf(uint64_t bits) {
    Kappa kappa;
    kappa.exponent = static_cast<int>(bits & 15);
    kappa.mantissa = U<1, 28>::FromRaw(static_cast<int64_t>(bits >> 4));
    return kappa;
  }
  NormalSeed ReadSeed() const {
    NormalSeed seed;
    BitReader quantities(top_->quantity_o);
    for (auto& lanes : seed.quantity) {
      for (size_t lane = 0; lane < kLanes; ++lane) {
        lanes[lane].difference = quantities.template TakeSigned<Quantity>();
        lanes[lane].first = quantities.template TakeSigned<Quantity>();
      }
    }
    BitReader lengths(top_->length_o);
    for (size_t lane = 0; lane < kLanes; ++lane) {
      seed.length_square[lane].curvature = lengths.template TakeSigned<LengthSquare>();
      seed.length_square[lane].difference = lengths.template TakeSigned<LengthSquare>();
      seed.length_square[lane].first = lengths.template TakeSigned<LengthSquare>();
    }
    seed.kappa = KappaOf(top_->kappa_o);
    BitReader steps(top_->step_kappa_o);
    for (Kappa& kappa : seed.step_kappa) kappa = KappaOf(steps.Take(33));
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

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

class NormalSetupDut : public NormalSetupDutOf<Vnormal_setup, 1> {
 public:
  static constexpr int kLatency = Vnormal_setup_normal_setup::Latency;
  static constexpr int kInterval = Vnormal_setup_normal_setup::Interval;
};
class NormalSetup4Dut : public NormalSetupDutOf<Vnormal_setup4, 4> {
 public:
  static constexpr int kLatency = Vnormal_setup4_normal_setup::Latency;
  static constexpr int kInterval = Vnormal_setup4_normal_setup::Interval;
};

}  // namespace shading::tb
