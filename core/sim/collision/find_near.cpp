// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "palpate/sim/collision/private/nearest.h"
#include "palpate/sim/collision/private/surface_contacts.h"

namespace palpate {
namespace {

/// [m] Near triangles are those that much farther than the nearest, and hold for half of it.
constexpr double kNearWindow = 2e-4;

/// [m] A vertex so much beyond the thickness is taken for one that may touch.
constexpr double kTouchWindow = 2e-5;

/// [-] Two triangles of a common edge have the same nearest point, but for rounding.
constexpr double kTie = 1e-9;

/// [m] How deep a vertex may have come through and is still pushed back. Deeper in itself a body
/// has its other side.
double find_depth(const SurfaceContacts& contacts) noexcept {
  return contacts.same ? contacts.barrier.thickness : kListMargin;
}

/// Whether the nearest point lies on the border of an open surface: what is there is neither before
/// it nor behind.
bool is_over_border(const SurfaceContacts& contacts, const Triangle& corners,
                    const Vec3& weights) noexcept {
  if (contacts.closed || weights.minCoeff() > 0.0) return false;
  for (int c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]);
    if (weights[c] > 0.0 && contacts.on_border[v] == 0) return false;
  }
  return true;
}

NearPoint find_on(const Vec3& p, int triangle, std::span<const Triangle> triangles,
                  std::span<const Vec3> x_t) noexcept {
  const auto& [a, b, c] = triangles[static_cast<std::size_t>(triangle)];
  return find_near_point(p, x_t[static_cast<std::size_t>(a)], x_t[static_cast<std::size_t>(b)],
                         x_t[static_cast<std::size_t>(c)]);
}

/// The nearest of some triangles. Where several share the point, the one that p is highest over or
/// deepest under tells the side: over an edge, the plane of another may lie on either.
int find_nearest(const Vec3& p, std::span<const int> list, std::span<const Triangle> triangles,
                 std::span<const Vec3> x_t, NearPoint& nearest) noexcept {
  int best = -1;
  NearPoint point;
  for (const int t : list) {
    const auto& [a, b, c] = triangles[static_cast<std::size_t>(t)];
    const double most = best < 0 ? std::numeric_limits<double>::infinity() : nearest.square;
    if (!find_within(p, x_t[static_cast<std::size_t>(a)], x_t[static_cast<std::size_t>(b)],
                     x_t[static_cast<std::size_t>(c)], most, point)) {
      continue;
    }
    if (best >= 0) {
      const double slack = kTie * nearest.square;
      if (point.square > nearest.square + slack) continue;
      const bool tied = point.square >= nearest.square - slack;
      if (tied && !(std::abs(point.height) > std::abs(nearest.height))) continue;
    }
    best = t;
    nearest = point;
  }
  return best;
}

void keep_near(std::size_t v, const Vec3& p, double nearest, double window,
               std::span<const Triangle> triangles, std::span<const Vec3> x_t,
               SurfaceContacts& contacts) noexcept {
  std::array<double, SurfaceContacts::kMostNear> distances;
  std::size_t count = 0;
  for (std::size_t k = 0; k < contacts.listed_count[v]; ++k) {
    const int t = contacts.listed[v][k];
    const double distance = std::sqrt(find_on(p, t, triangles, x_t).square);
    if (distance > nearest + window) continue;
    if (count < distances.size()) {
      distances[count] = distance;
      contacts.near[v][count++] = t;
      continue;
    }
    const auto worst = std::ranges::max_element(distances);
    if (!(distance < *worst)) continue;
    const auto at = static_cast<std::size_t>(worst - distances.begin());
    *worst = distance;
    contacts.near[v][at] = t;
  }
  std::sort(contacts.near[v].begin(),
            contacts.near[v].begin() + static_cast<std::ptrdiff_t>(count));
  contacts.near_count[v] = static_cast<unsigned char>(count);
}

/// A closed surface pushes outwards. Of an open one, a vertex is kept on the side it came from; and
/// what a body has behind its own surface is no contact, but its other side.
bool knows_side(const SurfaceContacts& contacts) noexcept {
  return contacts.closed && !contacts.same;
}

/// Whether a vertex was before a triangle's plane.
bool was_before(std::size_t v, const Triangle& corners, const Before& before) noexcept {
  const Vec3& a = before.x_t[static_cast<std::size_t>(corners[0])];
  const Vec3& b = before.x_t[static_cast<std::size_t>(corners[1])];
  const Vec3& c = before.x_t[static_cast<std::size_t>(corners[2])];
  return (b - a).cross(c - a).dot(before.x_v[v] - a) >= 0.0;
}

