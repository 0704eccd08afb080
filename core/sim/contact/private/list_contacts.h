// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/contact/private/touched_surface.h"
#include "palpate/sim/tree/private/box.h"

namespace palpate {

// Which triangles of one surface a tool touches at a position, and how hard: by the closest point
// in vector code or one after the other, then by the near field where the surface has one.

/// A contact and whose it is.
struct TriangleContact {
  int triangle = 0;
  Contact contact;
};

inline const Triangle& triangle_at(const TouchedSurface& surface, int t) noexcept {
  return surface.triangles[static_cast<std::size_t>(t)];
}

inline const Vec3& corner_at(const TouchedSurface& surface, int t, std::size_t c) noexcept {
  return surface.x[static_cast<std::size_t>(triangle_at(surface, t)[c])];
}

inline void fill_axis(const Capsule& axis, std::size_t number, std::size_t lane,
                      ContactLanes& lanes) noexcept {
  lanes.capsule[lane] = static_cast<int>(number);
  for (std::size_t k = 0; k < 3; ++k) {
    lanes.axis[k][lane] = axis.from[static_cast<Eigen::Index>(k)];
    lanes.axis[3 + k][lane] = axis.to[static_cast<Eigen::Index>(k)];
  }
}

inline void fill_lane(const TouchedSurface& surface, std::size_t candidate,
                      std::size_t lane) noexcept {
  const Candidates& candidates = *surface.candidates;
  const int t = candidates.triangles[candidate];
  ContactLanes& lanes = surface.candidates->lanes;
  lanes.triangle[lane] = t;
  lanes.border[lane] = find_openness(candidates, t).border;
  lanes.rest_area[lane] = surface.candidates->areas[candidate];
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& corner = corner_at(surface, t, c);
    for (std::size_t k = 0; k < 3; ++k) {
      lanes.corners[3 * c + k][lane] = corner[static_cast<Eigen::Index>(k)];
    }
  }
}

/// [m] No axis at p is nearer to the box.
inline double bound_distance(const Capsule& axis, const Vec3& p, const Box& box) noexcept {
  const Vec3 low = p + axis.from.cwiseMin(axis.to), high = p + axis.from.cwiseMax(axis.to);
  return (box.low - high).cwiseMax(low - box.high).maxCoeff();
}

/// Takes the candidates into lanes that have part in boxes within `reach` [m] of p, or of an axis
/// at p, with a lane for each axis.
inline void fill_lanes(const TouchedSurface& surface, const Axes& axes, const Vec3& p,
                       double reach) noexcept {
  const Candidates& candidates = *surface.candidates;
  ContactLanes& lanes = surface.candidates->lanes;
  std::size_t count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    const int t = candidates.triangles[i];
    const Box box = bound_triangle(corner_at(surface, t, 0), corner_at(surface, t, 1),
                                   corner_at(surface, t, 2));
    if (axes.count == 0 && compute_squared_distance(p, box.low, box.high) < reach * reach) {
      fill_lane(surface, i, count++);
    }
    for (std::size_t k = 0; k < axes.list().size(); ++k) {
      if (!(bound_distance(axes.list()[k], p, box) < reach)) continue;
      fill_axis(axes.list()[k], k, count, lanes);
      fill_lane(surface, i, count++);
    }
  }
  lanes.count = static_cast<int>(count);
  // a vector is always full: the last triangle again, whose lane nobody reads
  for (std::size_t lane = count; lane % static_cast<std::size_t>(lanes.width) != 0; ++lane) {
    for (auto& column : lanes.corners) column[lane] = column[count - 1];
    lanes.rest_area[lane] = lanes.rest_area[count - 1];
    if (axes.count == 0) continue;
    for (auto& column : lanes.axis) column[lane] = column[count - 1];
  }
  lanes.filled_at = p;
  lanes.reach = reach;
  lanes.found = false;
}

