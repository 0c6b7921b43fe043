// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "model/raster/front_end.h"
#include "tb/stimulus/random_triangles.h"
#include "tests/system/tlm_platform.h"

namespace shading::test {
namespace {

using sc_core::sc_time;

const sc_time kPeriod(7, sc_core::SC_NS);

// When each span's last pixel has left, and the end of the frame, in clock periods after END.
std::vector<int64_t> ExpectedCycles(const TriangleList& list, Method method) {
  const FrameWork work = FrontEnd::Run(list, method);
  ShadingUnit unit(work, 1, FlowPattern::Always(), FlowPattern::Always());
  std::vector<Pixel> pixels(kMaxScreen);
  std::vector<int64_t> cycles;
  ForEachSpan(
      work, [&](size_t t) { unit.Triangle(work.triangles[t]); },
      [&](const SpanCommand& span) {
        cycles.push_back(unit.Span(span, pixels.data()).last_left + 1);
        return true;
      });
  return cycles;
}

struct Observed {
  sc_time start, idle;
  std::vector<sc_time> arrivals;
};

Observed Observe(Setup setup, const TriangleList& list, Method method) {
  Observed observed;
  setup.options.clock_period = kPeriod;
  const Outcome outcome = Simulate(setup, {[&](Software* software) {
                                     ShadingDriver& driver = software->driver();
                                     driver.Start(list.frame, method, TargetFor(list.frame, false));
                                     for (const TrianglePacket& packet : list.triangles)
                                       driver.Push(packet);
                                     software->Wait(sc_core::SC_ZERO_TIME);
                                     observed.start = sc_core::sc_time_stamp() +
                                                      kPeriod;  // the access to CONTROL takes one
                                     driver.End();
                                     do software->Wait(kPeriod);
                                     while (driver.Busy());
                                     observed.idle = sc_core::sc_time_stamp();
                                     observed.arrivals = software->platform().monitor.arrivals;
                                   }});
  EXPECT_TRUE(outcome.finished);
  return observed;
}

// Whatever the quantum: bursts carry the time at which the span's last pixel has left, and BUSY
// falls when the frame is finished; the poll sees that up to three periods later.
TEST(TlmTiming, BurstsAndIdleAreExact) {
  const TriangleList list = tb::RandomTriangles(3, 100);
  const std::vector<int64_t> cycles = ExpectedCycles(list, Method::kQuad);
  for (const Core core : kBothCores) {
    for (const int quantum_us : {0, 1, 1000}) {
      const Observed observed =
          Observe({core, {}, sc_time(quantum_us, sc_core::SC_US), {}}, list, Method::kQuad);
      ASSERT_EQ(observed.arrivals.size(), cycles.size());
      for (size_t i = 0; i < cycles.size(); ++i) {
        ASSERT_EQ(observed.arrivals[i], observed.start + kPeriod * static_cast<double>(cycles[i]))
            << "span " << i << ", quantum " << quantum_us << " us";
      }
      const sc_time end = observed.start + kPeriod * static_cast<double>(cycles.back());
      EXPECT_GE(observed.idle, end);
      EXPECT_LE(observed.idle, end + 3 * kPeriod);
    }
  }
}

// A slow memory delays the end of the frame by one access and no burst.
TEST(TlmTiming, MemoryLatencyDelaysOnlyTheEnd) {
  const TriangleList list = tb::RandomTriangles(3, 20);
  const sc_time latency(1, sc_core::SC_US);
  const Observed fast = Observe({}, list, Method::kQuad);
  const Observed slow = Observe({Core::kModel, {}, {}, latency}, list, Method::kQuad);
  EXPECT_EQ(slow.arrivals, fast.arrivals);
  EXPECT_GE(slow.idle, slow.arrivals.back() + latency);
  EXPECT_LE(slow.idle, slow.arrivals.back() + latency + 3 * kPeriod);
}

}  // namespace
}  // namespace shading::test
