// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/contact_law.h"

namespace palpate {

// How the pull of a hand's spring answers to the way of a tool, with jaws or without
// [contact: balance].

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

}  // namespace palpate
