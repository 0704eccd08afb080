// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/tick/private/rigid_touch.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// [-] Of the stiffness of what a sphere is on, that of a bristle.
constexpr double kBristlePart = 0.5;

/// [-] Of its radius: a sphere whose centre is nearer than this to scenery comes no nearer.
constexpr double kGuarded = 0.3;

/// Of the guard, at most.
constexpr int kGuardRounds = 8;

/// [-] Two triangles that a sphere is on in directions of a larger cosine are one contact.
constexpr double kSameDirection = 0.95;

std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

/// [N] k d / max(0.1, 1 - d/r), damped: the barrier of [contact: law] for what is hard.
double press_hard(const RigidView& body, double depth, double radius, double away) noexcept {
  const double z = std::max(kBarrierFloor, 1.0 - depth / radius);
  const double k = body.fixed.contact_stiffness;
  return std::max(0.0, k * depth / z - body.damp(k) * away);
}

/// [N] That stops what would still come nearer to `at` along n than by `room` [m] in this step,
/// under all that is in the wrench so far: the last guard, as nothing may come through.
double stop_approach(const RigidView& body, const Vec3& at, const Vec3& n, double room) noexcept {
  const Quaternion& turn = body.state.orientation;
  const Vec3& inertia = body.moved.moved.inertia;
  const auto turned = [&](const Vec3& torque) noexcept {
    return Vec3(turn * (turn.conjugate() * torque).cwiseQuotient(inertia));
  };
  const double mass = body.moved.moved.mass;
  const Vec3 arm = at - body.state.position, lever = arm.cross(n);
  const Wrench& wrench = body.moved.wrench;
  const Vec3 w = body.state.angular_velocity + body.dt * turned(wrench.torque);
  const Vec3 v = body.state.velocity + body.dt / mass * wrench.force + w.cross(arm);
  return std::max(0.0, -v.dot(n) - std::max(0.0, room) / body.dt) /
         (body.dt * (1.0 / mass + lever.dot(turned(lever))));
}

/// Where a sphere is on a scenery: at most three directions, as in a corner.
struct HardTouch {
  std::array<SurfacePoint, 8> nearest;
  std::size_t count = 0;
};

HardTouch find_on_scenery(const RigidView& body, std::size_t s, const HardSurface& scenery,
                          std::span<const int> list) noexcept {
  HardTouch touch;
  const Vec3& centre = body.moved.centre[s];
  for (const int t : list) {
    const Triangle& corners = scenery.tree.triangles()[at(t)];
    const SurfacePoint found = find_closest_on_triangle(
        centre, scenery.x[at(corners[0])], scenery.x[at(corners[1])], scenery.x[at(corners[2])]);
    if (!(found.distance < body.fixed.sphere_radii[s]) || !(found.distance > 0.0)) continue;
    std::size_t k = std::min(touch.count, touch.nearest.size() - 1);
    if (touch.count == touch.nearest.size() && !(found.distance < touch.nearest[k].distance)) {
      continue;
    }
    touch.count = std::min(touch.count + 1, touch.nearest.size());
    for (; k > 0 && found.distance < touch.nearest[k - 1].distance; --k) {
      touch.nearest[k] = touch.nearest[k - 1];
    }
    touch.nearest[k] = found;
  }
  return touch;
}

/// Adds the friction of a bristle between the body and a point of what does not move with it.
Vec3 rub(const RigidView& body, std::size_t s, const Vec3& sum, const Vec3& there,
         const Vec3& velocity, Bristle& bristle) noexcept {
  const double pressed = sum.norm();
  const Vec3 here = place_of(body.state, bristle.place);
  Vec3 slip;
  const Vec3 pull =
      pull_bristle(body.bristle(kBristlePart * body.fixed.contact_stiffness), there - here,
                   velocity - velocity_at(body.state, here), sum / pressed, pressed, slip);
  bristle.place += body.state.orientation.conjugate() * slip;
  // the contact has rolled away from it: it is placed again in the next substep
  const double r = body.fixed.sphere_radii[s];
  const Vec3 arm = here - (body.moved.centre[s] - r * sum / pressed);
  if (arm.norm() > 0.5 * r) bristle.holds = false;
  body.moved.wrench.add(here, pull, body.state.position);
  return pull;
}

