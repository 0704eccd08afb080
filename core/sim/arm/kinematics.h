// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "palpate/sim/base/types.h"

namespace palpate {

/// The arm of the low-cost device: two links in a plane that yaws about the upright axis, all three
/// motors on the ground (a parallelogram drives the second link).
///
/// Joints [rad]: yaw, positive to the right; elevation of the upper link above the horizontal; the
/// forearm's own angle from straight down, positive towards the user. Frame: x to the right, y away
/// from the user, z up, the origin where the yaw axis and the first link meet [kinematics: tip].
struct Arm {
  double upper_length = 0.15;      ///< [m]
  double forearm_length = 0.15;    ///< [m]
  double upper_weight = 0.0287;    ///< [N·m] that carries the arm when the upper link is level
  double forearm_weight = 0.0177;  ///< [N·m] that carries it when the forearm is level
  Vec3 joint_min = {-1.0472, -0.2618, -0.7854};  ///< [rad]
  Vec3 joint_max = {1.0472, 1.5708, 1.3963};     ///< [rad]
  double bend_max = 1.1345;  ///< [rad] between upper link and forearm, 0 at a right angle
};
static_assert(sizeof(Arm) == 88 && alignof(Arm) == 8);

/// Throws std::invalid_argument naming the field, what it got and what was expected.
void validate(const Arm& arm);

/// Where the tip is [m].
Vec3 compute_tip(const Arm& arm, const Vec3& joints) noexcept;

/// How the stylus is held: three gimbal angles [rad] (yaw, pitch, roll) after yaw and forearm. Its
/// axes meet at the tip, so they do not move it. The identity where all five angles are zero.
Quaternion compute_stylus(const Vec3& joints, const Vec3& gimbal) noexcept;

/// How the tip moves with the joints [m/rad], one column per joint.
Mat3 compute_jacobian(const Arm& arm, const Vec3& joints) noexcept;

/// The joints that bring the tip to `tip` [m]; none where it is out of reach or on the yaw axis.
/// They may lie beyond the joints' limits: is_within tells.
std::optional<Vec3> find_joints(const Arm& arm, const Vec3& tip) noexcept;

/// Whether every joint is within its limits, and the links are bent enough to push every way.
bool is_within(const Arm& arm, const Vec3& joints) noexcept;

/// 1 in the workspace, fading to 0 over the last 3 degrees before its edge, 0 beyond. No force is
/// worth pushing the hand where the arm cannot follow.
double compute_edge_fade(const Arm& arm, const Vec3& joints) noexcept;

/// The torques [N·m] that hold the arm up against its weight.
Vec3 compute_weight_torque(const Arm& arm, const Vec3& joints) noexcept;

/// The torques [N·m] that let the hand feel `force` [N] while the arm's weight is carried, none
/// beyond `torque_max` [N·m]. Too large a force loses length, never direction; the weight comes
/// first.
Vec3 compute_torque(const Arm& arm, const Vec3& joints, const Vec3& force,
                    const Vec3& torque_max) noexcept;

/// The inverse: what the hand feels of `torque` [N·m] when the arm rests. Needs a bent arm.
Vec3 compute_tip_force(const Arm& arm, const Vec3& joints, const Vec3& torque) noexcept;

/// A box that lies within the workspace.
struct Workspace {
  Vec3 center = {0.0, -0.13, -0.09};  ///< [m] in the arm's frame
  Vec3 size = {0.20, 0.12, 0.14};     ///< [m]
};
static_assert(sizeof(Workspace) == 48 && alignof(Workspace) == 8);

}  // namespace palpate
