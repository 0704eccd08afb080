// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "palpate/sim/collision/private/held_kernels.h"
#include "palpate/sim/collision/private/nearest.h"
#include "palpate/sim/collision/private/surface_contacts.h"

namespace palpate {
namespace {

/// [m] Near triangles are those that much farther than the nearest, and hold for half of it.
constexpr double kNearWindow = 4e-4;

/// [m] And for so much at least where there are more of them than there is room for.
constexpr double kLeastHeld = 1e-4;

/// [m] A vertex so much beyond the thickness is taken for one that may touch.
constexpr double kTouchWindow = 2e-5;

/// [-] Of its gap: a contact is found again when both surfaces may have gone so far since.
constexpr double kHeldTravel = 0.1;

/// [-] Of the thickness: what goes no farther in a substep goes slowly.
constexpr double kSlow = 0.3;

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

/// The nearest of some triangles, -1 of none.
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
    if (best >= 0 && !is_nearer(point.square, point.height, nearest.square, nearest.height)) {
      continue;
    }
    best = t;
    nearest = point;
  }
  return best;
}

/// How far some triangles are from a point, as find_near_point() tells.
struct Listed {
  std::array<double, SurfaceContacts::kMostListed> square;  ///< [m²]
  std::array<double, SurfaceContacts::kMostListed> height;  ///< [m]
};

/// Four triangles at a time.
void measure_listed(const Vec3& p, std::span<const int> list, std::span<const Triangle> triangles,
                    std::span<const Vec3> x_t, Listed& listed) noexcept {
  tree_kernels::FourLists lists;
  tree_kernels::FourNearest found;
  lists.points.fill(&p);
  for (std::size_t first = 0; first < list.size(); first += 4) {
    const std::size_t count = std::min<std::size_t>(4, list.size() - first);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      lists.triangles[lane] = list.subspan(first + std::min(lane, count - 1), 1);
    }
    const unsigned healthy = tree_kernels::best().find_nearest_listed(triangles, x_t, lists, found);
    for (std::size_t lane = 0; lane < count; ++lane) {
      listed.square[first + lane] = found.square[lane];
      listed.height[first + lane] = found.height[lane];
      if ((healthy >> lane & 1U) != 0) continue;
      const NearPoint point = find_on(p, list[first + lane], triangles, x_t);
      listed.square[first + lane] = point.square;
      listed.height[first + lane] = point.height;
    }
  }
}

/// The place of the one that find_nearest() would choose; the list has one at least.
std::size_t choose_nearest(const Listed& listed, std::size_t count) noexcept {
  std::size_t best = 0;
  for (std::size_t k = 1; k < count; ++k) {
    if (is_nearer(listed.square[k], listed.height[k], listed.square[best], listed.height[best])) {
      best = k;
    }
  }
  return best;
}

/// Keeps the triangles that are no more than `window` [m] farther than the nearest. By how much [m]
/// the surfaces may move until one of the others may be nearer; where there was no room for all of
/// the window, half of what the next one is farther.
double keep_near(std::size_t v, const Listed& listed, double nearest, double window,
                 SurfaceContacts& contacts) noexcept {
  std::array<double, SurfaceContacts::kMostNear> distances;
  std::size_t count = 0;
  double next = nearest + window;
  for (std::size_t k = 0; k < contacts.listed_count[v]; ++k) {
    const double distance = std::sqrt(listed.square[k]);
    if (distance > nearest + window) continue;
    const int t = contacts.listed[v][k];
    if (count < distances.size()) {
      distances[count] = distance;
      contacts.near[v][count++] = t;
      continue;
    }
    const auto worst = std::ranges::max_element(distances);
    next = std::min(next, std::max(distance, *worst));
    if (!(distance < *worst)) continue;
    const auto at = static_cast<std::size_t>(worst - distances.begin());
    *worst = distance;
    contacts.near[v][at] = t;
  }
  std::sort(contacts.near[v].begin(),
            contacts.near[v].begin() + static_cast<std::ptrdiff_t>(count));
  contacts.near_count[v] = static_cast<unsigned char>(count);
  return 0.5 * (next - nearest);
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
  const double window = std::max(kNearWindow, 4.0 * contacts.ahead);
  const auto list = std::span<const int>(contacts.listed[v]).first(contacts.listed_count[v]);
  Listed listed;
  measure_listed(p, list, triangles, x_t, listed);
  const int nearest = list[choose_nearest(listed, list.size())];
  const NearPoint point = find_on(p, nearest, triangles, x_t);
  contacts.near_count[v] = 0;
  note_side(v, point, triangles[static_cast<std::size_t>(nearest)], before, contacts);
  const double distance = std::sqrt(point.square);
  const double spare = distance - contacts.barrier.thickness;
  if (spare > std::max(kTouchWindow, contacts.ahead)) {
    contacts.near_until[v] = contacts.moved + spare;
    return;
  }
  const double bears = keep_near(v, listed, distance, window, contacts);
  // of a fold with more triangles than there is room for, the nearest do for as long as few would
  const double least = std::max(kLeastHeld, contacts.ahead);
  contacts.near_until[v] = contacts.moved + std::max(least, bears);
}

std::span<const int> list_near(const SurfaceContacts& contacts, int vertex) noexcept {
  const auto v = static_cast<std::size_t>(vertex);
  return std::span<const int>(contacts.near[v]).first(contacts.near_count[v]);
}

