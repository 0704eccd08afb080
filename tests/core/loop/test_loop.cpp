// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "calls.h"
#include "core/loop/puppet.h"
#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/loop/loop.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

TEST_CASE("a loop runs or counts as missed every tick that was due, in order and once") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.5}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.ticks + report.missed_ticks == 500);
  CHECK(report.ticks == static_cast<long>(puppet.times.size()));
  CHECK(static_cast<long>(taken.ticks.size()) == report.ticks);
  CHECK(taken.count(EventKind::missed_ticks) == report.missed_ticks);
  CHECK(report.record_gaps == 0);
  CHECK(report.fault == DeviceFault::none);
  CHECK_FALSE(report.alarm);
  long last_due = -1;
  for (std::size_t i = 0; i < taken.ticks.size(); ++i) {
    const long due = std::lround(taken.ticks[i].sample.time * scene.rate);
    CHECK(taken.ticks[i].tick == static_cast<long>(i));
    CHECK(due > last_due);
    CHECK(puppet.times[i] == taken.ticks[i].sample.time);
    last_due = due;
  }
}

TEST_CASE("the device gets what the wrapper lets through, and a zero force last") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.006, 2.0);
  Loop loop(scene, puppet, {.duration = 0.9, .safety = {.force_max = 0.2, .ramp_time = 0.01}});

  run(loop);

  double largest = 0.0;
  for (const Vec3& force : puppet.forces) largest = std::max(largest, force.norm());
  CHECK(largest > 0.19);
  CHECK(largest <= 0.2 * (1.0 + 1e-12));
  CHECK(puppet.forces.size() == puppet.times.size() + 1);
  CHECK(puppet.forces[puppet.forces.size() - 2].norm() > 0.1);
  CHECK(puppet.forces.back() == Vec3::Zero());
}

TEST_CASE("the log of a loop ticks to the same forces and hashes in a fresh world") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.004, 1.2);
  TickLog log;
  Loop loop(scene, puppet, {.duration = 1.2}, &log);
  run(loop);
  const Taken taken(log);
  REQUIRE(taken.hashes.size() >= 1);
  REQUIRE(taken.hashes.back().tick == loop.report().ticks - 1);

  World world(scene);
  std::size_t next = 0, different = 0;
  for (const TickLog::Tick& entry : taken.ticks) {
    const Felt felt = compute_felt(tick(scene, entry.sample, 1e-3, world), world);
    different += felt.force != entry.felt.force || felt.position != entry.felt.position;
    if (next < taken.hashes.size() && taken.hashes[next].tick == entry.tick) {
      CHECK(compute_hash(world) == taken.hashes[next++].hash);
    }
  }

  CHECK(different == 0);
  CHECK(next == taken.hashes.size());
}

TEST_CASE("ticks that a slow device makes late are skipped, counted and told") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  puppet.on_read = [](int count, HapticSample&) {
    if (count == 20) std::this_thread::sleep_for(std::chrono::microseconds(6500));
  };
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.1}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.missed_ticks >= 6);
  CHECK(report.ticks + report.missed_ticks == 100);
  bool told = false;
  for (const Event& event : taken.events) {
    told = told || (event.kind == EventKind::missed_ticks && event.tick == 21 && event.index >= 6);
  }
  CHECK(told);
  CHECK(puppet.times[21] >= puppet.times[20] + 6.9e-3);
  CHECK(report.cost.max >= 6.5e-3);
  CHECK(report.processor.max < report.cost.max);  // who sleeps has no processor
  CHECK(report.lateness.max >= 5.5e-3);  // of tick 21 behind the time at which it was due first
}

TEST_CASE("a tick that works for longer than its period is told from one that was kept waiting") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  puppet.on_read = [](int count, HapticSample&) {
    const std::int64_t begun = read_thread_clock();
    while (count == 20 && read_thread_clock() - begun < 1'500'000) {
    }
  };
  Loop loop(scene, puppet, {.duration = 0.1});

  run(loop);

  const LoopReport report = loop.report();
  CHECK(report.slow_ticks >= 1);
  CHECK(report.missed_ticks >= 1);
  CHECK(report.processor.max >= 1.5e-3);
}

TEST_CASE("costs and latenesses are measured on every tick and come out in order") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  Loop loop(scene, puppet, {.duration = 0.3});

  run(loop);

  const LoopReport report = loop.report();
  for (const Percentiles& p : {report.cost, report.lateness}) {
    CHECK(p.median <= p.p99);
    CHECK(p.p99 <= p.p99_9);
    CHECK(p.p99_9 <= p.max);
  }
  CHECK(report.cost.median > 0.0);
}

TEST_CASE("another thread sees whole snapshots that only get newer") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.005, 0.6);
  Loop loop(scene, puppet, {.duration = 0.6});
  CHECK(loop.snapshot().bodies[0].position == scene.bodies[0].tissue.rest_position);

  loop.start();
  long last = -1, taken = 0;
  bool newer = true, whole = true, touched = false;
  while (loop.running() || loop.take_snapshot()) {
    if (loop.running() && !loop.take_snapshot()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    const Snapshot& snapshot = loop.snapshot();
    newer = newer && snapshot.tick >= last;
    whole =
        whole && snapshot.bodies[0].position.size() == scene.bodies[0].tissue.rest_position.size();
    touched = touched || snapshot.instruments[0].touching;
    last = snapshot.tick;
    ++taken;
  }
  loop.stop();

  CHECK(taken > 5);
  CHECK(newer);
  CHECK(whole);
  CHECK(touched);
  CHECK(last == loop.report().ticks - 1);
}

