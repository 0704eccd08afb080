// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/kinematics.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

constexpr double kFadeAngle = 3.0 * std::numbers::pi / 180.0;  // [rad]

void require_positive(const char* field, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    refuse(std::string("arm: ") + field, write_text(value), "a positive number");
  }
}

/// Where the tip is in the plane of the links: `out` from the yaw axis and `up`.
struct InPlane {
  double out, up;
};

InPlane find_in_plane(const Arm& arm, const Vec3& q) noexcept {
  return {arm.upper_length * std::cos(q[1]) + arm.forearm_length * std::sin(q[2]),
          arm.upper_length * std::sin(q[1]) - arm.forearm_length * std::cos(q[2])};
}

/// How far the joints are from the edge of the workspace [rad], negative beyond it.
double compute_margin(const Arm& arm, const Vec3& q) noexcept {
  const double joints = std::min((q - arm.joint_min).minCoeff(), (arm.joint_max - q).minCoeff());
  return std::min(joints, arm.bend_max - std::abs(q[1] - q[2]));
}

}  // namespace

void validate(const Arm& arm) {
  require_positive("upper_length [m]", arm.upper_length);
  require_positive("forearm_length [m]", arm.forearm_length);
  if (!std::isfinite(arm.upper_weight) || !std::isfinite(arm.forearm_weight)) {
    refuse("arm: weight [N m]", write_text(arm.upper_weight, ", ", arm.forearm_weight),
           "finite numbers");
  }
  for (int j = 0; j < 3; ++j) {
    if (!(arm.joint_min[j] < arm.joint_max[j])) {
      refuse(write_text("arm: joint_min[", j, "] [rad]"), write_text(arm.joint_min[j]),
             write_text("less than joint_max, ", arm.joint_max[j]));
    }
  }
  if (!(arm.bend_max > 0.0 && arm.bend_max < std::numbers::pi / 2.0)) {
    refuse("arm: bend_max [rad]", write_text(arm.bend_max),
           "more than 0, less than a right angle, where the arm cannot push");
  }
}

/// With r outwards from the yaw axis and h up [kinematics: tip],
///
///     r = L1 cos q1 + L2 sin q2,   h = L1 sin q1 - L2 cos q2,   p = (r sin q0, -r cos q0, h)
Vec3 compute_tip(const Arm& arm, const Vec3& q) noexcept {
  const auto [out, up] = find_in_plane(arm, q);
  return {out * std::sin(q[0]), -out * std::cos(q[0]), up};
}

Quaternion compute_stylus(const Vec3& joints, const Vec3& gimbal) noexcept {
  using Turn = Eigen::AngleAxisd;
  return Turn(joints[0], Vec3::UnitZ()) * Turn(-joints[2], Vec3::UnitX()) *
         Turn(gimbal[0], Vec3::UnitZ()) * Turn(gimbal[1], Vec3::UnitX()) *
         Turn(gimbal[2], Vec3::UnitY());
}

/// Its determinant is r L1 L2 cos(q1 - q2) but for the sign: the arm is singular with the tip on
/// the yaw axis, stretched, or folded.
Mat3 compute_jacobian(const Arm& arm, const Vec3& q) noexcept {
  const double s0 = std::sin(q[0]), c0 = std::cos(q[0]);
  const double upper_out = -arm.upper_length * std::sin(q[1]);
  const double upper_up = arm.upper_length * std::cos(q[1]);
  const double forearm_out = arm.forearm_length * std::cos(q[2]);
  const double forearm_up = arm.forearm_length * std::sin(q[2]);
  const double out = find_in_plane(arm, q).out;
  Mat3 jacobian;
  jacobian.col(0) = Vec3(out * c0, out * s0, 0.0);
  jacobian.col(1) = Vec3(upper_out * s0, -upper_out * c0, upper_up);
  jacobian.col(2) = Vec3(forearm_out * s0, -forearm_out * c0, forearm_up);
  return jacobian;
}

/// The law of cosines in the plane of the links [kinematics: inverse]; of the two ways to bend, the
/// elbow that is up.
std::optional<Vec3> find_joints(const Arm& arm, const Vec3& tip) noexcept {
  const double upper = arm.upper_length, forearm = arm.forearm_length;
  const double out = std::hypot(tip.x(), tip.y()), up = tip.z();
  const double reach = std::hypot(out, up);
  if (!(out > 0.0) || !(reach < upper + forearm) || !(reach > std::abs(upper - forearm))) {
    return std::nullopt;
  }
  const double cosine = (reach * reach + upper * upper - forearm * forearm) / (2.0 * reach * upper);
  const double elevation = std::atan2(up, out) + std::acos(std::clamp(cosine, -1.0, 1.0));
  return Vec3(std::atan2(tip.x(), -tip.y()), elevation,
              std::atan2(out - upper * std::cos(elevation), upper * std::sin(elevation) - up));
}

bool is_within(const Arm& arm, const Vec3& joints) noexcept {
  return compute_margin(arm, joints) >= 0.0;
}

double compute_edge_fade(const Arm& arm, const Vec3& joints) noexcept {
  return std::clamp(compute_margin(arm, joints) / kFadeAngle, 0.0, 1.0);
}

/// G = dV/dq with V = g1 sin q1 - g2 cos q2, as the links' heights are [kinematics: force].
Vec3 compute_weight_torque(const Arm& arm, const Vec3& q) noexcept {
  return {0.0, arm.upper_weight * std::cos(q[1]), arm.forearm_weight * std::sin(q[2])};
}

/// tau = G(q) + s J^T f with the largest s <= 1 that leaves no joint beyond its limit. Scaling only
/// the force's part keeps what the hand feels in the direction asked for.
Vec3 compute_torque(const Arm& arm, const Vec3& joints, const Vec3& force,
                    const Vec3& torque_max) noexcept {
  const Vec3 weight = compute_weight_torque(arm, joints).cwiseMax(-torque_max).cwiseMin(torque_max);
  const Vec3 wanted = compute_jacobian(arm, joints).transpose() * force;
  double share = 1.0;
  for (int j = 0; j < 3; ++j) {
    const double room = wanted[j] > 0.0 ? torque_max[j] - weight[j] : torque_max[j] + weight[j];
    if (std::abs(wanted[j]) > room) share = std::min(share, room / std::abs(wanted[j]));
  }
  return weight + share * wanted;
}

Vec3 compute_tip_force(const Arm& arm, const Vec3& joints, const Vec3& torque) noexcept {
  const Vec3 felt = torque - compute_weight_torque(arm, joints);
  return compute_jacobian(arm, joints).transpose().inverse() * felt;
}

}  // namespace palpate
