// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tests/accuracy/spread_table.h"

namespace shading::accuracy {
namespace {

struct Expected {
  Method method;
  int shininess;
  std::array<double, 3> limits;  // degrees, of kLimitCodes
  std::array<double, 7> errors;  // codes, of kErrorSpreads
};
constexpr std::array<double, 7> kErrorSpreads = {5, 10, 20, 30, 45, 60, 90};
constexpr std::array<Expected, 11> kExpected = {{
    {Method::kGouraud, 1, {6.2, 8.8, 12.4}, {.32, 1.3, 5.2, 11.7, 26, 47, 108}},
    {Method::kGouraud, 8, {2.2, 3.1, 4.4}, {2.6, 10, 39, 80, 148, 205, 252}},
    {Method::kGouraud, 32, {1.1, 1.55, 2.2}, {10, 38, 123, 198, 247, 255, 255}},
    {Method::kGouraud, 128, {.55, .78, 1.1}, {38, 122, 237, 254, 255, 255, 255}},
    {Method::kQuad, 1, {24.5, 30.9, 39.0}, {.004, .034, .27, .92, 3.0, 7.2, 28}},
    {Method::kQuad, 8, {10.4, 13.1, 16.5}, {.055, .44, 3.6, 11.7, 36, 74, 189}},
    {Method::kQuad, 32, {5.3, 6.7, 8.4}, {.42, 3.3, 24, 65, 140, 203, 254}},
    // Its last two are of the surface as it is, not clamped to 255.
    {Method::kQuad, 128, {2.67, 3.36, 4.23}, {3.3, 23, 111, 193, 247, 260, 284}},
    {Method::kQuadCosine, 8, {18.9, 23.4, 28.9}, {.008, .068, .60, 2.3, 9.3, 29, 149}},
    {Method::kQuadCosine, 32, {14.5, 17.8, 21.8}, {.017, .15, 1.5, 6.6, 33, 98, 247}},
    {Method::kQuadCosine, 128, {10.9, 13.3, 15.8}, {.037, .37, 5.1, 25, 110, 219, 255}},
}};

// quad-split is quad, and so is quad-cosine in diffuse light.
const Expected* Find(Method method, int shininess) {
  const bool as_quad =
      method == Method::kQuadSplit || (method == Method::kQuadCosine && shininess == 1);
  const Method wanted = as_quad ? Method::kQuad : method;
  for (const Expected& row : kExpected) {
    if (row.method == wanted && row.shininess == shininess) return &row;
  }
  return nullptr;
}

template <size_t kCount>
double At(const std::array<double, kCount>& places, const std::array<double, kCount>& values,
          double place) {
  const auto found = std::find(places.begin(), places.end(), place);
  return found == places.end() ? 0 : values[static_cast<size_t>(found - places.begin())];
}

}  // namespace

double ExpectedError(Method method, int shininess, double degrees) {
  const Expected* row = Find(method, shininess);
  return row ? At(kErrorSpreads, row->errors, degrees) : 0;
}

double ExpectedLimit(Method method, int shininess, double codes) {
  const Expected* row = Find(method, shininess);
  return row ? At(kLimitCodes, row->limits, codes) : 0;
}

double ExpectedTerminator(Method method, double degrees) {
  return method == Method::kQuad ? At(kTerminatorSpreads, {2.1, 4.3, 13, 55}, degrees) : 0;
}

}  // namespace shading::accuracy