NearPoint read_lane(const tree_kernels::FourNearest& found, std::size_t k) noexcept {
  const auto read = [&](const double(&from)[3][4]) noexcept {
    return Vec3(from[0][k], from[1][k], from[2][k]);
  };
  return {read(found.weights), read(found.offset), found.square[k], found.height[k],
          read(found.normal)};
}

/// The contact of a vertex with the nearest triangle and the point that is nearest there.
VertexContact choose_contact(const SurfaceContacts& contacts, int vertex, int nearest,
                             const NearPoint& point, std::span<const Triangle> triangles,
                             double reach) noexcept {
  const auto v = static_cast<std::size_t>(vertex);
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

/// Finds the contacts of the active vertices at the first `count` of these places.
void find_four(const std::array<std::size_t, 4>& places, std::size_t count,
               std::span<const Vec3> x_v, std::span<const Triangle> triangles,
               std::span<const Vec3> x_t, SurfaceContacts& contacts) noexcept {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  constexpr double kRounding = 1e-9;  // [m]
  const auto vertex_at = [&](std::size_t lane) noexcept {
    return contacts.active[places[std::min(lane, count - 1)]];
  };
  tree_kernels::FourLists lists;
  tree_kernels::FourNearest found;
  for (std::size_t lane = 0; lane < places.size(); ++lane) {
    lists.points[lane] = &x_v[static_cast<std::size_t>(vertex_at(lane))];
    lists.triangles[lane] = list_near(contacts, vertex_at(lane));
  }
  const unsigned healthy = tree_kernels::best().find_nearest_listed(triangles, x_t, lists, found);
  for (std::size_t lane = 0; lane < count; ++lane) {
    VertexContact& contact = contacts.contact[places[lane]];
    contact =
        (healthy >> lane & 1U) == 0
            ? find_contact(contacts, vertex_at(lane), *lists.points[lane], triangles, x_t, kAny)
            : choose_contact(contacts, vertex_at(lane), static_cast<int>(found.triangle[lane]),
                             read_lane(found, lane), triangles, kAny);
    const double spare = contact.gap - contacts.barrier.thickness - kRounding;
    contacts.far_until[places[lane]] =
        contact.triangle < 0 ? contacts.travelled : contacts.travelled + spare;
    contacts.held_until[places[lane]] =
        contact.triangle < 0 ? contacts.travelled : contacts.travelled + kHeldTravel * contact.gap;
    contacts.resistance[places[lane]] = SurfaceContacts::kNotKnown;
  }
}

/// No contact for a while; below 0, the triangle can be told from its number.
void leave_out(VertexContact& contact) noexcept {
  if (contact.triangle >= 0) contact.triangle = ~contact.triangle;
}
void take_back(VertexContact& contact) noexcept {
  if (contact.triangle < 0) contact.triangle = ~contact.triangle;
}

}  // namespace

void find_near(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
               std::span<const Vec3> x_t, SurfaceContacts& contacts,
               const Before& before) noexcept {
  contacts.active_count = 0;
  contacts.travelled = 0.0;
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
    const auto at = static_cast<std::size_t>(contacts.active_count++);
    contacts.active[at] = static_cast<int>(v);
    contacts.far_until[at] = contacts.held_until[at] = 0.0;
  }
}

VertexContact find_contact(const SurfaceContacts& contacts, int vertex, const Vec3& x,
                           std::span<const Triangle> triangles, std::span<const Vec3> x_t,
                           double reach) noexcept {
  NearPoint point;
  const int nearest = find_nearest(x, list_near(contacts, vertex), triangles, x_t, point);
  return choose_contact(contacts, vertex, nearest, point, triangles, reach);
}

bool go_slowly(const SurfaceContacts& contacts, double travel) noexcept {
  const double thickness = contacts.barrier.thickness;
  return travel < kSlow * thickness && contacts.ahead < (1.0 - kClosestPart) * thickness;
}

void find_contacts(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
                   std::span<const Vec3> x_t, double travel, SurfaceContacts& contacts) noexcept {
  const std::span<const int> active = contacts.active_in_use();
  const bool slowly = go_slowly(contacts, travel);
  if (slowly) contacts.travelled += travel;
  std::array<std::size_t, 4> lanes;
  std::size_t count = 0, held = 0;
  const auto find = [&](std::size_t k) noexcept {
    lanes[count++] = k;
    if (count < lanes.size()) return;
    find_four(lanes, count, x_v, triangles, x_t, contacts);
    count = 0;
  };
  for (std::size_t k = 0; k < active.size(); ++k) {
    if (slowly && contacts.far_until[k] > contacts.travelled) {
      leave_out(contacts.contact[k]);
    } else if (slowly && contacts.held_until[k] > contacts.travelled) {
      take_back(contacts.contact[k]);
      contacts.held[held++] = static_cast<int>(k);
    } else {
      find(k);
    }
  }
  if (travel != 0.0) {
    const auto places = std::span<const int>(contacts.held).first(held);
    const std::size_t lapsed =
        held_kernels::best().follow(x_v, triangles, x_t, places, contacts, contacts.lapsed);
    for (std::size_t n = 0; n < lapsed; ++n) find(static_cast<std::size_t>(contacts.lapsed[n]));
  }
  if (count > 0) find_four(lanes, count, x_v, triangles, x_t, contacts);
}

}  // namespace palpate
