// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "palpate/sim/device/simulated_devices.h"

using namespace palpate;
using Vec4 = Eigen::Vector4d;

TEST_CASE("a scripted hand is at its key frames at their times") {
  ScriptedDevice device({{0.5, {0, 0, 0}, 0}, {1.5, {0, 0, 0.01}, 1}, {2.0, {0.02, 0, 0}, 0}});

  CHECK(device.read(0.5).position == Vec3(0, 0, 0));
  CHECK(device.read(1.5).position == Vec3(0, 0, 0.01));
  CHECK(device.read(2.0).position == Vec3(0.02, 0, 0));
  CHECK(device.duration() == 2.0);
}

TEST_CASE("a scripted hand stands still before its first and after its last key frame") {
  ScriptedDevice device({{0.5, {0, 0, 0.003}, 1}, {1.5, {0, 0, 0.01}, 1}});

  CHECK(device.read(0.1).position == Vec3(0, 0, 0.003));
  CHECK(device.read(0.1).buttons == 0);
  CHECK(device.read(9.0).position == Vec3(0, 0, 0.01));
  CHECK(device.read(9.0).velocity == Vec3::Zero());
}

TEST_CASE("half way in time a minimum-jerk hand is half way in space at 15/8 of the mean speed") {
  ScriptedDevice device({{1.0, {0, 0, 0}, 0}, {3.0, {0.008, 0, 0}, 0}});

  const HapticSample sample = device.read(2.0);

  CHECK(sample.position.x() == doctest::Approx(0.004));
  CHECK(sample.velocity.x() == doctest::Approx(0.004 * 15.0 / 8.0));
}

TEST_CASE("the velocity of a scripted hand is the slope of its position") {
  ScriptedDevice device({{0.0, {0, 0, 0}, 0}, {0.7, {0.01, -0.02, 0.005}, 0}});
  const double h = 1e-6;

  for (double t = 0.05; t < 0.7; t += 0.05) {
    const Vec3 slope = (device.read(t + h).position - device.read(t - h).position) / (2.0 * h);
    CHECK((device.read(t).velocity - slope).norm() < 1e-7);
  }
}

TEST_CASE("buttons of a script hold from their key frame to the next") {
  ScriptedDevice device({{0, {0, 0, 0}, 0}, {1, {0, 0, 0}, kAttachButton}, {2, {0, 0, 0}, 0}});

  CHECK(device.read(0.999).buttons == 0);
  CHECK(device.read(1.0).buttons == kAttachButton);
  CHECK(device.read(1.999).buttons == kAttachButton);
  CHECK(device.read(2.0).buttons == 0);
}

TEST_CASE("a script without frames, out of order or not finite is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();

  CHECK_THROWS_AS(ScriptedDevice({}), std::invalid_argument);
  CHECK_THROWS_AS(ScriptedDevice({{1, {0, 0, 0}, 0}, {1, {0, 0, 1}, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(ScriptedDevice({{0, {0, nan, 0}, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(ScriptedDevice({{nan, {0, 0, 0}, 0}}), std::invalid_argument);
}

TEST_CASE("a replayed hand gives one sample per call and then stays at the last") {
  HapticSample first, second;
  first.position.x() = 1.0;
  second.position.x() = 2.0;
  ReplayDevice device({first, second});

  CHECK(device.read(7.0).position.x() == 1.0);
  CHECK_FALSE(device.finished());
  CHECK(device.read(7.0).position.x() == 2.0);
  CHECK(device.finished());
  CHECK(device.read(7.0).position.x() == 2.0);
  CHECK_THROWS_AS(ReplayDevice({}), std::invalid_argument);
}

TEST_CASE("a pointer's samples reach another thread whole, and forces come back whole") {
  PointerDevice device;
  std::atomic<bool> stop{false};
  std::thread window([&] {
    for (int i = 1; !stop; ++i) {
      HapticSample sample;
      sample.orientation = Quaternion(i, i, i, i);
      sample.grip = i;
      device.set(sample);
      const Vec3 force = device.take_command().force;
      if (force.x() != force.y() || force.x() != force.z()) stop = true;
    }
  });

  bool whole = true, newer = true;
  double last = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const HapticSample sample = device.read(i);
    const double grip = sample.grip;
    whole = whole && sample.time == i &&
            (grip == 0.0 || sample.orientation.coeffs() == Vec4::Constant(grip));
    newer = newer && sample.grip >= last;
    last = sample.grip;
    device.write({.force = Vec3::Constant(i)});
  }
  const bool forces_whole = !stop;
  stop = true;
  window.join();

  CHECK(whole);
  CHECK(newer);
  CHECK(forces_whole);
  CHECK(device.take_command().force == Vec3::Constant(19999));
}

TEST_CASE("a pointer's hand begins where it is first set, and glides from there without a step") {
  PointerDevice device;
  HapticSample sample;
  sample.position = Vec3(0.1, 0.2, 0.3);
  device.set(sample);
  CHECK(device.read(0.0).position == Vec3(0.1, 0.2, 0.3));

  sample.position = Vec3(0.105, 0.2, 0.3);
  sample.buttons = kAttachButton;
  device.set(sample);
  Vec3 last(0.1, 0.2, 0.3);
  for (int i = 1; i <= 300; ++i) {
    const HapticSample hand = device.read(1e-3 * i);
    CHECK(hand.buttons == kAttachButton);
    CHECK(hand.position.x() >= last.x());
    CHECK((hand.position - last).norm() <= 0.35e-3);  // 5 mm / 15 ms
    CHECK((hand.velocity - (hand.position - last) / 1e-3).norm() < 1e-9);
    last = hand.position;
    if (i == 15) CHECK(last.x() == doctest::Approx(0.105 - 0.005 * std::exp(-1.0)));
  }
  CHECK(last == Vec3(0.105, 0.2, 0.3));
  CHECK(device.read(0.301).velocity == Vec3::Zero());
}

TEST_CASE("a pointer's hand does not hurry after ticks that were missed") {
  PointerDevice punctual, late;
  HapticSample sample;
  for (PointerDevice* device : {&punctual, &late}) {
    device->set(sample);
    device->read(0.0);
  }
  sample.position.z() = 0.004;
  punctual.set(sample);
  late.set(sample);

  const double height = punctual.read(1.5e-3).position.z();
  CHECK(height > 0.0);
  CHECK(late.read(0.020).position.z() == height);
}

TEST_CASE("a pointer's hand is never faster than 1 m/s, however far the pointer jumps") {
  PointerDevice device;
  HapticSample sample;
  device.set(sample);
  device.read(0.0);
  sample.position.z() = 0.5;
  device.set(sample);

  CHECK(device.read(0.001).velocity.norm() == doctest::Approx(1.0));
  CHECK(device.read(0.002).position.z() == doctest::Approx(0.002));
}
