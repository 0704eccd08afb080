// SPDX-License-Identifier: BSD-3-Clause
// Motors that go off in the middle of a run: nobody feels the force, and nothing may say so.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/arm/device_bench.h"
#include "core/loop/puppet.h"
#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/arm/transport.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A puppet whose motors are as its string says: one letter for each read, the last one stays.
struct Motors : Puppet {
  explicit Motors(std::string states_in)
      : Puppet(press_script(0.006, 2.0)), states(std::move(states_in)) {
    times.reserve(20000);
    forces.reserve(20000);
  }
  MotorState motors() const noexcept override {
    const char state = states[std::min(std::max<std::size_t>(times.size(), 1), states.size()) - 1];
    return state == '1'   ? MotorState::on
           : state == 's' ? MotorState::silent
           : state == '0' ? MotorState::off
                          : MotorState::cut;
  }
  std::string explain_fault() const override { return "motors off: a test"; }

  std::string states;
};

std::string repeat(char state, int count) {
  return std::string(static_cast<std::size_t>(count), state);
}

long count_unrendered(const Taken& taken) {
  return std::count_if(taken.ticks.begin(), taken.ticks.end(), [](const TickLog::Tick& tick) {
    return (tick.felt.touched & kNotRendered) != 0;
  });
}

/// [N] The largest force of the ticks that were felt, or of those that were not.
double find_peak(const Taken& taken, bool rendered) {
  double peak = 0.0;
  for (const TickLog::Tick& tick : taken.ticks) {
    if (((tick.felt.touched & kNotRendered) == 0) == rendered) {
      peak = std::max(peak, double(tick.felt.force.norm()));
    }
  }
  return peak;
}

const Event* find(const Taken& taken, EventKind kind) {
  for (const Event& event : taken.events) {
    if (event.kind == kind) return &event;
  }
  return nullptr;
}

}  // namespace

TEST_CASE(
    "a run whose device loses its motors ends with the tick that finds it, if it is asked to") {
  const Scene scene = press_scene();
  ScriptedDevice hand = press_script(0.006, 2.0);
  FaultyDevice device(hand, {.cut_at = 0.3});
  TickLog log;
  Loop loop(scene, device, {.duration = 2.0, .on_fault = FaultResponse::end}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.fault == DeviceFault::motors_cut);
  CHECK(report.fault_reason == "motors off: they were cut");
  CHECK(report.unrendered_ticks == 1);
  CHECK(report.ticks < 302);
  CHECK(report.ticks == static_cast<long>(taken.ticks.size()));
  REQUIRE(find(taken, EventKind::fault));
  CHECK(find(taken, EventKind::fault)->tick == taken.ticks.back().tick);
  CHECK(find(taken, EventKind::fault)->index == int(DeviceFault::motors_cut));
  REQUIRE(find(taken, EventKind::motors_off));
  CHECK(find(taken, EventKind::motors_off)->index == int(MotorState::cut));
  CHECK(taken.ticks.back().felt.touched >= kNotRendered);
}

TEST_CASE("a device that is gone ends the run too, and says why") {
  const Scene scene = press_scene();
  ScriptedDevice hand = press_script(0.006, 2.0);
  FaultyDevice device(hand, {.unplug_at = 0.1});
  Loop loop(scene, device, {.duration = 2.0, .on_fault = FaultResponse::end});

  run(loop);

  CHECK(loop.report().fault == DeviceFault::device_failed);
  CHECK(loop.report().fault_reason == "unplugged");
  CHECK(loop.report().ticks < 102);
}

TEST_CASE("no force counts that motors did not give, whatever was computed") {
  const Scene scene = press_scene();
  ScriptedDevice hand = press_script(0.006, 1.0);
  FaultyDevice device(hand, {.cut_at = 0.28});  // in the tissue, and it goes deeper
  TickLog log;
  Loop loop(scene, device, {.duration = 0.6, .safety = {.ramp_time = 0.01}}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.fault == DeviceFault::motors_cut);  // and it went on to its end
  CHECK(report.ticks + report.missed_ticks == 600);
  CHECK(report.unrendered_ticks == count_unrendered(taken));
  CHECK(report.unrendered_ticks > 0);
  REQUIRE(find_peak(taken, true) > 0.0);
  CHECK(find_peak(taken, false) > 1.2 * find_peak(taken, true));
  CHECK(report.peak_force < 1.01 * find_peak(taken, true));
  CHECK(report.peak_force > 0.5 * find_peak(taken, true));
  const long touched =
      std::count_if(taken.ticks.begin(), taken.ticks.end(),
                    [](const TickLog::Tick& tick) { return tick.felt.touched == kTouching; });
  CHECK(report.touch_ticks == touched);
  CHECK(report.touch_force > 0.0);
  CHECK(report.touch_force <= report.peak_force);
}

