// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "palpate/sim/device/safe_device.h"

using namespace palpate;

namespace {

constexpr double kDt = 1e-3;          // [s]
constexpr double kMass = 0.1;         // [kg] of hand and stylus
constexpr double kHold = 100.0;       // [N/m] by which the hand keeps its place
constexpr double kGrip = 0.5;         // [N·s/m] of a light hand
constexpr double kStiffness = 200.0;  // [N/m] of the contact

/// A hand that keeps its place by spring and damper and is moved by what it is sent.
struct HeldHand : HapticDevice {
  HapticSample read(double time) noexcept override {
    constexpr int kSteps = 50;
    constexpr double kStep = kDt / kSteps;
    double &x = hand.position.z(), &v = hand.velocity.z();
    for (int k = 0; k < kSteps; ++k) {
      v += kStep / kMass * (felt.z() - kHold * x - kGrip * v);
      x += kStep * v;
    }
    hand.time = time;
    return hand;
  }
  void write(const HapticCommand& command) noexcept override { felt = command.force; }
  std::string name() const override { return "held hand"; }
  /// [J] of its motion and its spring.
  double energy() const noexcept {
    return 0.5 * kMass * hand.velocity.squaredNorm() + 0.5 * kHold * hand.position.squaredNorm();
  }

  HapticSample hand;
  Vec3 felt = Vec3::Zero();
};

/// [J] of the hand, tick by tick, beyond what it begins with: pushed by a spring that also pushes
/// along with it, by `drive` [N·s/m].
struct Given {
  std::vector<double> energy;
  std::size_t begins = 0;  // tick in which the controller first acts; how many there are for none
};
Given give(double drive, double energy_max, double seconds) {
  HeldHand hand;
  hand.hand.velocity.z() = -0.02;
  SafeDevice safe(hand, {.force_max = 20.0,
                         .force_continuous = 20.0,
                         .slew_max = 1e5,
                         .ramp_time = 1e-3,
                         .start_force_max = 1.0,
                         .velocity_max = 50.0,
                         .energy_max = energy_max});
  const double before = hand.energy();
  Given given;
  for (int k = 0; k < std::lround(seconds / kDt); ++k) {
    const HapticSample sample = safe.read(k * kDt);
    given.energy.push_back(hand.energy() - before);
    safe.write({.force = drive * sample.velocity - kStiffness * sample.position});
    if (safe.damped_count() == 0) ++given.begins;
  }
  return given;
}

}  // namespace

TEST_CASE("a contact that makes energy is stopped: 50 ms on, the hand has what it may be given") {
  const double most = SafetyLimits{}.energy_max;
  for (const double drive : {1.0, 1.5, 2.0}) {
    CAPTURE(drive);
    const Given wild = give(drive, 1e6, 2.0), tame = give(drive, most, 2.0);
    const std::size_t stops = tame.begins + 50;

    CHECK(wild.begins == wild.energy.size());
    CHECK(wild.energy.back() > 50.0 * most);
    REQUIRE(stops < 1000);
    const double then = *std::max_element(tame.energy.begin(), tame.energy.begin() + long(stops));
    const double later = *std::max_element(tame.energy.begin() + long(stops), tame.energy.end());
    CHECK(then < 1.1 * most);
    CHECK(later < 1.1 * most);
  }
}

TEST_CASE("beyond the controller's damping it makes energy on, more slowly") {
  const double most = SafetyLimits{}.energy_max;
  const double drive = kGrip + 1.3 * SafetyLimits{}.damping_max;
  const Given wild = give(drive, 1e6, 0.4), tame = give(drive, most, 0.4);

  CHECK(tame.energy.back() > 3.0 * most);
  CHECK(tame.energy.back() < 0.5 * wild.energy.back());
}
