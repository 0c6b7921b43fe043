// SPDX-License-Identifier: Apache-2.0
#include "sim/report/scale.h"

#include <algorithm>
#include <cmath>

namespace shading::report {
namespace {
constexpr double kMargin = 0.06;  // of the range, on both sides
}

Scale::Scale(double low, double high, bool logarithmic, double from, double to)
    : logarithmic_(logarithmic), from_(from), to_(to) {
  if (logarithmic) {
    low = std::log10(low);
    high = std::log10(high);
  }
  const double least = logarithmic ? 0.3 : std::max(1e-9, std::abs(high) * 0.1);
  const double middle = (low + high) / 2, half = std::max(high - low, least) / 2;
  low_ = middle - half * (1 + 2 * kMargin);
  high_ = middle + half * (1 + 2 * kMargin);
  if (!logarithmic && low >= 0) low_ = std::max(low_, 0.0);
}

double Scale::operator()(double value) const {
  const double place = logarithmic_ ? std::log10(value) : value;
  return from_ + (place - low_) / (high_ - low_) * (to_ - from_);
}

std::vector<double> Scale::Ticks(int most) const {
  return logarithmic_ ? LogTicks(most) : LinearTicks(most);
}

std::vector<double> Scale::LogTicks(int most) const {
  const std::vector<std::vector<double>> digits = {
      {1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 3, 5, 7}, {1, 2, 5}, {1, 3}, {1}};
  std::vector<double> ticks;
  for (const std::vector<double>& set : digits) {
    ticks.clear();
    for (int decade = static_cast<int>(std::floor(low_)); decade <= std::ceil(high_); ++decade) {
      for (const double digit : set) {
        const double place = decade + std::log10(digit);
        if (place >= low_ && place <= high_) ticks.push_back(digit * std::pow(10, decade));
      }
    }
    if (static_cast<int>(ticks.size()) <= most) return ticks;
  }
  const size_t step = (ticks.size() + static_cast<size_t>(most) - 1) / static_cast<size_t>(most);
  std::vector<double> fewer;
  for (size_t i = 0; i < ticks.size(); i += step) fewer.push_back(ticks[i]);
  return fewer;
}

std::vector<double> Scale::LinearTicks(int most) const {
  double step = std::pow(10, std::floor(std::log10((high_ - low_) / most)));
  for (const double factor : {2.0, 2.5, 2.0}) {  // 2, 5, 10
    if ((high_ - low_) / step <= most) break;
    step *= factor;
  }
  std::vector<double> ticks;
  for (double k = std::ceil(low_ / step); k * step <= high_; ++k) ticks.push_back(k * step);
  return ticks;
}

}  // namespace shading::report
