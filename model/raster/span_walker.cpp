// SPDX-License-Identifier: Apache-2.0
#include "model/raster/span_walker.h"

#include <algorithm>

#include "model/fixed/wide_integer.h"

namespace shading {
namespace {

// The pixels of a row that one edge admits, stepped downwards.
class EdgeWalker {
 public:
  explicit EdgeWalker(const Edge& edge) {
    // w - 1 >= 0 excludes the pixels on an edge that is neither top nor left.
    const int64_t w = edge.w0 - (edge.top_left ? 0 : 1);
    if (edge.dx > 0) {
      side_ = Side::kLow;  // x >= ceil(-w / dx)
      Start(-w + edge.dx - 1, -edge.dy, edge.dx);
    } else if (edge.dx < 0) {
      side_ = Side::kHigh;  // x <= floor(w / -dx)
      Start(w, edge.dy, -edge.dx);
    } else {
      side_ = Side::kRow;  // the whole row or none of it
      Start(w, edge.dy, 1);
    }
  }

  void Clip(int64_t* low, int64_t* high) const {
    if (side_ == Side::kLow) *low = std::max(*low, quotient_);
    if (side_ == Side::kHigh) *high = std::min(*high, quotient_);
    if (side_ == Side::kRow && quotient_ < 0) *high = -1;
  }

  void NextRow() {
    quotient_ += quotient_step_;
    remainder_ += remainder_step_;
    if (remainder_ >= divisor_) {
      remainder_ -= divisor_;
      ++quotient_;
    }
  }

 private:
  enum class Side { kLow, kHigh, kRow };

  void Start(int64_t n, int64_t step, int64_t d) {
    divisor_ = d;
    quotient_ = FloorDivide(n, d);
    remainder_ = n - quotient_ * d;
    quotient_step_ = FloorDivide(step, d);
    remainder_step_ = step - quotient_step_ * d;
  }

  Side side_;
  int64_t divisor_, quotient_, remainder_, quotient_step_, remainder_step_;
};

}  // namespace

int64_t SpanWalker::Walk(const TriangleGeometry& geometry, const Plane& depth,
                         std::vector<SpanCommand>* spans) {
  std::array<EdgeWalker, 3> edges = {EdgeWalker(geometry.edge[0]), EdgeWalker(geometry.edge[1]),
                                     EdgeWalker(geometry.edge[2])};
  int64_t pixels = 0;
  for (int y = 0; y < geometry.rows; ++y) {
    int64_t low = 0, high = geometry.columns - 1;
    for (EdgeWalker& edge : edges) {
      edge.Clip(&low, &high);
      edge.NextRow();
    }
    if (low > high) continue;
    const int x = static_cast<int>(low);
    const int length = static_cast<int>(high - low + 1);
    spans->push_back({geometry.box_x + x, geometry.box_y + y, length,
                      DepthAcc::Wrap(static_cast<int64_t>(depth.At(x, y))), false});
    pixels += length;
  }
  if (pixels > 0) spans->back().last = true;
  return pixels;
}

}  // namespace shading
