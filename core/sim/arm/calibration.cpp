// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/arm/private/gimbal.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

constexpr double kDutyFull = 255.0;
constexpr double kDutyMax = 230.0;  ///< the firmware never drives more
/// [counts] of an open or shorted wire, kept away from the ends of a joint's range.
constexpr int kRailLow = 8, kRailHigh = 1015;

void require(bool good, const std::string& field, double value, const char* expected) {
  if (!good || !std::isfinite(value)) {
    refuse("calibration: " + field, write_text(value), expected);
  }
}

void require_joint(const JointSensor& joint, int j) {
  const std::string name = write_text("joints[", j, "].");
  // the device keeps whole nanoradians in 32 bits
  require(std::abs(joint.scale) >= 1e-9 && std::abs(joint.scale) < 2.1, name + "scale [rad/count]",
          joint.scale, "a size of 1e-9 to 2.1");
  require(joint.zero >= 0 && joint.zero <= 65535, name + "zero [counts]", joint.zero, "0 to 65535");
  require(joint.min >= 0, name + "min [counts]", joint.min, "0 or more");
  require(joint.max <= 65535, name + "max [counts]", joint.max, "at most 65535");
  require(joint.min < joint.max, name + "min [counts]", joint.min, "less than max");
}

/// The largest force [N] that can be had in every direction at `joints`, of motors that have
/// `torque` [N·m] for it: no column of the Jacobian may need more.
double find_force_every_way(const Arm& arm, const Vec3& joints, const Vec3& torque) noexcept {
  const Vec3 weight = compute_weight_torque(arm, joints).cwiseAbs();
  const Mat3 jacobian = compute_jacobian(arm, joints);
  double force = std::numeric_limits<double>::infinity();
  for (int j = 0; j < 3; ++j) {
    force = std::min(force, std::max(0.0, torque[j] - weight[j]) / jacobian.col(j).norm());
  }
  return force;
}

/// Of all corners of the workspace that the arm reaches.
double find_force_in_workspace(const Arm& arm, const Vec3& torque) noexcept {
  const Workspace box;
  double force = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 part(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    const auto joints = find_joints(arm, box.center + part.cwiseProduct(box.size));
    if (joints) force = std::min(force, find_force_every_way(arm, *joints, torque));
  }
  return force;
}

}  // namespace

void validate(const Calibration& calibration) {
  for (int j = 0; j < 6; ++j) require_joint(calibration.joints[static_cast<std::size_t>(j)], j);
  require(calibration.upper_length >= 1e-6 && calibration.upper_length < 4000.0, "upper_length [m]",
          calibration.upper_length, "a micrometre or more");
  require(calibration.forearm_length >= 1e-6 && calibration.forearm_length < 4000.0,
          "forearm_length [m]", calibration.forearm_length, "a micrometre or more");
  for (int m = 0; m < 3; ++m) {
    const double torque = calibration.torque_full[m];
    require(std::abs(torque) >= 1e-6 && std::abs(torque) < 2000.0, "torque_full [N m]", torque,
            "a size of 1e-6 to 2000");
    const auto i = static_cast<std::size_t>(m);
    require(calibration.deadband[i] >= 0 && calibration.deadband[i] < 64, "deadband [duty]",
            calibration.deadband[i], "0 to 63");
    require(calibration.continuous_duty[i] >= 1 && calibration.continuous_duty[i] <= 255,
            "continuous_duty [duty]", calibration.continuous_duty[i], "1 to 255");
  }
  require(std::abs(calibration.upper_weight) < 2000.0, "upper_weight [N m]",
          calibration.upper_weight, "less than 2000");
  require(std::abs(calibration.forearm_weight) < 2000.0, "forearm_weight [N m]",
          calibration.forearm_weight, "less than 2000");
  require(calibration.heat_time >= 0.033 && calibration.heat_time <= 1048.0, "heat_time [s]",
          calibration.heat_time, "0.033 to 1048");
  require(calibration.speed_max >= 1 && calibration.speed_max <= 255, "speed_max [counts/ms]",
          calibration.speed_max, "1 to 255");
}

Calibration find_calibration(const Plant& plant) {
  const Arm arm = find_arm(plant);
  Calibration found;
  for (int j = 0; j < 6; ++j) {
    JointSensor& joint = found.joints[static_cast<std::size_t>(j)];
    joint.scale = j < 3 ? plant.count : plant.gimbal_count;
    const double middle = j < 3 ? 0.5 * (plant.joint_min[j] + plant.joint_max[j]) : 0.0;
    joint.zero = kSensorMiddle - static_cast<int>(std::lround(middle / joint.scale));
    const double half =
        j < 3 ? 0.5 * (plant.joint_max[j] - plant.joint_min[j]) / joint.scale : kGimbalReach;
    joint.min = std::max(kRailLow, kSensorMiddle - static_cast<int>(std::lround(half)));
    joint.max = std::min(kRailHigh, kSensorMiddle + static_cast<int>(std::lround(half)));
  }
  found.upper_length = plant.upper_length;
  found.forearm_length = plant.forearm_length;
  found.torque_full.setConstant(compute_stall_torque(plant.motor));
  found.upper_weight = arm.upper_weight;
  found.forearm_weight = arm.forearm_weight;
  return found;
}

std::array<double, 6> compute_angles(const Calibration& calibration,
                                     const std::array<std::uint16_t, 6>& counts) noexcept {
  std::array<double, 6> angles{};
  for (std::size_t j = 0; j < 6; ++j) {
    const JointSensor& joint = calibration.joints[j];
    angles[j] = joint.scale * (static_cast<int>(counts[j]) - joint.zero);
  }
  return angles;
}

Arm find_arm(const Calibration& calibration) noexcept {
  Arm arm;
  arm.upper_length = calibration.upper_length;
  arm.forearm_length = calibration.forearm_length;
  arm.upper_weight = calibration.upper_weight;
  arm.forearm_weight = calibration.forearm_weight;
  for (int j = 0; j < 3; ++j) {
    const JointSensor& joint = calibration.joints[static_cast<std::size_t>(j)];
    const double a = joint.scale * (joint.min - joint.zero);
    const double b = joint.scale * (joint.max - joint.zero);
    arm.joint_min[j] = std::min(a, b);
    arm.joint_max[j] = std::max(a, b);
  }
  return arm;
}

SafetyLimits find_safety_limits(const Calibration& calibration) {
  const Arm arm = find_arm(calibration);
  Vec3 forever;
  for (int m = 0; m < 3; ++m) {
    forever[m] = std::abs(calibration.torque_full[m]) / kDutyFull *
                 calibration.continuous_duty[static_cast<std::size_t>(m)];
  }
  const Vec3 peak = calibration.torque_full.cwiseAbs() * (kDutyMax / kDutyFull);
  SafetyLimits limits;
  limits.force_max = find_force_in_workspace(arm, peak);
  limits.force_continuous = find_force_in_workspace(arm, forever);
  limits.heat_time = calibration.heat_time;
  if (!(limits.force_continuous > 0.0) || !std::isfinite(limits.force_max)) {
    refuse("calibration", "motors that cannot carry the arm's weight or links that do not reach",
           "an arm that can push anywhere in its workspace");
  }
  // what starts the motors must be felt as little even where they are weak
  limits.start_force_max = std::min(limits.start_force_max, 0.5 * limits.force_continuous);
  return limits;
}

}  // namespace palpate
