// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/footprint/footprint_types.h"
#include "model/raster/triangle_setup.h"
#include "model/shading_types.h"
#include "model/triangle_packet.h"
#include "model/unit_contract.h"

namespace shading {

// Which triangle a sample is read from.
enum class FootprintForm {
  kSeamless,  // the triangle itself, its barycentrics signed
  kPaper      // paper 001: the enlarged triangle; what lies outside is excluded
};

// Weight of each vertex in a perspective picture, 1 over its distance, the largest 1: U1.22. All 1
// without perspective.
using VertexWeights = std::array<int64_t, 3>;
inline constexpr VertexWeights kNoPerspective = {1 << 22, 1 << 22, 1 << 22};

// The footprint of the pixels of a triangle, paper 001. On the screen it is a disc of the pixel's
// second moments, and what is interpolated is affine there: with weights w_i = 1 / distance the
// direction of sum lambda_i w_i N_i is that of the interpolation on the surface, so that offsets
// are constants of the triangle with perspective too.
//
//   O_k = r (M, m) p_k,  M, m = J along the axes of J'J       p_k: rules of the disc, see the page
//   samples by the turn: T = n |M|^2, t = n |m|^2, errors 255 (T + t) / 8, (16 t + T^2) / 128,
//     (32 T t + T^3) / 3072 codes of 1, 2, 4 samples, n the shininess
//   kPaper: N_B' = 2 (N_A.N_B) N_B - N_A, (5); N = sum lambda_i P_i, 8 P_A = 4 N_A' + N_B' + 2 N_C'
//     (the enlarged triangle's own interpolation), a' = 4 a + 2 b + c >= 0, (3), (4)
class FootprintSetup {
 public:
  static constexpr UnitContract kContract = {
      "footprint_setup",
      "footprint",
      0,
      0,
      "normals S1.22, weights U1.22, edge functions",
      "vertices S1.22, offsets S1.38, barycentrics S3.28",
      0.5,
      "roots of the samples' second moments, in ulp of S1.28; edges of 3 pixels and more"};

  struct Options {
    FootprintForm form = FootprintForm::kSeamless;
    Tolerance tolerance = Tolerance::FromRaw(int64_t{1} << (Tolerance::kFraction - 1));
    FootprintPattern least = FootprintPattern::kCentre, most = FootprintPattern::kEight;
  };

  struct Result {
    std::array<Vector3, 3> vertex;  // what is interpolated, by vertex of the packet
    Footprint footprint;
    std::array<Plane, 3> margin;  // counted from pixel (x, y), 44 fraction bits; kPaper
    bool subdivide = false;       // kPaper: enlarged normals more than 90 degrees apart

    // At the first pixel of a span, `columns` and `rows` from (x, y).
    Margins At(int columns, int rows) const;
  };
  static constexpr int kMarginPlaneFraction = 44;

  explicit FootprintSetup(const Options& options) : options_(options) {}

  // 1 - slope z of each vertex, over the largest, rounded to nearest.
  static VertexWeights WeightsOf(const std::array<VertexDepth, 3>& z, DepthSlope slope);

  Result Of(const TrianglePacket& packet, const TriangleGeometry& geometry,
            const Material& material, int x, int y,
            const VertexWeights& weights = kNoPerspective) const;

  // Changes from the centre to the end of an axis, raw: 38 and 28 fraction bits.
  struct Axis {
    std::array<int64_t, 3> normal, margin;
  };
  // Offsets of a pattern from those along the axes, rounded to nearest; normals saturate.
  static std::array<FootprintOffset, 3> Offsets(FootprintPattern pattern, const Axis& major,
                                                const Axis& minor);
  // The smallest pattern that keeps a full-scale highlight within the tolerance, from the squares
  // of the turns along the axes times the shininess, 20 fraction bits.
  static FootprintPattern PatternFor(int64_t major, int64_t minor, Tolerance tolerance);

 private:
  FootprintPattern Pattern(const std::array<int64_t, 3>& major, const std::array<int64_t, 3>& minor,
                           const std::array<int64_t, 3>& sum, const Material& material) const;

  Options options_;
};

}  // namespace shading
