// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// How far a surface goes from tick to tick.
struct SurfaceMotion {
  explicit SurfaceMotion(std::size_t count = 0)
      : last(count, Vec3::Zero()), before(count, Vec3::Zero()) {}

  Vec3Array last;         ///< [m] the surface at the last tick (follow_move)
  Vec3Array before;       ///< [m] likewise at the one before that (follow_move)
  bool has_last = false;  ///< `last` is of the tick before (follow_move)
  double move = 0.0;      ///< [m] of any vertex since, at most (follow_move)
  double speed = 0.0;     ///< [m/s] of any vertex meanwhile, at most (follow_move)
};

/// [1/kg] per vertex of a surface; 0 of one whose particles are all held, as nothing moves it.
std::vector<double> invert_surface_masses(const TissueModel& tissue);

/// What is known within a tick of a surface that may touch others.
struct SurfaceTouch : SurfaceMotion {
  SurfaceTouch() = default;
  explicit SurfaceTouch(const TissueModel& tissue);

  // what never changes
  std::vector<double> inverse_mass;        ///< [1/kg] per vertex; 0 of what is held
  std::vector<std::array<int, 2>> corner;  ///< per vertex: a triangle, and which of its corners

  bool is_touched = false;  ///< something may touch it in this tick
  /// [m] no vertex has gone farther since contacts were looked at (move_tissue, touch_bodies)
  double went = std::numeric_limits<double>::infinity();
  double behind = 0.0;     ///< [m] by which it may have left the boxes of its tree
  double stiffness = 0.0;  ///< [1/s²] that contacts add to the largest eigenvalue of M⁻¹K at most
  double approach = 0.0;     ///< [-] of a barrier's thickness, by which a gap closes in a tick
  std::vector<double> row;   ///< [1/s²] per vertex: what contacts make of the row of M⁻¹K
  Vec3Array force;           ///< [N] per vertex, of this substep (push_contacts, take_pushes)
  Vec3Array impulse;         ///< [m/s] per vertex, of impulses since its last step
  bool has_impulse = false;  ///< some of them are not 0
  std::vector<int> pushed;   ///< vertices with a force; capacity
  int pushed_count = 0;      ///< how many of them are in use
  /// [J] No less than pushes have taken from it in this tick (touch_bodies).
  double lost = 0.0;
  std::vector<unsigned char> is_pushed;  ///< whether in `pushed`

  std::span<const int> pushed_in_use() const noexcept {
    return std::span(pushed).first(static_cast<std::size_t>(pushed_count));
  }
};

/// Measures how far a surface at x [m] has gone since this was called last, `elapsed` [s] ago; 0
/// where it was put back to where it was, and is as fast as it was.
void follow_move(std::span<const Vec3> x, double elapsed, SurfaceMotion& motion) noexcept;

/// Calls visit(push) for the force on each vertex, and begins again.
template <class Visit>
void take_pushes(SurfaceTouch& touch, Visit visit) noexcept {
  for (const int vertex : touch.pushed_in_use()) {
    const auto v = static_cast<std::size_t>(vertex);
    const auto& [triangle, corner] = touch.corner[v];
    visit(Push{triangle, Vec3::Unit(corner), touch.force[v]});
    touch.force[v].setZero();
    touch.is_pushed[v] = 0;
  }
  touch.pushed_count = 0;
}

struct TouchingSurface;

/// [W] That the forces on a surface take from it at the velocities that it has.
double measure_lost(const TouchingSurface& surface) noexcept;

/// A surface as it stands in a substep.
struct TouchingSurface {
  const TissueModel& tissue;
  std::span<const Vec3> x;         ///< [m] of the vertices, or of the middles of `edges`
  std::span<const Vec3> velocity;  ///< [m/s] of the particles
  SurfaceTouch& touch;             ///< what contacts do to it
  std::span<const std::array<int, 2>> edges = {};  ///< ends; where there are none, its vertices

  /// [m/s] With what impulses have done to it.
  Vec3 velocity_of(int vertex) const noexcept;
  void add_force(int vertex, const Vec3& force) const noexcept {
    const auto v = static_cast<std::size_t>(vertex);
    touch.force[v] += force;
    if (touch.is_pushed[v] != 0) return;
    touch.is_pushed[v] = 1;
    touch.pushed[static_cast<std::size_t>(touch.pushed_count++)] = vertex;
  }
  /// An impulse [N s].
  void add_impulse(int vertex, const Vec3& impulse) const noexcept;

  /// Calls visit(vertex, weight) for what a point of `x` follows: a vertex, or the ends of an edge.
  template <class Visit>
  void for_each_of(int point, Visit visit) const noexcept {
    if (edges.empty()) return visit(point, 1.0);
    for (const int end : edges[static_cast<std::size_t>(point)]) visit(end, 0.5);
  }
};

}  // namespace palpate
