// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/model/private/sum_over_pushes.h"
#include "palpate/sim/tick/private/rigid_touch.h"

namespace palpate {
namespace {

/// [m] What is so near to a sphere counts as a contact for what it asks of steps and masses.
constexpr double kSoon = 2e-4;

/// [N/m] Of a bristle in tissue.
constexpr double kTissueBristle = 50.0;

std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

/// The contact of a sphere with a triangle of tissue, which it touches as a tip does.
bool find_on_tissue(const RigidView& body, std::size_t s, double area, const Triangle& corners,
                    std::span<const Vec3> x, double more, Contact& contact) noexcept {
  const Tool ball{.radius = body.fixed.sphere_radii[s] + more, .stiffness = body.fixed.stiffness};
  return find_contact(ball, area, body.moved.centre[s], x[at(corners[0])], x[at(corners[1])],
                      x[at(corners[2])], contact);
}

/// [m/s] Of a point of a tissue's surface.
Vec3 find_velocity(const TissueModel& tissue, const SoftState& state, const Triangle& corners,
                   const Vec3& weights) noexcept {
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < 3; ++c) {
    const std::size_t v = at(corners[at(c)]);
    if (tissue.skin.corners.empty()) {
      sum += weights[c] * state.tissue.velocity[v];
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      sum += weights[c] * tissue.skin.weights[v][k] *
             state.tissue.velocity[at(tissue.skin.corners[v][k])];
    }
  }
  return sum;
}

/// The contacts of one sphere with a tissue.
struct SphereTouch {
  std::array<Push, kMostSpherePushes> pushes;  ///< on the sphere
  std::size_t count = 0;
  Vec3 sum = Vec3::Zero();  ///< [N]
  double stored = 0.0;      ///< [J]
};

void find_pressures(const RigidView& body, std::size_t s, const SoftBody& soft,
                    const SoftState& state, std::span<const int> list,
                    SphereTouch& touch) noexcept {
  const std::span<const Vec3> x = surface_position(state);
  for (const int t : list) {
    const Triangle& corners = soft.tissue.triangles[at(t)];
    Contact contact;
    if (!find_on_tissue(body, s, soft.rest_areas[at(t)], corners, x, 0.0, contact)) continue;
    if (touch.count == touch.pushes.size()) return;
    const Vec3 point = compute_point(corners, contact.weights, x);
    const double away = (velocity_at(body.state, point) -
                         find_velocity(soft.tissue, state, corners, contact.weights))
                            .dot(contact.direction);
    const double force = std::max(0.0, contact.force - body.damp(contact.stiffness) * away);
    touch.stored += contact.force * (body.fixed.sphere_radii[s] - contact.distance);
    touch.pushes[touch.count++] = {t, contact.weights, force * contact.direction};
    touch.sum += force * contact.direction;
  }
}

/// A bristle between the sphere and the triangle that presses it most, shared out as the pressures
/// are.
void add_friction(const RigidView& body, std::size_t s, const SoftBody& soft,
                  const SoftState& state, SphereTouch& touch, Bristle& bristle) noexcept {
  const double pressed = touch.sum.norm();
  if (!(pressed > 0.0) || body.fixed.friction == 0.0) {
    bristle.holds = false;
    return;
  }
  const Vec3 normal = touch.sum / pressed;
  const std::span<const Vec3> x = surface_position(state);
  if (!bristle.holds) {
    const auto begin = touch.pushes.begin();
    const auto most = std::max_element(
        begin, begin + static_cast<std::ptrdiff_t>(touch.count),
        [](const Push& a, const Push& b) { return a.force.squaredNorm() < b.force.squaredNorm(); });
    const Vec3 point = compute_point(soft.tissue.triangles[at(most->triangle)], most->weights, x);
    bristle = {true, body.state.orientation.conjugate() * (point - body.state.position),
               most->weights, most->triangle};
  }
  const Triangle& corners = soft.tissue.triangles[at(bristle.triangle)];
  const Vec3 here = place_of(body.state, bristle.place);
  const Vec3 there = compute_point(corners, bristle.other, x);
  const Vec3 speed =
      find_velocity(soft.tissue, state, corners, bristle.other) - velocity_at(body.state, here);
  Vec3 slip;
  const Vec3 pull =
      pull_bristle(body.bristle(kTissueBristle), there - here, speed, normal, pressed, slip);
  bristle.place += body.state.orientation.conjugate() * slip;
  // one that the contact has moved away from is placed again in the next substep
  if ((here - body.moved.centre[s]).norm() > 2.0 * body.fixed.sphere_radii[s]) {
    bristle.holds = false;
  }
  for (std::size_t k = 0; k < touch.count; ++k) {
    touch.pushes[k].force += touch.pushes[k].force.norm() / pressed * pull;
  }
}

/// Adds to the rows [1/s²] of the particles that carry a triangle: of a contact of the slope k
/// between a body and sum_i J_i x_i the row i of M⁻¹K has the sum k |J_i| (1 + sum_j |J_j|)/m_i.
void add_under_skin(const TissueModel& tissue, const Triangle& corners, const Contact& contact,
                    std::span<double> rows) noexcept {
  double all = 1.0;
  for_each_carrier(tissue, corners, contact.weights,
                   [&](std::size_t, double w) noexcept { all += std::abs(w); });
  for_each_carrier(tissue, corners, contact.weights, [&](std::size_t i, double w) noexcept {
    rows[i] += contact.stiffness * all * std::abs(w) / tissue.mass[i];
  });
}

}  // namespace

