// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/loop/loop.h"

using namespace palpate;

namespace {

ScriptedDevice still_hand() { return ScriptedDevice({{0.0, Vec3(0.002, 0.0, 0.0)}}); }

}  // namespace

TEST_CASE("a device loop sends a force, and a spring's from where the hand is") {
  ScriptedDevice hand = still_hand();
  DeviceLoop loop(hand);

  loop.set_task({.force = {0.0, 0.0, 0.3}, .stiffness = 100.0});
  loop.run(0.5);

  CHECK(hand.last_command.force.x() == doctest::Approx(-0.2));
  CHECK(hand.last_command.force.z() == doctest::Approx(0.3));
  CHECK(loop.time() == doctest::Approx(0.499));
}

TEST_CASE("a device loop keeps within the limits of the device") {
  ScriptedDevice hand = still_hand();
  DeviceLoop loop(hand, {.force_max = 0.5, .force_continuous = 0.5});
  loop.set_task({.force = {0.0, 0.0, 0.3}});
  loop.run(0.5);

  loop.set_task({.force = {0.0, 0.0, 9.0}});
  loop.run(0.5);

  CHECK(hand.last_command.force.norm() <= 0.5 + 1e-12);
}

TEST_CASE("a device loop in a thread of its own goes by the clock and leaves no force") {
  ScriptedDevice hand = still_hand();
  DeviceLoop loop(hand);
  loop.set_task({.force = {0.0, 0.0, 0.3}});

  loop.start();
  CHECK(loop.running());
  CHECK_THROWS_AS(loop.start(), std::logic_error);
  CHECK_THROWS_AS(loop.run(1.0), std::logic_error);
  while (loop.time() < 0.05) std::this_thread::yield();
  loop.stop();

  CHECK_FALSE(loop.running());
  CHECK(hand.last_command.force == Vec3::Zero());
  const double before = loop.time();
  loop.start();
  while (loop.time() <= before) std::this_thread::yield();
  loop.stop();
}

TEST_CASE("a device that hears nothing from its loop for a while cuts its motors and says why") {
  ScriptedDevice hand({{0.0, Vec3::Zero()}});
  SimulatedArm arm(hand);
  arm.open();
  DeviceLoop loop(arm);
  loop.run(1.0);
  REQUIRE(arm.core().drive().enabled);

  loop.fall_silent(0.03);
  loop.run(0.1);

  CHECK_FALSE(arm.core().drive().enabled);
  arm.driver().take_status();
  CHECK(name_fault(arm.driver().status().first_fault) == "host silent");
}

TEST_CASE("a device that is gone ends in a fault of the loop") {
  ScriptedDevice hand({{0.0, Vec3::Zero()}});
  SimulatedArm arm(hand);
  arm.open();
  DeviceLoop loop(arm);
  loop.run(0.1);
  CHECK(loop.fault() == DeviceFault::none);

  arm.pull_cable();
  loop.run(0.1);

  CHECK(loop.fault() == DeviceFault::device_failed);
}

TEST_CASE("what no hand can feel is refused") {
  ScriptedDevice hand = still_hand();
  DeviceLoop loop(hand);
  const double nan = std::numeric_limits<double>::quiet_NaN();

  CHECK_THROWS_AS(loop.set_task({.force = {nan, 0.0, 0.0}}), std::invalid_argument);
  CHECK_THROWS_AS(loop.set_task({.stiffness = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(loop.set_task({.rest = {0.0, nan, 0.0}}), std::invalid_argument);
  CHECK_THROWS_AS(loop.run(0.0), std::invalid_argument);
  CHECK_THROWS_AS(loop.run(nan), std::invalid_argument);
}

TEST_CASE(
    "a wide hand goes to a joint's stop, and what happens to the arm is heard by the driver") {
  PointerDevice pointer;
  pointer.set({.position = Workspace{}.center});
  SimulatedArm arm(pointer, Workspace{}.center);
  arm.open();
  DeviceLoop loop(arm);
  loop.run(0.1);
  const Vec3 stop(0.0, 0.5236, Arm{}.joint_max[2] + 0.01);

  arm.widen(true);
  pointer.set({.position = compute_tip(Arm{}, stop)});
  loop.run(1.5);
  CHECK(arm.core().state().joints[2] == doctest::Approx(Arm{}.joint_max[2]).epsilon(0.003));
  CHECK(arm.hand_force().norm() > 0.1);

  arm.press_stop(true);
  loop.run(0.05);
  arm.driver().take_status();
  CHECK(name_fault(arm.driver().status().first_fault) == "stop pressed");
}

TEST_CASE("round trips are counted by how long they took") {
  ScriptedDevice hand({{0.0, Vec3::Zero()}});
  SimulatedArm arm(hand);
  arm.open();
  DeviceLoop loop(arm);

  loop.run(1.0);

  arm.driver().take_status();
  const DeviceStatus& status = arm.driver().status();
  long all = 0, before = 0;
  double median = 0.0;
  for (const long count : status.round_trips) all += count;
  for (std::size_t bin = 0; bin < status.round_trips.size(); ++bin) {
    before += status.round_trips[bin];
    if (2 * before >= all) {
      median = 0.25e-3 * (double(bin) + 0.5);
      break;
    }
  }
  CHECK(all > 900);
  CHECK(median == doctest::Approx(status.round_trip_median).epsilon(0.3));
}

#ifdef PALPATE_SERIAL

TEST_CASE("a silence lasts although the device's reports come on") {
  PtyDevice device;
  SerialTransport transport(device.path());
  SerialDevice driver(transport);
  driver.open(20.0);
  DeviceLoop loop(driver);
  const auto wait_for = [&](auto&& done) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    do {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      driver.take_status();
    } while (!done() && std::chrono::steady_clock::now() < until);
    return done();
  };
  loop.start();
  // a machine that is busy may fall silent on its own
  int waited = 0;
  REQUIRE(wait_for([&] {
    if (driver.status().mode == DeviceMode::faulted && waited++ % 25 == 0) driver.clear_fault();
    return driver.status().mode == DeviceMode::run;
  }));

  loop.fall_silent(0.03);

  CHECK(wait_for([&] { return name_fault(driver.status().first_fault) == "host silent"; }));
  CHECK(loop.fault() == DeviceFault::none);
  loop.stop();
}

#endif
