// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace shading {

// What a unit promises. The RTL, the model, the unit test and the doc page all carry these
// numbers; the unit test compares RTL and model, tests/repo compares the page.
struct UnitContract {
  const char* name;
  const char* group;
  int latency_cycles;     // input accepted to first output valid; 0 for a unit without a clock
  int interval_cycles;    // initiation interval: cycles between two accepted inputs
  const char* input;      // formats
  const char* output;     // formats
  double max_error_ulp;   // model to ideal; of the output format, or of what `valid_for` names
  const char* valid_for;  // range of inputs for which the error bound holds
};

}  // namespace shading
