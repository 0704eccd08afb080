// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "palpate/sim/arm/kinematics.h"
#include "palpate/sim/arm/plant.h"
#include "palpate/sim/device/safe_device.h"

namespace palpate {

/// What one sensor's counts mean.
struct JointSensor {
  int zero = 512;            ///< [counts] at angle zero
  double scale = 0.002;      ///< [rad/count], its sign is the direction
  int min = 16, max = 1007;  ///< [counts] ends of the joint's range
};

/// What a device keeps of itself in its EEPROM, in SI units.
struct Calibration {
  std::array<JointSensor, 6> joints{};    ///< three of the arm, three of the gimbal
  double upper_length = 0.15;             ///< [m]
  double forearm_length = 0.15;           ///< [m]
  Vec3 torque_full = {0.47, 0.47, 0.47};  ///< [N·m] at the joint, of full duty; signed
  double upper_weight = 0.0;              ///< [N·m] that carries the level upper link
  double forearm_weight = 0.0;            ///< [N·m] that carries the level forearm
  std::array<int, 3> deadband{};          ///< [duty] at which the motor begins to push
  std::array<int, 3> continuous_duty = {127, 127, 127};  ///< [duty] that may be held for ever
  double heat_time = 10.0;                               ///< [s] in which the motors warm up
  int speed_max = 40;  ///< [counts/ms] of an arm joint; more is a fault
  std::uint32_t serial_number = 0;
};
static_assert(sizeof(Calibration) == 240 && alignof(Calibration) == 8);

/// Throws std::invalid_argument naming the field, what it got and what was expected: what the
/// device's own numbers can hold.
void validate(const Calibration& calibration);

/// The calibration a plant would get if nothing were measured wrong.
Calibration find_calibration(const Plant& plant);

/// [rad] of six sensors.
std::array<double, 6> compute_angles(const Calibration& calibration,
                                     const std::array<std::uint16_t, 6>& counts) noexcept;

/// The kinematics and the joints' limits of a calibrated device.
Arm find_arm(const Calibration& calibration) noexcept;

/// What forces a device can bear: in every direction and place of its workspace, at any moment and
/// for ever.
SafetyLimits find_safety_limits(const Calibration& calibration);

}  // namespace palpate
