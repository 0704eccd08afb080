// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "core/arm/device_bench.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/device/simulated_devices.h"

using namespace palpate;

namespace {

ScriptedDevice straight() { return ScriptedDevice({{0.0, {0, 0, 0}}, {1.0, {0.1, 0, 0}}}); }

/// The driver over a wire to which faults happen, and what became of it.
struct FaultyRun {
  double worst_force = 0.0, worst_jump = 0.0;
  DeviceStatus status;
  bool failed = false;
};

FaultyRun run(const Faults& faults, double seconds = 3.0) {
  NativeCore core(clamped_plant());
  FaultyTransport wire(core, faults);
  SerialDevice device(wire, Workspace{}.center);
  core.hold({Workspace{}.center, Vec3::Zero(), true});
  device.open(3.0);
  FaultyRun result;
  Vec3 last = Vec3::Zero();
  for (int k = 0; k < seconds * 1000; ++k) {
    const HapticSample sample = device.read(1e-3 * k);
    device.write({.force = {0.0, 0.0, k < 700 ? 0.0 : 1.0}});
    REQUIRE(sample.position.allFinite());
    if (k > 100) result.worst_jump = std::max(result.worst_jump, (sample.position - last).norm());
    last = sample.position;
    result.worst_force = std::max(result.worst_force, core.motor_force().norm());
  }
  device.take_status();
  result.status = device.status();
  result.failed = device.failed();
  return result;
}

}  // namespace

TEST_CASE("without faults a faulty device is the device itself") {
  ScriptedDevice bare = straight(), inner = straight();
  FaultyDevice faulty(inner, {});

  for (double time : {0.0, 0.3, 0.6, 2.0}) {
    CHECK(faulty.read(time).position == bare.read(time).position);
  }
  faulty.write({.force = {1, 2, 3}});
  CHECK(inner.last_command.force == Vec3(1, 2, 3));
  CHECK_FALSE(faulty.failed());
  CHECK(faulty.name() == "faulty script");
}

TEST_CASE("a delay makes samples and commands late by just so much") {
  ScriptedDevice bare = straight(), inner = straight();
  FaultyDevice faulty(inner, {.delay = 5e-3});

  for (int k = 0; k < 500; ++k) {
    const HapticSample sample = faulty.read(1e-3 * k);
    faulty.write({.force = {double(k), 0, 0}});
    if (k < 10) continue;
    CHECK((sample.position - bare.read(1e-3 * (k - 5)).position).norm() < 1e-6);
    CHECK(inner.last_command.force.x() == doctest::Approx(k - 5).epsilon(0.2));
  }
}

TEST_CASE("a device that sticks says the same for ever, one that is unplugged is gone") {
  ScriptedDevice inner = straight();
  FaultyDevice sticking(inner, {.stick_at = 0.5});
  const Vec3 before = sticking.read(0.4).position;
  CHECK(sticking.read(0.6).position == before);
  CHECK(sticking.read(0.9).position == before);
  CHECK_FALSE(sticking.failed());

  FaultyDevice unplugged(inner, {.unplug_at = 0.5});
  unplugged.read(0.4);
  CHECK_FALSE(unplugged.failed());
  unplugged.read(0.5);
  CHECK(unplugged.failed());
  CHECK(unplugged.read(0.9).position.allFinite());
}

TEST_CASE(
    "whatever happens to its samples, a safe device hands on finite ones and stops for good") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ScriptedDevice inner = straight();
    FaultyDevice faulty(inner, {.drop = 0.1, .corrupt = 0.01, .reorder = 0.1, .seed = seed});
    SafeDevice safe(faulty);
    for (int k = 0; k < 1000; ++k) {
      const HapticSample sample = safe.read(1e-3 * k);
      REQUIRE(sample.position.allFinite());
      REQUIRE(sample.velocity.allFinite());
      safe.write({.force = {0.0, 0.0, k > 0 ? 1.0 : 0.0}});
    }
    CHECK((safe.fault() == DeviceFault::sample_not_finite ||
           safe.fault() == DeviceFault::sample_out_of_reach ||
           safe.fault() == DeviceFault::sample_too_fast));
    CHECK(safe.sent().force == Vec3::Zero());
  }
}

TEST_CASE("a wire that loses one frame in ten costs reports, never the run") {
  const FaultyRun lossy = run({.drop = 0.1, .seed = 5});

  CHECK(lossy.status.mode == DeviceMode::run);
  CHECK(lossy.status.lost_reports > 200);
  CHECK(lossy.worst_force < 1.3);
  CHECK(lossy.worst_jump < 2e-3);
}

TEST_CASE("frames that were changed on their way are found out, and change nothing") {
  const FaultyRun noisy = run({.corrupt = 0.2, .seed = 6});

  CHECK(noisy.status.mode == DeviceMode::run);
  CHECK(noisy.status.damaged_frames > 300);
  CHECK(noisy.worst_force < 1.3);
  CHECK(noisy.worst_jump < 2e-3);
}

TEST_CASE("reports that overtake each other and come 4 ms late are borne") {
  const FaultyRun late = run({.reorder = 0.1, .delay = 4e-3, .seed = 7});

  CHECK(late.status.mode == DeviceMode::run);
  CHECK(late.status.round_trip_median > 8e-3);
  CHECK(late.worst_force < 1.3);
}

TEST_CASE("a wire that carries nothing but noise is said so, in time") {
  NativeCore core;
  FaultyTransport wire(core, {.corrupt = 1.0, .seed = 8});
  SerialDevice device(wire);

  CHECK_THROWS(device.open(0.5));
}

TEST_CASE("a device that repeats one report for ever loses its force") {
  const FaultyRun stuck = run({.stick_at = 1.5}, 1.6);
  CHECK(stuck.worst_force > 0.9);  // before
  CHECK(stuck.status.degraded);

  CHECK(run({.stick_at = 1.5}, 2.8).failed);
}

TEST_CASE("a cable pulled in the middle of a run is a failed device") {
  const FaultyRun pulled = run({.unplug_at = 1.0}, 1.5);

  CHECK(pulled.failed);
  CHECK(pulled.status.link == LinkState::lost);
}

TEST_CASE("faults that cannot be are refused") {
  ScriptedDevice inner = straight();
  CHECK_THROWS_AS(FaultyDevice(inner, {.drop = 1.1}), std::invalid_argument);
  CHECK_THROWS_AS(FaultyDevice(inner, {.corrupt = -0.1}), std::invalid_argument);
  CHECK_THROWS_AS(FaultyDevice(inner, {.reorder = std::nan("")}), std::invalid_argument);
  CHECK_THROWS_AS(FaultyDevice(inner, {.delay = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(FaultyDevice(inner, {.stick_at = std::nan("")}), std::invalid_argument);
}
