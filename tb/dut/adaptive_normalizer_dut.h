// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "Vadaptive_normalizer.h"
#include "Vadaptive_normalizer4.h"
#include "Vadaptive_normalizer4_adaptive_normalizer.h"
#include "Vadaptive_normalizer_adaptive_normalizer.h"
#include "model/flow_pattern.h"
#include "model/normal/adaptive_normalizer.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of adaptive_normalizer as spans in, groups of normals out; Top is the build with kLanes
// lanes. The only file that includes Vadaptive_normalizer.h and Vadaptive_normalizer4.h.
template <typename Top, int kLanes>
class AdaptiveNormalizerBuildDut {
 public:
  static constexpr int kLatency = Vadaptive_normalizer_adaptive_normalizer::Latency;
  static constexpr int kInterval = Vadaptive_normalizer_adaptive_normalizer::Interval;
  static constexpr int kLaneCount = kLanes;
  using Bits = std::array<uint32_t, 5>;

  struct Span {
    SpanSeed run;  // all but the length travels along unread
    std::array<SpanNormal, 2> normal;
    AngleLimit limit;
  };
  struct Group {
    std::array<PixelNormal, kLanes> normal;
    uint32_t mask;
    bool last;
    int64_t cycle;
  };
  struct Start {
    Bits run;
    int64_t cycle;
  };
  struct Count {
    int normalised, skipped;
    int64_t cycle;
  };
  struct Result {
    std::vector<int64_t> spans;  // cycle in which each is taken
    std::vector<Start> starts;
    std::vector<Group> groups;
    std::vector<Count> counts;
    int64_t normaliser_starts = 0;  // of phong_direct
    int64_t middle_changes = 0;     // cycles in which the products (Nl + Nr)/z move
    std::string failure;  // empty when every span left and the unit is empty
  };

  AdaptiveNormalizerBuildDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
    Reset();
  }

  void Reset() {
    top_->span_valid_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

  // Until every span left, or until cycle `stop`.
  Result Run(AdaptiveKind kind, const std::vector<Span>& spans, const FlowPattern& span_flow,
             const FlowPattern& pixel_flow, int64_t stop = INT64_MAX) {
    Result result;
    top_->kind_i = static_cast<uint8_t>(kind);
    size_t pixels = 0;
    for (const Span& span : spans) pixels += static_cast<size_t>(span.run.length);
    Watch watch;
    for (int64_t cycle = 0; watch.left < spans.size(); ++cycle) {
      if (cycle == stop) return result;
      const bool wants = result.spans.size() < spans.size() && span_flow.At(cycle);
      if (!top_->span_valid_i && wants) Drive(spans[result.spans.size()]);
      top_->pixel_ready_i = pixel_flow.At(cycle);
      Settle();
      const bool taken = top_->span_valid_i && top_->span_ready_o;
      if (taken) result.spans.push_back(cycle);
      Observe(cycle, &watch, &result);
      if (result.groups.size() > pixels) result.failure = "more groups than pixels";
      if (!result.failure.empty()) return result;
      Tick();
      if (taken) Undrive();
    }
    Settle();
    if (top_->busy_o || top_->pixel_valid_o) result.failure = "not empty after the last group";
    return result;
  }

  static Bits RunBits(const Span& span) {
    Bits bits = {};
    DriveLitRun(span.run, bits);
    return bits;
  }

 private:
  static constexpr int64_t kDeadline = 2000;  // four segments of a chord, halved at every level

  // The pixels' side so far.
  struct Watch {
    size_t left = 0;   // spans
    int64_t idle = 0;  // cycles since the last group
    bool held = false;
    Group on_offer = {};
    std::array<uint32_t, 3> middle = {};
  };
  void Observe(int64_t cycle, Watch* watch, Result* result) {
    if (top_->run_valid_o) result->starts.push_back({BitsOfRun(top_->run_o), cycle});
    if (top_->count_valid_o) {
      result->counts.push_back({top_->normalised_o, top_->skipped_o, cycle});
    }
    ObserveActivity(watch, result);
    const bool valid = top_->pixel_valid_o;
    const Group group = valid ? Read(cycle) : Group{};
    if (watch->held && !(valid && Same(group, watch->on_offer))) {
      result->failure = "a group on offer changed in cycle " + std::to_string(cycle);
    }
    watch->held = valid && !top_->pixel_ready_i;
    watch->on_offer = group;
    ++watch->idle;
    if (valid && top_->pixel_ready_i) {
      result->groups.push_back(group);
      watch->left += group.last;
      watch->idle = 0;
    }
    if (watch->idle > kDeadline) {
      result->failure = "no group for too long, cycle " + std::to_string(cycle);
    }
  }

  void ObserveActivity(Watch* watch, Result* result) {
    const auto& inside = *top_->adaptive_normalizer;
    result->normaliser_starts += inside.setup_point_valid || inside.divide_point_valid;
    std::array<uint32_t, 3> middle;
    for (size_t word = 0; word < 3; ++word) {
      middle[word] = inside.u_divide__DOT__middle[static_cast<int>(word)];
    }
    result->middle_changes += middle != watch->middle;
    watch->middle = middle;
  }

  template <typename Port>
  static void DriveLitRun(const SpanSeed& run, Port& port) {
    BitPacker<5> bits;
    bits.Put(run.material, kMaterialWidth);
    bits.Put(run.dz_dx);
    bits.Put(run.z);
    bits.Put(run.length, kLengthWidth);
    bits.Put(run.y, kCoordWidth);
    bits.Put(run.x, kCoordWidth);
    bits.Store(port);
  }
  template <typename Port>
  static Bits BitsOfRun(const Port& port) {
    return {port[0], port[1], port[2], port[3], port[4]};
  }

  void Drive(const Span& span) {
    top_->span_valid_i = 1;
    DriveLitRun(span.run, top_->run_i);
    BitPacker<6> normals;
    for (const SpanNormal& normal : span.normal) {
      for (const SpanNormalComponent value : normal) normals.Put(value);
    }
    normals.Store(top_->normal_i);
    top_->limit_i = static_cast<uint32_t>(span.limit.raw());
  }
  // What lies at the pins of an idle port must not matter.
  void Undrive() {
    top_->span_valid_i = 0;
    for (int word = 0; word < 6; ++word) top_->normal_i[word] = ~top_->normal_i[word];
    for (int word = 0; word < 3; ++word) top_->run_i[word] = ~top_->run_i[word];
    top_->limit_i ^= (1u << AngleLimit::kWidth) - 1;
  }
  Group Read(int64_t cycle) const {
    BitReader bits(top_->normal_o);
    Group group = {};
    group.mask = top_->mask_o;
    group.last = top_->last_o;
    group.cycle = cycle;
    for (PixelNormal& normal : group.normal) {
      for (PixelNormalComponent& value : normal) {
        value = bits.template TakeSigned<PixelNormalComponent>();
      }
    }
    return group;
  }
  static bool Same(const Group& a, const Group& b) {
    return a.normal == b.normal && a.mask == b.mask && a.last == b.last;
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

using AdaptiveNormalizerDut = AdaptiveNormalizerBuildDut<Vadaptive_normalizer, 1>;
using AdaptiveNormalizer4Dut = AdaptiveNormalizerBuildDut<Vadaptive_normalizer4, 4>;

}  // namespace shading::tb
