// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "sim/commands/commands.h"
#include "sim/option_checks.h"
#include "sim/option_words.h"
#include "sim/options.h"

namespace {

constexpr int kBadInput = 2;

int Run(const shading::sim::Options& options) {
  switch (options.command) {
    case shading::sim::Command::kRender: return shading::sim::Render(options);
    case shading::sim::Command::kVerify: return shading::sim::Verify(options);
    case shading::sim::Command::kCycles: return shading::sim::Cycles(options);
    case shading::sim::Command::kBench: return shading::sim::RunBench(options);
    case shading::sim::Command::kStress: return shading::sim::Stress(options);
    case shading::sim::Command::kList: return shading::sim::List(options);
  }
  return kBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto options = shading::sim::ParseOptions(argc, argv);
    if (!options) return 0;
    shading::sim::CheckOutputs(*options);
    const int status = Run(*options);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    fmt::print(stderr, "shadesim: the output could not be written; make room for it\n");
  } catch (const CLI::Error& error) {
    fmt::print(stderr, "shadesim: {}; see {}\n", error.what(), shading::sim::HelpOf(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "shadesim: {}\n", error.what());
  }
  return kBadInput;
}
