// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "palpate/sim/collision/private/barrier.h"
#include "palpate/sim/collision/private/pair_friction.h"
#include "palpate/sim/collision/private/touching_surface.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// [m] Lists go so much beyond the thickness, and hold until the surfaces may have moved by it.
inline constexpr double kListMargin = 1e-3;

/// [-] Of its gap: a contact is found again when its vertex has slid so far since.
inline constexpr double kHeldPart = 0.02;

/// Where a vertex is over the nearest triangle.
struct VertexContact {
  int triangle = -1;            ///< none: nothing is within reach
  Vec3 weights = Vec3::Zero();  ///< barycentric
  Vec3 normal = Vec3::Zero();   ///< unit, towards where the vertex is to be
  double gap = 0.0;             ///< [m] along it, below 0 where the vertex has come through
};

/// A force [N] on the vertex of a contact, or what another point follows, and -force on the
/// triangle.
inline void add_force(const VertexContact& contact, int vertex, const Vec3& force,
                      const TouchingSurface& vertices, const TouchingSurface& triangles) noexcept {
  vertices.for_each_of(vertex, [&](int v, double w) noexcept { vertices.add_force(v, w * force); });
  const Triangle& corners = triangles.tissue.triangles[static_cast<std::size_t>(contact.triangle)];
  for (int c = 0; c < 3; ++c) {
    const double w = contact.weights[c];
    if (w != 0.0) triangles.add_force(corners[static_cast<std::size_t>(c)], -w * force);
  }
}

/// Vertices of one surface that may touch the triangles of another, or of the same.
///
/// A vertex has two lists: of all triangles that it may come to touch before it is looked at again,
/// and of those among them that may be the nearest. Both say up to which motion they hold, where
/// motion is the sum of how far the vertices of both surfaces have gone at most, tick by tick. So
/// few vertices are looked at in any one tick [contact: bodies].
struct SurfaceContacts {
  static constexpr std::size_t kMostListed = 24;  ///< with more, the nearest of them
  static constexpr std::size_t kMostNear = 6;     ///< likewise
  static constexpr double kNotKnown = -1.0;

  SurfaceContacts() = default;
  /// `triangles` of the second surface; `same` where it is the first as well.
  SurfaceContacts(const SurfaceMesh& vertices, const SurfaceMesh& triangles, const Barrier& barrier,
                  bool same = false);
  /// Of points with these areas [m²], which are no vertices of the triangles.
  SurfaceContacts(std::vector<double> areas, const SurfaceMesh& triangles, const Barrier& barrier);

  // what never changes
  Barrier barrier;
  bool same = false;
  bool closed = true;                         ///< the triangles': they have an inside
  std::vector<double> area;                   ///< [m²] per vertex, at rest
  std::vector<unsigned char> on_border;       ///< per vertex of the triangles
  std::vector<int> first_excluded, excluded;  ///< per vertex: triangles of its 2-ring, ascending

  // (renew_lists)
  bool begun = false;                ///< the lists are of now, not of before the surfaces were far
  double moved = 0.0;                ///< [m] neither surface has gone farther, both together
  double ahead = 0.0;                ///< [m] by which `moved` may grow in this tick
  std::size_t next = 0;              ///< vertex of the round
  std::vector<double> listed_until;  ///< [m] of `moved`
  std::vector<std::array<int, kMostListed>> listed;
  std::vector<unsigned char> listed_count;
  std::vector<int> found;  ///< room for a query

  // (find_near)
  std::vector<double> near_until;  ///< [m] of `moved`
  std::vector<std::array<int, kMostNear>> near;
  std::vector<unsigned char> near_count;
  std::vector<signed char> side;  ///< of an open surface: 1 before it, -1 behind, 0 not known;
                                  ///< 2 and -2 where it has come through from there
  bool follows_sides = false;     ///< it is known where both surfaces were before
  std::vector<int> active;        ///< vertices with near triangles, ascending; capacity
  int active_count = 0;

  // (find_contacts)
  double travelled = 0.0;  ///< [m] since find_near the surfaces have gone no farther, both together
  std::vector<VertexContact> contact;  ///< of the active ones, as they are; none of those far off
  std::vector<double> far_until;   ///< [m] of `travelled`, per active one: farther off till then
  std::vector<double> held_until;  ///< [m] likewise: `contact` follows where it was found till then
  std::vector<int> held, lapsed;   ///< room for places of active ones

