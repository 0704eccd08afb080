// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

// The stages of a tick in which bodies touch each other, in their sequence. Without body_pairs none
// does anything.

/// Of build_scene: checks body_pairs, adds those of bodies that may fold, and chooses their
/// constants where they are 0. Throws std::invalid_argument.
void build_body_pairs(Scene& scene);

/// Makes what a world needs for its body_pairs, with all lists of contacts that may be.
void build_body_contacts(const Scene& scene, World& world);

/// Finds which bodies are near each other. Those follow all of their tissue in this tick, of dt
/// [s].
void meet_bodies(double dt, World& world) noexcept;

/// Finds what of their surfaces may touch in this tick, where all of them is up to date.
void find_body_contacts(const Scene& scene, double dt, World& world) noexcept;

/// A surface as it stands in a substep.
inline TouchingSurface view_surface(const Scene& scene, std::size_t body, World& world) noexcept {
  const SoftState& state = world.bodies[body];
  return {scene.bodies[body].tissue, surface_position(state), state.tissue.velocity,
          workspace(world).touched[body]};
}

/// The middles of its long edges that may touch the other of a pair, likewise.
inline TouchingSurface view_edges(const Scene& scene, std::size_t body, EdgePoints& points,
                                  World& world) noexcept {
  TouchingSurface view = view_surface(scene, body, world);
  follow_active(view.x, points);
  view.x = points.x;
  view.edges = points.ends;
  return view;
}

/// Calls visit(points, contacts) for the vertices of a body of a pair, and for the middles of its
/// long edges, where any may touch the other.
template <class Visit>
void for_each_side(const Scene& scene, BodyContacts& contacts, std::size_t k, World& world,
                   Visit visit) {
  const std::size_t body = contacts.bodies[k];
  SurfaceContacts& side = contacts.sides[k];
  if (side.active_count > 0) visit(view_surface(scene, body, world), side);
  EdgePoints& edges = contacts.edges[k];
  if (edges.contacts.active_count > 0) {
    visit(view_edges(scene, body, edges, world), edges.contacts);
  }
}

/// Notes that no vertex of a body has gone farther than by `way` [m] in a step.
void add_way(std::size_t body, double way, World& world) noexcept;

/// Likewise of one that may have gone anywhere.
void forget_way(std::size_t body, World& world) noexcept;

/// Whether a surface of another body, or of its own, may touch this one in this tick.
bool is_touched(std::size_t body, World& world) noexcept;

/// [1/s²] What contacts with other surfaces add to the largest eigenvalue of M⁻¹K at most.
double bound_touch_stiffness(std::size_t body, World& world) noexcept;

/// The substeps that the speed at which other surfaces come near asks for.
double count_approach_substeps(std::size_t body, World& world) noexcept;

/// Calls `visit(push)` for what other surfaces do to a body in a substep, once; none without
/// body_pairs.
template <class Visit>
void take_touch_pushes(std::size_t body, World& world, Visit visit) noexcept {
  if (!world.body_pairs.empty()) take_pushes(workspace(world).touched[body], visit);
}

/// Calls `visit_vertex(vertex)` for what may touch other surfaces of a body, or its own, and
/// `visit_triangle(triangle)` for what may be touched by them; some of them several times.
template <class VisitVertex, class VisitTriangle>
void for_each_touched(std::size_t body, World& world, VisitVertex visit_vertex,
                      VisitTriangle visit_triangle) {
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    const BodyContacts& contacts = workspace(world).contacts[p];
    const auto& bodies = contacts.bodies;
    const auto visit_near = [&](const SurfaceContacts& side, int vertex) {
      const auto v = static_cast<std::size_t>(vertex);
      for (std::size_t n = 0; n < side.near_count[v]; ++n) visit_triangle(side.near[v][n]);
    };
    for (std::size_t k = 0; k < contacts.side_count; ++k) {
      const SurfaceContacts& side = contacts.sides[k];
      for (const int vertex : side.active_in_use()) {
        if (bodies[k] == body) visit_vertex(vertex);
        if (bodies[1 - k] == body) visit_near(side, vertex);
      }
      const EdgePoints& points = contacts.edges[k];
      for (const int edge : points.contacts.active_in_use()) {
        if (bodies[k] == body) {
          for (const int end : points.ends[static_cast<std::size_t>(edge)]) visit_vertex(end);
        }
        if (bodies[1 - k] == body) visit_near(points.contacts, edge);
      }
    }
  }
}

/// Finds the forces between all bodies for substep s of `finest`, each of dt [s].
void touch_bodies(const Scene& scene, int s, int finest, double dt, World& world) noexcept;

/// Takes note of where bodies stick to each other, and takes them back there.
void keep_pair_friction(World& world) noexcept;
void rewind_pair_friction(World& world) noexcept;

/// Ends the substeps of a tick: what each pair did in them.
void end_touching(int finest, World& world) noexcept;

/// [J] No less than a body can have been given by others it touches: what these have lost, and what
/// was in the barriers between them.
double bound_touch_work(std::size_t body, World& world) noexcept;

}  // namespace palpate
