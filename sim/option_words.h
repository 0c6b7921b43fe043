// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/shading_types.h"

namespace shading::sim {

// What the parser fills as text and Finish() turns into Options.
struct Words {
  std::string method = "quad", methods = "all", size, rotate, light, camera = "ortho";
  std::string lighting = "blinn", cull = "back", engine = "rtl";
  int lanes = 1;
  double tolerance = 0.5;
  std::string subdivide = "none";
};

// Throws CLI::ValidationError.
[[noreturn]] void Refuse(const std::string& what);

// "A,B,.." or "AxB": exactly `count` numbers; `option` is named when it is refused.
std::vector<double> Numbers(const std::string& option, const std::string& text, char separator,
                            size_t count);

// A method, or all.
std::vector<Method> Methods(const std::string& word);

// What is wrong with a --seed, or "".
std::string SeedFault(const std::string& text);

// Refuses what is no command, and none.
void CheckCommand(int argc, char** argv);

// What to type for help on the command that is given, or on all of them.
std::string HelpOf(int argc, char** argv);

// Several with commas between: each once, in the order of shadesim list.
std::vector<Method> MethodList(const std::string& words);

}  // namespace shading::sim