void find_tissue_need(const Scene& scene, std::size_t b, const SphereLists& lists,
                      const RigidView& body, World& world) noexcept {
  const SoftBody& soft = scene.bodies[b];
  BodyInternals& its = internals(world.bodies[b]);
  const std::span<const Vec3> x = surface_position(world.bodies[b]);
  for (std::size_t s = 0; s < body.sphere_count(); ++s) {
    for (const int t : lists.of(s)) {
      Contact contact;
      const Triangle& corners = soft.tissue.triangles[at(t)];
      if (!find_on_tissue(body, s, soft.rest_areas[at(t)], corners, x, kSoon, contact)) continue;
      body.moved.stiffness += contact.stiffness;
      if (!soft.tissue.skin.corners.empty()) {
        add_under_skin(soft.tissue, corners, contact, its.vertex_scratch);
        continue;
      }
      for (int c = 0; c < 3; ++c) {
        const std::size_t v = at(corners[at(c)]);
        its.vertex_scratch[v] += 2.0 * contact.weights[c] * contact.stiffness / its.surface_mass[v];
      }
    }
  }
}

void touch_tissue(const Scene& scene, std::size_t b, const SphereLists& lists,
                  const RigidView& body, World& world) noexcept {
  RigidContacts& rigid = workspace(world).rigid;
  const SoftState& state = world.bodies[b];
  const std::span<const Vec3> x = surface_position(state);
  for (std::size_t s = 0; s < body.sphere_count(); ++s) {
    SphereTouch touch;
    find_pressures(body, s, scene.bodies[b], state, lists.of(s), touch);
    body.moved.stored_energy += touch.stored;
    add_friction(body, s, scene.bodies[b], state, touch, rigid.bristles[lists.first_bristle + s]);
    body.moved.contacts += touch.count > 0;
    for (std::size_t k = 0; k < touch.count; ++k) {
      const Push& push = touch.pushes[k];
      if (!rigid.loads[b].add({push.triangle, push.weights, -push.force})) break;
      const Vec3 point =
          compute_point(scene.bodies[b].tissue.triangles[at(push.triangle)], push.weights, x);
      body.moved.wrench.add(point, push.force, body.state.position);
      body.state.tissue_force += push.force;
    }
  }
}

}  // namespace palpate
