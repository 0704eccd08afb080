// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "core/arm/device_bench.h"
#include "palpate/sim/base/error.h"

using namespace palpate;

namespace {

const auto kNothing = [](const HapticSample&) { return Vec3::Zero(); };

}  // namespace

TEST_CASE("a device is greeted, tells its calibration, and goes through its ramp to full force") {
  DeviceBench bench;

  bench.device.open();
  CHECK(bench.status().link == LinkState::ready);
  CHECK(bench.status().mode == DeviceMode::idle);
  CHECK(bench.device.calibration().upper_length == doctest::Approx(0.15));
  CHECK(bench.device.calibration().torque_full[1] == doctest::Approx(0.4703).epsilon(1e-3));

  bench.run(0.05, kNothing);
  CHECK(bench.status().mode == DeviceMode::ramp);
  bench.run(0.6, kNothing);
  CHECK(bench.status().mode == DeviceMode::run);
  CHECK(bench.status().first_fault == 15);
  CHECK(describe_status(bench.status()) == "run");
}

TEST_CASE("the hand is where the arm is, within what a count is worth") {
  DeviceBench bench;
  bench.start();
  const Vec3 wanted = Workspace{}.center + Vec3(0.04, 0.01, -0.02);

  bench.core.hold({wanted, Vec3::Zero(), true});
  bench.run(1.5, kNothing);

  const Vec3 tip = find_tip(bench.core.plant(), bench.core.state());
  CHECK((tip - wanted).norm() < 2e-3);
  CHECK((bench.sample.position - tip).norm() < 0.7e-3);  // half a count of three joints
  CHECK(bench.sample.velocity.norm() < 0.05);
}

TEST_CASE("the hand's velocity follows it through the sensors' steps") {
  DeviceBench bench(clamped_plant());
  bench.start();
  Vec3 hand = Workspace{}.center - Vec3(0.05, 0.0, 0.0);
  bench.core.hold({hand, Vec3::Zero(), true});
  bench.run(1.0, kNothing);

  const Vec3 velocity(0.1, 0.0, 0.03);
  bench.core.hold({hand, velocity, true});
  bench.run(0.1, kNothing);
  Vec3 mean = Vec3::Zero();
  double worst = 0.0;
  bench.run(0.5, [&](const HapticSample& sample) {
    mean += sample.velocity / 500.0;
    worst = std::max(worst, (sample.velocity - velocity).norm());
    return Vec3::Zero();
  });

  CHECK((mean - velocity).norm() < 0.01);
  CHECK(worst < 0.15);  // [m/s]; one count in one tick is 0.4
}

TEST_CASE("a hand that moves through the sensors' steps is told to move, not to jump") {
  DeviceBench bench(clamped_plant());
  bench.start();
  const Vec3 velocity(0.0, 0.0, -0.04);
  bench.core.hold({Workspace{}.center + Vec3(0, 0, 0.03), velocity, true});
  bench.run(0.3, kNothing);
  Vec3 last = bench.sample.position;
  double fastest = 0.0, off = 0.0;

  bench.run(0.5, [&](const HapticSample& sample) {
    fastest = std::max(fastest, (sample.position - last).norm() / 1e-3);
    last = sample.position;
    const Vec3 tip = find_tip(bench.core.plant(), bench.core.state());
    off = std::max(off, (sample.position - tip).norm());
    return Vec3::Zero();
  });

  CHECK(fastest < 0.15);  // [m/s]; a step of one count in one tick would be 0.35
  CHECK(off < 1e-3);
}

TEST_CASE("the force asked for is felt within 5 % and a step of the duty, all over the workspace") {
  DeviceBench bench(clamped_plant());
  bench.start();

  CHECK(check_forces(bench, 0.12) < 0.05);
}

TEST_CASE("a force beyond the motors is felt shorter but in its direction") {
  DeviceBench bench(clamped_plant());
  bench.start();
  const Vec3 at = Workspace{}.center;
  bench.core.hold({at, Vec3::Zero(), true});

  const Vec3 force(3.0, -4.0, 5.0);
  bench.run(0.3, [&force](const HapticSample&) { return force; });

  const Vec3 felt = -bench.core.state().hand_force;
  CHECK(felt.norm() > 1.0);
  CHECK(felt.norm() < 6.0);
  CHECK(felt.normalized().dot(force.normalized()) > 0.998);
}

TEST_CASE("left alone for 5 s the arm drifts by less than a millimetre") {
  DeviceBench bench;
  bench.start();
  const Vec3 before = find_tip(bench.core.plant(), bench.core.state());

  bench.run(5.0, kNothing);

  CHECK((find_tip(bench.core.plant(), bench.core.state()) - before).norm() < 1e-3);
}

