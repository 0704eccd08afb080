// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "palpate/sim/arm/kinematics.h"

namespace palpate {

/// The masses of the arm's parts. Springs or counterweights carry some of their weight.
struct ArmMasses {
  double upper = 0.045;    ///< [kg] a rod, heavy in its middle
  double forearm = 0.030;  ///< [kg] likewise
  double gimbal = 0.045;   ///< [kg] at the tip
  double motor = 1e-4;     ///< [kg·m²] inertia of each motor, seen from its joint
  double balance = 0.8;    ///< 0 to 1: how much of the weight is carried
};

/// One brushed motor under a voltage, behind a capstan.
struct Motor {
  double supply = 12.0;             ///< [V]
  double resistance = 4.0;          ///< [Ohm]
  double torque_constant = 0.0165;  ///< [N·m/A], and [V·s/rad]
  double gear = 10.0;               ///< motor turns per joint turn
  double efficiency = 0.95;         ///< 0 to 1
};

/// The hand that holds the stylus: a mass, drawn by spring and damper to where it wants to be.
struct Hand {
  double mass = 0.08;        ///< [kg]
  double stiffness = 400.0;  ///< [N/m]
  double damping = 8.0;      ///< [N·s/m]
};

/// What a real arm does to what it is told, and to what it says: everything of the device that is
/// not firmware, in numbers. Nothing in it is left to chance: noise comes from the seed.
struct Plant {
  double upper_length = 0.15;    ///< [m]
  double forearm_length = 0.15;  ///< [m]
  ArmMasses masses = {};
  Vec3 joint_min = Arm{}.joint_min;  ///< [rad] where the joints have their stops
  Vec3 joint_max = Arm{}.joint_max;  ///< [rad]
  Motor motor = {};
  Vec3 dry_friction = {0.012, 0.012, 0.012};   ///< [N·m] per joint
  Vec3 viscous_friction = {5e-4, 5e-4, 5e-4};  ///< [N·m·s/rad] per joint
  Hand hand = {};
  double count = 0.0023;         ///< [rad] of the arm joints' sensors: 132 degrees over 10 bits
  double gimbal_count = 0.0046;  ///< [rad] of the gimbal's: 270 degrees over 10 bits
  double noise = 0.0;            ///< [counts] standard deviation
  std::uint64_t seed = 1;
  double step = 50e-6;  ///< [s] the longest step of its motion
};
static_assert(sizeof(Plant) == 256 && alignof(Plant) == 8);

/// What the drivers are told.
struct Drive {
  Vec3 duty = Vec3::Zero();  ///< -255 to 255
  bool enabled = false;      ///< off, the motors are not connected
};
static_assert(sizeof(Drive) == 32 && alignof(Drive) == 8);

/// Where the hand wants to be.
struct HandTarget {
  Vec3 position = Vec3::Zero();  ///< [m] in the arm's frame
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  bool holding = false;          ///< no hand holds the stylus otherwise
};
static_assert(sizeof(HandTarget) == 56 && alignof(HandTarget) == 8);

struct PlantState {
  explicit PlantState(const Plant& plant);  ///< at rest in the middle of its workspace

  double time = 0.0;               ///< [s]
  Vec3 joints = Vec3::Zero();      ///< [rad]
  Vec3 rates = Vec3::Zero();       ///< [rad/s]
  Vec3 gimbal = Vec3::Zero();      ///< [rad]
  Vec3 hand_force = Vec3::Zero();  ///< [N] of the hand on the stylus
  std::uint64_t random = 0;
};
static_assert(sizeof(PlantState) == 112 && alignof(PlantState) == 8);

inline constexpr int kSensorMiddle = 512;  ///< counts at an angle in the middle of a joint's range
inline constexpr int kSensorEnd = 1023;

/// Throws std::invalid_argument naming the field, what it got and what was expected.
void validate(const Plant& plant);

/// What kinematics and weights of this plant are, as a calibration would find them.
Arm find_arm(const Plant& plant) noexcept;

/// [kg·m²] of the arm, and of the hand where one is holding it.
Mat3 compute_mass(const Plant& plant, const Vec3& joints, bool holding) noexcept;

/// [J] kinetic and potential, without the hand.
double compute_energy(const Plant& plant, const PlantState& state) noexcept;

/// [N·m] at the joints, of motors that turn at `rates` [rad/s].
Vec3 compute_motor_torque(const Plant& plant, const Drive& drive, const Vec3& rates) noexcept;

/// [N·m] at the joint of a motor held still at full duty.
double compute_stall_torque(const Motor& motor) noexcept;

/// [N·m·s/rad] that a motor under voltage brakes its joint with.
double compute_motor_damping(const Motor& motor) noexcept;

/// Moves the arm on by `dt` [s] in steps no longer than its own.
void move_plant(const Plant& plant, const Drive& drive, const HandTarget& hand, double dt,
                PlantState& state) noexcept;

/// What the sensors of three joints and the gimbal say: 0 to 1023. Noise moves the seed on.
std::array<std::uint16_t, 6> read_sensors(const Plant& plant, PlantState& state) noexcept;

/// [m] where the stylus' tip really is.
Vec3 find_tip(const Plant& plant, const PlantState& state) noexcept;

}  // namespace palpate
