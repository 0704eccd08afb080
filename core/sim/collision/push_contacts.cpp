// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "palpate/sim/collision/private/held_kernels.h"
#include "palpate/sim/collision/private/surface_contacts.h"

namespace palpate {
namespace {

/// [m/s] As TouchingSurface::velocity_of(), which is called for each corner of each contact.
Vec3 find_velocity(const TouchingSurface& surface, int vertex) noexcept {
  if (!surface.tissue.skin.corners.empty()) return surface.velocity_of(vertex);
  const auto v = static_cast<std::size_t>(vertex);
  if (!surface.touch.has_impulse) return surface.velocity[v];
  return surface.velocity[v] + surface.touch.impulse[v];
}

/// A contact, and what moves there.
struct Moving {
  double inverse_mass = 0.0;  ///< [1/kg] of the gap: of the vertex, and of the corners by weight
  double speed = 0.0;         ///< [m/s] at which the gap grows
};

Moving measure(const VertexContact& contact, int vertex, const TouchingSurface& vertices,
               const TouchingSurface& triangles) noexcept {
  Moving moving;
  vertices.for_each_of(vertex, [&](int v, double w) noexcept {
    moving.inverse_mass += w * w * vertices.touch.inverse_mass[static_cast<std::size_t>(v)];
    moving.speed += w * find_velocity(vertices, v).dot(contact.normal);
  });
  const Triangle& corners = triangles.tissue.triangles[static_cast<std::size_t>(contact.triangle)];
  for (int c = 0; c < 3; ++c) {
    const int corner = corners[static_cast<std::size_t>(c)];
    const double w = contact.weights[c];
    if (w == 0.0) continue;
    moving.inverse_mass += w * w * triangles.touch.inverse_mass[static_cast<std::size_t>(corner)];
    moving.speed -= w * find_velocity(triangles, corner).dot(contact.normal);
  }
  return moving;
}

/// An impulse j [N s] on the vertex, and -j on the triangle.
void add_impulse(const VertexContact& contact, int vertex, const Vec3& j,
                 const TouchingSurface& vertices, const TouchingSurface& triangles) noexcept {
  vertices.for_each_of(vertex, [&](int v, double w) noexcept { vertices.add_impulse(v, w * j); });
  const Triangle& corners = triangles.tissue.triangles[static_cast<std::size_t>(contact.triangle)];
  for (int c = 0; c < 3; ++c) {
    const double w = contact.weights[c];
    if (w != 0.0) triangles.add_impulse(corners[static_cast<std::size_t>(c)], -w * j);
  }
}

/// [N/m] By which a contact answers to its gap, as stiff as it gets in this tick; with damping, by
/// the step that it allows: dt <= 2/w (sqrt(1 + z²) - z), and z = zeta w0/w of w0 without a gap.
double bound_slope(const SurfaceContacts& contacts, double gap, double area) noexcept {
  const Barrier& barrier = contacts.barrier;
  const double part = std::clamp(gap / barrier.thickness, kClosestPart, 1.0);
  const double z = barrier.damping * part, shorter = std::sqrt(1.0 + z * z) - z;
  return contacts.bristles.steepening * barrier.stiffness * area /
         (part * part * shorter * shorter);
}

/// [m/s] That is too much of a closing speed, in a step of dt [s].
double find_excess(const Barrier& barrier, const VertexContact& contact, const Moving& moving,
                   double dt) noexcept {
  const double room = std::max(0.0, contact.gap - kClosestPart * barrier.thickness);
  return -moving.speed - room / dt;
}

/// [m] How far two surfaces have gone, together at most.
double find_travel(const TouchingSurface& vertices, const TouchingSurface& triangles) noexcept {
  return vertices.touch.went + triangles.touch.went;
}

/// What an impulse takes of one contact changes others: they are gone over again, where surfaces
/// have not moved meanwhile, until what is left would not close a gap by more than a hundredth of
/// the thickness.
void stop_what_is_left(const SurfaceContacts& contacts, double dt, const TouchingSurface& vertices,
                       const TouchingSurface& triangles, ContactSum& sum) noexcept {
  const std::span<const int> active = contacts.active_in_use();
  constexpr int kPasses = 8;
  const double enough = 0.01 * contacts.barrier.thickness / dt;
  bool all = false;
  for (int pass = 0; pass < kPasses && !all; ++pass) {
    all = true;
    for (std::size_t k = 0; k < active.size(); ++k) {
      const int vertex = active[k];
      const VertexContact& contact = contacts.contact[k];
      if (contact.triangle < 0) continue;
      const Moving moving = measure(contact, vertex, vertices, triangles);
      const double excess = find_excess(contacts.barrier, contact, moving, dt);
      if (!(moving.inverse_mass > 0.0) || !(excess > enough)) continue;
      all = false;
      const Vec3 impulse = excess / moving.inverse_mass * contact.normal;
      add_impulse(contact, vertex, impulse, vertices, triangles);
      add_force(contact, vertex, impulse / dt, vertices, triangles);
      sum.force -= impulse / dt;
    }
  }
}

/// The contacts of a substep of dt [s], as they push.
struct Pushing {
  double dt;
  const TouchingSurface &vertices, &triangles;
  SurfaceContacts& contacts;
  bool with_energy;
  ContactSum sum;
  bool stopped = false;  ///< an impulse has changed velocities
};

void add_pushed(std::size_t k, double force, Pushing& pushing) noexcept {
  const SurfaceContacts& contacts = pushing.contacts;
  const VertexContact& contact = contacts.contact[k];
  const int vertex = contacts.active[k];
  ContactSum& sum = pushing.sum;
  add_force(contact, vertex, force * contact.normal, pushing.vertices, pushing.triangles);
  sum.least_gap = sum.touching++ == 0 ? contact.gap : std::min(sum.least_gap, contact.gap);
  if (pushing.with_energy) {
    sum.energy += contacts.area[static_cast<std::size_t>(vertex)] *
                  compute_barrier_energy(contacts.barrier, contact.gap);
  }
  sum.force -= force * contact.normal;
  if (contacts.bristles.friction > 0.0) pushing.contacts.bristles.pressed[k] = force;
}

/// [N s/m] zeta times what is critical; 0 where nothing can move.
double find_resistance(const Barrier& barrier, double area, double inverse_mass) noexcept {
  if (!(inverse_mass > 0.0)) return 0.0;
  const double critical = 2.0 * std::sqrt(barrier.stiffness * area / inverse_mass);
  return barrier.damping * critical;
}

void push_one(std::size_t k, Pushing& pushing) noexcept {
  const SurfaceContacts& contacts = pushing.contacts;
  const Barrier& barrier = contacts.barrier;
  const VertexContact& contact = contacts.contact[k];
  const int vertex = contacts.active[k];
  const bool within = contact.gap < barrier.thickness;
  const Moving moving = measure(contact, vertex, pushing.vertices, pushing.triangles);
  const double area = contacts.area[static_cast<std::size_t>(vertex)];
  double force = area * compute_pressure(barrier, contact.gap);
  if (moving.inverse_mass > 0.0) {
    const double resistance = find_resistance(barrier, area, moving.inverse_mass);
    if (within) force = std::max(0.0, force - resistance * moving.speed);
    if (const double excess = find_excess(barrier, contact, moving, pushing.dt); excess > 0.0) {
      const double impulse = excess / moving.inverse_mass;
      pushing.stopped = true;
      add_impulse(contact, vertex, impulse * contact.normal, pushing.vertices, pushing.triangles);
      force += impulse / pushing.dt;
    }
  }
  if (within || force != 0.0) add_pushed(k, force, pushing);
}

/// Likewise the contacts at as many places, up to four, of surfaces that are their own particles.
void push_four(std::span<const int> places, Pushing& pushing) noexcept {
  SurfaceContacts& contacts = pushing.contacts;
  std::array<int, 4> four;
  for (std::size_t lane = 0; lane < four.size(); ++lane) {
    const int place = four[lane] = places[std::min(lane, places.size() - 1)];
    const auto k = static_cast<std::size_t>(place);
    if (contacts.resistance[k] != SurfaceContacts::kNotKnown) continue;
    const int vertex = contacts.active[k];
    const Moving moving = measure(contacts.contact[k], vertex, pushing.vertices, pushing.triangles);
    contacts.resistance[k] = find_resistance(
        contacts.barrier, contacts.area[static_cast<std::size_t>(vertex)], moving.inverse_mass);
  }
  const held_kernels::FourForces forces =
      held_kernels::best().push(pushing.dt, pushing.vertices, pushing.triangles, contacts, four);
  // an impulse changes the velocities of those after it
  const unsigned asked = (1U << places.size()) - 1U;
  for (std::size_t lane = 0; lane < places.size(); ++lane) {
    const auto k = static_cast<std::size_t>(places[lane]);
    if ((forces.stopped & asked) != 0) {
      push_one(k, pushing);
    } else if (contacts.contact[k].gap < contacts.barrier.thickness) {
      add_pushed(k, forces.force[lane], pushing);
    }
  }
}

bool is_its_particles(const TouchingSurface& surface) noexcept {
  return surface.edges.empty() && surface.tissue.skin.corners.empty();
}

}  // namespace

/// f = A (p(g) - c dg/dt) along the normal, never below 0, with c A = 2 zeta sqrt(k_A A m) of the
/// mass m of the gap. An impulse takes what would close the gap in this step to under a tenth of
/// the thickness, from wherever it is, mass-weighted, one contact after the other, so that none
/// takes twice what another has taken.
ContactSum push_contacts(double dt, const TouchingSurface& vertices,
                         const TouchingSurface& triangles, SurfaceContacts& contacts,
                         bool with_energy) noexcept {
  const std::span<const int> active = contacts.active_in_use();
  const double travel = find_travel(vertices, triangles);
  find_contacts(vertices.x, triangles.tissue.triangles, triangles.x, travel, contacts);
  const bool slowly = go_slowly(contacts, travel);
  const bool in_fours = is_its_particles(vertices) && is_its_particles(triangles);
  Pushing pushing{dt, vertices, triangles, contacts, with_energy, {}};
  std::array<int, 4> places;
  std::size_t count = 0;
  for (std::size_t k = 0; k < active.size(); ++k) {
    const VertexContact& contact = contacts.contact[k];
    if (contact.triangle < 0 || (slowly && !(contact.gap < contacts.barrier.thickness))) continue;
    if (!in_fours) {
      push_one(k, pushing);
      continue;
    }
    places[count++] = static_cast<int>(k);
    if (count < places.size()) continue;
    push_four(places, pushing);
    count = 0;
  }
  if (count > 0) push_four(std::span<const int>(places).first(count), pushing);
  if (pushing.stopped) stop_what_is_left(contacts, dt, vertices, triangles, pushing.sum);
  return pushing.sum;
}

/// The gap of a contact has the gradient n on the vertex and -w n on the corners, so that in
/// M⁻¹K the row of the vertex sums to 2 k/m, and that of a corner to 2 k w/m.
ContactNeed accumulate_stiffness(double dt, const TouchingSurface& vertices,
                                 const TouchingSurface& triangles,
                                 SurfaceContacts& contacts) noexcept {
  const std::span<const int> active = contacts.active_in_use();
  find_contacts(vertices.x, triangles.tissue.triangles, triangles.x,
                std::numeric_limits<double>::infinity(), contacts);
  ContactNeed need;
  for (std::size_t k = 0; k < active.size(); ++k) {
    const int vertex = active[k];
    const auto v = static_cast<std::size_t>(vertex);
    const VertexContact& contact = contacts.contact[k];
    if (contact.triangle < 0) continue;
    const Moving moving = measure(contact, vertex, vertices, triangles);
    const double closes = std::max(0.0, -moving.speed);
    if (!(contact.gap - dt * closes < contacts.barrier.thickness)) continue;
    need.approach = std::max(need.approach, closes);
    const double slope = bound_slope(contacts, contact.gap - dt * closes, contacts.area[v]);
    vertices.for_each_of(vertex, [&](int of, double w) noexcept {
      const auto row = static_cast<std::size_t>(of);
      vertices.touch.row[row] += 2.0 * slope * w * vertices.touch.inverse_mass[row];
    });
    const Triangle& corners =
        triangles.tissue.triangles[static_cast<std::size_t>(contact.triangle)];
    for (int c = 0; c < 3; ++c) {
      const auto corner = static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]);
      triangles.touch.row[corner] +=
          2.0 * slope * contact.weights[c] * triangles.touch.inverse_mass[corner];
    }
  }
  return need;
}

}  // namespace palpate