/// The contact of a lane with the axis that it is for.
inline bool find_lane_contact(const Shape& shape, const TouchedSurface& surface, const Vec3& p,
                              std::size_t lane, Contact& contact) noexcept {
  const ContactLanes& lanes = surface.candidates->lanes;
  const int t = lanes.triangle[lane];
  Shape one{shape.tool, {}};
  if (shape.axes.count > 0) {
    one.axes.capsules[0] = shape.axes.list()[static_cast<std::size_t>(lanes.capsule[lane])];
    one.axes.count = 1;
  }
  const Vec3 &a = corner_at(surface, t, 0), &b = corner_at(surface, t, 1),
             &c = corner_at(surface, t, 2);
  const bool touches = find_shape_contact(one, lanes.rest_area[lane], p, a, b, c, contact,
                                          find_openness(*surface.candidates, t));
  if (touches && spreads(shape, surface.springs)) spread_contact(one, p, a, b, c, contact);
  return touches;
}

/// Again those of triangles with a border, which vector code knows nothing of.
inline void find_at_border(const Shape& shape, const TouchedSurface& surface,
                           const Vec3& p) noexcept {
  ContactLanes& lanes = surface.candidates->lanes;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes.count); ++lane) {
    if (lanes.border[lane] == 0) continue;
    Contact contact;
    lanes.force[lane] = lanes.stiffness[lane] = 0.0;
    if (!find_lane_contact(shape, surface, p, lane, contact)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      lanes.weights[k][lane] = contact.weights[static_cast<Eigen::Index>(k)];
      lanes.direction[k][lane] = contact.direction[static_cast<Eigen::Index>(k)];
    }
    lanes.distance[lane] = contact.distance;
    lanes.force[lane] = contact.force;
    lanes.stiffness[lane] = contact.stiffness;
  }
}

/// Part of the radius by which a tool may move on, within a substep, with the lanes that it has.
inline constexpr double kLaneMargin = 0.125;

inline void copy_lane(std::size_t from, std::size_t to, ContactLanes& lanes) noexcept {
  const auto copy = [&](auto& columns) noexcept {
    for (auto& column : columns) column[to] = column[from];
  };
  lanes.triangle[to] = lanes.triangle[from];
  lanes.border[to] = lanes.border[from];
  if (!lanes.capsule.empty()) {
    lanes.capsule[to] = lanes.capsule[from];
    copy(lanes.axis);
  }
  copy(lanes.corners);
  copy(lanes.weights);
  copy(lanes.direction);
  for (auto* column : {&lanes.rest_area, &lanes.distance, &lanes.force, &lanes.stiffness}) {
    (*column)[to] = (*column)[from];
  }
}

/// Leaves out the lanes, found at p, of triangles whose box is within reach and which are not.
inline void drop_far_lanes(const Vec3& p, double reach, ContactLanes& lanes) noexcept {
  std::size_t kept = 0;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes.count); ++lane) {
    if (!(lanes.distance[lane] < reach)) continue;
    if (kept != lane) copy_lane(lane, kept, lanes);
    ++kept;
  }
  lanes.count = static_cast<int>(kept);
  lanes.filled_at = p;
  lanes.reach = reach;
}

/// Contacts at p of all lanes; once for each p. The tool's steps within a substep are far shorter
/// than its radius, so that the lanes filled at its beginning mostly do for all.
inline void find_in_lanes(const Shape& shape, const TouchedSurface& surface,
                          const Vec3& p) noexcept {
  ContactLanes& lanes = surface.candidates->lanes;
  const double radius = shape.tool.radius;
  const double reach = (1.0 + kLaneMargin) * radius;
  const bool fills = !((p - lanes.filled_at).norm() + radius <= lanes.reach);
  if (fills) fill_lanes(surface, shape.axes, p, reach);
  if (lanes.found && lanes.centre == p) return;
  lanes.centre = p;
  lanes.side = find_openness(*surface.candidates, 0).side;
  const auto find = shape.axes.count == 0             ? lanes.find
                    : spreads(shape, surface.springs) ? lanes.find_jaws
                                                      : lanes.find_capsules;
  find(lanes, radius, shape.tool.stiffness);
  if (fills) drop_far_lanes(p, reach, lanes);
  if (surface.candidates->at_border) find_at_border(shape, surface, p);
  lanes.found = true;
}

/// The lane of the axis that is nearest to the triangle of this one, which is the first of its
/// lanes; `next` becomes the first of the next triangle.
inline std::size_t find_nearest_lane(const ContactLanes& lanes, std::size_t lane,
                                     std::size_t& next) noexcept {
  std::size_t nearest = lane;
  const auto count = static_cast<std::size_t>(lanes.count);
  for (next = lane + 1; next < count && lanes.triangle[next] == lanes.triangle[lane]; ++next) {
    if (lanes.distance[next] < lanes.distance[nearest]) nearest = next;
  }
  return nearest;
}

