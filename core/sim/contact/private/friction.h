// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

// Coulomb's friction between tool and tissue: one cone for all contacts together
// [contact: friction].

/// What a tool that is not in balance yet is under, at its position p.
struct Unbalanced {
  Vec3 applied = Vec3::Zero();            ///< [N] by the hand's spring and holds
  Vec3 contact = Vec3::Zero();            ///< [N] by the contacts
  double applied_stiffness = 0.0;         ///< [N/m] of spring and holds, in every direction
  Mat3 contact_stiffness = Mat3::Zero();  ///< [N/m] of the contacts, along their directions
};

/// [m] How far the tissue that was touched in the last substep has moved since, along its surface.
Vec3 measure_carry(std::span<const TouchedSurface> surfaces, const ToolState& state) noexcept;

/// [m] A Newton step of a tool that touches, by friction of the coefficient mu; `back` leads to
/// where it would be had it stuck.
Vec3 find_friction_step(const Unbalanced& tool, const Vec3& back, double mu) noexcept;

/// Shares friction out among the pushes of contacts, which are all that the loads have as yet, and
/// takes note of the patch they are on. `applied` [N] is by the hand's spring and holds, `contact`
/// [N] by the contacts. Returns the friction on the tool [N].
Vec3 add_friction(std::span<const TouchedSurface> surfaces, const Vec3& applied,
                  const Vec3& contact, double mu, ToolState& state) noexcept;

}  // namespace palpate
