// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/base/types.h"

namespace palpate {

/// [counts] A gimbal axis turns so far either way of the middle of its sensor.
inline constexpr int kGimbalReach = 500;

/// [rad] The gimbal angles (yaw, pitch, roll) that hold the stylus as `stylus`, unit, where the arm
/// is in `joints` [rad]: the inverse of compute_stylus, each within `most` [rad] of its middle. A
/// stylus that cannot be held so comes as near as with angles that stop there.
Vec3 compute_gimbal(const Vec3& joints, const Quaternion& stylus, double most) noexcept;

}  // namespace palpate
