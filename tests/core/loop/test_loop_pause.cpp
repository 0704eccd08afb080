// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "calls.h"
#include "core/loop/puppet.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// The loop that the puppet below stops in the middle of a tick, at a count known in advance.
Loop* paused_by_puppet = nullptr;

void pause_at_200(int count, HapticSample&) {
  if (count == 200) paused_by_puppet->pause();
}

void wait_until_paused(const Loop& loop) {
  while (!loop.paused() && loop.running()) std::this_thread::yield();
}

}  // namespace

TEST_CASE("a pause misses no tick, makes none up, and lets the run's time stand still") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.004, 0.5);
  puppet.on_read = pause_at_200;
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.5}, &log);
  paused_by_puppet = &loop;

  loop.start();
  wait_until_paused(loop);
  const long before = loop.report().ticks;
  std::this_thread::sleep_for(std::chrono::milliseconds(120));
  CHECK(loop.report().ticks == before);
  CHECK(loop.paused());
  CHECK(loop.running());
  loop.resume();
  while (!loop.wait(10.0)) {
  }
  loop.stop();

  const Taken taken(log);
  CHECK(before == 201);
  CHECK_FALSE(loop.paused());
  CHECK(loop.report().ticks + loop.report().missed_ticks == 500);
  // the pause of 120 ms itself is no lateness: what is due after it has a new due time
  CHECK(puppet.times[201] - puppet.times[200] < 0.1);
  REQUIRE(taken.count(EventKind::paused) == 1);
  for (const Event& event : taken.events) {
    if (event.kind != EventKind::paused) continue;
    CHECK(event.tick == 201);
    CHECK(event.value >= 0.12);
  }
}

TEST_CASE("the device gets zero forces throughout a pause, and then less than a jump") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.006, 2.0);
  puppet.on_read = [](int count, HapticSample&) {
    if (count == 800) paused_by_puppet->pause();  // deep in the tissue
  };
  Loop loop(scene, puppet, {.duration = 0.9, .safety = {.slew_max = 1e6, .ramp_time = 0.05}});
  paused_by_puppet = &loop;

  loop.start();
  wait_until_paused(loop);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  loop.resume();
  while (!loop.wait(10.0)) {
  }
  loop.stop();

  std::size_t first = 801;  // one force for each of the ticks 0 to 800 came before
  REQUIRE(puppet.times.size() > 860);
  CHECK(puppet.forces[first - 1].norm() > 0.1);
  std::size_t resumed = first;
  while (puppet.forces[resumed] == Vec3::Zero()) ++resumed;
  CHECK(resumed - first >= 5);
  // one twentieth of the way up a ramp of 50 ms after a few of them
  CHECK(puppet.forces[resumed + 2].norm() < 0.2 * puppet.forces[first - 1].norm());
  CHECK(puppet.forces[puppet.forces.size() - 2].norm() > 0.5 * puppet.forces[first - 1].norm());
}

TEST_CASE("the log of a run with pauses ticks to the same forces and hashes in a fresh world") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.004, 0.6);
  puppet.on_read = [](int count, HapticSample&) {
    if (count == 150 || count == 300) paused_by_puppet->pause();
  };
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.6}, &log);
  paused_by_puppet = &loop;
  loop.start();
  for (int k = 0; k < 2; ++k) {
    wait_until_paused(loop);
    loop.resume();
    while (loop.paused()) std::this_thread::yield();
  }
  while (!loop.wait(10.0)) {
  }
  loop.stop();
  const Taken taken(log);
  REQUIRE(taken.count(EventKind::paused) == 2);
  REQUIRE(taken.hashes.size() >= 1);

  World world(scene);
  std::size_t different = 0;
  for (const TickLog::Tick& entry : taken.ticks) {
    const Felt felt = compute_felt(tick(scene, entry.sample, 1e-3, world), world);
    different += felt.force != entry.felt.force || felt.position != entry.felt.position;
  }

  CHECK(different == 0);
  CHECK(compute_hash(world) == taken.hashes.back().hash);
}

TEST_CASE("a loop can be paused before it starts and stopped while it is paused") {
  const Scene scene = press_scene();
  Puppet puppet = make_puppet();
  Loop loop(scene, puppet, {.duration = 1.0});
  loop.pause();
  CHECK_FALSE(loop.paused());

  loop.start();
  wait_until_paused(loop);
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  loop.stop();

  CHECK_FALSE(loop.running());
  CHECK_FALSE(loop.paused());
  CHECK(loop.report().ticks == 0);
  CHECK(loop.report().missed_ticks == 0);
  for (const Vec3& force : puppet.forces) CHECK(force == Vec3::Zero());
}

TEST_CASE("pausing allocates nothing and takes no lock in the loop's thread") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  static Calls first, last;
  const Scene scene = press_scene();
  Puppet puppet = make_puppet(0.005, 0.4);
  puppet.on_read = [](int count, HapticSample&) {
    if (count == 200) paused_by_puppet->pause();
    (count == 0 ? first : last) = count_calls_of_this_thread();
  };
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.4}, &log);
  paused_by_puppet = &loop;

  loop.start();
  wait_until_paused(loop);
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  loop.resume();
  while (!loop.wait(10.0)) {
  }
  loop.stop();

  CHECK(loop.report().ticks > 201);
  CHECK(last.allocations == first.allocations);
  CHECK(last.locks == first.locks);
}
