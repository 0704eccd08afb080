// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/multirate/private/stiffness_scale.h"

#include <Eigen/LU>
#include <algorithm>

namespace palpate {
namespace {

/// Part of what a single exchange shows that is taken over.
constexpr double kGain = 0.7;

/// Part of the force by which it must have changed to count by half.
constexpr double kNoise = 0.1;

/// However little or much a tissue shows: 0 would be a force that is held, which is not passive.
constexpr double kLeast = 0.2, kMost = 2.0;

}  // namespace

/// With the change D that the stiffness K of the exchange before foretells of the force where the
/// hand went from h0 to h1, and d that there was, s minimises (d - s D)² over the exchanges;
/// normalised least mean squares [WidrowHoff60] go a part of the way at each:
///
///     D = -(I + K/k)^-1 K (h1 - h0)
///     s += gain (d . D - s D²) / (D² + noise²)
///
/// A tissue that swings under a hand that rests has D = 0, and one that the hand strikes foretells
/// more than all of the force: neither teaches anything.
void StiffnessScale::follow(const Vec3& hand, double coupling, LocalModel& measured) noexcept {
  const bool touches = !measured.force.isZero(0.0) && !measured.stiffness.isZero(0.0);
  if (touches && touched_ && measured.held == before_.held) {
    const Mat3 soft = Mat3::Identity() + before_.stiffness / coupling;
    const Vec3 foretold = -(soft.inverse() * before_.stiffness * (hand - hand_));
    const double force = std::max(measured.force.norm(), before_.force.norm());
    const double size = foretold.squaredNorm(), noise = kNoise * force;
    if (size <= force * force) {
      const double error = (measured.force - before_.force).dot(foretold) - value_ * size;
      value_ = std::clamp(value_ + kGain * error / (size + noise * noise), kLeast, kMost);
    }
  }
  touched_ = touches;
  before_ = measured;
  hand_ = hand;
  measured.stiffness *= value_;
}

}  // namespace palpate
