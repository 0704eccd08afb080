// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/private/gimbal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/arm/kinematics.h"

namespace palpate {
namespace {

/// Cosine of the pitch below which yaw and roll turn about one axis.
constexpr double kLocked = 1e-9;

/// An angle [rad] turned by half a circle, within -pi to pi.
double turn_half(double angle) noexcept {
  return angle > 0.0 ? angle - std::numbers::pi : angle + std::numbers::pi;
}

}  // namespace

/// R = Rz(a) Rx(b) Ry(c) is read off its entries [kinematics: gimbal]:
///
///     sin b = R_21,   tan a = -R_01/R_11,   tan c = -R_20/R_22,
///
/// with cos b > 0, or the same with a + pi, pi - b, c + pi. Where b is a right angle only a + c or
/// a - c is known, of which yaw and roll take half each.
Vec3 compute_gimbal(const Vec3& joints, const Quaternion& stylus, double most) noexcept {
  const Quaternion forearm = compute_stylus(joints, Vec3::Zero());
  const Mat3 r = (forearm.conjugate() * stylus).toRotationMatrix();
  const double pitch = std::asin(std::clamp(r(2, 1), -1.0, 1.0));
  Vec3 first(std::atan2(-r(0, 1), r(1, 1)), pitch, std::atan2(-r(2, 0), r(2, 2)));
  if (std::hypot(r(0, 1), r(1, 1)) < kLocked) {
    const double half = 0.5 * std::atan2(r(1, 0), r(0, 0));
    first = Vec3(half, pitch, pitch > 0.0 ? half : -half);
  }
  const Vec3 second(turn_half(first[0]), turn_half(-first[1]), turn_half(first[2]));
  const Vec3 a = first.cwiseMax(-most).cwiseMin(most), b = second.cwiseMax(-most).cwiseMin(most);
  if (a == first) return a;
  const double left_by_a = compute_stylus(joints, a).angularDistance(stylus);
  const double left_by_b = compute_stylus(joints, b).angularDistance(stylus);
  return left_by_b < left_by_a ? b : a;
}

}  // namespace palpate
