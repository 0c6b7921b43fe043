// SPDX-License-Identifier: Apache-2.0
#include "tests/toggles/toggle_run.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "Vshading_unit_toggles.h"
#include "Vshading_unit_toggles___024root.h"
#include "model/raster/front_end.h"
#include "tb/dut/shading_unit_dut.h"
#include "tb/scoreboard/scoreboard.h"

namespace shading::test {
namespace {

// A waveform that is gone when it has been read.
class ScratchFile {
 public:
  ScratchFile()
      : path_(std::filesystem::temp_directory_path() /
              ("shadesim_toggles_" + std::to_string(getpid()) + ".fst")) {}
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    std::filesystem::remove(path_.string() + ".gtkw", ignored);
    std::filesystem::remove(path_.replace_extension(".gtkw"), ignored);
  }
  std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace

FrameWork WorkOf(const TriangleList& list, Method method, Tolerance tolerance) {
  FrontEndOptions options;
  options.tolerance = tolerance;
  return FrontEnd::Run(list, method, options);
}

int64_t TracedFrame::toggles() const {
  int64_t sum = 0;
  for (const tb::SignalToggles& signal : signals) sum += signal.toggles;
  return sum;
}

TracedFrame Trace(const FrameWork& work) {
  const ScratchFile file;
  tb::Observation observation;
  observation.trace = file.name();
  const FlowPattern always = FlowPattern::Always();
  tb::Scoreboard scoreboard(work, 1, always, always);
  const tb::RtlResult result = tb::ShadingUnitDut<Vshading_unit_toggles, 1>().Run(
      work, always, always, &scoreboard, observation);
  if (!result.finished) throw std::runtime_error(result.failure);
  if (!scoreboard.Finish(result).Good()) throw std::runtime_error("RTL and model differ");
  return {tb::CountToggles(file.name()), result.cycles,
          static_cast<int64_t>(std::filesystem::file_size(file.name())), result.counters};
}

}  // namespace shading::test
