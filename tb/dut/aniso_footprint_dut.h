// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "Vaniso_footprint.h"
#include "Vaniso_footprint4.h"
#include "Vaniso_footprint_aniso_footprint.h"
#include "model/flow_pattern.h"
#include "model/footprint/aniso_footprint.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of aniso_footprint between a walker that offers groups of pixels and a queue that takes
// them; Top is the build with kLanes lanes. The only file that includes Vaniso_footprint.h and
// Vaniso_footprint4.h.
template <typename Top, size_t kLanes>
class AnisoFootprintBuildDut {
 public:
  static constexpr size_t kLaneCount = kLanes;
  static constexpr int kLatency = Vaniso_footprint_aniso_footprint::Latency;

  struct Group {
    std::array<std::array<Quantity, kLanes>, 3> normal;
    uint32_t mask;
  };
  struct Span {
    Footprint footprint;
    Margins first;
    std::vector<Group> groups;
  };
  struct Sample {
    std::array<std::array<Quantity, 3>, kLanes> normal;
    uint32_t live;
    bool first, last, twice;
    int64_t cycle;  // in which it is valid
  };
  struct Counters {
    uint32_t taken, excluded, saved;
  };
  struct Result {
    std::vector<int64_t> offers;  // first cycle in which each group is on offer
    std::vector<int64_t> enters;  // cycle in which it enters the queue
    std::vector<Sample> samples;
    Counters counters = {};
    std::string failure;  // empty when every group entered and every sample came
  };

  AnisoFootprintBuildDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
    Reset();
  }

  void Reset() {
    top_->load_i = 0;
    top_->pixel_valid_i = 0;
    top_->enter_ready_i = 0;
    top_->clear_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }
  void Clear() {
    top_->clear_i = 1;
    Tick();
    top_->clear_i = 0;
  }

  // As the walker does: a group is on offer from a willing cycle of the source until it enters; a
  // span is loaded in the cycle in which the last group of the one before enters. Until every span
  // is through, or until cycle `stop`.
  Result Run(const std::vector<Span>& spans, const FlowPattern& source, const FlowPattern& sink,
             int64_t stop = INT64_MAX) {
    Result result;
    Place at;
    const int64_t patience = 2 * (source.longest_gap() + sink.longest_gap()) + 16;
    int64_t moved = 0;
    for (int64_t cycle = 0; cycle < stop && result.failure.empty(); ++cycle) {
      if (at.span == spans.size() && cycle > moved + AnisoFootprint::kSampleLatency) break;
      if (at.loaded && !top_->pixel_valid_i && at.span < spans.size() && source.At(cycle)) {
        DriveGroup(spans[at.span].groups[at.group]);
        result.offers.push_back(cycle);
      }
      top_->enter_ready_i = sink.At(cycle);
      Settle();
      const bool entered = Observe(cycle, &result);
      const bool loads = Advance(entered, spans, &at);
      Tick();
      if (entered) Withdraw();
      top_->load_i = 0;
      if (loads || entered) moved = cycle;
      if (cycle > moved + patience) {
        result.failure = "nothing moved until cycle " + std::to_string(cycle);
      }
    }
    result.counters = ReadCounters();
    return result;
  }

 private:
  // The group that is, or will be, on offer.
  struct Place {
    size_t span = 0, group = 0;
    bool loaded = false;  // a span was, and groups follow
  };

  // Whether a group enters.
  bool Observe(int64_t cycle, Result* result) const {
    const bool entered = top_->enter_valid_o && top_->enter_ready_i;
    if (entered != (top_->pixel_valid_i && top_->pixel_ready_o)) {
      result->failure = "taken without entering in cycle " + std::to_string(cycle);
    }
    if (entered) result->enters.push_back(cycle);
    if (top_->sample_valid_o) result->samples.push_back(Read(cycle));
    return entered;
  }

  // Whether a span is loaded.
  bool Advance(bool entered, const std::vector<Span>& spans, Place* at) {
    const bool done = entered && ++at->group == spans[at->span].groups.size();
    if (!done && at->loaded) return false;
    if (done) ++at->span;
    at->group = 0;
    at->loaded = true;
    if (at->span == spans.size()) return false;
    DriveLoad(spans[at->span]);
    return true;
  }

  void DriveLoad(const Span& span) {
    top_->load_i = 1;
    BitPacker<24> bits;
    PutFootprint(span.footprint, bits);
    bits.Store(top_->footprint_i);
    BitPacker<3> first;
    for (const Margin value : span.first) first.Put(value);
    first.Store(top_->margin_i);
  }
  void DriveGroup(const Group& group) {
    top_->pixel_valid_i = 1;
    top_->mask_i = static_cast<uint8_t>(group.mask);
    BitPacker<(120 * kLanes + 31) / 32> bits;
    for (const auto& lanes : group.normal) {
      for (const Quantity value : lanes) bits.Put(value);
    }
    bits.Store(top_->normal_i);
  }
  // What lies at the pins of an idle port must not matter.
  void Withdraw() {
    top_->pixel_valid_i = 0;
    top_->mask_i = static_cast<uint8_t>(~top_->mask_i & ((1u << kLanes) - 1));
    for (int word = 0; word < 3; ++word) top_->normal_i[word] = ~top_->normal_i[word];
    for (int word = 0; word < 24; ++word) top_->footprint_i[word] = ~top_->footprint_i[word];
    top_->footprint_i[23] &= (1u << (kFootprintWidth - 32 * 23)) - 1;
  }
  Sample Read(int64_t cycle) const {
    BitReader bits(top_->normal_o);
    Sample sample = {};
    for (auto& normal : sample.normal) {
      for (Quantity& value : normal) value = bits.template TakeSigned<Quantity>();
    }
    sample.live = top_->live_o;
    sample.twice = top_->place_o & 1;
    sample.last = top_->place_o >> 1 & 1;
    sample.first = top_->place_o >> 2 & 1;
    sample.cycle = cycle;
    return sample;
  }
  Counters ReadCounters() const {
    return {top_->counters_o[2], top_->counters_o[1], top_->counters_o[0]};
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

  static constexpr int kFootprintWidth = 2 + 3 * (3 * 40 + 3 * 32) + 3 * 32;  // footprint_t

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

using AnisoFootprintDut = AnisoFootprintBuildDut<Vaniso_footprint, 1>;
using AnisoFootprint4Dut = AnisoFootprintBuildDut<Vaniso_footprint4, 4>;

}  // namespace shading::tb
