// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/improve_triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/authoring/border_lines.h"
#include "palpate/authoring/flip_edges.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

constexpr int kSmoothRounds = 20;
constexpr int kFlipsPerRound = 3;

/// Rounds that only work on the worst triangles left.
constexpr int kMendRounds = 15;

/// Of the way to the middle of the neighbours: all of it overshoots where everybody moves.
constexpr double kStep = 0.6;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Angles this good may get worse for the sake of evenness, down to this.
constexpr double kGoodAngle = 32.0 * kDegree;

/// A move may turn a triangle by 60 degrees at most.
constexpr double kLeastCosine = 0.5;

/// Steps of the search for a better place, in parts of the mean length of the edges around.
constexpr double kSearchSteps[] = {0.2, 0.07, 0.025};
constexpr int kSearchDirections = 8;

using Corners = std::array<Vec3, 3>;

double smallest_angle(const Corners& x) {
  double smallest = std::numbers::pi;
  for (int c = 0; c < 3; ++c) {
    const Vec3 u = x[(c + 1) % 3] - x[c], v = x[(c + 2) % 3] - x[c];
    smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return smallest;
}

Vec3 normal_of(const Corners& x) { return (x[1] - x[0]).cross(x[2] - x[0]); }

/// A mesh whose vertices move, never further than its triangles stand.
class Moving {
 public:
  Moving(const BorderLines& lines, const SourceSurface& source, SurfaceMesh& mesh)
      : lines_(lines), source_(source), mesh_(mesh), loop_(mesh.vertices.size(), -1) {
    for (const auto& loop : find_border_loops(mesh.triangles)) {
      for (const int v : loop) loop_[v] = lines.find_loop(mesh.vertices[v]);
    }
  }

  /// Who is around whom; to be called after the triangles have changed.
  void look_around() {
    fans_.assign(mesh_.vertices.size(), {});
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      for (const int v : mesh_.triangles[t]) fans_[v].push_back(t);
    }
    border_.assign(mesh_.vertices.size(), {-1, -1});
    for (const auto& loop : find_border_loops(mesh_.triangles)) {
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i) border_[loop[i]] = {loop[(i + n - 1) % n], loop[(i + 1) % n]};
    }
  }

  /// Every vertex a step towards the middle of its neighbours.
  void smooth() {
    for (int v = 0; v < static_cast<int>(mesh_.vertices.size()); ++v) {
      const Fan fan = measure(v, mesh_.vertices[v]);
      const Vec3 place = draw_back(v, mesh_.vertices[v] + kStep * find_way(v));
      if (stands(v, place, std::min(fan.angle, kGoodAngle))) mesh_.vertices[v] = place;
    }
  }

  /// Each vertex of a triangle that is not good to the best place near by.
  void mend() {
    for (int v = 0; v < static_cast<int>(mesh_.vertices.size()); ++v) {
      const Fan fan = measure(v, mesh_.vertices[v]);
      if (fan.angle < kGoodAngle) search(v, fan);
    }
  }

 private:
  struct Fan {
    double angle = std::numbers::pi;  ///< the smallest of the triangles around
    double length = 0.0;              ///< [m] mean distance to the neighbours
    Vec3 normal = Vec3::Zero();       ///< of unit length
  };

  Corners corners(int t, int moved, const Vec3& place) const {
    Corners x;
    for (int c = 0; c < 3; ++c) {
      const int v = mesh_.triangles[t][c];
      x[c] = v == moved ? place : mesh_.vertices[v];
    }
    return x;
  }

  Fan measure(int v, const Vec3& place) const {
    Fan fan;
    for (const int t : fans_[v]) {
      const Corners x = corners(t, v, place);
      fan.angle = std::min(fan.angle, smallest_angle(x));
      fan.normal += normal_of(x);
      for (const Vec3& p : x) fan.length += (p - place).norm();
    }
    fan.length /= 2.0 * static_cast<double>(fans_[v].size());
    fan.normal.normalize();
    return fan;
  }

  /// To the mean of the triangles' centres by area, along the surface; on the border to the middle
  /// between the neighbours on it.
  Vec3 find_way(int v) const {
    const Vec3& x = mesh_.vertices[v];
    if (border_[v][0] >= 0) {
      return 0.5 * (mesh_.vertices[border_[v][0]] + mesh_.vertices[border_[v][1]]) - x;
    }
    Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
    double area = 0.0;
    for (const int t : fans_[v]) {
      const Corners p = corners(t, v, x);
      const Vec3 n = normal_of(p);
      middle += n.norm() * (p[0] + p[1] + p[2]) / 3.0;
      area += n.norm();
      normal += n;
    }
    const Vec3 way = middle / area - x;
    normal.normalize();
    return way - way.dot(normal) * normal;
  }

  Vec3 draw_back(int v, const Vec3& p) const {
    return loop_[v] >= 0 ? lines_.find_closest(loop_[v], p) : source_.find_closest(p).point;
  }

  /// No triangle around `v` would turn too far or have an angle below `least`.
  bool stands(int v, const Vec3& place, double least) const {
    for (const int t : fans_[v]) {
      const Corners x = corners(t, v, place);
      const Vec3 before = normal_of(corners(t, v, mesh_.vertices[v])), after = normal_of(x);
      if (!(after.dot(before) > kLeastCosine * after.norm() * before.norm())) return false;
      if (smallest_angle(x) < least) return false;
    }
    return true;
  }

  void search(int v, const Fan& fan) {
    const Vec3 side = fan.normal.unitOrthogonal(), other = fan.normal.cross(side);
    double best = fan.angle;
    Vec3 found = mesh_.vertices[v];
    for (const double step : kSearchSteps) {
      for (int d = 0; d < kSearchDirections; ++d) {
        const double turn = 2.0 * std::numbers::pi * d / kSearchDirections;
        const Vec3 way = step * fan.length * (std::cos(turn) * side + std::sin(turn) * other);
        const Vec3 place = draw_back(v, mesh_.vertices[v] + way);
        if (!stands(v, place, best)) continue;
        best = measure(v, place).angle;
        found = place;
      }
    }
    mesh_.vertices[v] = found;
  }

  const BorderLines& lines_;
  const SourceSurface& source_;
  SurfaceMesh& mesh_;
  std::vector<int> loop_;  // of the outline, for each border vertex; -1 elsewhere
  std::vector<std::vector<int>> fans_;
  std::vector<std::array<int, 2>> border_;  // neighbours on the border
};

}  // namespace

void improve_triangles(const SurfaceMesh& outline, const SourceSurface& source,
                       SurfaceMesh& mesh) {
  const BorderLines lines(outline);
  Moving moving(lines, source, mesh);
  for (int round = 0; round < kSmoothRounds + kMendRounds; ++round) {
    for (int pass = 0; pass < kFlipsPerRound; ++pass) {
      if (flip_edges(mesh) == 0) break;
    }
    moving.look_around();
    if (round < kSmoothRounds) {
      moving.smooth();
    } else {
      moving.mend();
    }
  }
}

}  // namespace palpate::authoring
