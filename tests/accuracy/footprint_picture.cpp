// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tests/accuracy/footprint_flicker.h"

namespace shading::accuracy {
namespace {

constexpr std::array<Drawing, 4> kShown = {kCentreOnly, kFootprint, kEllipseMean, kSupersampled};
constexpr int kCell = 320;  // pixels that the width of a scene may take
constexpr int kGap = 8;
constexpr std::array<uint8_t, 3> kGround = {48, 48, 48};

struct Box {
  int left, top, width, height;
};

Box Covered(const sim::Image& image) {
  Box box = {image.width, image.height, 0, 0};
  int right = 0, bottom = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!image.covered[static_cast<size_t>(y * image.width + x)]) continue;
      box.left = std::min(box.left, x);
      box.top = std::min(box.top, y);
      right = std::max(right, x + 1);
      bottom = std::max(bottom, y + 1);
    }
  }
  box.width = right - box.left;
  box.height = bottom - box.top;
  return box;
}

// The covered part of `from`, enlarged, into `to` with its corner at (left, top).
void Enlarge(const sim::Image& from, const Box& box, int left, int top, sim::Image* to) {
  const int zoom = kCell / box.width;
  for (int y = 0; y < zoom * box.height; ++y) {
    for (int x = 0; x < zoom * box.width; ++x) {
      const auto source =
          static_cast<size_t>((box.top + y / zoom) * from.width + box.left + x / zoom);
      if (!from.covered[source]) continue;
      to->code[static_cast<size_t>((top + y) * to->width + left + x)] = from.code[source];
    }
  }
}

}  // namespace

sim::Image FlickerPicture(const std::vector<Turning>& scenes, int frame) {
  std::vector<Drawn> rows;
  std::vector<Box> boxes;
  int height = kGap;
  for (const Turning& scene : scenes) {
    for (const int k : {frame, frame + 1}) {
      rows.push_back(DrawFrame(scene, k));
      boxes.push_back(Covered(rows.back()[kCentreOnly]));
      height += boxes.back().height * (kCell / boxes.back().width) + kGap;
    }
  }
  const int columns = static_cast<int>(kShown.size());
  sim::Image picture{columns * (kCell + kGap) + kGap, height, {}, {}};
  picture.code.assign(static_cast<size_t>(picture.width * height), kGround);
  picture.covered.assign(picture.code.size(), 1);
  int top = kGap;
  for (size_t row = 0; row < rows.size(); ++row) {
    for (int column = 0; column < columns; ++column) {
      Enlarge(rows[row][kShown[static_cast<size_t>(column)]], boxes[row],
              kGap + column * (kCell + kGap), top, &picture);
    }
    top += boxes[row].height * (kCell / boxes[row].width) + kGap;
  }
  return picture;
}

}  // namespace shading::accuracy