TEST_CASE("without its motors the same arm sinks: it is they that carry it") {
  Plant plant;
  plant.dry_friction.setConstant(1e-3);
  DeviceBench carried(plant), sinking(plant);
  carried.start();
  sinking.start();
  const Vec3 before = find_tip(plant, carried.core.state());

  sinking.device.enable(false);
  carried.run(0.5, kNothing);
  sinking.run(0.5, kNothing);

  CHECK(sinking.status().mode == DeviceMode::idle);
  CHECK((find_tip(plant, sinking.core.state()) - before).norm() > 0.02);
  CHECK((find_tip(plant, carried.core.state()) - before).norm() < 0.005);
}

TEST_CASE("a host that dies leaves no force after 25 ms") {
  DeviceBench bench(clamped_plant());
  bench.start();
  bench.core.hold({Workspace{}.center, Vec3::Zero(), true});
  bench.run(0.3, [](const HapticSample&) { return Vec3(0.0, 0.0, 1.0); });
  REQUIRE(bench.core.motor_force().norm() > 0.9);

  bench.core.advance(bench.time - 1e-3 + 25e-3);  // the last command went out a tick ago

  CHECK(bench.core.motor_force().norm() <= 0.1);
  bench.core.advance(bench.time + 1.0);
  CHECK_FALSE(bench.core.drive().enabled);
}

TEST_CASE("a cable that is pulled leaves no force after 25 ms, and the driver says so") {
  DeviceBench bench(clamped_plant());
  bench.start();
  bench.core.hold({Workspace{}.center, Vec3::Zero(), true});
  const auto push = [](const HapticSample&) { return Vec3(0.0, 0.0, 1.0); };
  bench.run(0.3, push);

  bench.core.pull_cable();
  bench.core.advance(bench.time - 1e-3 + 25e-3);  // the last command went out a tick ago

  CHECK(bench.core.motor_force().norm() <= 0.1);
  bench.run(0.01, push);
  CHECK(bench.device.failed());
  CHECK(bench.sample.position.allFinite());
  CHECK(bench.status().link == LinkState::lost);
  CHECK(describe_status(bench.status()) == "lost: the cable is out, or the device is silent");
}

TEST_CASE("the emergency stop cuts the motors and stays until it is released and cleared") {
  DeviceBench bench;
  bench.start();

  bench.core.press_stop(true);
  bench.run(0.02, kNothing);
  CHECK_FALSE(bench.core.drive().enabled);
  CHECK(bench.status().mode == DeviceMode::faulted);
  CHECK(name_fault(bench.status().first_fault) == "stop pressed");
  CHECK(describe_status(bench.status()) ==
        "motors off: stop pressed; release the emergency stop, then clear");

  bench.device.clear_fault();
  bench.run(0.05, kNothing);
  CHECK(bench.status().mode == DeviceMode::faulted);

  bench.core.press_stop(false);
  bench.run(0.05, kNothing);
  CHECK(bench.status().mode == DeviceMode::faulted);
  bench.device.clear_fault();
  bench.run(0.7, kNothing);
  CHECK(bench.status().mode == DeviceMode::run);
}

TEST_CASE("a device that was reset is greeted again and comes back by itself") {
  DeviceBench bench;
  bench.start();

  bench.core.reset();
  bench.run(0.05, kNothing);
  CHECK(bench.status().degraded);
  bench.run(1.5, kNothing);

  CHECK(bench.status().mode == DeviceMode::run);
  CHECK_FALSE(bench.device.failed());
}

TEST_CASE("a host that comes back after a silence clears its own fault and no other") {
  DeviceBench bench;
  bench.start();
  bench.core.advance(bench.time + 0.2);  // the host sleeps
  bench.time += 0.2;

  bench.device.open();
  bench.time = 0.0;
  bench.run(0.8, kNothing);

  CHECK(bench.status().mode == DeviceMode::run);
}

TEST_CASE("a device whose calibration was damaged in its EEPROM says so, not that it is blank") {
  DeviceBench bench({}, {.damaged = true});
  bench.device.open();
  bench.run(0.2, kNothing);

  CHECK(bench.status().link == LinkState::uncalibrated);
  CHECK(bench.status().damaged);
  CHECK_FALSE(bench.status().blank);
  CHECK(describe_status(bench.status()).find("its calibration in the EEPROM is damaged") !=
        std::string::npos);

  bench.device.store(find_calibration(bench.core.plant()));
  CHECK_FALSE(bench.status().damaged);
}

