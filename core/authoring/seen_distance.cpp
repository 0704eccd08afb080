// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/seen_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/authoring/spread_directions.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/tree/queries.h"

namespace palpate::authoring {
namespace {

/// The rays of one side: a square grid over the ball around the surface, seen along `along`.
class Rays {
 public:
  Rays(const Vec3& middle, double radius, double spacing, const Vec3& along, int side)
      : along_(along),
        right_(along_.unitOrthogonal()),
        up_(along_.cross(right_)),
        first_(middle - 2.0 * radius * along_),
        radius_(radius),
        spacing_(spacing),
        // another part of a step for each side, so that no row of edges lies on all grids
        shift_(std::fmod(side * std::numbers::phi, 1.0)) {}

  template <class Look>
  void for_each(const Look& look) const {
    const int most = static_cast<int>(std::ceil(radius_ / spacing_));
    for (int i = -most; i <= most; ++i) {
      for (int j = -most; j <= most; ++j) {
        const double u = (i + shift_) * spacing_, v = (j + shift_) * spacing_;
        if (u * u + v * v <= radius_ * radius_) look(first_ + u * right_ + v * up_, along_);
      }
    }
  }

 private:
  Vec3 along_, right_, up_, first_;
  double radius_, spacing_, shift_;
};

}  // namespace

Vec3Array find_seen_points(const SurfaceMesh& mesh) {
  const AabbTree tree(mesh.vertices, mesh.triangles);
  const Vec3 middle = 0.5 * (tree.low() + tree.high());
  const double diagonal = (tree.high() - tree.low()).norm();
  Vec3Array points;
  if (!(diagonal > 0.0)) return points;
  const Vec3Array sides = spread_directions(kSides);
  for (int side = 0; side < kSides; ++side) {
    const Rays rays(middle, 0.5 * diagonal, kSightGrid * diagonal, sides[side], side);
    rays.for_each([&](const Vec3& from, const Vec3& along) {
      if (const auto hit = find_ray_hit(tree, mesh.vertices, from, along)) {
        points.push_back(hit->point);
      }
    });
  }
  return points;
}

SurfaceDistance measure_seen_distance(const SurfaceMesh& from, const SourceSurface& tree) {
  const Vec3Array points = find_seen_points(from);
  if (points.empty()) return {0.0, 0.0, 0.0};
  double sum = 0.0, furthest = 0.0;
  for (const Vec3& p : points) {
    const double away = (tree.find_closest(p).point - p).norm();
    sum += away;
    furthest = std::max(furthest, away);
  }
  const double spacing = kSightGrid * compute_diagonal(from.vertices);
  return {sum / static_cast<double>(points.size()), furthest, furthest + spacing};
}

}  // namespace palpate::authoring
