// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// What a tick was given that it cannot use: the index of an alarm of kind invalid_input.
enum class TickInput {
  time,                ///< [s] of the sample; finite
  position,            ///< [m] of the sample, its largest coordinate; finite, within kFarthestHand
  orientation,         ///< of the sample; finite
  velocity,            ///< [m/s] of the sample; finite
  grip,                ///< [rad] of the sample; finite
  dt,                  ///< [s] positive and finite
  scene,               ///< the very scene of the world, or a copy of it
  tool_radius,         ///< [m] positive and finite, as in build_scene; so are those that follow
  tool_stiffness,      ///< [N/m³]
  coupling_stiffness,  ///< [N/m]
  coupling_force_max,  ///< [N]
  hold_stiffness,      ///< [N/m]
  gravity,             ///< [m/s²] finite
  substeps,            ///< at least 1
  substeps_max,        ///< at least substeps
  samples,             ///< one for each instrument, and as many commands
  tool_friction,       ///< [-] not negative, and finite
};

/// [m] No hand is farther from where its device has its origin.
inline constexpr double kFarthestHand = 1e3;

/// Whether a tick can use what it is given; `value` is what it got. A scene is a plain struct that
/// a program may change after build_scene has checked it, and a sample comes from any device.
Alarm check_input(const Scene& scene, std::span<const HapticSample> samples,
                  std::size_t command_count, double dt, const World& world) noexcept;

}  // namespace palpate
