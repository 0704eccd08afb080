// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/hold.h"

#include <algorithm>

namespace palpate {

double measure_slip(const Coupling& coupling, const Vec3& hand_position,
                    const ToolState& state) noexcept {
  const double reach = coupling.force_max / coupling.stiffness;
  return std::max(0.0, (hand_position - state.position).norm() - reach);
}

namespace {

std::span<const ToolState::Hold> holds_of(const ToolState& state) noexcept {
  return {state.holds.data(), static_cast<std::size_t>(state.hold_count)};
}

/// How many pushes of holds there are on a surface: its last.
std::size_t count_held(const ToolState& state, std::size_t body,
                       std::span<const Push> pushes) noexcept {
  const auto on_it = [&](const ToolState::Hold& hold) noexcept {
    return hold.body == static_cast<int>(body);
  };
  return std::min(pushes.size(),
                  static_cast<std::size_t>(std::ranges::count_if(holds_of(state), on_it)));
}

}  // namespace

double measure_held_load(const ToolState& state,
                         std::span<const TouchedSurface> surfaces) noexcept {
  double sum = 0.0;
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    const std::span<const Push> pushes = surfaces[b].load->pushes();
    for (const Push& push : pushes.last(count_held(state, b, pushes))) sum += push.force.norm();
  }
  return sum;
}

/// The spring of the hand holds K d²/2, or F (d - F/(2K)) where it is limited to F; a hold f²/(2k).
/// A contact's force grows with its depth, which is at most the radius, and what a near field has
/// lifted the tool by: f times that is more than it holds.
double bound_stored_energy(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                           const ToolState& state,
                           std::span<const TouchedSurface> surfaces) noexcept {
  const double length = (hand_position - state.position).norm();
  const double pull = std::min(coupling.stiffness * length, coupling.force_max);
  double energy = pull * (length - 0.5 * pull / coupling.stiffness);
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    const std::span<const Push> pushes = surfaces[b].load->pushes();
    std::size_t next = pushes.size() - count_held(state, b, pushes);
    const double deepest = tool.radius + surfaces[b].candidates->near.lift.norm();
    for (const Push& push : pushes.first(next)) energy += push.force.norm() * deepest;
    for (const ToolState::Hold& hold : holds_of(state)) {
      if (hold.body != static_cast<int>(b) || next == pushes.size()) continue;
      const double softest = hold.is_tied() ? hold.sideways : hold.stiffness;
      energy += 0.5 * pushes[next++].force.squaredNorm() / softest;
    }
  }
  return energy;
}

}  // namespace palpate