  // (push_contacts)
  std::vector<double> resistance;  ///< [N s/m] of the damping, per active one, until it is found
                                   ///< again; kNotKnown where nobody has asked
  PointBristles bristles;          ///< without friction, empty

  std::span<const int> active_in_use() const noexcept {
    return std::span(active).first(static_cast<std::size_t>(active_count));
  }
};

/// How far two surfaces go, together.
struct Travel {
  double move = 0.0;    ///< [m] since lists were looked at last
  double ahead = 0.0;   ///< [m] at most until they are looked at again
  double behind = 0.0;  ///< [m] by which the triangles may have left the boxes of their tree
};

/// What goes on as it did may go twice as far, and a little more where it begins to move.
inline Travel expect_same(double move) noexcept {
  constexpr double kUnseen = 1e-5;  // [m] what begins to move within a tick
  return {move, 2.0 * move + kUnseen, 0.0};
}

/// Begins a tick, or a part of one, in which the surfaces are at x_v and x_t [m]: the lists of the
/// vertices whose turn it is are found again in the tree.
void renew_lists(std::span<const Vec3> x_v, const AabbTree& tree, std::span<const Vec3> x_t,
                 const Travel& travel, SurfaceContacts& contacts) noexcept;

/// Likewise a tick in which the surfaces have moved by `move` [m] since the last one.
inline void renew_lists(std::span<const Vec3> x_v, const AabbTree& tree, std::span<const Vec3> x_t,
                        double move, SurfaceContacts& contacts) noexcept {
  renew_lists(x_v, tree, x_t, expect_same(move), contacts);
}

/// Where the surfaces were when they were looked at last [m]; empty where nobody knows.
struct Before {
  std::span<const Vec3> x_v, x_t;
};

/// Finds which vertices may touch in this tick, and the triangles that may be their nearest. A
/// vertex that is found behind an open surface has come through where it was before the nearest
/// triangle; where it was behind that already, it has come to another fold, or around the border.
void find_near(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
               std::span<const Vec3> x_t, SurfaceContacts& contacts,
               const Before& before = {}) noexcept;

/// The contact of a vertex at `x` [m], from its near triangles; none beyond `reach` [m].
VertexContact find_contact(const SurfaceContacts& contacts, int vertex, const Vec3& x,
                           std::span<const Triangle> triangles, std::span<const Vec3> x_t,
                           double reach) noexcept;

/// What the contacts of a substep come to.
struct ContactSum {
  int touching = 0;
  double least_gap = 0.0;     ///< [m] set where touching
  double energy = 0.0;        ///< [J] in the barrier
  Vec3 force = Vec3::Zero();  ///< [N] on the triangles
};

/// Whether surfaces that have gone by `travel` [m] at most, both together, since their contacts
/// were looked at last go so slowly, and are to in all of this tick, that what is not within the
/// thickness cannot come to the floor within a substep.
bool go_slowly(const SurfaceContacts& contacts, double travel) noexcept;

/// Finds the contacts of all active vertices with the nearest of their triangles into
/// SurfaceContacts::contact: those of find_contact(), to the bit, some at a time. The surfaces have
/// gone by `travel` [m] since it was called last, or since find_near; where they go slowly, what
/// cannot have come within the thickness has none, and a contact keeps normal and weights until it
/// has slid by kHeldPart of its gap, or they may have gone by a tenth of it: meanwhile the gap is
/// that of the same points, along the same normal.
void find_contacts(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
                   std::span<const Vec3> x_t, double travel, SurfaceContacts& contacts) noexcept;

/// Adds the forces of all contacts to both surfaces, for a substep of dt [s] from here; the energy
/// in the barrier is left out unless it is asked for, as it takes a logarithm for each contact.
ContactSum push_contacts(double dt, const TouchingSurface& vertices,
                         const TouchingSurface& triangles, SurfaceContacts& contacts,
                         bool with_energy = true) noexcept;

/// What contacts ask of the steps of a tick of dt [s].
struct ContactNeed {
  double approach = 0.0;  ///< [m/s] at which a gap closes, the fastest
};

/// Adds to the rows [1/s²] of both surfaces how stiff contacts make each vertex over its mass; the
/// largest of a surface bounds what they add to the eigenvalues of its M⁻¹K.
ContactNeed accumulate_stiffness(double dt, const TouchingSurface& vertices,
                                 const TouchingSurface& triangles,
                                 SurfaceContacts& contacts) noexcept;

}  // namespace palpate
