// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <deque>
#include <limits>

#include "palpate/sim/device/safe_device.h"

using namespace palpate;

namespace {

constexpr double kDt = 1e-3;

/// A hand of its own mass that the device really moves; what is sent acts one tick later per
/// `delay`. Nothing damps it.
struct FreeHand : HapticDevice {
  HapticSample read(double time) noexcept override {
    const Vec3 felt = pipe.front();
    pipe.pop_front();
    // exact under a held force
    const Vec3 a = felt / mass;
    hand.position += hand.velocity * kDt + 0.5 * a * kDt * kDt;
    hand.velocity += a * kDt;
    hand.time = time;
    return hand;
  }
  void write(const HapticCommand& command) noexcept override { pipe.push_back(command.force); }
  std::string name() const override { return "free hand"; }
  bool failed() const noexcept override { return gone; }

  double mass = 0.1;  // [kg]
  std::deque<Vec3> pipe = {Vec3::Zero()};
  HapticSample hand;
  bool gone = false;
};

/// Lets the hand run into a wall at z = 0 that pushes with `stiffness` [N/m] and nothing else;
/// returns the largest speed it has in the last of `seconds`.
double bounce(SafeDevice& safe, const FreeHand& hand, double stiffness, double seconds) {
  double fastest = 0.0;
  for (int k = 0; k < seconds / kDt; ++k) {
    const HapticSample sample = safe.read(k * kDt);
    const double depth = std::max(0.0, -sample.position.z());
    safe.write({.force = {0.0, 0.0, stiffness * depth}});
    if (k * kDt > seconds - 1.0) fastest = std::max(fastest, hand.hand.velocity.norm());
  }
  return fastest;
}

/// A hand between two walls, so that it comes back for ever.
double bounce_between(SafeDevice& safe, const FreeHand& hand, double stiffness, double seconds) {
  double fastest = 0.0;
  for (int k = 0; k < seconds / kDt; ++k) {
    const HapticSample sample = safe.read(k * kDt);
    const double z = sample.position.z();
    const double push = z < 0.0 ? -stiffness * z : z > 0.02 ? stiffness * (0.02 - z) : 0.0;
    safe.write({.force = {0.0, 0.0, push}});
    if (k * kDt > seconds - 1.0) fastest = std::max(fastest, hand.hand.velocity.norm());
  }
  return fastest;
}

const SafetyLimits kNoController = {.force_max = 50.0,
                                    .force_continuous = 50.0,
                                    .slew_max = 1e6,
                                    .ramp_time = 1e-3,
                                    .velocity_max = 100.0,
                                    .energy_max = 1e6};

/// Hands over samples as told.
struct Told : HapticDevice {
  HapticSample read(double time) noexcept override {
    hand.time = time;
    return hand;
  }
  void write(const HapticCommand& command) noexcept override { pushed = command.force; }
  std::string name() const override { return "told"; }
  HapticSample hand;
  Vec3 pushed = Vec3::Zero();
};

Vec3 run(SafeDevice& safe, const Told& device, const Vec3& force, int ticks, double& time) {
  for (int i = 0; i < ticks; ++i, time += kDt) {
    safe.read(time);
    safe.write({.force = force});
  }
  return device.pushed;
}

}  // namespace

TEST_CASE("a device whose first command is large stays without force until a small one came") {
  Told device;
  SafeDevice safe(device, {.start_force_max = 0.5});
  double time = 0.0;

  CHECK(run(safe, device, {0, 0, 2}, 500, time) == Vec3::Zero());
  run(safe, device, {0, 0, 0.5}, 1, time);
  CHECK(run(safe, device, {0, 0, 2}, 100, time).z() == doctest::Approx(1.0));
  CHECK(run(safe, device, {0, 0, 2}, 150, time).z() == 2.0);
}

TEST_CASE("what a rest interrupts goes on without waiting for a small force") {
  Told device;
  SafeDevice safe(device, {.start_force_max = 0.5});
  double time = 0.0;
  run(safe, device, Vec3::Zero(), 1, time);
  run(safe, device, {0, 0, 2}, 300, time);

  safe.rest();

  CHECK(run(safe, device, {0, 0, 2}, 1, time).z() == 0.0);
  CHECK(run(safe, device, {0, 0, 2}, 300, time).z() == 2.0);
}

