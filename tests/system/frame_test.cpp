// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "model/raster/front_end.h"
#include "tb/stimulus/random_triangles.h"
#include "tests/system/tlm_platform.h"

namespace shading::test {
namespace {

const char* const kCounters[] = {"PIXELS",
                                 "STALL",
                                 "SETUP",
                                 "CYCLES",
                                 "TRIANGLES",
                                 "SPANS",
                                 "WRITTEN",
                                 "SKIPPED_BACK_FACING",
                                 "SKIPPED_DEGENERATE",
                                 "SKIPPED_OFF_SCREEN",
                                 "SKIPPED_EMPTY",
                                 "NORMALISED",
                                 "NORMALISED_SKIPPED",
                                 "SKIPPED_AMBIENT",
                                 "SPANS_CONSTANT",
                                 "SPANS_DARK",
                                 "SPANS_UNNORMALISED",
                                 "CHANNELS_BLACK"};
using CounterValues = std::map<std::string, uint64_t>;

// What a frame leaves behind.
struct Rendered {
  std::vector<uint8_t> memory;
  CounterValues counters;
};

struct Case {
  TriangleList list;
  Method method;
  bool depth_test;
  FlowPattern sink = FlowPattern::Always();
};

Rendered OnDevice(Core core, const Case& test, const sc_core::sc_time& quantum) {
  Rendered result;
  ShadingDevice::Options options;
  options.sink = test.sink;
  const Outcome outcome = Simulate({core, options, quantum, {}}, {[&](Software* software) {
                                     software->Clear(0xff);
                                     software->Render(test.list, test.method,
                                                      TargetFor(test.list.frame, test.depth_test));
                                     EXPECT_EQ(software->driver().Error(), DeviceError::kNone);
                                     for (const char* name : kCounters)
                                       result.counters[name] = software->driver().Counter(name);
                                   }});
  EXPECT_TRUE(outcome.finished);
  result.memory = outcome.memory;
  return result;
}

// The frame buffer of one frame, pixel by pixel.
class SoftwareFrameBuffer {
 public:
  explicit SoftwareFrameBuffer(const FrameBuffer& target)
      : target_(target), memory_(Platform::kMemory, 0xff) {}

  bool Put(const Pixel& pixel) {
    const uint64_t depth_at = target_.depth_base + pixel.y * target_.depth_stride + 4u * pixel.x;
    if (target_.depth_test) {
      uint32_t depth;
      std::memcpy(&depth, &memory_[depth_at], 4);
      if (depth <= pixel.z) return false;
      std::memcpy(&memory_[depth_at], &pixel.z, 4);
    }
    uint8_t* color = &memory_[target_.color_base + pixel.y * target_.color_stride + 4u * pixel.x];
    color[0] = pixel.r;
    color[1] = pixel.g;
    color[2] = pixel.b;
    color[3] = 255;
    return true;
  }
  const std::vector<uint8_t>& memory() const { return memory_; }

 private:
  FrameBuffer target_;
  std::vector<uint8_t> memory_;
};

// The same frame without SystemC.
Rendered OnModel(const Case& test) {
  const FrameWork work = FrontEnd::Run(test.list, test.method);
  SoftwareFrameBuffer frame_buffer(TargetFor(test.list.frame, test.depth_test));
  ShadingUnit unit(work, 1, FlowPattern::Always(), test.sink);
  std::vector<Pixel> pixels(kMaxScreen);
  uint64_t written = 0, cycles = 1;
  const auto shade = [&](const SpanCommand& span) {
    cycles = static_cast<uint64_t>(unit.Span(span, pixels.data()).last_left) + 1;
    for (int i = 0; i < span.length; ++i) {
      written += frame_buffer.Put(pixels[static_cast<size_t>(i)]);
    }
    return true;
  };
  ForEachSpan(
      work, [&](size_t t) { unit.Triangle(work.triangles[t]); }, shade);
  const auto u = [](int64_t value) { return static_cast<uint64_t>(value); };
  return {frame_buffer.memory(),
          {{"PIXELS", u(work.pixels)},
           {"STALL", u(unit.counters().stall)},
           {"SETUP", u(unit.counters().setup)},
           {"CYCLES", cycles},
           {"TRIANGLES", work.triangles.size()},
           {"SPANS", work.spans.size()},
           {"WRITTEN", written},
           {"SKIPPED_BACK_FACING", u(work.skipped.back_facing)},
           {"SKIPPED_DEGENERATE", u(work.skipped.degenerate)},
           {"SKIPPED_OFF_SCREEN", u(work.skipped.off_screen)},
           {"SKIPPED_EMPTY", u(work.skipped.empty)},
           {"NORMALISED", u(unit.counters().normalised)},
           {"NORMALISED_SKIPPED", u(unit.counters().skipped)},
           {"SKIPPED_AMBIENT", u(unit.counters().ambient)},
           {"SPANS_CONSTANT", u(unit.counters().constant)},
           {"SPANS_DARK", u(unit.counters().dark)},
           {"SPANS_UNNORMALISED", u(unit.counters().unnormalised)},
           {"CHANNELS_BLACK", u(unit.counters().black)}}};
}

void ExpectSame(const Case& test, const sc_core::sc_time& quantum) {
  const Rendered expected = OnModel(test);
  for (const Core core : kBothCores) {
    const Rendered actual = OnDevice(core, test, quantum);
    EXPECT_TRUE(actual.memory == expected.memory) << "frame buffer of core " << int(core);
    EXPECT_EQ(actual.counters, expected.counters) << "counters of core " << int(core);
  }
}

TEST(TlmFrame, BothCoresMatchTheModelAndASoftwareDepthTest) {
  for (const Method method : kAllMethods) {
    for (const bool depth_test : {false, true}) {
      for (uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(testing::Message()
                     << Name(method) << ", depth test " << depth_test << ", seed " << seed);
        ExpectSame({tb::RandomTriangles(seed, 300), method, depth_test},
                   sc_core::sc_time(depth_test ? 2 : 0, sc_core::SC_US));
      }
    }
  }
}

TEST(TlmFrame, StallsAreThoseOfTheModel) {
  ExpectSame({tb::RandomTriangles(5, 200), Method::kQuad, true, FlowPattern::Random(5)},
             sc_core::SC_ZERO_TIME);
}

TEST(TlmFrame, FrameWithoutPixels) {
  const TriangleList empty = Empty(16, 16);
  ExpectSame({empty, Method::kFlat, false}, sc_core::SC_ZERO_TIME);
}

// Nearer, then farther, then equal: only the first is left.
TEST(TlmFrame, EarlierTriangleWinsATie) {
  TriangleList list = Empty(16, 8);
  list.frame.materials.push_back(list.frame.materials[0]);
  list.frame.materials[1].diffuse = {};
  for (const int64_t depth : {1000, 2000, 1000}) {
    list.triangles.push_back(Cover(depth));
    list.triangles.back().material = list.triangles.size() > 1;
  }
  for (const Core core : kBothCores) {
    const Rendered actual = OnDevice(core, {list, Method::kFlat, true}, sc_core::SC_ZERO_TIME);
    EXPECT_EQ(actual.counters.at("PIXELS"), 3u * 16 * 8);
    EXPECT_EQ(actual.counters.at("WRITTEN"), 1u * 16 * 8);
    EXPECT_EQ(actual.memory[0], 255);
  }
}

}  // namespace
}  // namespace shading::test
