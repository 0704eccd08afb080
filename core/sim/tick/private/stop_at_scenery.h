// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

// The stages of a tick in which bodies stop at scenery, in their sequence [contact: scenery].
// Without scenery none does anything.

/// Of build_scene: checks scenery. Throws std::invalid_argument.
void check_scenery(const Scene& scene);

/// Makes what a world needs for it.
void build_scenery_contacts(const Scene& scene, World& world);

/// Finds which bodies are near to what stops them. Those follow all of their tissue in this tick.
void meet_scenery(World& world) noexcept;

/// Finds what of their surfaces may come to touch in this tick, where all of them is up to date.
void find_scenery_contacts(const Scene& scene, World& world) noexcept;

/// Whether a scenery may stop a part of this body in this tick.
bool is_stopped(std::size_t body, World& world) noexcept;

/// After a step of dt [s] of a body, one of `steps` in this tick: takes back what came through.
void stop_at_scenery(const Scene& scene, std::size_t body, double dt, int steps,
                     World& world) noexcept;

/// Begins the substeps of a tick.
void begin_stopping(World& world) noexcept;

/// Calls `visit(vertex)` for the vertices of a body that a scenery may stop in this tick; some of
/// them several times.
template <class Visit>
void for_each_stopped_vertex(const Scene& scene, std::size_t body, World& world, Visit visit) {
  for (std::size_t s = 0; s < world.scenery_contacts.size(); ++s) {
    if (world.scenery_contacts[s].body != static_cast<int>(body)) continue;
    const StopContacts& contacts = workspace(world).stops[s];
    for (const int vertex : contacts.on_scenery.active_in_use()) visit(vertex);
    const SurfaceContacts& side = contacts.on_body;
    for (const int vertex : side.active_in_use()) {
      const auto v = static_cast<std::size_t>(vertex);
      for (std::size_t n = 0; n < side.near_count[v]; ++n) {
        const auto t = static_cast<std::size_t>(side.near[v][n]);
        for (const int corner : scene.bodies[body].tissue.triangles[t]) visit(corner);
      }
    }
  }
}

}  // namespace palpate
