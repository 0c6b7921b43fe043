// SPDX-License-Identifier: Apache-2.0
#include "model/raster/subdivision.h"

#include <cstdlib>
#include <optional>

#include "model/fixed/wide_integer.h"

namespace shading {
namespace {

struct Vertex {
  ScreenCoord x, y;
  VertexDepth z;
  Vector3 n;
};

Vertex VertexOf(const TrianglePacket& packet, size_t i) {
  return {packet.x[i], packet.y[i], packet.z[i], packet.n[i]};
}

TrianglePacket Packet(const std::array<Vertex, 3>& vertices, int material) {
  TrianglePacket packet;
  for (size_t i = 0; i < 3; ++i) {
    packet.x[i] = vertices[i].x;
    packet.y[i] = vertices[i].y;
    packet.z[i] = vertices[i].z;
    packet.n[i] = vertices[i].n;
  }
  packet.material = material;
  return packet;
}

int64_t SquaredTurn(const Vector3& a, const Vector3& b) {
  int64_t square = 0;
  for (size_t c = 0; c < a.size(); ++c) {
    const int64_t difference = a[c].raw() - b[c].raw();
    square += difference * difference;
  }
  return square;
}

// (a + b) / |a + b|, nullopt where that is undefined.
std::optional<Vector3> MeanNormal(const Vector3& a, const Vector3& b) {
  constexpr int64_t kLeastSquare = int64_t{1} << (2 * NormalComponent::kFraction - 10);
  std::array<int64_t, 3> sum;
  int64_t square = 0;
  for (size_t c = 0; c < sum.size(); ++c) {
    sum[c] = a[c].raw() + b[c].raw();
    square += sum[c] * sum[c];
  }
  if (square < kLeastSquare) return std::nullopt;
  constexpr int kGuard = 30;
  const auto length =
      static_cast<int64_t>(IntegerRoot(static_cast<Uint128>(square) << (2 * kGuard)));
  Vector3 mean;
  for (size_t c = 0; c < sum.size(); ++c) {
    const Int128 scaled = static_cast<Int128>(sum[c]) * (int64_t{1} << NormalComponent::kFraction) *
                          (int64_t{1} << kGuard);
    mean[c] = NormalComponent::FromRaw(RoundDivide(scaled, length));
  }
  return mean;
}

}  // namespace

bool Subdivision::TurnsTooFar(const TrianglePacket& packet) const {
  for (size_t k = 0; k < 3; ++k) {
    if (SquaredTurn(packet.n[k], packet.n[(k + 1) % 3]) > limit_) return true;
  }
  return false;
}

void Subdivision::Split(const TrianglePacket& packet, int depth,
                        std::vector<TrianglePacket>* pieces) const {
  const std::array<Vertex, 3> corner = {VertexOf(packet, 0), VertexOf(packet, 1),
                                        VertexOf(packet, 2)};
  // Of the edge from corner k to corner k + 1, where it is to be halved.
  std::array<std::optional<Vertex>, 3> middle;
  size_t halved = 0, last = 0;
  for (size_t k = 0; k < 3 && depth < kDeepest; ++k) {
    const Vertex& a = corner[k];
    const Vertex& b = corner[(k + 1) % 3];
    const bool tiny = std::abs(a.x.raw() - b.x.raw()) < 2 && std::abs(a.y.raw() - b.y.raw()) < 2;
    if (tiny || SquaredTurn(a.n, b.n) <= limit_) continue;
    const auto normal = MeanNormal(a.n, b.n);
    if (!normal) continue;
    middle[k] = Vertex{ScreenCoord::FromRaw((a.x.raw() + b.x.raw()) >> 1),
                       ScreenCoord::FromRaw((a.y.raw() + b.y.raw()) >> 1),
                       VertexDepth::FromRaw((a.z.raw() + b.z.raw()) >> 1), *normal};
    ++halved;
    last = k;
  }
  const auto piece = [&](const Vertex& a, const Vertex& b, const Vertex& c) {
    Split(Packet({a, b, c}, packet.material), depth + 1, pieces);
  };
  if (halved == 0) {
    pieces->push_back(packet);
  } else if (halved == 1) {
    const size_t j = (last + 1) % 3, k = (last + 2) % 3;
    piece(corner[last], *middle[last], corner[k]);
    piece(*middle[last], corner[j], corner[k]);
  } else if (halved == 2) {
    // Edge i is whole: a triangle at the corner between the halved ones, and a quadrilateral.
    const size_t i = !middle[0] ? 0 : !middle[1] ? 1 : 2, j = (i + 1) % 3, k = (i + 2) % 3;
    piece(*middle[j], corner[k], *middle[k]);
    piece(corner[i], corner[j], *middle[j]);
    piece(corner[i], *middle[j], *middle[k]);
  } else {
    for (size_t i = 0; i < 3; ++i) piece(corner[i], *middle[i], *middle[(i + 2) % 3]);
    piece(*middle[0], *middle[1], *middle[2]);
  }
}

}  // namespace shading
