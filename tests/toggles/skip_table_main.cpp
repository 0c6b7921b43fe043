// SPDX-License-Identifier: Apache-2.0
//
// Prints what each skip of auto saves: skip_table [SCENE [SIZE]].
#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "tests/toggles/skip.h"
#include "tests/toggles/toggle_run.h"
#include "tests/toggles/toggle_scene.h"

namespace shading::test {
namespace {

// Cycles and toggles a pixel of the plain frame: back faces, too, are drawn for the same picture.
void PrintRow(Skip off, const TracedFrame& frame, const TracedFrame& plain, int64_t pixels) {
  const auto each = [&](int64_t count) {
    return static_cast<double>(count) / static_cast<double>(pixels);
  };
  const auto more = [](int64_t with, int64_t without) {
    return 100 * (static_cast<double>(without) / static_cast<double>(with) - 1);
  };
  fmt::print("| {} | {} | {:+} | {:+.1f} % | {:.1f} | {:+.1f} | {:+.1f} % |\n",
             kSkipNames[static_cast<size_t>(off)], frame.cycles, frame.cycles - plain.cycles,
             more(plain.cycles, frame.cycles), each(frame.toggles()),
             each(frame.toggles() - plain.toggles()), more(plain.toggles(), frame.toggles()));
}

void Print(const std::string& scene, const TriangleList& list) {
  const FrameWork work = WorkOf(list, Method::kAuto);
  const TracedFrame by_auto = Trace(work);
  const FrameWork same = WorkWithout(list, kOneCode, Skip::kNone);
  const TracedFrame plain = Trace(same);
  if (plain.cycles != by_auto.cycles) throw std::runtime_error("not the cycles of auto");
  const Counters& c = by_auto.counters;
  fmt::print("{}, {} x {}, tolerance 1 LSB: {} pixels, {} spans\n", scene, list.frame.width,
             list.frame.height, work.pixels, work.spans.size());
  fmt::print("back faces {}, no pixel {}; triangles only ambient {}\n", work.skipped.back_facing,
             work.skipped.total() - work.skipped.back_facing, c.ambient);
  fmt::print("spans of one colour {}, no highlight {}, not normalised {}; black channels {}\n\n",
             c.constant, c.dark, c.unnormalised, c.black);
  fmt::print("| not left out | cycles | more | | toggles a pixel | more | |\n");
  fmt::print("|---|--:|--:|--:|--:|--:|--:|\n");
  for (const Skip off : kSkips) {
    const TracedFrame frame = off == Skip::kNone ? plain : Trace(WorkWithout(list, kOneCode, off));
    PrintRow(off, frame, plain, work.pixels);
  }
  fmt::print("\nauto itself, with the ranges and limits of the scene: {:.1f} toggles a pixel\n",
             static_cast<double>(by_auto.toggles()) / static_cast<double>(work.pixels));
}

}  // namespace
}  // namespace shading::test

int main(int argc, char** argv) {
  return shading::test::PrintScene("skip_table", argc, argv, shading::test::Print);
}
