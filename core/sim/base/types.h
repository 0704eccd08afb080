// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace palpate {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// Points or vectors, one after the other in memory, so NumPy sees (n, 3) without a copy.
using Vec3Array = std::vector<Vec3>;

/// Three particle indices, counter-clockwise from outside.
using Triangle = std::array<int, 3>;

static_assert(sizeof(Vec3) == 3 * sizeof(double), "a Vec3Array must be contiguous (n, 3)");

}  // namespace palpate
