// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/improve_triangles.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/authoring/border_lines.h"
#include "palpate/authoring/flip_edges.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/trade_edges.h"
#include "palpate/authoring/triangle_shape.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

constexpr int kFlipsPerRound = 3;

/// Rounds of smoothing; before the ones after these, triangles nothing else can repair are traded.
constexpr int kSmoothRounds = 24;
constexpr int kTradeRounds[] = {15, 20};

/// Rounds that only work on the worst triangles left.
constexpr int kRepairRounds = 12;

/// Of the path to the middle of the neighbours: all of it overshoots where all of them move.
constexpr double kStep = 0.6;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Angles this good may get worse for the sake of evenness, down to this.
constexpr double kGoodAngle = 32.0 * kDegree;

/// Below this a triangle's shortest edge is traded for another.
constexpr double kBadAngle = 25.0 * kDegree;

/// A direction is bent where its eigenvalue is this part of the normal's: triangles at some 60
/// degrees to each other.
constexpr double kRidge = 0.3;

/// Steps of the search for a better place, in parts of the mean length of the edges around.
constexpr double kSearchSteps[] = {0.2, 0.07, 0.025};
constexpr int kSearchDirections = 8;

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
  void find_neighbours() {
    fans_.assign(mesh_.vertices.size(), {});
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      for (const int v : mesh_.triangles[t]) fans_[v].push_back(t);
    }
    border_.assign(mesh_.vertices.size(), {-1, -1});
    for (const auto& loop : find_border_loops(mesh_.triangles)) {
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i)
        border_[loop[i]] = {loop[(i + n - 1) % n], loop[(i + 1) % n]};
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
  void repair() {
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

  /// To the mean of the triangles' centres by area, as far as the surface lets a vertex go; on the
  /// border to the middle between the neighbours on it.
  Vec3 find_way(int v) const {
    const Vec3& x = mesh_.vertices[v];
    if (border_[v][0] >= 0) {
      return 0.5 * (mesh_.vertices[border_[v][0]] + mesh_.vertices[border_[v][1]]) - x;
    }
    Vec3 middle = Vec3::Zero();
    double area = 0.0;
    for (const int t : fans_[v]) {
      const Corners p = corners(t, v, x);
      const double part = normal_of(p).norm();
      middle += part * (p[0] + p[1] + p[2]) / 3.0;
      area += part;
    }
    return find_freedom(v) * (middle / area - x);
  }

  /// Where a vertex may go without changing the shape [Jiao07]: the eigenvectors of sum n n' over
  /// its triangles are its normal, and directions in which it is free as far as their eigenvalues
  /// are small. On a ridge one is left, at a tip none.
  Mat3 find_freedom(int v) const {
    Mat3 tensor = Mat3::Zero();
    for (const int t : fans_[v]) {
      const Vec3 n = normal_of(corners(t, v, mesh_.vertices[v]));
      const double length = n.norm();
      if (length > 0.0) tensor += n * n.transpose() / length;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor);
    const Vec3 values = solver.eigenvalues();
    Mat3 freedom = Mat3::Zero();
    for (int i = 0; i < 2; ++i) {
      const Vec3 e = solver.eigenvectors().col(i);
      freedom += std::max(0.0, 1.0 - values[i] / (kRidge * values[2])) * e * e.transpose();
    }
    return freedom;
  }

  Vec3 draw_back(int v, const Vec3& p) const {
    return loop_[v] >= 0 ? lines_.find_closest(loop_[v], p) : source_.find_closest(p).point;
  }

  /// No triangle around `v` would turn too far or have an angle below `least`.
  bool stands(int v, const Vec3& place, double least) const {
    for (const int t : fans_[v]) {
      const Corners x = corners(t, v, place);
      const Vec3 before = normal_of(corners(t, v, mesh_.vertices[v]));
      if (is_turned(before, normal_of(x)) || smallest_angle(x) < least) return false;
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
        const Vec3 offset = step * fan.length * (std::cos(turn) * side + std::sin(turn) * other);
        const Vec3 place = draw_back(v, mesh_.vertices[v] + offset);
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

std::size_t count_crossings(const SurfaceMesh& mesh) {
  const auto faces = find_self_intersecting_faces(mesh);
  return faces ? faces->size() : mesh.triangles.size();
}

/// Puts back what has made faces cross that did not before: their own vertices first, all of them
/// where that does not do.
void undo_crossings(const Vec3Array& before, std::size_t allowed, SurfaceMesh& mesh) {
  for (;;) {
    const auto faces = find_self_intersecting_faces(mesh);
    if (faces && faces->size() <= allowed) return;
    bool put_back = false;
    for (const int t : faces.value_or(std::vector<int>())) {
      for (const int v : mesh.triangles[t]) {
        put_back = put_back || mesh.vertices[v] != before[v];
        mesh.vertices[v] = before[v];
      }
    }
    if (put_back) continue;
    mesh.vertices = before;
    return;
  }
}

/// One pass of flips; those that make faces cross are undone and held back.
int flip_guarded(std::size_t allowed, SurfaceMesh& mesh) {
  const std::vector<Triangle> before = mesh.triangles;
  std::vector<char> held(mesh.vertices.size(), 0);
  for (;;) {
    const int flips = flip_edges(mesh, held);
    const auto faces = find_self_intersecting_faces(mesh);
    if (flips == 0 || (faces && faces->size() <= allowed)) return flips;
    bool is_new = false;
    for (const int t : faces.value_or(std::vector<int>())) {
      for (const Triangle& corners : {mesh.triangles[t], before[t]}) {
        for (const int v : corners) {
          is_new = is_new || !held[v];
          held[v] = 1;
        }
      }
    }
    mesh.triangles = before;
    if (!is_new) return 0;
  }
}

/// Rounds of flips and moves. With `guarded`, whatever makes faces cross is undone.
void run_rounds(const BorderLines& lines, const SourceSurface& source, bool guarded,
                SurfaceMesh& mesh) {
  const std::size_t allowed = guarded ? count_crossings(mesh) : 0;
  Moving moving(lines, source, mesh);
  for (int round = 0; round < kSmoothRounds + kRepairRounds; ++round) {
    for (int pass = 0; pass < kFlipsPerRound; ++pass) {
      if ((guarded ? flip_guarded(allowed, mesh) : flip_edges(mesh)) == 0) break;
    }
    if (std::count(std::begin(kTradeRounds), std::end(kTradeRounds), round) > 0) {
      const SurfaceMesh before = mesh;
      trade_edges(source, kBadAngle, mesh);
      if (guarded && count_crossings(mesh) > allowed) mesh = before;
    }
    moving.find_neighbours();
    const Vec3Array before = mesh.vertices;
    if (round < kSmoothRounds) {
      moving.smooth();
    } else {
      moving.repair();
    }
    if (guarded) undo_crossings(before, allowed, mesh);
  }
}

}  // namespace

void improve_triangles(const SurfaceMesh& outline, const SourceSurface& source, SurfaceMesh& mesh) {
  const BorderLines lines(outline);
  SurfaceMesh improved = mesh;
  run_rounds(lines, source, false, improved);
  // to look for crossings after every round is slow, and rarely needed
  if (count_crossings(improved) > count_crossings(mesh)) {
    improved = mesh;
    run_rounds(lines, source, true, improved);
  }
  mesh = std::move(improved);
}

}  // namespace palpate::authoring
