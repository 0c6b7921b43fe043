// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <random>

#include "model/fixed/wide_integer.h"
#include "model/shading_types.h"
#include "tb/dut/span_setup_dut.h"
#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {

// I(x, y) in raw S9.26 units, x and y from the triangle's origin: the expanded polynomial in wide
// integers, so that no register wraps.
inline Int128 Polynomial(const Surface& s, Method method, int x, int y) {
  if (method == Method::kFlat) return s.f.raw();
  const Int128 wide_x = x, wide_y = y;
  const Int128 plane = s.d.raw() * wide_x + s.e.raw() * wide_y + s.f.raw();
  if (method == Method::kGouraud) return plane;
  return s.a.raw() * wide_x * wide_x + s.b.raw() * wide_y * wide_y + s.c.raw() * wide_x * wide_y +
         plane;
}

// A coordinate on the screen: its ends are frequent, so offsets reach -4095 and 4095.
inline int RandomCoord(std::mt19937& random) {
  switch (random() % 4) {
    case 0: return 0;
    case 1: return kMaxScreen - 1;
    default: return static_cast<int>(random() % kMaxScreen);
  }
}

inline DepthAcc RandomDepth(std::mt19937& random) {
  return DepthAcc::Wrap(static_cast<int64_t>(static_cast<uint64_t>(random()) << 32 | random()));
}

inline SpanCommand RandomSpan(std::mt19937& random) {
  SpanCommand span;
  span.x = RandomCoord(random);
  span.y = RandomCoord(random);
  span.length = std::min(RandomLength(random), kMaxScreen - span.x);
  span.z = RandomDepth(random);
  return span;
}

// Unrelated coefficients of any magnitude: sums and products wrap, and so do most results.
inline Surface RandomSurface(std::mt19937& random) {
  Surface s;
  for (IntensityAcc* k : {&s.a, &s.b, &s.c, &s.d, &s.e, &s.f}) *k = RandomAcc(random);
  return s;
}

// A surface whose value at (x, y) lies in S9.26 although its terms are up to 8000 times larger: D
// and E nearly cancel the second order there.
inline Surface CancellingSurface(int x, int y, std::mt19937& random) {
  const auto raw = [&](int64_t limit) {
    return static_cast<int64_t>(random() % static_cast<uint32_t>(2 * limit + 1)) - limit;
  };
  const auto rest = [&](int offset) {
    return raw(100 * kOneCode / 8) * 8 / (std::abs(offset) + 1);
  };
  const int64_t a = raw(kOneCode / 20), b = raw(kOneCode / 20), c = raw(kOneCode / 20);
  Surface s;
  s.a = IntensityAcc::FromRaw(a);
  s.b = IntensityAcc::FromRaw(b);
  s.c = IntensityAcc::FromRaw(c);
  s.d = IntensityAcc::FromRaw(-(a * x + c * y) + rest(x));
  s.e = IntensityAcc::FromRaw(-b * y + rest(y));
  s.f = IntensityAcc::FromRaw(128 * kOneCode);
  return s;
}

// Triangles of one to six spans, half of them of one.
inline tb::SpanSetupDut::Work RandomWork(Method method, int triangles, std::mt19937& random) {
  tb::SpanSetupDut::Work work;
  work.method = method;
  for (int i = 0; i < triangles; ++i) {
    TriangleState triangle;
    triangle.origin_x = RandomCoord(random);
    triangle.origin_y = RandomCoord(random);
    triangle.dz_dx = RandomDepth(random);
    const int spans = random() % 2 ? 1 : 1 + static_cast<int>(random() % 6);
    // Downwards, the first at the origin's row; most of the others one row below the one before.
    for (int k = 0, y = triangle.origin_y; k < spans; ++k) {
      work.spans.push_back(RandomSpan(random));
      if (k > 0)
        y = std::min(y + (random() % 4 ? 1 : 2 + static_cast<int>(random() % 9)), kMaxScreen - 1);
      work.spans.back().y = y;
      work.spans.back().last = k + 1 == spans || y == kMaxScreen - 1;
      if (work.spans.back().last) break;
    }
    const int x = work.spans.back().x - triangle.origin_x;
    const int y = work.spans.back().y - triangle.origin_y;
    for (Surface& surface : triangle.surface) {
      surface = random() % 2 ? RandomSurface(random) : CancellingSurface(x, y, random);
    }
    for (Surface& surface : triangle.specular) surface = RandomSurface(random);
    for (IntensityAcc& ambient : triangle.ambient) ambient = RandomAcc(random);
    for (CosineSurface& surface : triangle.curve) {
      for (CosineAcc* k :
           {&surface.a, &surface.b, &surface.c, &surface.d, &surface.e, &surface.f}) {
        *k = CosineAcc::Wrap(RandomDepth(random).raw() << (random() % 7));
      }
    }
    triangle.material = static_cast<int>(random() % 256);
    work.triangles.push_back(triangle);
  }
  return work;
}

}  // namespace shading