inline Contact read_lane(const ContactLanes& lanes, std::size_t lane) noexcept {
  const auto vector = [&](const std::array<ContactLanes::Column, 3>& columns) noexcept {
    return Vec3(columns[0][lane], columns[1][lane], columns[2][lane]);
  };
  return {vector(lanes.weights), vector(lanes.direction), lanes.distance[lane], lanes.force[lane],
          lanes.stiffness[lane]};
}

/// [m] Where a ball at p is for a surface: under a near field lifted off the triangles.
inline Vec3 lift(const TouchedSurface& surface, const Vec3& p) noexcept {
  return surface.near ? Vec3(p + surface.candidates->near.lift) : p;
}

/// Calls `take(triangle, contact)` for every triangle that the hard law touches with the centre at
/// p, which is lifted.
template <class Take>
void for_each_closest(const Shape& shape, const TouchedSurface& surface, const Vec3& p,
                      Take take) noexcept {
  const Candidates& candidates = *surface.candidates;
  if (candidates.count == 0) return;
  const ContactLanes& lanes = candidates.lanes;
  if (lanes.find != nullptr && shape.axes.count > 0) {
    find_in_lanes(shape, surface, p);
    for (std::size_t lane = 0, next = 0; lane < static_cast<std::size_t>(lanes.count);
         lane = next) {
      const std::size_t nearest = find_nearest_lane(lanes, lane, next);
      if (lanes.force[nearest] > 0.0) take(lanes.triangle[nearest], read_lane(lanes, nearest));
    }
    return;
  }
  if (lanes.find != nullptr) {
    find_in_lanes(shape, surface, p);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes.count); ++lane) {
      if (lanes.force[lane] > 0.0) take(lanes.triangle[lane], read_lane(lanes, lane));
    }
    return;
  }
  Contact contact;
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    const int t = candidates.triangles[i];
    const Vec3 &a = corner_at(surface, t, 0), &b = corner_at(surface, t, 1),
               &c = corner_at(surface, t, 2);
    if (!find_shape_contact(shape, candidates.areas[i], p, a, b, c, contact,
                            find_openness(candidates, t))) {
      continue;
    }
    if (spreads(shape, surface.springs)) spread_contact(shape, p, a, b, c, contact);
    take(t, contact);
  }
}

/// Contacts at p, lifted, under the law of the surface's near field; once for each p.
inline void find_near(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept {
  NearContacts& near = surface.candidates->near;
  if (near.found && near.centre == p) return;
  near.count = 0;
  for_each_closest(shape, surface, p, [&](int t, const Contact& contact) noexcept {
    const auto at = static_cast<std::size_t>(near.count++);
    near.triangle[at] = t;
    near.closest[at] = contact;
  });
  find_near_contacts(shape, surface, p);
}

/// Calls `take(triangle, contact)` for every contact with the centre at p; under a near field some
/// may be without force.
template <class Take>
void for_each_contact(const Shape& shape, const TouchedSurface& surface, const Vec3& p,
                      Take take) noexcept {
  if (!surface.near) return for_each_closest(shape, surface, p, take);
  find_near(shape, surface, lift(surface, p));
  const NearContacts& near = surface.candidates->near;
  for (std::size_t i = 0; i < static_cast<std::size_t>(near.count); ++i) {
    take(near.triangle[i], near.contact[i]);
  }
}

/// The contacts with force of a tool at `position` [m] with one of its surfaces as that is now, by
/// the law that balance_tool() has: its candidates must be those of the place. Writes into the
/// candidates' work space, so that they should not be those of a running scene. Allocates.
inline std::vector<TriangleContact> list_contacts(
    const Tool& tool, const TouchedSurface& surface, const Vec3& position,
    const Quaternion& orientation = Quaternion::Identity()) {
  std::vector<TriangleContact> list;
  const Shape shape{tool, Axes(tool, orientation)};
  surface.candidates->lanes.reach = -1.0;
  surface.candidates->near.found = false;
  for_each_contact(shape, surface, position, [&](int t, const Contact& contact) {
    if (contact.force > 0.0) list.push_back({t, contact});
  });
  return list;
}

}  // namespace palpate