TEST_CASE("a run without end goes on until it is stopped") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  Loop loop(scene, puppet);
  CHECK_FALSE(loop.running());

  loop.start();
  CHECK(loop.running());
  CHECK_FALSE(loop.wait(0.02));
  while (loop.report().ticks < 10) std::this_thread::yield();
  loop.stop();

  CHECK_FALSE(loop.running());
  CHECK(loop.wait(0.0));
  CHECK(puppet.forces.back() == Vec3::Zero());
}

TEST_CASE("a loop runs once") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  Loop loop(scene, puppet, {.duration = 0.01});
  loop.start();
  CHECK_THROWS_AS(loop.start(), std::logic_error);
  loop.stop();

  CHECK_THROWS_AS(loop.start(), std::logic_error);
}

TEST_CASE("a loop without real-time rights runs all the same and says what was refused") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  Loop asked(scene, puppet, {.duration = 0.02});
  Loop modest(scene, puppet, {.duration = 0.02, .realtime = false});

  run(asked);
  run(modest);

  CHECK((asked.report().realtime ||
         asked.report().realtime_note.find("priority") != std::string::npos));
  CHECK_FALSE(modest.report().realtime);
  CHECK(modest.report().realtime_note == "real-time priority was not asked for");
}

TEST_CASE("a core that does not exist is said and not fatal") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  Loop loop(scene, puppet, {.duration = 0.02, .realtime = false, .cpu = 100000});

  run(loop);

  CHECK(loop.report().realtime_note.find("not pinned to core 100000") != std::string::npos);
  CHECK(loop.report().ticks > 0);
}

TEST_CASE("a device that says something that is not a number is cut off, told and survived") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.006, 0.2);
  puppet.on_read = [](int count, HapticSample& sample) {
    if (count == 90) sample.position.x() = std::numeric_limits<double>::quiet_NaN();
  };
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.15, .safety = {.ramp_time = 0.01}}, &log);

  run(loop);

  CHECK(loop.report().fault == DeviceFault::sample_not_finite);
  CHECK(Taken(log).count(EventKind::fault) == 1);
  CHECK(puppet.forces[89].norm() > 0.0);
  for (std::size_t i = 90; i < puppet.forces.size(); ++i) CHECK(puppet.forces[i] == Vec3::Zero());
}

TEST_CASE("a tissue that blows up is told, and its force is gone") {
  Scene scene = press_scene();
  // a memory keeps it from being stepped implicitly
  scene.bodies[0].tissue.maxwell = {.ratio = 0.5, .time = 0.4};
  scene = build_scene(std::move(scene));
  scene.rate = 1000.0 / (4.0 * scene.bodies[0].substeps);
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 1;
  Puppet puppet = make_puppet(0.004, 2.0);
  TickLog log;
  Loop loop(scene, puppet, {.duration = 3.0}, &log);
  loop.start();
  while (!loop.report().alarm && loop.running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const long ticks = loop.report().ticks;
  while (loop.report().ticks < ticks + 3 && loop.running()) std::this_thread::yield();

  loop.stop();

  CHECK(loop.report().alarm);
  CHECK(Taken(log).count(EventKind::alarm) == 1);
  CHECK(puppet.forces[puppet.forces.size() - 2].norm() == 0.0);
}

TEST_CASE("a full log costs records, not ticks, and the gap is told") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  TickLog log(50);
  Loop loop(scene, puppet, {.duration = 0.2}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.ticks + report.missed_ticks == 200);
  CHECK(taken.ticks.size() == 50);
  CHECK(report.record_gaps == report.ticks - 50);
  REQUIRE(taken.count(EventKind::record_gap) == 1);
  CHECK(taken.events.back().tick == report.ticks);
  CHECK(taken.events.back().index == report.ticks - 50);
}

TEST_CASE("the loop's thread allocates nothing and takes no lock from its first tick to its last") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  static Calls first, last;
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.005, 1.1);
  puppet.on_read = [](int count, HapticSample&) {
    (count == 0 ? first : last) = count_calls_of_this_thread();
  };
  TickLog log;
  Loop loop(scene, puppet, {.duration = 1.1}, &log);

  run(loop);

  CHECK(puppet.times.back() > 1.0);
  CHECK(last.allocations == first.allocations);
  CHECK(last.locks == first.locks);
}

TEST_CASE("options that mean nothing are refused") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  const double nan = std::numeric_limits<double>::quiet_NaN();

  CHECK_THROWS_AS(Loop(scene, puppet, {.duration = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(Loop(scene, puppet, {.duration = nan}), std::invalid_argument);
  CHECK_THROWS_AS(Loop(scene, puppet, {.cpu = -2}), std::invalid_argument);
  CHECK_THROWS_AS(Loop(scene, puppet, {.spin = 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(Loop(scene, puppet, {.safety = {.force_max = -1.0}}), std::invalid_argument);
}
