// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tb/dut/pins.h"

namespace shading::tb {

// The triangle and the span port of a unit: commands in order, each on offer until it is taken. Top
// is a Verilated class.
template <typename Top>
class CommandPorts {
 public:
  explicit CommandPorts(Top* top) : top_(*top) {}

  void Clear() {
    top_.triangle_valid_i = 0;
    top_.span_valid_i = 0;
  }

  // Offers the next command of each kind where its port is idle and its source willing.
  void Offer(const std::vector<TriangleState>& triangles, size_t next_triangle,
             bool triangle_willing, const std::vector<SpanCommand>& spans, size_t next_span,
             bool span_willing) {
    if (!top_.triangle_valid_i && next_triangle < triangles.size() && triangle_willing) {
      DriveTriangle(triangles[next_triangle], top_.triangle_i);
      top_.triangle_valid_i = 1;
    }
    if (!top_.span_valid_i && next_span < spans.size() && span_willing) {
      DriveSpan(spans[next_span], top_.span_i);
      top_.span_valid_i = 1;
    }
  }

  // What the coming clock edge will take.
  void Observe() {
    take_triangle_ = top_.triangle_valid_i && top_.triangle_ready_o;
    take_span_ = top_.span_valid_i && top_.span_ready_o;
  }
  bool take_triangle() const { return take_triangle_; }
  bool take_span() const { return take_span_; }

  // Taken commands leave their ports; the payload turns into noise.
  void Withdraw() {
    if (take_triangle_) {
      top_.triangle_valid_i = 0;
      for (int word = 0; word < kTriangleWords; ++word) {
        top_.triangle_i[word] = ~top_.triangle_i[word];
      }
    }
    if (take_span_) {
      top_.span_valid_i = 0;
      for (int word = 0; word < kSpanWords; ++word) top_.span_i[word] = ~top_.span_i[word];
    }
  }

 private:
  Top& top_;
  bool take_triangle_ = false, take_span_ = false;
};

}  // namespace shading::tb
