// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/private/local_law.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

extern "C" {
#include "protocol/messages.h"
}

namespace palpate {
namespace {

constexpr double kKeep = 0.9;  ///< of the past, with each tick

/// [m²] of motion below which a slope is made of rounding: some micrometres a tick.
constexpr double kLeastMotion = 1e-11;

/// [s] T/2 + d of the law on the device: half its tick, and from its sampling to its motors.
constexpr double kLocalDelay = 0.95e-3;

/// Of what [Colgate97] allows; the hand's own damping comes on top.
constexpr double kMargin = 0.7;

constexpr int kShiftMax = 8;
constexpr double kLargest = 32767.0;

std::int16_t write_number(double value) noexcept {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -kLargest, kLargest)));
}

}  // namespace

/// Least squares of the force's changes over the hand's, the symmetric half of
///
///     K = -(sum df dx^T) (sum dx dx^T)^-1.
Mat3 StiffnessWatch::add(const Vec3& position, const Vec3& force) noexcept {
  if (force.isZero(0.0)) {
    clear();
    return Mat3::Zero();
  }
  if (has_last_) {
    const Vec3 moved = position - position_;
    squares_ = kKeep * squares_ + moved * moved.transpose();
    products_ = kKeep * products_ - (force - force_) * moved.transpose();
  }
  has_last_ = true;
  position_ = position;
  force_ = force;
  const Mat3 stiffness = products_ * (squares_ + kLeastMotion * Mat3::Identity()).inverse();
  return 0.5 * (stiffness + stiffness.transpose());
}

/// A sampled spring k that is answered late takes k (T/2 + d) of the damping b [Colgate97]; of two
/// such springs each takes its part. With l on the device and k - l by way of the host,
///
///     l L + (k - l) H <= m b,   so   l = (k H - m b) / (H - L),   and   l L <= m b.
double choose_local_stiffness(double stiffness, double late, double damping) noexcept {
  const double allowed = kMargin * damping;
  if (!(late > kLocalDelay) || !(stiffness > 0.0)) return 0.0;
  const double wanted = (stiffness * late - allowed) / (late - kLocalDelay);
  return std::clamp(wanted, 0.0, std::min(stiffness, allowed / kLocalDelay));
}

Mat3 choose_local_stiffness(const Mat3& stiffness, double late, double damping) noexcept {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(stiffness);
  Vec3 chosen;
  for (int i = 0; i < 3; ++i) {
    chosen[i] = choose_local_stiffness(solver.eigenvalues()[i], late, damping);
  }
  return solver.eigenvectors() * chosen.asDiagonal() * solver.eigenvectors().transpose();
}

/// Joints of different scales make the frame's matrix asymmetric, which it cannot hold: the mean of
/// both halves goes out.
void add_law(const Calibration& calibration, const Mat3& stiffness,
             const std::array<std::uint16_t, 6>& counts, palpate_command& command) noexcept {
  Mat3 wire;  // [1/32767 of full scale per count]
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      wire(i, j) = stiffness(i, j) * calibration.joints[static_cast<std::size_t>(j)].scale /
                   calibration.torque_full[i] * double(PALPATE_TORQUE_FULL);
    }
  }
  wire = (0.5 * (wire + wire.transpose())).eval();
  const double largest = wire.cwiseAbs().maxCoeff();
  if (!std::isfinite(largest) || largest == 0.0) return;
  int shift = 0;
  while (shift < kShiftMax && std::ldexp(largest, shift + 1) <= kLargest) ++shift;
  const double factor = std::min(std::ldexp(1.0, shift), kLargest / largest);
  command.has_law = true;
  command.shift = static_cast<std::uint8_t>(shift);
  const double numbers[] = {wire(0, 0), wire(0, 1), wire(0, 2), wire(1, 1), wire(1, 2), wire(2, 2)};
  for (int n = 0; n < 6; ++n) command.stiffness[n] = write_number(factor * numbers[n]);
  for (std::size_t m = 0; m < PALPATE_MOTORS; ++m) {
    command.rest[m] = static_cast<std::uint16_t>(counts[m] << PALPATE_FRACTION_BITS);
  }
}

}  // namespace palpate