/// One sphere after the other, again and again: what stops one turns the body towards others.
void guard_spheres(const HardSurface& scenery, const SphereLists& lists,
                   const RigidView& body) noexcept {
  bool stopped = true;
  for (int round = 0; round < kGuardRounds && stopped; ++round) {
    stopped = false;
    for (std::size_t s = 0; s < body.sphere_count(); ++s) {
      const HardTouch touch = find_on_scenery(body, s, scenery, lists.of(s));
      if (touch.count == 0) continue;
      const SurfacePoint& point = touch.nearest[0];
      const Vec3 n = (body.moved.centre[s] - point.point) / point.distance;
      const double room = point.distance - kGuarded * body.fixed.sphere_radii[s];
      const double force = stop_approach(body, point.point, n, room);
      if (!(force > 0.0)) continue;
      body.moved.wrench.add(point.point, force * n, body.state.position);
      stopped = true;
    }
  }
}

}  // namespace

void touch_scenery(const HardSurface& scenery, const SphereLists& lists, const RigidView& body,
                   RigidContacts& rigid) noexcept {
  for (std::size_t s = 0; s < body.sphere_count(); ++s) {
    const HardTouch touch = find_on_scenery(body, s, scenery, lists.of(s));
    Bristle& bristle = rigid.bristles[lists.first_bristle + s];
    Vec3 sum = Vec3::Zero();
    std::array<Vec3, 3> taken;
    std::size_t count = 0;
    for (std::size_t k = 0; k < touch.count && count < taken.size(); ++k) {
      const SurfacePoint& point = touch.nearest[k];
      const Vec3 n = (body.moved.centre[s] - point.point) / point.distance;
      const bool known =
          std::any_of(taken.begin(), taken.begin() + std::ptrdiff_t(count),
                      [&](const Vec3& other) { return n.dot(other) > kSameDirection; });
      if (known) continue;
      taken[count++] = n;
      const double away = velocity_at(body.state, point.point).dot(n);
      const double r = body.fixed.sphere_radii[s];
      const Vec3 force = press_hard(body, r - point.distance, r, away) * n;
      body.moved.wrench.add(point.point, force, body.state.position);
      sum += force;
    }
    body.moved.contacts += static_cast<int>(count);
    if (sum.isZero(0.0) || body.fixed.friction == 0.0) {
      bristle.holds = false;
      continue;
    }
    if (!bristle.holds) {
      const Vec3 point = touch.nearest[0].point;
      bristle = {true, body.state.orientation.conjugate() * (point - body.state.position), point,
                 0};
    }
    rub(body, s, sum, bristle.other, Vec3::Zero(), bristle);
  }
  guard_spheres(scenery, lists, body);
}

/// Two rigid bodies, each sphere with each: the softer spring, the smaller friction.
void touch_pair(const RigidView& a, const RigidView& b, std::span<Bristle> bristles) noexcept {
  const RigidView soft{a.fixed.contact_stiffness < b.fixed.contact_stiffness ? a.fixed : b.fixed,
                       a.state, a.moved, a.dt};
  for (std::size_t s = 0; s < a.sphere_count(); ++s) {
    for (std::size_t u = 0; u < b.sphere_count(); ++u) {
      Bristle& bristle = bristles[s * b.sphere_count() + u];
      const Vec3 arm = a.moved.centre[s] - b.moved.centre[u];
      const double ra = a.fixed.sphere_radii[s], rb = b.fixed.sphere_radii[u];
      const double distance = arm.norm(), depth = ra + rb - distance;
      if (!(depth > 0.0) || !(distance > 0.0)) {
        bristle.holds = false;
        continue;
      }
      const Vec3 n = arm / distance, point = b.moved.centre[u] + (rb - 0.5 * depth) * n;
      const double away = (velocity_at(a.state, point) - velocity_at(b.state, point)).dot(n);
      const Vec3 force = press_hard(soft, depth, std::min(ra, rb), away) * n;
      a.moved.wrench.add(point, force, a.state.position);
      b.moved.wrench.add(point, -force, b.state.position);
      ++a.moved.contacts;
      ++b.moved.contacts;
      if (force.isZero(0.0) || std::min(a.fixed.friction, b.fixed.friction) == 0.0) continue;
      if (!bristle.holds) {
        bristle = {true, a.state.orientation.conjugate() * (point - a.state.position),
                   b.state.orientation.conjugate() * (point - b.state.position), 0};
      }
      const Vec3 there = place_of(b.state, bristle.other);
      const Vec3 pull = rub(a, s, force, there, velocity_at(b.state, there), bristle);
      b.moved.wrench.add(there, -pull, b.state.position);
    }
  }
}

}  // namespace palpate
