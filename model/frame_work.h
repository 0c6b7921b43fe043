// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/choice/choice_types.h"
#include "model/light/light_types.h"
#include "model/shading_types.h"

namespace shading {

// Triangles that the front end drops, each for one reason.
struct SkipCounts {
  int64_t back_facing = 0;
  int64_t degenerate = 0;  // zero area
  int64_t off_screen = 0;  // bounding box outside the scissor
  int64_t empty = 0;       // covers no pixel centre

  int64_t total() const { return back_facing + degenerate + off_screen + empty; }
};

// What is shaded by one method.
struct MethodShare {
  int64_t triangles = 0, spans = 0, pixels = 0;
};

// One frame as it enters the shading unit: triangles in order, each followed by its spans.
struct FrameWork {
  Method method = Method::kFlat;
  Tolerance tolerance;              // quad-segment; adaptive methods: see limit of TriangleState
  LightState light;                 // methods that light every pixel, as the materials
  std::vector<Material> materials;  // at most kMaxMaterials
  std::vector<ChoiceLimit> limits;  // auto: of each material
  std::vector<TriangleState> triangles;
  std::vector<uint32_t> packet;  // of each triangle: its index in the triangle list
  std::vector<SpanCommand> spans;
  int64_t pixels = 0;
  std::array<MethodShare, kMethodCount> share;  // by method
  int64_t split_spans = 0;  // spans in two because their normals are over 90 degrees apart
  int64_t over_limit = 0;   // packets on the screen that turn too far for the tolerance
  int64_t pieces = 0;       // triangles that are drawn for them
  SkipCounts skipped;
};

// Calls on_triangle(index) before the first span of each triangle and on_span(span) for every span,
// until that returns false.
template <typename OnTriangle, typename OnSpan>
void ForEachSpan(const FrameWork& work, const OnTriangle& on_triangle, const OnSpan& on_span) {
  size_t triangle = 0;
  bool first = true;
  for (const SpanCommand& span : work.spans) {
    if (first) on_triangle(triangle++);
    first = span.last;
    if (!on_span(span)) return;
  }
}

}  // namespace shading
