// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/stop_at_scenery.h"

#include <algorithm>

#include "palpate/sim/collision/private/stop.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/private/packed_checkpoint.h"
#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tree/private/box_distance.h"

namespace palpate {
namespace {

/// [m] Nearer than this, surfaces are looked at; farther than twice it, no longer.
constexpr double kMeeting = 3.0 * kListMargin;

/// What stops has no thickness and no stiffness.
constexpr Barrier kNone = {};

std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

/// A body in a step of dt [s], and what stops it.
struct Stopped {
  const TissueModel& tissue;
  SoftState& state;
  std::span<const double> inverse_mass;
  PackedKernel* packed;  ///< where that is what moves it
  double dt;
};

/// Of a skin, where a vertex is now that some of its particles have been moved.
void place_vertex(const Stopped& body, int vertex) noexcept {
  if (body.state.skin.empty()) return;
  body.state.skin[at(vertex)] =
      place_on_skin(body.tissue.skin, at(vertex), body.state.tissue.position);
}

/// What has been moved, rounded as the packed tissue has it.
void write_back(const Stopped& body, const CarriedPoint& point) noexcept {
  if (body.packed == nullptr) return;
  for (std::size_t k = 0; k < point.count; ++k) {
    const std::size_t i = at(point.particle[k]);
    if (body.inverse_mass[i] == 0.0) continue;
    take_over_particle(*body.packed->model, body.tissue, body.state.tissue, i, body.packed->state);
    unpack_particle(*body.packed->model, body.tissue, body.packed->state, i, body.state.tissue);
  }
}

Vec3 stop_at(const Stopped& body, const CarriedPoint& point, const Stop& stop,
             SceneryContact& sum) noexcept {
  const Vec3 impulse = stop_point(point, stop, body.dt, body.inverse_mass,
                                  body.state.tissue.position, body.state.tissue.velocity);
  write_back(body, point);
  ++sum.touching;
  return impulse;
}

/// The vertices of the body that have come through the scenery.
Vec3 stop_vertices(const Stopped& body, const SurfaceContacts& side, const HardSurface& scenery,
                   double friction, SceneryContact& sum) noexcept {
  Vec3 impulse = Vec3::Zero();
  for (const int vertex : side.active_in_use()) {
    place_vertex(body, vertex);
    const Vec3& x = surface_position(body.state)[at(vertex)];
    const VertexContact contact =
        find_contact(side, vertex, x, scenery.tree.triangles(), scenery.x, 0.0);
    if (contact.triangle < 0) continue;
    CarriedPoint point;
    point.add(body.tissue, vertex, 1.0);
    impulse += stop_at(body, point, {contact.normal, -contact.gap, friction}, sum);
  }
  return impulse;
}

/// Where the vertices of the scenery have come through the body.
Vec3 stop_triangles(const Stopped& body, const SurfaceContacts& side, const HardSurface& scenery,
                    double friction, SceneryContact& sum) noexcept {
  Vec3 impulse = Vec3::Zero();
  for (const int vertex : side.active_in_use()) {
    for (std::size_t n = 0; n < side.near_count[at(vertex)]; ++n) {
      for (const int corner : body.tissue.triangles[at(side.near[at(vertex)][n])]) {
        place_vertex(body, corner);
      }
    }
    const VertexContact contact =
        find_contact(side, vertex, scenery.x[at(vertex)], body.tissue.triangles,
                     surface_position(body.state), 0.0);
    if (contact.triangle < 0) continue;
    CarriedPoint point;
    for (int c = 0; c < 3; ++c) {
      point.add(body.tissue, body.tissue.triangles[at(contact.triangle)][at(c)],
                contact.weights[c]);
    }
    impulse += stop_at(body, point, {-contact.normal, -contact.gap, friction}, sum);
  }
  return impulse;
}

void find_contacts_of(const Scene& scene, std::size_t s, World& world) noexcept {
  StopContacts& contacts = workspace(world).stops[s];
  const SceneryContact& pair = world.scenery_contacts[s];
  const SoftState& body = world.bodies[at(pair.body)];
  const HardSurface& scenery = workspace(world).hard[at(pair.scenery)];
  if (!pair.near) {
    for (SurfaceContacts* side : {&contacts.on_scenery, &contacts.on_body}) {
      side->begun = false;
      side->active_count = 0;
    }
    return;
  }
  const double move = workspace(world).stopped[at(pair.body)].motion.move;
  const std::span<const Vec3> x = surface_position(body);
  const std::vector<Triangle>& triangles = scene.bodies[at(pair.body)].tissue.triangles;
  renew_lists(x, scenery.tree, scenery.x, move, contacts.on_scenery);
  find_near(x, scenery.tree.triangles(), scenery.x, contacts.on_scenery);
  renew_lists(scenery.x, body.tree, x, move, contacts.on_body);
  find_near(scenery.x, triangles, x, contacts.on_body);
}

}  // namespace

void build_scenery_contacts(const Scene& scene, World& world) {
  TickBuffers& work = workspace(world);
  for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
    const SurfaceMesh& mesh = scene.scenery[s].mesh;
    for (const int b : scene.scenery[s].bodies) {
      const TissueModel& tissue = scene.bodies[at(b)].tissue;
      const SurfaceMesh surface{compute_surface(tissue, tissue.rest_position), tissue.triangles};
      world.scenery_contacts.push_back({.scenery = static_cast<int>(s), .body = b});
      work.stops.push_back(
          {SurfaceContacts(surface, mesh, kNone), SurfaceContacts(mesh, surface, kNone)});
      work.stopped.resize(scene.bodies.size());
      StoppedBody& stopped = work.stopped[at(b)];
      if (!stopped.inverse_mass.empty()) continue;
      stopped.motion = SurfaceMotion(surface.vertices.size());
      for (const double mass : tissue.mass) stopped.inverse_mass.push_back(1.0 / mass);
      for (const int held : tissue.fixed) stopped.inverse_mass[at(held)] = 0.0;
    }
  }
  world.costs.scenery.resize(world.scenery_contacts.size());
  meet_scenery(world);
  find_scenery_contacts(scene, world);
}