void note_side(std::size_t v, const NearPoint& point, const Triangle& corners, const Before& before,
               SurfaceContacts& contacts) noexcept {
  if (knows_side(contacts)) return;
  signed char& side = contacts.side[v];
  const bool in_front = !(point.height < 0.0);
  if (is_over_border(contacts, corners, point.weights)) {
    side = 0;
  } else if (contacts.same && contacts.closed) {
    if (point.height > 0.0) side = 1;
  } else if (side == 0 || in_front == (side > 0)) {
    side = in_front ? 1 : -1;
  } else if (contacts.follows_sides && std::abs(side) == 1) {
    if (was_before(v, corners, before) == in_front) {
      side = in_front ? 1 : -1;
    } else {
      side = in_front ? -2 : 2;
    }
  }
}

/// Likewise of a vertex whose lists still hold.
void follow_side(std::size_t v, const Vec3& p, std::span<const Triangle> triangles,
                 std::span<const Vec3> x_t, const Before& before,
                 SurfaceContacts& contacts) noexcept {
  NearPoint point;
  const auto list = std::span<const int>(contacts.near[v]).first(contacts.near_count[v]);
  const int nearest = find_nearest(p, list, triangles, x_t, point);
  note_side(v, point, triangles[static_cast<std::size_t>(nearest)], before, contacts);
}

void find_near_of(std::size_t v, const Vec3& p, std::span<const Triangle> triangles,
                  std::span<const Vec3> x_t, const Before& before,
                  SurfaceContacts& contacts) noexcept {
  const double window = std::max(kNearWindow, 2.0 * contacts.ahead);
  const auto list = std::span<const int>(contacts.listed[v]).first(contacts.listed_count[v]);
  NearPoint point;
  contacts.near_count[v] = 0;
  const int nearest = find_nearest(p, list, triangles, x_t, point);
  if (nearest < 0) return;
  note_side(v, point, triangles[static_cast<std::size_t>(nearest)], before, contacts);
  const double distance = std::sqrt(point.square);
  const double spare = distance - contacts.barrier.thickness;
  if (spare > std::max(kTouchWindow, contacts.ahead)) {
    contacts.near_until[v] = contacts.moved + spare;
    return;
  }
  contacts.near_until[v] = contacts.moved + 0.5 * window;
  keep_near(v, p, distance, window, triangles, x_t, contacts);
}

}  // namespace

void find_near(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
               std::span<const Vec3> x_t, SurfaceContacts& contacts,
               const Before& before) noexcept {
  contacts.active_count = 0;
  contacts.follows_sides = !before.x_v.empty();
  const bool follows = contacts.follows_sides && !knows_side(contacts) && !contacts.same;
  for (std::size_t v = 0; v < x_v.size(); ++v) {
    if (contacts.listed_count[v] == 0) {
      contacts.near_count[v] = 0;
      if (!knows_side(contacts)) contacts.side[v] = 0;
      continue;
    }
    if (contacts.moved + contacts.ahead > contacts.near_until[v]) {
      find_near_of(v, x_v[v], triangles, x_t, before, contacts);
    } else if (follows && contacts.near_count[v] > 0) {
      follow_side(v, x_v[v], triangles, x_t, before, contacts);
    }
    if (contacts.near_count[v] == 0) continue;
    contacts.active[static_cast<std::size_t>(contacts.active_count++)] = static_cast<int>(v);
  }
}

VertexContact find_contact(const SurfaceContacts& contacts, int vertex, const Vec3& x,
                           std::span<const Triangle> triangles, std::span<const Vec3> x_t,
                           double reach) noexcept {
  const auto v = static_cast<std::size_t>(vertex);
  const auto list = std::span<const int>(contacts.near[v]).first(contacts.near_count[v]);
  NearPoint point;
  const int nearest = find_nearest(x, list, triangles, x_t, point);
  if (nearest < 0 || contacts.side[v] == 0) return {};
  if (is_over_border(contacts, triangles[static_cast<std::size_t>(nearest)], point.weights)) {
    return {};
  }
  const double distance = std::sqrt(point.square), side = contacts.side[v] > 0 ? 1.0 : -1.0;
  const bool through = side * point.height < 0.0;
  // nobody has come through by more than may have gone since it was looked at
  const bool jumped = contacts.follows_sides && !knows_side(contacts) && !contacts.same &&
                      std::abs(contacts.side[v]) == 1 && distance > contacts.ahead;
  if (through && jumped) return {};
  const double gap = through ? -distance : distance;
  if (!(gap < reach) || gap < -find_depth(contacts)) return {};
  constexpr double kOnSurface = 1e-9;  // [m]
  VertexContact contact{nearest, point.weights, side * point.normal, gap};
  if (distance > kOnSurface) contact.normal = point.offset / (through ? -distance : distance);
  return contact;
}

}  // namespace palpate
