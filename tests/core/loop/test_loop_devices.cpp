// SPDX-License-Identifier: BSD-3-Clause
// The live loop over a scene of several instruments, each with a device of its own.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "calls.h"
#include "core/loop/pair_scene.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

double largest(const std::vector<Vec3>& forces) {
  double most = 0.0;
  for (const Vec3& force : forces) most = std::max(most, force.norm());
  return most;
}

/// The second hand says something that is not a number from its 100th tick on.
void fail_aside(int count, HapticSample& sample) {
  sample.position += kAside;
  if (count >= 100) sample.position.x() = std::numeric_limits<double>::quiet_NaN();
}

std::string refusal(const Scene& scene, std::vector<HapticDevice*> devices,
                    const LoopOptions& options = {}, TickLog* log = nullptr) {
  try {
    const Loop loop(scene, devices, options, log);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("each of two devices gets the force of its own instrument, read at the same times") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(0.006, 0.4), second = make_puppet_aside(0.003, 0.4);
  TickLog log(4000, 2);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second}, {.duration = 0.4}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(first.times == second.times);
  CHECK(static_cast<long>(taken.ticks.size()) == 2 * report.ticks);
  REQUIRE(report.devices.size() == 2);
  for (int i : {0, 1}) {
    const DeviceReport& device = report.devices[static_cast<std::size_t>(i)];
    const Puppet& puppet = i == 0 ? first : second;
    CHECK(device.peak_force == largest(puppet.forces));
    CHECK(device.peak_force > 0.01);
    CHECK(device.touch_ticks > 0);
    CHECK(device.unrendered_ticks == 0);
    CHECK(device.fault == DeviceFault::none);
    CHECK(puppet.forces.back() == Vec3::Zero());
  }
  CHECK(report.devices[0].peak_force > 1.2 * report.devices[1].peak_force);
  CHECK(report.peak_force == report.devices[0].peak_force);
  CHECK(report.touch_ticks == report.devices[0].touch_ticks + report.devices[1].touch_ticks);
  CHECK(report.touch_force > report.devices[1].touch_force);
  CHECK(report.touch_force < report.devices[0].touch_force);
}

TEST_CASE("the log of two instruments ticks to the same forces and hashes in a fresh world") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(), second = make_puppet_aside();
  TickLog log(4000, 2);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second}, {.duration = 0.3}, &log);
  run(loop);
  const Taken taken(log);
  REQUIRE(taken.hashes.size() == 1);

  World world(scene);
  std::size_t different = 0;
  for (std::size_t row = 0; row < taken.ticks.size(); row += 2) {
    const TickLog::Tick *const a = &taken.ticks[row], *const b = a + 1;
    REQUIRE(a->tick == b->tick);
    std::array<HapticCommand, 2> commands;
    tick(scene, std::array{a->sample, b->sample}, 1e-3, world, commands);
    different += compute_felt(commands[0], world, 0).force != a->felt.force;
    different += compute_felt(commands[1], world, 1).force != b->felt.force;
  }
  CHECK(different == 0);
  CHECK(compute_hash(world) == taken.hashes[0].hash);
}

TEST_CASE("a device that fails loses its own force, and the other one feels as before") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(0.006, 0.3), second = make_puppet_aside(0.006, 0.3);
  second.on_read = fail_aside;
  TickLog log(4000, 2);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second},
            {.duration = 0.3, .safety = {.ramp_time = 0.01}}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.ticks + report.missed_ticks == 300);
  CHECK(report.fault == DeviceFault::sample_not_finite);
  CHECK(report.devices[0].fault == DeviceFault::none);
  CHECK(report.devices[0].unrendered_ticks == 0);
  CHECK(report.devices[1].fault == DeviceFault::sample_not_finite);
  CHECK(report.devices[1].unrendered_ticks == report.unrendered_ticks);
  CHECK(report.fault_reason == report.devices[1].fault_reason);
  CHECK(first.forces[150].norm() > 0.0);
  for (std::size_t i = 100; i < second.forces.size(); ++i) CHECK(second.forces[i].norm() == 0.0);
  for (const Event& event : taken.events) {
    if (event.kind == EventKind::fault) CHECK(event.source == 1);
  }
  CHECK(taken.count(EventKind::fault) == 1);
  for (std::size_t row = 0; row < taken.ticks.size(); ++row) {
    const bool rendered = (taken.ticks[row].felt.touched & kNotRendered) == 0;
    CHECK(rendered == (row % 2 == 0 || row / 2 < 100));
  }
}

