// SPDX-License-Identifier: Apache-2.0
#include "tests/toggles/toggle_run.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "model/raster/front_end.h"
#include "tb/rtl_shading_unit.h"

namespace shading::test {
namespace {

class NoPixels : public tb::PixelConsumer {
 public:
  bool Consume(const TimedPixel*, size_t) override { return true; }
};

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

tb::Toggles TogglesOf(const TriangleList& list, Method method, Tolerance tolerance) {
  FrontEndOptions options;
  options.tolerance = tolerance;
  const FrameWork work = FrontEnd::Run(list, method, options);
  const ScratchFile file;
  tb::Observation observation;
  observation.trace = file.name();
  NoPixels nobody;
  const FlowPattern always = FlowPattern::Always();
  const tb::RtlResult result =
      tb::RtlShadingUnit::CreateAll()->Run(work, always, always, &nobody, observation);
  if (!result.finished) throw std::runtime_error(result.failure);
  return tb::CountToggles(file.name());
}

}  // namespace shading::test
