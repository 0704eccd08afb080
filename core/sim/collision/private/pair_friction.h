// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "palpate/sim/base/types.h"

namespace palpate {

struct SurfaceContacts;
struct TouchingSurface;

/// How far a point of a surface has been drawn over a triangle of another from where it sticks.
struct PointBristle {
  long substep = -1;            ///< in which it has pushed last
  int triangle = 0;             ///< that it was over then
  Vec3 weights = Vec3::Zero();  ///< barycentric, there
  Vec3 offset = Vec3::Zero();   ///< [m] of the point from there
  Vec3 stretch = Vec3::Zero();  ///< [m] from the point to where it sticks
};

/// Of the points of a surface that push another [contact: bodies].
struct PointBristles {
  PointBristles() = default;
  PointBristles(double friction, std::size_t points);

  // what never changes
  double friction = 0.0;    ///< [-] mu; 0: all below is empty
  double steepening = 1.0;  ///< [-] by which it makes contacts stiffer at most

  std::vector<double> pressed;  ///< [N] per active contact, until it has rubbed (push_contacts)

  // (begin_rubbing, rub_contacts)
  long substep = 0;
  std::vector<PointBristle> points;  ///< those of this substep or the one before hold
  std::vector<int> rubbed;           ///< points of this substep; capacity
  int rubbed_count = 0;              ///< how many of them are in use

  // (keep_bristles)
  std::vector<PointBristle> kept;  ///< capacity
  std::vector<int> kept_points;    ///< likewise
  int kept_count = 0;
};

/// What the friction of a substep comes to.
struct FrictionSum {
  double energy = 0.0;        ///< [J] in the bristles
  Vec3 force = Vec3::Zero();  ///< [N] on the triangles
};

/// Begins a substep: a point that does not push in it lets go.
void begin_rubbing(PointBristles& bristles) noexcept;

/// Adds the friction of all contacts that push_contacts() has found to push in this substep to both
/// surfaces.
FrictionSum rub_contacts(const TouchingSurface& points, const TouchingSurface& triangles,
                         SurfaceContacts& contacts) noexcept;

/// Takes note of the bristles that hold.
void keep_bristles(PointBristles& bristles) noexcept;

/// Back to what was kept.
void rewind_bristles(PointBristles& bristles) noexcept;

}  // namespace palpate