TEST_CASE("a device that fails ends or pauses the run of all, where the run is asked to") {
  const Scene scene = pair_of(press_scene());
  for (const FaultResponse response : {FaultResponse::end, FaultResponse::pause}) {
    Puppet first = make_puppet(), second = make_puppet_aside();
    second.on_read = fail_aside;
    Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second},
              {.duration = 10.0, .on_fault = response});
    loop.start();
    while (!loop.paused() && !loop.wait(0.01)) {
    }
    CHECK(loop.paused() == (response == FaultResponse::pause));
    loop.stop();

    CHECK(loop.report().ticks == 101);
    CHECK(first.forces.back() == Vec3::Zero());
  }
}

TEST_CASE("what an instrument holds and a device's motors are told with the instrument's number") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet();
  Puppet second(press_script(0.006, 0.3, true));
  second.times.reserve(20000);
  second.forces.reserve(20000);
  second.on_read = [](int, HapticSample& sample) { sample.position += kAside; };
  TickLog log(4000, 2);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second}, {.duration = 0.35}, &log);

  run(loop);

  const Taken taken(log);
  CHECK(taken.count(EventKind::attached) == 1);
  CHECK(taken.count(EventKind::released) == 1);
  for (const Event& event : taken.events) {
    CHECK(event.source == (event.kind == EventKind::missed_ticks ? 0 : 1));
  }
}

TEST_CASE("a snapshot shows every instrument with what its own hand is given") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(0.006, 0.4), second = make_puppet_aside(-0.001, 0.4);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second}, {.duration = 0.16});
  REQUIRE(loop.snapshot().instruments.size() == 2);

  run(loop);

  REQUIRE(loop.take_snapshot());
  const Snapshot& snapshot = loop.snapshot();
  CHECK(snapshot.instruments[0].touching);
  CHECK_FALSE(snapshot.instruments[1].touching);
  CHECK(snapshot.instruments[0].force == first.forces[first.forces.size() - 2]);
  CHECK(snapshot.instruments[1].force == Vec3::Zero());
  CHECK(snapshot.instruments[0].sample.time == snapshot.instruments[1].sample.time);
  CHECK((snapshot.instruments[1].tool_position - snapshot.instruments[0].tool_position).x() > 0.1);
}

TEST_CASE("each device has the limits that are given for it") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(0.006, 0.4), second = make_puppet_aside(0.006, 0.4);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second},
            {.duration = 0.3,
             .device_safety = {{.force_max = 0.2, .ramp_time = 0.01}, {.ramp_time = 0.01}}});

  run(loop);

  CHECK(loop.report().devices[0].peak_force <= 0.2 * (1.0 + 1e-12));
  CHECK(loop.report().devices[1].peak_force > 0.25);
}

TEST_CASE("the thread of a loop over two devices allocates nothing and takes no lock") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  static Calls first_calls, last_calls;
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(0.005, 1.1), second = make_puppet_aside(0.005, 1.1);
  first.on_read = [](int count, HapticSample&) {
    (count == 0 ? first_calls : last_calls) = count_calls_of_this_thread();
  };
  TickLog log(4000, 2);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second}, {.duration = 1.1}, &log);

  run(loop);

  CHECK(first.times.back() > 1.0);
  CHECK(last_calls.allocations == first_calls.allocations);
  CHECK(last_calls.locks == first_calls.locks);
}

TEST_CASE("other numbers of devices, limits and rows than instruments are refused in a sentence") {
  const Scene scene = pair_of(press_scene());
  Puppet first = make_puppet(), second = make_puppet_aside();
  TickLog narrow, wide(4000, 2);
  const std::string each = ", expected 2, one for each instrument of the scene";

  CHECK(refusal(scene, {&first}) == "loop: devices: got 1" + each);
  CHECK(refusal(scene, {}) == "loop: devices: got 0" + each);
  CHECK(refusal(scene, {&first, &first}) ==
        "loop: devices[1]: got a device that drives another instrument, expected one of its own");
  CHECK(refusal(scene, {&first, nullptr}) == "loop: devices[1]: got none, expected one of its own");
  CHECK(refusal(scene, {&first, &second}, {.device_safety = {{}}}) ==
        "loop: device_safety: got 1" + each);
  CHECK(refusal(scene, {&first, &second}, {}, &narrow) == "loop: log.instruments: got 1" + each);
  CHECK(refusal(scene, {&first, &second}, {}, &wide).empty());
}
