// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/aniso_footprint.h"

#include <algorithm>

namespace shading {
namespace {

Quantity SaturatedSum(Quantity value, int64_t offset) {
  constexpr int64_t kLimit = int64_t{1} << (Quantity::kWidth - 1);
  return Quantity::FromRaw(std::clamp(value.raw() + offset, -kLimit, kLimit - 1));
}

}  // namespace

AnisoFootprint::AnisoFootprint(const Footprint& footprint, const Margins& first, int lane,
                               int lanes)
    : footprint_(footprint) {
  for (size_t c = 0; c < 3; ++c) {
    const int64_t dx = footprint.margin_dx[c].raw();
    margin_[c] = Margin::Wrap(first[c].raw() + lane * dx);
    step_[c] = Margin::Wrap(lanes * dx);
  }
}

bool AnisoFootprint::IsInside(const Margins& offset, bool negative) const {
  for (size_t c = 0; c < 3; ++c) {
    const int64_t by = negative ? -offset[c].raw() : offset[c].raw();
    if (Margin::Wrap(margin_[c].raw() + by).raw() < 0) return false;
  }
  return true;
}

FootprintSample AnisoFootprint::Next(int i, const std::array<Quantity, 3>& centre) {
  const FootprintPattern pattern = footprint_.pattern;
  const int turn = i - HasCentre(pattern);
  FootprintOffset offset;  // of the centre
  if (turn >= 0) offset = footprint_.offset[static_cast<size_t>(turn / 2)];
  const bool negative = turn % 2 == 1;

  FootprintSample sample;
  sample.live = IsInside(offset.margin, negative);
  sample.weight = i == 0 && pattern == FootprintPattern::kEight ? 2 : 1;
  any_live_ = sample.live || (any_live_ && i > 0);
  const bool falls_back = i + 1 == SampleCount(pattern) && !any_live_;
  sample.live |= falls_back;
  taken_ += sample.live;
  for (size_t c = 0; c < 3; ++c) {
    const int64_t by = falls_back ? 0 : offset.normal[c].raw();
    sample.normal[c] = SaturatedSum(centre[c], negative ? -by : by);
  }
  return sample;
}

void AnisoFootprint::Step() {
  for (size_t c = 0; c < 3; ++c) margin_[c] = Margin::Wrap(margin_[c].raw() + step_[c].raw());
}

}  // namespace shading