TEST_CASE(
    "a device without calibration tells no place, keeps its motors off, and can be given one") {
  DeviceBench bench({}, {.calibrated = false});

  bench.device.open();
  bench.run(0.2, kNothing);
  CHECK(bench.status().link == LinkState::uncalibrated);
  CHECK(bench.status().blank);
  CHECK(describe_status(bench.status()) ==
        "blank board: no calibration was ever stored in it, so its motors stay off; calibrate the "
        "device");
  CHECK_FALSE(bench.core.drive().enabled);
  CHECK(bench.status().counts[0] == 512);
  CHECK_THROWS_AS(bench.device.calibration(), DeviceError);

  bench.device.store(find_calibration(bench.core.plant()));
  CHECK(bench.device.calibration().forearm_weight ==
        doctest::Approx(find_arm(bench.core.plant()).forearm_weight).epsilon(1e-4));
  bench.device.clear_fault();
  bench.time = 0.0;
  bench.run(1.0, kNothing);
  CHECK(bench.status().mode == DeviceMode::run);
}

TEST_CASE("what is stored is what is read, number by number") {
  DeviceBench bench;
  bench.device.open();
  Calibration wanted = bench.device.calibration();
  wanted.joints[4] = {.zero = 300, .scale = -0.0031, .min = 20, .max = 900};
  wanted.torque_full = {0.1, -0.2, 0.3};
  wanted.deadband = {1, 2, 3};
  wanted.heat_time = 20.0;
  wanted.serial_number = 4711;

  bench.device.store(wanted);
  const Calibration found = bench.device.calibration();

  CHECK(found.joints[4].zero == 300);
  CHECK(found.joints[4].scale == doctest::Approx(-0.0031));
  CHECK(found.torque_full.isApprox(wanted.torque_full));
  CHECK(found.deadband == wanted.deadband);
  CHECK(found.heat_time == doctest::Approx(20.0).epsilon(0.02));
  CHECK(found.serial_number == 4711);
}

TEST_CASE("a calibration the device cannot hold is refused before anything is written") {
  DeviceBench bench;
  bench.device.open();
  Calibration wrong = bench.device.calibration();
  wrong.joints[0].scale = 0.0;
  CHECK_THROWS_AS(bench.device.store(wrong), std::invalid_argument);
  wrong = bench.device.calibration();
  wrong.torque_full[2] = std::nan("");
  CHECK_THROWS_AS(bench.device.store(wrong), std::invalid_argument);
}

TEST_CASE("nobody at the other end is said in a sentence, within the time given") {
  NativeCore core;
  core.pull_cable();
  SerialDevice device(core);

  CHECK_THROWS_WITH_AS(device.open(0.5), "native core: the cable is out", DeviceError);
}

TEST_CASE("the round trip, the reports' rate and the clocks' drift are measured") {
  DeviceBench bench({}, {.link_delay = 1e-3, .drift = 500e-6});
  bench.start();
  bench.run(8.0, kNothing);
  const DeviceStatus& status = bench.status();

  CHECK(status.report_rate == doctest::Approx(1000.0).epsilon(0.01));
  CHECK(status.lost_reports == 0);
  CHECK(status.damaged_frames == 0);
  CHECK(status.round_trip_median >= 2e-3);  // a millisecond each way
  CHECK(status.round_trip_median <= 5e-3);
  CHECK(std::abs(status.clock_drift - 500e-6) < 75e-6);  // as fine as a reading each millisecond is
  CHECK(status.jitter_p99 < 1.1e-3);                     // read once a millisecond
}

TEST_CASE("a host that answers when the report has come is up to a millisecond less late") {
  const auto find_round_trip = [](double phase) {
    DeviceBench bench;
    bench.device.open();
    bench.run(1e-3, kNothing);
    bench.time += phase;  // of the device's millisecond in which the host reads
    bench.run(1.2, kNothing);
    return bench.status().round_trip_median;
  };
  // tick, half a millisecond until the report begins, 0.35 ms on the wire
  const double with_report = find_round_trip(0.84e-3), just_missed = find_round_trip(0.78e-3);

  std::printf("round trip: %.2f ms with the report, %.2f ms just before it, %.2f ms between\n",
              1e3 * with_report, 1e3 * just_missed, 1e3 * find_round_trip(0.3e-3));
  CHECK(std::abs(with_report - 1e-3) < 0.02e-3);
  CHECK(std::abs(just_missed - 2e-3) < 0.02e-3);
}

TEST_CASE("buttons come through") {
  DeviceBench bench;
  bench.start();

  for (const std::uint8_t pressed : {1, 2, 0}) {
    bench.core.press_buttons(pressed);
    bench.run(0.02, kNothing);
    CHECK(bench.sample.buttons == pressed);
    CHECK(bench.status().buttons == pressed);
  }
}

TEST_CASE("two runs are the same to the last bit") {
  const auto run = [] {
    Plant plant;
    plant.noise = 0.6;
    DeviceBench bench(plant);
    bench.start();
    bench.core.hold({Workspace{}.center, Vec3(0.02, 0, 0), true});
    bench.run(0.5, [](const HapticSample& s) { return Vec3(-20.0 * s.velocity); });
    return bench.core.state().joints;
  };

  CHECK(run() == run());
}
