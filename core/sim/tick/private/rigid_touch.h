// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "palpate/sim/tick/private/rigid_contacts.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

// What one rigid body does in a substep to a tissue (rigid_on_tissue.cpp), and to what is hard
// (rigid_on_hard.cpp).

/// [-] Of critical damping of a contact.
inline constexpr double kRigidDamping = 0.3;

/// A rigid body in a substep of dt [s].
struct RigidView {
  const RigidBody& fixed;
  RigidState& state;
  MovedBody& moved;
  double dt;

  std::size_t sphere_count() const noexcept { return fixed.sphere_radii.size(); }
  /// [N s/m] Of a contact of that stiffness [N/m], its part of the mass.
  double damp(double stiffness) const noexcept {
    return 2.0 * kRigidDamping *
           std::sqrt(stiffness * moved.moved.mass / std::max(1, moved.last_contacts));
  }
  BristleLaw bristle(double stiffness) const noexcept {
    return {stiffness, damp(stiffness), fixed.friction};
  }
};

/// What contacts that are near add to the rows of a tissue, and to the stiffness under a body.
void find_tissue_need(const Scene& scene, std::size_t b, const SphereLists& lists,
                      const RigidView& body, World& world) noexcept;

void touch_tissue(const Scene& scene, std::size_t b, const SphereLists& lists,
                  const RigidView& body, World& world) noexcept;

void touch_scenery(const HardSurface& scenery, const SphereLists& lists, const RigidView& body,
                   RigidContacts& rigid) noexcept;

/// Each sphere of the one with each of the other, whose bristles are in that sequence.
void touch_pair(const RigidView& a, const RigidView& b, std::span<Bristle> bristles) noexcept;

}  // namespace palpate
