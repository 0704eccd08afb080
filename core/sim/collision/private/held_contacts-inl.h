// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by held_kernels.cpp, once by held_kernels_plain.cpp: contacts that keep
// their normals and weights.
#if defined(PALPATE_HELD_CONTACTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_HELD_CONTACTS_INL_H
#undef PALPATE_HELD_CONTACTS_INL_H
#else
#define PALPATE_HELD_CONTACTS_INL_H
#endif

#include <algorithm>

#include "palpate/sim/collision/private/held_kernels.h"
#include "palpate/sim/tree/private/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::held_kernels::PALPATE_TREE_TARGET {

using namespace tree_kernels::PALPATE_TREE_TARGET;

/// Four contacts of active vertices.
struct FourContacts {
  std::size_t vertex[4];
  const VertexContact* contact[4];
  const Triangle* corners[4];
};

PALPATE_TREE_INLINE FourContacts choose_contacts(const SurfaceContacts& contacts,
                                                 std::span<const Triangle> triangles,
                                                 std::span<const int> places) {
  FourContacts four;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const auto k = static_cast<std::size_t>(places[std::min(lane, places.size() - 1)]);
    four.vertex[lane] = static_cast<std::size_t>(contacts.active[k]);
    four.contact[lane] = &contacts.contact[k];
    four.corners[lane] = &triangles[static_cast<std::size_t>(four.contact[lane]->triangle)];
  }
  return four;
}

PALPATE_TREE_INLINE Points gather_at(std::span<const Vec3> x, const std::size_t (&at)[4]) {
  const Four rows[4] = {load_point(x[at[0]]), load_point(x[at[1]]), load_point(x[at[2]]),
                        load_point(x[at[3]])};
  Points points;
  transpose(rows, points.x, points.y, points.z);
  return points;
}

PALPATE_TREE_INLINE Points gather_of(const FourContacts& four, Vec3 VertexContact::*what) {
  const Four rows[4] = {load_point(four.contact[0]->*what), load_point(four.contact[1]->*what),
                        load_point(four.contact[2]->*what), load_point(four.contact[3]->*what)};
  Points points;
  transpose(rows, points.x, points.y, points.z);
  return points;
}

PALPATE_TREE_INLINE Four gather_gaps(const FourContacts& four) {
  alignas(32) double gaps[4];
  for (std::size_t lane = 0; lane < 4; ++lane) gaps[lane] = four.contact[lane]->gap;
  return load(gaps);
}

/// Follows contacts by the points that were nearest: n (p - sum w x) is the gap to where it was
/// found, but for the square of how far p has slid over that point, and its gradient is that of the
/// forces. What has slid too far is written into `lapsed`.
inline std::size_t follow(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
                          std::span<const Vec3> x_t, std::span<const int> places,
                          SurfaceContacts& contacts, std::span<int> lapsed) noexcept {
  std::size_t count = 0;
  for (std::size_t first = 0; first < places.size(); first += 4) {
    const std::span<const int> of =
        places.subspan(first, std::min<std::size_t>(4, places.size() - first));
    const FourContacts four = choose_contacts(contacts, triangles, of);
    const Points normal = gather_of(four, &VertexContact::normal);
    Four rows[4];
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Vec3& weights = four.contact[lane]->weights;
      const auto corner = [&](std::size_t c) {
        return load_point(x_t[static_cast<std::size_t>((*four.corners[lane])[c])]);
      };
      const Four point =
          (set(weights[0]) * corner(0) + set(weights[1]) * corner(1)) + set(weights[2]) * corner(2);
      rows[lane] = load_point(x_v[four.vertex[lane]]) - point;
    }
    Points offset;
    transpose(rows, offset.x, offset.y, offset.z);
    const Four gap = dot(normal, offset);
    const Four most = set(kHeldPart) * gap;
    const Points slid = offset - gap * normal;
    const unsigned held = bits((set(0.0) < gap) & (dot(slid, slid) < most * most));
    alignas(32) double gaps[4];
    store(gap, gaps);
    for (std::size_t lane = 0; lane < of.size(); ++lane) {
      contacts.contact[static_cast<std::size_t>(of[lane])].gap = gaps[lane];
      if ((held >> lane & 1U) == 0) lapsed[count++] = of[lane];
    }
  }
  return count;
}

/// As compute_pressure() of gaps that are within the thickness.
PALPATE_TREE_INLINE Four compute_pressures(const Barrier& barrier, Four gap) {
  const Four stiffness = set(barrier.stiffness), thickness = set(barrier.thickness);
  const Four above = max(gap, set(kClosestPart * barrier.thickness));
  const Four part = above / thickness;
  const Four pressure = stiffness * (thickness - above) / part;
  if (bits(gap < above) == 0) return pressure;
  return pressure + stiffness / (part * part) * (above - gap);
}

/// [m/s] Of four vertices, or corners, along normals.
PALPATE_TREE_INLINE Four find_speeds(const TouchingSurface& surface, const std::size_t (&at)[4],
                                     const Points& normal) {
  Points velocity = gather_at(surface.velocity, at);
  if (surface.touch.has_impulse) velocity = velocity + gather_at(surface.touch.impulse, at);
  return dot(velocity, normal);
}

/// As push_one() of push_contacts.cpp, but that nothing is stopped.
inline FourForces push(double dt, const TouchingSurface& vertices, const TouchingSurface& triangles,
                       const SurfaceContacts& contacts, std::span<const int, 4> places) noexcept {
  const Barrier& barrier = contacts.barrier;
  const FourContacts four = choose_contacts(contacts, triangles.tissue.triangles, places);
  const Points weights = gather_of(four, &VertexContact::weights);
  const Points normal = gather_of(four, &VertexContact::normal);
  const Four each[3] = {weights.x, weights.y, weights.z};
  Four speed = find_speeds(vertices, four.vertex, normal);
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t corner[4];
    for (std::size_t lane = 0; lane < 4; ++lane) {
      corner[lane] = static_cast<std::size_t>((*four.corners[lane])[c]);
    }
    speed = speed - each[c] * find_speeds(triangles, corner, normal);
  }
  alignas(32) double areas[4], resistances[4];
  for (std::size_t lane = 0; lane < 4; ++lane) {
    areas[lane] = contacts.area[four.vertex[lane]];
    resistances[lane] = contacts.resistance[static_cast<std::size_t>(places[lane])];
  }
  const Four zero = set(0.0), gap = gather_gaps(four);
  const Four pressed = load(areas) * compute_pressures(barrier, gap);
  const Four damped = max(pressed - load(resistances) * speed, zero);
  const Four room = max(gap - set(kClosestPart * barrier.thickness), zero);
  FourForces forces;
  store(select(gap < set(barrier.thickness), damped, zero), forces.force);
  forces.stopped = bits(zero < (zero - speed) - room / set(dt));
  return forces;
}

inline Kernels list_kernels(const char* target) { return {target, &follow, &push}; }

}  // namespace palpate::held_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_HELD_CONTACTS_INL_H