TEST_CASE("motors that are not on yet, or switched off on purpose, are no fault") {
  const Scene scene = press_scene();
  Motors device(repeat('0', 60) + repeat('1', 60) + "0");
  TickLog log;
  Loop loop(scene, device, {.duration = 0.18, .on_fault = FaultResponse::end}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.fault == DeviceFault::none);
  CHECK(report.fault_reason.empty());
  CHECK(report.ticks + report.missed_ticks == 180);
  CHECK(report.unrendered_ticks == report.ticks - 60);
  CHECK(taken.count(EventKind::motors_off) == 2);
  REQUIRE(taken.count(EventKind::motors_on) == 1);
  CHECK(find(taken, EventKind::motors_on)->tick == 60);
  CHECK(count_unrendered(taken) == report.unrendered_ticks);
}

TEST_CASE("a run can rest for a fault, rests again while it lasts, and goes on when it is over") {
  const Scene scene = press_scene();
  Motors device(repeat('1', 50) + "ccc" + "1");
  Loop loop(scene, device, {.duration = 0.2, .on_fault = FaultResponse::pause});
  const auto wait_for_rest = [&loop] {
    while (!loop.paused() && loop.running()) std::this_thread::yield();
  };
  loop.start();
  for (int k = 0; k < 3; ++k) {
    wait_for_rest();
    REQUIRE(loop.running());
    REQUIRE(loop.report().ticks == 51 + k);
    CHECK(loop.report().fault == DeviceFault::motors_cut);
    CHECK(loop.report().fault_reason == "motors off: a test");
    loop.resume();
    // it may rest again before anybody has seen it run
    while (loop.report().ticks == 51 + k && loop.running()) std::this_thread::yield();
  }
  while (!loop.wait(10.0)) {
  }

  CHECK(loop.report().fault == DeviceFault::none);
  CHECK(loop.report().unrendered_ticks == 3);
  CHECK(loop.report().ticks + loop.report().missed_ticks == 200);
}

TEST_CASE("a run that is stopped while it rests for a fault ended with that fault") {
  const Scene scene = press_scene();
  Motors device(repeat('1', 50) + "c");
  Loop loop(scene, device, {.on_fault = FaultResponse::pause});
  loop.start();
  while (!loop.paused()) std::this_thread::yield();

  loop.stop();

  CHECK(loop.report().fault == DeviceFault::motors_cut);
  CHECK(loop.report().ticks == 51);
}

TEST_CASE("motors that are off are sent nothing, and fade in when they come back") {
  Motors device(repeat('1', 400) + repeat('0', 50) + "1");
  SafeDevice safe(device, {.slew_max = 1e6, .ramp_time = 0.1});
  std::vector<double> sent;
  for (int k = 0; k < 700; ++k) {
    safe.read(1e-3 * k);
    safe.write({.force = Vec3(0, 0, k < 10 ? 0.1 : 2.0)});
    sent.push_back(safe.sent().force.z());
    CHECK(device.forces.back().z() == sent.back());
  }

  CHECK(sent[390] == doctest::Approx(2.0));
  CHECK(*std::max_element(sent.begin() + 400, sent.begin() + 450) == 0.0);
  CHECK(sent[455] < 0.2);
  CHECK(sent[500] == doctest::Approx(1.0).epsilon(0.1));
  CHECK(sent[600] == doctest::Approx(2.0));
}

TEST_CASE("some reports that are missing take the force back, not the time to fade in again") {
  Motors device(repeat('1', 400) + repeat('s', 5) + "1");
  SafeDevice safe(device, {.slew_max = 1e6, .ramp_time = 0.1});
  for (int k = 0; k < 410; ++k) {
    safe.read(1e-3 * k);
    safe.write({.force = Vec3(0, 0, k < 10 ? 0.1 : 2.0)});
    if (k >= 400 && k < 405) CHECK(safe.sent().force == Vec3::Zero());
  }

  CHECK(safe.sent().force.z() == doctest::Approx(2.0));
}

