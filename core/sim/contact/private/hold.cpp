// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/hold.h"

#include <algorithm>

namespace palpate {

double measure_slip(const Coupling& coupling, const Vec3& hand_position,
                    const ToolState& state) noexcept {
  const double reach = coupling.force_max / coupling.stiffness;
  return std::max(0.0, (hand_position - state.position).norm() - reach);
}

double measure_held_load(const ToolState& state, const Load& load) noexcept {
  // the pushes of holds come last
  const std::span<const Push> pushes = load.pushes();
  const auto held = std::min(pushes.size(), static_cast<std::size_t>(state.hold_count));
  double sum = 0.0;
  for (const Push& push : pushes.last(held)) sum += push.force.norm();
  return sum;
}

/// The spring of the hand holds K d²/2, or F (d - F/(2K)) where it is limited to F; a hold f²/(2k).
/// A contact's force grows with its depth, which is at most the radius: f r is more than it holds.
double bound_stored_energy(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                           const ToolState& state, const Load& load) noexcept {
  const double length = (hand_position - state.position).norm();
  const double pull = std::min(coupling.stiffness * length, coupling.force_max);
  double energy = pull * (length - 0.5 * pull / coupling.stiffness);
  // the pushes of holds come last
  const std::span<const Push> pushes = load.pushes();
  const auto held = std::min(pushes.size(), static_cast<std::size_t>(state.hold_count));
  for (const Push& push : pushes.first(pushes.size() - held)) {
    energy += push.force.norm() * tool.radius;
  }
  for (std::size_t h = 0; h < held; ++h) {
    const Push& push = pushes[pushes.size() - held + h];
    energy += 0.5 * push.force.squaredNorm() / state.holds[h].stiffness;
  }
  return energy;
}

}  // namespace palpate
