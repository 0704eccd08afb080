// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "palpate/sim/multirate/slow_tissue.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// A spring between tool and tissue, along one direction.
struct LocalSpring {
  Vec3 direction = Vec3::Zero();  ///< unit
  double stiffness = 0.0;         ///< [N/m], positive
};

/// [N/m] What holds a tool that leans on tissue by these springs, the tissue giving way under each
/// of them and under the others by `compliance` [m/N], (k, k).
Mat3 condense(std::span<const LocalSpring> springs, const Eigen::MatrixXd& compliance);

/// Triangles around a place that a local model may be of.
inline constexpr int kMostTriangles = 4096;

/// Particles that give way around a contact; more of them are held.
inline constexpr int kMostParticles = 200;

/// The local model of one instrument where the last tick has left its tool. `felt` [N] is what the
/// hand at `hand` [m] was given then. `scratch` is work space, per body. Tissues must be caught up.
LocalModel measure_local_model(const Scene& scene, std::size_t instrument, const Vec3& hand,
                               const Vec3& felt, World& world, std::span<Candidates> scratch);

}  // namespace palpate