TEST_CASE("a peak is had for a while, then the motors' heat takes it back to what they stand") {
  Told device;
  SafeDevice safe(device, {.force_max = 4.0, .force_continuous = 2.0, .heat_time = 1.0});
  double time = 0.0;
  run(safe, device, Vec3::Zero(), 1, time);

  CHECK(run(safe, device, {0, 0, 4}, 210, time).z() == doctest::Approx(4.0));
  // 16 (1 - exp(-t)) N^2 reaches 80 % of 4 N^2 after 223 ms
  CHECK(run(safe, device, {0, 0, 4}, 190, time).z() < 3.9);
  const double late = run(safe, device, {0, 0, 4}, 5000, time).z();
  CHECK(late == doctest::Approx(2.0).epsilon(0.02));
  CHECK(safe.heat() <= 1.0);

  CHECK(run(safe, device, Vec3::Zero(), 3000, time) == Vec3::Zero());  // 3 time constants of rest
  CHECK(safe.heat() < 0.06);
  CHECK(run(safe, device, {0, 0, 4}, 100, time).z() == doctest::Approx(4.0));
}

TEST_CASE("the heat stays below what the motors stand whatever is asked for") {
  Told device;
  SafeDevice safe(device, {.force_max = 9.0, .force_continuous = 1.0, .heat_time = 0.2});
  double time = 0.0;
  run(safe, device, Vec3::Zero(), 1, time);
  double hottest = 0.0;

  for (int i = 0; i < 40; ++i) {
    run(safe, device, {i % 2 ? 20.0 : 0.0, 20.0, i % 3 - 1.0}, 97, time);
    hottest = std::max(hottest, safe.heat());
  }

  CHECK(hottest <= 1.0);
  CHECK(hottest > 0.8);
}

TEST_CASE("a hand that is too fast is not pushed along, and braked by the excess") {
  Told device;
  SafeDevice safe(device, {.slew_max = 1e6, .velocity_max = 2.0, .brake = 0.5});
  double time = 0.0;
  run(safe, device, Vec3::Zero(), 1, time);
  run(safe, device, {0.3, 0, 1}, 300, time);

  device.hand.velocity = {0.0, 0.0, 3.0};

  const Vec3 sent = run(safe, device, {0.3, 0, 1}, 1, time);
  CHECK(sent.x() == doctest::Approx(0.3));
  CHECK(sent.z() == doctest::Approx(-0.5));  // 0.5 N s/m on 1 m/s too much
}

TEST_CASE("a hand that is too fast is stopped no harder than it was pushed, but for the brake") {
  Told device;
  SafeDevice safe(device, {.slew_max = 1e6, .velocity_max = 2.0, .brake = 0.5});
  double time = 0.0;
  run(safe, device, Vec3::Zero(), 1, time);
  run(safe, device, {0, 0, 1}, 300, time);

  device.hand.velocity = {0.0, 0.0, -2.5};  // into the tissue

  CHECK(run(safe, device, {0, 0, 4}, 1, time).z() == doctest::Approx(1.25));
  device.hand.velocity = {0.0, 0.0, -1.9};
  CHECK(run(safe, device, {0, 0, 4}, 1, time).z() == doctest::Approx(4.0));
}

TEST_CASE("an undamped hand between stiff walls gains speed without the controller, not with it") {
  FreeHand wild, tame;
  wild.hand.position.z() = tame.hand.position.z() = 0.01;
  wild.hand.velocity.z() = tame.hand.velocity.z() = -0.1;
  SafetyLimits limits = kNoController;
  SafeDevice without(wild, limits);
  limits.energy_max = 1e-4;
  SafeDevice with(tame, limits);

  // without damping any sampled wall feeds energy: K T / 2 > 0 = b
  const double unbound = bounce_between(without, wild, 300.0, 10.0);
  const double bound = bounce_between(with, tame, 300.0, 10.0);

  CHECK(unbound > 1.0);
  // 0.5 mJ of its own, 0.1 mJ that is let pass, and as much in each of ten seconds
  CHECK(bound < std::sqrt(2.0 * (5e-4 + 1e-4 + 10 * 1e-4) / tame.mass));
  CHECK(with.damped_count() > 0);
  CHECK(without.damped_count() == 0);
}

