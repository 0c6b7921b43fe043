// SPDX-License-Identifier: Apache-2.0
#include "sim/report/label_placer.h"

#include <algorithm>
#include <cmath>

namespace shading::report {
namespace {
constexpr double kCharacter = 6.4;  // mean width at 11 pixels
constexpr double kNear = 16;        // pixels; farther labels get a line
}  // namespace

double LabelPlacer::WidthOf(const std::string& label) {
  return kCharacter * static_cast<double>(label.size());
}

bool LabelPlacer::Free(const Box& box) const {
  if (box.left < frame_.left || box.right > frame_.right) return false;
  if (box.top < frame_.top || box.bottom > frame_.bottom) return false;
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Box& other) { return box.Overlaps(other); });
}

LabelPlacer::Place LabelPlacer::Find(double x, double y, const std::string& label) {
  const double width = WidthOf(label);
  Place place;
  for (const double distance : {6.0, 12.0, 20.0, 30.0, 42.0, 56.0, 72.0, 90.0}) {
    for (int direction = 0; direction < 16; ++direction) {
      const double angle = direction * 3.14159265358979 / 8;
      const double dx = std::cos(angle), dy = -std::sin(angle);
      const double centre_x = x + dx * (distance + width / 2);
      const double centre_y = y + dy * (distance + kHeight / 2);
      const Box box = {centre_x - width / 2, centre_y - kHeight / 2, centre_x + width / 2,
                       centre_y + kHeight / 2};
      if (!Free(box)) continue;
      taken_.push_back(box);
      place = {box.left, box.bottom - 3, true, distance > kNear, 0, 0};
      place.line_x = std::clamp(x, box.left, box.right);
      place.line_y = std::clamp(y, box.top, box.bottom);
      return place;
    }
  }
  place.x = std::min(x + 6, frame_.right - width);
  place.y = y + 4;
  return place;
}

}  // namespace shading::report
