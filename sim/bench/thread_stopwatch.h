// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

namespace shading::sim {

// Processor time of the calling thread: waiting for a processor does not count.
class ThreadStopwatch {
 public:
  double Seconds() const { return Now() - start_; }

 private:
  static double Now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = Now();
};

}  // namespace shading::sim
