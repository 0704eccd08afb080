// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/pair_friction.h"

#include <cmath>

#include "palpate/sim/collision/private/pull_bristle.h"
#include "palpate/sim/collision/private/surface_contacts.h"

namespace palpate {
namespace {

/// A point over a triangle, and how it moves there.
struct Rubbing {
  Vec3 offset = Vec3::Zero();    ///< [m] of the point from what is under it
  Vec3 velocity = Vec3::Zero();  ///< [m/s] of what is under it, from the point
  double inverse_mass = 0.0;     ///< [1/kg] of both
};

Rubbing measure_rubbing(const VertexContact& contact, int point, const TouchingSurface& points,
                        const TouchingSurface& triangles) noexcept {
  Rubbing rubbing;
  rubbing.offset = points.x[static_cast<std::size_t>(point)];
  points.for_each_of(point, [&](int v, double w) noexcept {
    rubbing.inverse_mass += w * w * points.touch.inverse_mass[static_cast<std::size_t>(v)];
    rubbing.velocity -= w * points.velocity_of(v);
  });
  const Triangle& corners = triangles.tissue.triangles[static_cast<std::size_t>(contact.triangle)];
  for (int c = 0; c < 3; ++c) {
    const int corner = corners[static_cast<std::size_t>(c)];
    const auto v = static_cast<std::size_t>(corner);
    const double w = contact.weights[c];
    if (w == 0.0) continue;
    rubbing.inverse_mass += w * w * triangles.touch.inverse_mass[v];
    rubbing.offset -= w * triangles.x[v];
    rubbing.velocity += w * triangles.velocity_of(corner);
  }
  return rubbing;
}

/// [m] By how much a point at `x` [m] has gone over what was under it in the substep before.
Vec3 measure_slide(const PointBristle& bristle, const Vec3& x,
                   const TouchingSurface& triangles) noexcept {
  Vec3 slide = x - bristle.offset;
  const Triangle& corners = triangles.tissue.triangles[static_cast<std::size_t>(bristle.triangle)];
  for (int c = 0; c < 3; ++c) {
    const double w = bristle.weights[c];
    if (w != 0.0)
      slide -= w * triangles.x[static_cast<std::size_t>(corners[static_cast<std::size_t>(c)])];
  }
  return slide;
}

}  // namespace

PointBristles::PointBristles(double friction_in, std::size_t count) : friction(friction_in) {
  if (friction == 0.0) return;
  // a push k g along n that brings mu k g along a tangent t has the block k (n + mu t) n^T
  steepening = std::sqrt(1.0 + friction * friction);
  pressed.assign(count, 0.0);
  points.assign(count, {});
  rubbed.assign(count, 0);
  kept.assign(count, {});
  kept_points.assign(count, 0);
}

void begin_rubbing(PointBristles& bristles) noexcept {
  ++bristles.substep;
  bristles.rubbed_count = 0;
}

/// With the stretch s from the point to where it sticks, drawn along with what the point has gone
/// over the material under it since the substep before,
///
///     f = k_b s + c ds/dt along the surface, |f| <= mu N,   k_b = k_A A_v,   c = 2 zeta sqrt(k_b
///     m)
///
/// and where k_b s is more than mu N, it sticks nearer. -f is on the corners that bear N. k_b and c
/// are what the barrier has at its edge: nowhere more than along the normal, for which steps are
/// chosen.
FrictionSum rub_contacts(const TouchingSurface& points, const TouchingSurface& triangles,
                         SurfaceContacts& contacts) noexcept {
  FrictionSum sum;
  PointBristles& bristles = contacts.bristles;
  const Barrier& barrier = contacts.barrier;
  const std::span<const int> active = contacts.active_in_use();
  for (std::size_t k = 0; k < active.size(); ++k) {
    const double pressed = bristles.pressed[k];
    if (!(pressed > 0.0)) continue;
    bristles.pressed[k] = 0.0;
    const int point = active[k];
    const auto p = static_cast<std::size_t>(point);
    const VertexContact& contact = contacts.contact[k];
    const Rubbing rubbing = measure_rubbing(contact, point, points, triangles);
    if (!(rubbing.inverse_mass > 0.0)) continue;
    PointBristle& bristle = bristles.points[p];
    const Vec3 stretch =
        bristle.substep == bristles.substep - 1
            ? Vec3(bristle.stretch - measure_slide(bristle, points.x[p], triangles))
            : Vec3::Zero();
    const double stiffness = barrier.stiffness * contacts.area[p];
    const double critical = 2.0 * std::sqrt(stiffness / rubbing.inverse_mass);
    Vec3 slip;
    const Vec3 force = pull_bristle({stiffness, barrier.damping * critical, bristles.friction},
                                    stretch, rubbing.velocity, contact.normal, pressed, slip);
    const Vec3 along = stretch - contact.normal.dot(stretch) * contact.normal - slip;
    bristle = {bristles.substep, contact.triangle, contact.weights, rubbing.offset, along};
    bristles.rubbed[static_cast<std::size_t>(bristles.rubbed_count++)] = point;
    add_force(contact, point, force, points, triangles);
    sum.force -= force;
    sum.energy += 0.5 * stiffness * along.squaredNorm();
  }
  return sum;
}

void keep_bristles(PointBristles& bristles) noexcept {
  bristles.kept_count = bristles.rubbed_count;
  for (std::size_t n = 0; n < static_cast<std::size_t>(bristles.kept_count); ++n) {
    bristles.kept_points[n] = bristles.rubbed[n];
    bristles.kept[n] = bristles.points[static_cast<std::size_t>(bristles.rubbed[n])];
  }
}

/// What was done since does not hold, as no substep before this one has its number.
void rewind_bristles(PointBristles& bristles) noexcept {
  begin_rubbing(bristles);
  bristles.rubbed_count = bristles.kept_count;
  for (std::size_t n = 0; n < static_cast<std::size_t>(bristles.kept_count); ++n) {
    const int point = bristles.rubbed[n] = bristles.kept_points[n];
    PointBristle& bristle = bristles.points[static_cast<std::size_t>(point)];
    bristle = bristles.kept[n];
    bristle.substep = bristles.substep;
  }
}

}  // namespace palpate
