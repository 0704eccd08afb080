// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

/// [s] in which a hold that is let go fades: longer is no better [contact: release].
inline constexpr double kReleaseTime = 0.03;

/// The tissue could not be pulled much farther without an alarm.
bool is_near_alarm(const SoftBody& body, const SoftState& state) noexcept;

/// Fastens the tool of an instrument to what it touches when the attach button goes down, and lets
/// go when it comes up, or when the tool has slid out of its grip or the tissue would bear no more.
/// `dt` [s] is that of the tick.
void follow_button(const Scene& scene, std::size_t instrument, std::uint8_t buttons, double dt,
                   World& world) noexcept;

/// Follows the hand's button and grip axis with the jaws of an instrument that has some: a button
/// that is down closes them, else they are open by as much as the hand is. Jaws that open take back
/// their closing force from what they carry on, to nothing within 30 ms [contact: release]; those
/// that strain the tissue so far that the run would soon have to end close less and less.
void follow_jaws(const Scene& scene, std::size_t instrument, const HapticSample& sample, double dt,
                 World& world) noexcept;

}  // namespace palpate