void meet_scenery(World& world) noexcept {
  for (std::size_t s = 0; s < world.scenery_contacts.size(); ++s) {
    SceneryContact& pair = world.scenery_contacts[s];
    SoftState& body = world.bodies[at(pair.body)];
    const AabbTree& scenery = workspace(world).hard[at(pair.scenery)].tree;
    const double between = measure_between(body.tree, scenery) - bound_lag(body);
    pair.near = between < (pair.near ? 2.0 : 1.0) * kMeeting;
    if (pair.near) internals(body).meets = true;
  }
}

/// What sleeps has not moved, and scenery never does.
void find_scenery_contacts(const Scene& scene, World& world) noexcept {
  if (world.scenery_contacts.empty()) return;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SurfaceMotion& motion = workspace(world).stopped[b].motion;
    motion.move = 0.0;
    if (motion.last.empty()) continue;
    if (!internals(world.bodies[b]).meets) {
      motion.has_last = false;
    } else if (!world.bodies[b].asleep || !motion.has_last) {
      follow_move(surface_position(world.bodies[b]), 0.0, motion);
    }
  }
  Stopwatch watch(world.measures_costs);
  for (std::size_t s = 0; s < world.scenery_contacts.size(); ++s) {
    const StopContacts& contacts = workspace(world).stops[s];
    const bool asleep = world.bodies[at(world.scenery_contacts[s].body)].asleep;
    if (asleep && contacts.on_scenery.begun) continue;
    find_contacts_of(scene, s, world);
    watch.add_to(world.costs.scenery[s].candidates);
  }
}

bool is_stopped(std::size_t body, World& world) noexcept {
  for (std::size_t s = 0; s < world.scenery_contacts.size(); ++s) {
    if (world.scenery_contacts[s].body != static_cast<int>(body)) continue;
    const StopContacts& contacts = workspace(world).stops[s];
    if (contacts.on_scenery.active_count > 0 || contacts.on_body.active_count > 0) return true;
  }
  return false;
}

void begin_stopping(World& world) noexcept {
  for (SceneryContact& pair : world.scenery_contacts) {
    pair.force.setZero();
    pair.touching = 0;
  }
}

/// One contact after the other, each with what those before have moved.
void stop_at_scenery(const Scene& scene, std::size_t body, double dt, int steps,
                     World& world) noexcept {
  if (!is_stopped(body, world)) return;
  TickBuffers& work = workspace(world);
  SoftState& state = world.bodies[body];
  PackedKernel* packed = find_packed(state);
  const Stopped stopped{scene.bodies[body].tissue, state, work.stopped[body].inverse_mass,
                        is_stepped_in_double(state) ? nullptr : packed, dt};
  bool touched = false;
  Stopwatch watch(world.measures_costs);
  for (std::size_t s = 0; s < world.scenery_contacts.size(); ++s) {
    SceneryContact& pair = world.scenery_contacts[s];
    if (pair.body != static_cast<int>(body)) continue;
    const HardSurface& scenery = work.hard[at(pair.scenery)];
    const double friction = scene.scenery[at(pair.scenery)].friction;
    pair.touching = 0;
    Vec3 impulse = stop_vertices(stopped, work.stops[s].on_scenery, scenery, friction, pair);
    impulse += stop_triangles(stopped, work.stops[s].on_body, scenery, friction, pair);
    pair.force += impulse / (dt * steps);
    touched = touched || pair.touching > 0;
    watch.add_to(world.costs.scenery[s].contact);
  }
  if (touched) forget_way(body, world);
  if (!touched || state.skin.empty()) return;
  if (stopped.packed == nullptr)
    return move_skin(stopped.tissue.skin, state.tissue.position, state.skin);
  for (const int vertex : packed->near.skin_in_use()) place_vertex(stopped, vertex);
}

}  // namespace palpate
