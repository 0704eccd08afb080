// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

// The stages of a tick in which rigid bodies touch and move, in their sequence [contact: rigid].
// Without any, none does anything.

/// Of build_scene: checks rigid bodies, and makes the meshes of those that have none. Throws
/// std::invalid_argument.
void build_rigid(Scene& scene);

/// Makes what a world needs for them; after what is hard.
void build_rigid_contacts(const Scene& scene, World& world);

/// Finds which tissues and scenery they are near to. Tissues follow all of themselves then.
void meet_rigid(const Scene& scene, double dt, World& world) noexcept;

/// Finds what their spheres may touch in a tick of dt [s].
void find_rigid_contacts(const Scene& scene, double dt, World& world) noexcept;

/// Whether one may touch this tissue in this tick.
bool is_rigid_near(std::size_t body, World& world) noexcept;

/// [1/s²] What they add to the largest eigenvalue of a tissue's M⁻¹K at most.
double bound_rigid_stiffness(std::size_t body, World& world) noexcept;

/// How many substeps there are of `finest` of the tissues: as many times more as rigid bodies that
/// touch something ask for, so as to be moved with their own mass.
int refine_for_rigid(const Scene& scene, int finest, World& world) noexcept;

/// Begins substeps of dt [s].
void begin_rigid(const Scene& scene, double dt, World& world) noexcept;

/// Finds the forces on and of them in a substep of dt [s], where instruments are balanced.
void touch_rigid(const Scene& scene, double dt, World& world) noexcept;

/// Moves them, and their meshes.
void move_rigid(const Scene& scene, double dt, World& world) noexcept;

/// Ends the substeps of a tick.
void end_rigid(int finest, World& world) noexcept;

/// What they do to a tissue in a substep.
std::span<const Push> list_rigid_pushes(std::size_t body, World& world) noexcept;

/// [J] No less than they can give to a tissue in a tick of dt [s].
double bound_rigid_work(const Scene& scene, double dt, World& world) noexcept;

void keep_rigid(World& world) noexcept;
void rewind_rigid(const Scene& scene, World& world) noexcept;

/// Calls `visit(triangle)` for those of a tissue that rigid bodies may touch, or stick to.
template <class Visit>
void for_each_rigid_triangle(std::size_t body, World& world, Visit visit) {
  const RigidContacts& rigid = workspace(world).rigid;
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const SphereLists& lists = rigid.on_tissue[r * world.bodies.size() + body];
    if (!lists.near) continue;
    for (std::size_t s = 0; s < lists.end.size(); ++s) {
      for (const int t : lists.of(s)) visit(t);
      const Bristle& bristle = rigid.bristles[lists.first_bristle + s];
      if (bristle.holds) visit(bristle.triangle);
    }
  }
}

}  // namespace palpate
