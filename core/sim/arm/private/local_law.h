// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "palpate/sim/arm/calibration.h"

struct palpate_command;  // of the firmware's protocol

namespace palpate {

/// How stiff what the hand feels is: by how much the force changed as the hand moved, over the last
/// ten ticks. Knows nothing of the tissue, so it is right for every kind of it, and for what the
/// safety wrapper makes of the force.
class StiffnessWatch {
 public:
  /// `force` [N] answers a hand at `position` [m]. Returns the symmetric stiffness [N/m], zero
  /// where nothing is felt, and along every direction in which the hand has not gone.
  Mat3 add(const Vec3& position, const Vec3& force) noexcept;
  void clear() noexcept { *this = StiffnessWatch{}; }

 private:
  bool has_last_ = false;
  Vec3 position_ = Vec3::Zero(), force_ = Vec3::Zero();
  Mat3 squares_ = Mat3::Zero(), products_ = Mat3::Zero();
};

/// [N·m/rad] of `stiffness` [N·m/rad] that the device should answer by itself, where the host's
/// answer is `late` [s], half a tick for its being held included, and the joints are damped by
/// `damping` [N·m·s/rad]: no more than keeps the loop stable, none where it is so without.
double choose_local_stiffness(double stiffness, double late, double damping) noexcept;

/// The same along each of a symmetric matrix' own directions.
Mat3 choose_local_stiffness(const Mat3& stiffness, double late, double damping) noexcept;

/// Adds to a command the law with the symmetric `stiffness` [N·m/rad] of the joints about `counts`.
/// What the frame cannot hold becomes softer.
void add_law(const Calibration& calibration, const Mat3& stiffness,
             const std::array<std::uint16_t, 6>& counts, palpate_command& command) noexcept;

}  // namespace palpate
