// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/normal/sphere_arc.h"
#include "model/raster/triangle_setup.h"

namespace shading {

// Unit normals where the centre line of a row cuts one edge of a triangle: the slerp from the upper
// to the lower vertex, stepped by the scaled recurrence of paper 000 (7),
//
//   N(t+1) = N(t) + D(t),   D(t) = D(t-1) - kappa N(t),   kappa = 4 sin^2(phi / 2),
//
// one step a row, phi = psi / height. It starts, exactly on the arc, at the edge's first row on the
// screen, so that both triangles of an edge get the same bits. In S3.60: after 4095 steps within
// 2^-36 of the arc (t^2 / 2 roundings of 2^-60).
class EdgeNormals {
 public:
  EdgeNormals() = default;
  // Vertices in raw S13.8 rows, top < bottom; no row before `first_row` will be asked for.
  EdgeNormals(int64_t top, int64_t bottom, const ArcVector& top_normal,
              const ArcVector& bottom_normal, int first_row);

  // Rows never decrease, and their centres lie on the edge.
  const ArcVector& At(int row);

 private:
  int row_ = 0;
  ArcVector normal_ = {}, difference_ = {};
  int64_t kappa_ = 0;  // S3.60
};

// The normals at both ends of the rows of a triangle: where its left and right edge are cut.
class RowEnds {
 public:
  RowEnds(const TriangleGeometry& geometry, const TrianglePacket& packet);

  // The arc along a row whose centre line cuts the triangle, rows in increasing order. Weight()
  // then holds for that row.
  SphereArc Row(int row);
  // (x - x_l) / (x_r - x_l) at the centre of pixel x, clamped to U0.60; 0 where x_l = x_r.
  int64_t Weight(int x) const;

 private:
  struct Side {
    Edge edge;
    EdgeNormals normals;
    int64_t bottom = 0;  // raw S13.8
  };
  Side MakeSide(const TriangleGeometry& geometry, const TrianglePacket& packet, size_t a, size_t b,
                const std::array<ArcVector, 3>& normal) const;

  int box_x_, box_y_;
  Side long_, upper_, lower_;  // from top to bottom; to and from the middle vertex
  bool has_upper_;             // it is not horizontal
  bool long_is_left_;
  const Edge* left_ = nullptr;
  const Edge* right_ = nullptr;
  int64_t left_at_ = 0, right_at_ = 0;  // their edge functions at the row's pixel box_x_
};

}  // namespace shading
