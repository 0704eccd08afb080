// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "palpate/authoring/border_lines.h"
#include "palpate/authoring/feature_lines.h"
#include "palpate/authoring/source_surface.h"
#include "palpate/authoring/triangle_shape.h"

namespace palpate::authoring {

/// What stays of a surface while its triangles are improved.
struct Kept {
  FeatureLines lines;  ///< vertices slide along these; corners and edges of them stay
  bool sides = false;  ///< no vertex goes over to the other side of a thin part
};

/// What a mesh is drawn back onto.
struct Outline {
  const SurfaceMesh& surface;
  const SourceSurface& source;
  const Kept& kept;
  BorderLines borders;
};

/// A mesh whose vertices move, never further than its triangles stand.
class MovingVertices {
 public:
  MovingVertices(const Outline& outline, SurfaceMesh& mesh);

  /// Who is around whom; to be called after the triangles have changed.
  void find_neighbours();
  /// Every vertex a step towards the middle of its neighbours.
  void smooth();
  /// Each vertex of a triangle that is not good to the best place near by.
  void repair();

 private:
  struct Fan {
    double angle = std::numbers::pi;  ///< the smallest of the triangles around
    double length = 0.0;              ///< [m] mean distance to the neighbours
    Vec3 normal = Vec3::Zero();       ///< of unit length
  };

  Corners corners(int t, int moved, const Vec3& place) const;
  Fan measure(int v, const Vec3& place) const;
  Vec3 find_way(int v) const;
  Mat3 find_freedom(int v) const;
  int line_of(int v) const;
  Vec3 draw_back(int v, const Vec3& p) const;
  bool is_on_side(int v, const Vec3& place) const;
  bool stands(int v, const Vec3& place, double least) const;
  void search(int v, const Fan& fan);

  const Outline& outline_;
  SurfaceMesh& mesh_;
  std::vector<int> loop_;  // of the outline, for each border vertex; -1 elsewhere
  std::vector<std::vector<int>> fans_;
  std::vector<std::array<int, 2>> border_;  // neighbours on the border
};

}  // namespace palpate::authoring
