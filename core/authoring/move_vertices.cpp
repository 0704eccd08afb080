// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/move_vertices.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// Of the path to the middle of the neighbours: all of it overshoots where all of them move.
constexpr double kStep = 0.6;

/// [rad] Angles this good may get worse for the sake of evenness, down to this.
constexpr double kGoodAngle = 32.0 * (std::numbers::pi / 180.0);

/// A direction is bent where its eigenvalue is this part of the normal's: triangles at some 60
/// degrees to each other.
constexpr double kRidge = 0.3;

/// A place of the source whose normal turns from a vertex's as far is on the other side of a rim.
constexpr double kOtherSide = -0.3;

/// Steps of the search for a better place, in parts of the mean length of the edges around.
constexpr double kSearchSteps[] = {0.2, 0.07, 0.025};
constexpr int kSearchDirections = 8;

}  // namespace

MovingVertices::MovingVertices(const Outline& outline, SurfaceMesh& mesh)
    : outline_(outline), mesh_(mesh), loop_(mesh.vertices.size(), -1) {
  for (const auto& loop : find_border_loops(mesh.triangles)) {
    for (const int v : loop) loop_[v] = outline.borders.find_loop(mesh.vertices[v]);
  }
}

void MovingVertices::find_neighbours() {
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

void MovingVertices::smooth() {
  for (int v = 0; v < static_cast<int>(mesh_.vertices.size()); ++v) {
    if (line_of(v) == FeatureLines::kCorner) continue;
    const Fan fan = measure(v, mesh_.vertices[v]);
    const Vec3 place = draw_back(v, mesh_.vertices[v] + kStep * find_way(v));
    if (stands(v, place, std::min(fan.angle, kGoodAngle))) mesh_.vertices[v] = place;
  }
}

void MovingVertices::repair() {
  for (int v = 0; v < static_cast<int>(mesh_.vertices.size()); ++v) {
    if (line_of(v) == FeatureLines::kCorner) continue;
    const Fan fan = measure(v, mesh_.vertices[v]);
    if (fan.angle < kGoodAngle) search(v, fan);
  }
}

Corners MovingVertices::corners(int t, int moved, const Vec3& place) const {
  Corners x;
  for (int c = 0; c < 3; ++c) {
    const int v = mesh_.triangles[t][c];
    x[c] = v == moved ? place : mesh_.vertices[v];
  }
  return x;
}

MovingVertices::Fan MovingVertices::measure(int v, const Vec3& place) const {
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
Vec3 MovingVertices::find_way(int v) const {
  const Vec3& x = mesh_.vertices[v];
  if (border_[v][0] >= 0) {
    return 0.5 * (mesh_.vertices[border_[v][0]] + mesh_.vertices[border_[v][1]]) - x;
  }
  if (line_of(v) >= 0) {
    const auto& links = outline_.kept.lines.links[v];
    return 0.5 * (mesh_.vertices[links[0]] + mesh_.vertices[links[1]]) - x;
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
Mat3 MovingVertices::find_freedom(int v) const {
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

int MovingVertices::line_of(int v) const {
  return outline_.kept.lines.empty() ? FeatureLines::kNone : outline_.kept.lines.line[v];
}

Vec3 MovingVertices::draw_back(int v, const Vec3& p) const {
  if (loop_[v] >= 0) return outline_.borders.find_closest(loop_[v], p);
  if (line_of(v) >= 0) return outline_.kept.lines.find_closest(line_of(v), p);
  return outline_.source.find_closest(p).point;
}

/// Whether a place on the source is of the side that the triangles around `v` are on.
bool MovingVertices::is_on_side(int v, const Vec3& place) const {
  if (!outline_.kept.sides || loop_[v] >= 0 || line_of(v) >= 0) return true;
  const Triangle& below = outline_.surface.triangles[outline_.source.find_closest(place).triangle];
  const Vec3 normal = normal_of(corners_of(outline_.surface, below)).normalized();
  return normal.dot(measure(v, mesh_.vertices[v]).normal) > kOtherSide;
}

/// No triangle around `v` would turn too far or have an angle below `least`.
bool MovingVertices::stands(int v, const Vec3& place, double least) const {
  for (const int t : fans_[v]) {
    const Corners x = corners(t, v, place);
    const Vec3 before = normal_of(corners(t, v, mesh_.vertices[v]));
    if (is_turned(before, normal_of(x)) || smallest_angle(x) < least) return false;
  }
  return is_on_side(v, place);
}

void MovingVertices::search(int v, const Fan& fan) {
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

}  // namespace palpate::authoring