TEST_CASE("the driver tells motors that are on, off on purpose and cut, and why") {
  DeviceBench bench;
  bench.device.open();
  const auto none = [](const HapticSample&) { return Vec3::Zero(); };
  bench.run(0.002, none);
  CHECK(bench.device.motors() == MotorState::off);
  bench.run(0.2, none);
  REQUIRE(bench.status().mode == DeviceMode::ramp);
  CHECK(bench.device.motors() == MotorState::on);

  bench.device.enable(false);
  bench.run(0.05, none);
  CHECK(bench.device.motors() == MotorState::off);
  bench.device.enable(true);
  bench.run(0.01, none);
  CHECK(bench.device.motors() != MotorState::cut);
  bench.run(0.1, none);
  CHECK(bench.device.motors() == MotorState::on);
  CHECK(bench.device.explain_fault().empty());

  bench.core.press_stop(true);
  bench.run(0.01, none);
  CHECK(bench.device.motors() == MotorState::cut);
  CHECK(bench.device.explain_fault().find("motors off: stop pressed") == 0);
  bench.core.press_stop(false);
  bench.device.clear_fault();
  long cut = 0;
  for (int k = 0; k < 200 && bench.device.motors() == MotorState::cut; ++k, ++cut) {
    CHECK(bench.device.explain_fault().find("motors off: stop pressed") == 0);
    bench.run(0.001, none);
  }
  CHECK(cut > 1);
  CHECK(bench.device.motors() == MotorState::on);

  bench.core.reset();
  std::string seen;
  for (int k = 0; k < 1000; ++k) {
    bench.run(0.001, none);
    const char state = "1s0c"[static_cast<int>(bench.device.motors())];
    if (seen.empty() || seen.back() != state) seen += state;
  }
  CHECK(seen == "1sc1");
  bench.core.pull_cable();
  bench.run(0.002, none);
  CHECK(bench.device.motors() == MotorState::cut);
  CHECK(bench.device.explain_fault().find("lost: the cable is out") == 0);
}

TEST_CASE("a stop that is pressed before the run is a fault, the last host's silence is none") {
  for (const bool pressed : {true, false}) {
    DeviceBench bench;
    bench.start();
    if (!pressed) bench.core.advance(bench.time + 0.1);  // the host dies
    bench.core.press_stop(pressed);
    bench.core.advance(bench.time + 0.2);
    SerialDevice next(bench.core, Workspace{}.center);
    next.open();
    bool was_cut = false;
    for (int k = 0; k < 500; ++k) {
      next.read(1e-3 * k);
      next.write({});
      was_cut = was_cut || next.motors() == MotorState::cut;
    }

    CHECK(was_cut == pressed);
    CHECK((next.motors() == MotorState::on) == !pressed);
  }
}

TEST_CASE("a host that falls silent before it has seen the motors on finds them cut") {
  const auto none = [](const HapticSample&) { return Vec3::Zero(); };
  DeviceBench bench;
  bench.device.open();
  while (!bench.core.drive().enabled) bench.run(0.001, none);
  REQUIRE(bench.device.motors() == MotorState::off);
  bench.core.advance(bench.time + 0.05);
  bench.time += 0.05;
  bench.run(0.005, none);

  CHECK(bench.device.motors() == MotorState::cut);
  CHECK(bench.device.explain_fault().find("motors off: host silent") == 0);
}

TEST_CASE("a pause keeps the device awake, and its fault can be cleared meanwhile") {
  ScriptedDevice hand({{0.0, Vec3::Zero()}});
  SimulatedArm arm(hand);
  arm.open();
  SafeDevice safe(arm);
  double time = 0.0;
  const auto run = [&](int ticks) {
    for (int k = 0; k < ticks; ++k, time += 1e-3) {
      safe.read(time);
      safe.write({});
    }
  };
  const auto rest = [&](int ticks) {
    for (int k = 0; k < ticks; ++k) safe.rest(1e-3);
  };
  run(800);
  REQUIRE(arm.motors() == MotorState::on);

  rest(500);
  CHECK(arm.motors() == MotorState::on);
  run(10);
  CHECK(arm.motors() == MotorState::on);
  arm.driver().take_status();
  CHECK(arm.driver().status().mode == DeviceMode::run);

  arm.press_stop(true);
  rest(10);
  CHECK(arm.motors() == MotorState::cut);
  arm.driver().take_status();
  CHECK(arm.driver().status().mode == DeviceMode::faulted);
  arm.press_stop(false);
  arm.driver().clear_fault();
  rest(300);
  CHECK(arm.motors() == MotorState::on);
  run(10);
  CHECK(arm.motors() == MotorState::on);
}

TEST_CASE("every fault of a device has a sentence of its own") {
  const ScriptedDevice device({{0.0, Vec3::Zero()}});
  CHECK(describe_fault(DeviceFault::none, 0.0, device).empty());
  CHECK(describe_fault(DeviceFault::sample_out_of_reach, 1e300, device) ==
        "the device told a hand at 1e+300 m, expected within 10 m");
  CHECK(describe_fault(DeviceFault::sample_too_fast, 2e3, device) ==
        "the device told a hand at 2000 m/s, expected at most 1000 m/s");
  CHECK(describe_fault(DeviceFault::motors_cut, 0.0, device) == "the device's motors are off");
}
