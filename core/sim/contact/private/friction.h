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
/// [N] by the contacts; `mu` is Tool::friction, of which each surface has its part. Returns the
/// friction on the tool [N].
Vec3 add_friction(std::span<const TouchedSurface> surfaces, const Vec3& applied,
                  const Vec3& contact, double mu, ToolState& state) noexcept;

// How the pull of the hand's spring answers, with friction or without [contact: balance].

inline bool is_at_limit(const Coupling& coupling, const Vec3& to_hand) noexcept {
  return coupling.stiffness * to_hand.norm() > coupling.force_max;
}

/// [N/m] By which the pull of the hand's spring answers to the tool's way. One that is at its limit
/// pulls no less from nearer: of a tool that is too deep, `residual` [N] along the sum of the
/// contacts, only what it turns by is left there, so that it is put where its contacts bear that
/// pull in a step or two, not pushed there against a spring that there is none of. Across, and
/// inwards, it is left as it is: steps come out short there.
inline Mat3 find_pull_slope(const Coupling& coupling, const Vec3& to_hand, const Vec3& contact,
                            const Vec3& residual) noexcept {
  const Mat3 whole = coupling.stiffness * Mat3::Identity();
  const double distance = to_hand.norm(), force = contact.norm();
  if (!is_at_limit(coupling, to_hand) || !(residual.dot(contact) > 0.0)) return whole;
  const Vec3 n = contact / force, u = to_hand / distance;
  const double turned = coupling.force_max / distance * (1.0 - n.dot(u) * n.dot(u));
  return whole - (coupling.stiffness - turned) * (n * n.transpose());
}

/// Whether a spring at its limit, after the step that it would make without one, is within it: so
/// it is of a hand that is a little further off than K reaches. Such a step is right, where one
/// under what the limit leaves goes far past the hand, or only as far as the limit over K.
inline bool comes_within_limit(const Coupling& coupling, const Vec3& to_hand,
                               const Vec3& step) noexcept {
  return step.allFinite() && !is_at_limit(coupling, to_hand - step);
}

}  // namespace palpate