TEST_CASE("a wall far too stiff is beyond the controller, whose damping has its limit") {
  FreeHand hand;
  hand.hand.position.z() = 0.01;
  hand.hand.velocity.z() = -0.1;
  SafetyLimits limits = kNoController;
  limits.energy_max = 1e-4;
  limits.damping_max = 2.0;
  SafeDevice safe(hand, limits);

  // 2 N s/m against K T / 2 = 20 N s/m
  CHECK(bounce_between(safe, hand, 40000.0, 3.0) > 0.2);
}

TEST_CASE("what is passive already is not damped") {
  FreeHand hand;
  hand.hand.position.z() = 0.01;
  hand.hand.velocity.z() = -0.1;
  SafeDevice safe(hand, {.force_max = 50.0, .ramp_time = 1e-3});

  bounce(safe, hand, 100.0, 1.0);  // one bounce feeds 1e-5 J, below what is allowed

  CHECK(safe.damped_count() == 0);
  CHECK(safe.given_energy() < 1e-4);
}

TEST_CASE("a force that the hand gives in to is energy given, one it overcomes is not") {
  Told device;
  SafeDevice safe(device, {.energy_max = 1.0});
  double time = 0.0;
  run(safe, device, Vec3::Zero(), 1, time);
  run(safe, device, {0, 0, 1}, 300, time);
  const double before = safe.given_energy();
  CHECK(before == 0.0);

  device.hand.position.z() = 0.01;  // 1 N over 1 cm
  run(safe, device, {0, 0, 1}, 1, time);
  CHECK(safe.given_energy() == doctest::Approx(0.01).epsilon(2e-3));

  device.hand.position.z() = -0.01;
  run(safe, device, {0, 0, 1}, 1, time);
  CHECK(safe.given_energy() == doctest::Approx(-0.01).epsilon(5e-3));

  run(safe, device, Vec3::Zero(), 3, time);  // felt nothing: what was put in is forgotten
  CHECK(safe.given_energy() == 0.0);
}

TEST_CASE("what a hand put into a spring is remembered for as long as it holds it") {
  Told device;
  SafeDevice safe(device, {.force_max = 20.0, .force_continuous = 20.0, .ramp_time = 1e-3});
  constexpr double kSpring = 1000.0;  // [N/m]
  double time = 0.0;
  const auto stay = [&](double depth, int ticks) {
    for (int k = 0; k < ticks; ++k, time += kDt) {
      device.hand.position.z() = -depth;
      safe.read(time);
      safe.write({.force = {0, 0, kSpring * depth}});
    }
  };
  stay(0.0, 10);
  for (int k = 0; k <= 200; ++k) stay(5e-3 * k / 200, 1);
  const double put_in = -safe.given_energy();
  CHECK(put_in == doctest::Approx(0.5 * kSpring * 25e-6).epsilon(0.02));

  stay(5e-3, 5000);
  CHECK(-safe.given_energy() == doctest::Approx(put_in).epsilon(1e-9));

  for (int k = 200; k >= 0; --k) stay(5e-3 * k / 200, 1);
  CHECK(safe.given_energy() < 2e-4);  // K T times the integral of v^2, there and back
  CHECK(safe.damped_count() == 0);
}

TEST_CASE("a device that gave up is a fault, and gets zero forces from then on") {
  FreeHand hand;
  SafeDevice safe(hand);
  safe.read(0.0);
  safe.write({});
  CHECK(safe.fault() == DeviceFault::none);

  hand.gone = true;
  safe.read(kDt);
  safe.write({.force = {0, 0, 1}});

  CHECK(safe.fault() == DeviceFault::device_failed);
  CHECK(safe.failed());
  CHECK(safe.sent().force == Vec3::Zero());
}
