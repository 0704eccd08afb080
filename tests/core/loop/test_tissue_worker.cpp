// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "calls.h"
#include "core/loop/puppet.h"
#include "core/model/refusal.h"
#include "palpate/sim/loop/private/tissue_worker.h"
#include "palpate/sim/multirate/slow_tissue.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr int kTicks = 500;

Scene slow_scene(double exchange_rate) {
  Scene scene = press_scene();
  scene.exchange_rate = exchange_rate;
  return build_scene(std::move(scene));
}

struct Slow {
  std::vector<Vec3> forces;
  std::vector<Event> exchanges;
  long late = 0;
};

/// A press through a worker, so many microseconds from tick to tick.
Slow feel(const Scene& scene, int wait, bool attach = false) {
  TissueWorker worker(scene);
  World shown(scene);
  TickLog log;
  ScriptedDevice hand = press_script(0.005, 0.5, attach);
  HapticCommand command;
  Slow slow;
  for (int t = 0; t < kTicks; ++t) {
    const HapticSample sample = hand.read(1e-3 * t);
    worker.tick({&sample, 1}, shown, {&command, 1}, &log);
    slow.forces.push_back(command.force);
    if (wait > 0) std::this_thread::sleep_for(std::chrono::microseconds(wait));
  }
  slow.exchanges = Taken(log).events;
  slow.late = worker.late_exchanges();
  CHECK(worker.exchanges() == static_cast<long>(slow.exchanges.size()));
  CHECK(shown.tick_count == kTicks);
  return slow;
}

}  // namespace

TEST_CASE("a tissue that is in time is felt to the bit as in the thread that asks") {
  const Scene scene = slow_scene(50.0);
  SlowTissue asked(scene, 1000.0, 20);
  ScriptedDevice hand = press_script(0.005, 0.5);
  std::vector<Vec3> expected;
  for (int t = 0; t < kTicks; ++t) expected.push_back(asked.tick(hand.read(1e-3 * t)).force);

  Slow slow = feel(scene, 1000);
  for (int again = 0; again < 5 && slow.late > 0; ++again) slow = feel(scene, 1000);

  SKIP_UNLESS(slow.late == 0,
              "cannot be had here: a machine with the time for 162 vertices at 50 Hz");
  CHECK(slow.forces == expected);
  REQUIRE(slow.exchanges.size() == 24);
  for (std::size_t i = 0; i < slow.exchanges.size(); ++i) {
    CHECK(slow.exchanges[i].kind == EventKind::tissue_exchanged);
    CHECK(slow.exchanges[i].tick == 20 * (static_cast<long>(i) + 1));
    CHECK(slow.exchanges[i].index == 20);
    CHECK(slow.exchanges[i].value > 0.0);
  }
}

TEST_CASE("nobody waits for a tissue that is late, and it is said to be") {
  const Scene scene = slow_scene(1000.0);
  TissueWorker worker(scene);
  World shown(scene);
  HapticSample sample;
  sample.position = {0.001, 0.002, 0.022};
  HapticCommand command;
  bool finite = true;

  // ticks one after the other, in each of which an exchange is due: a tissue needs many of them
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (worker.late_exchanges() < 5 && std::chrono::steady_clock::now() < patience) {
    worker.tick({&sample, 1}, shown, {&command, 1}, nullptr);
    finite = finite && command.force.allFinite();
  }

  CHECK(worker.late_exchanges() == 5);
  CHECK(shown.tick_count > 2 * worker.exchanges());
  CHECK(finite);
}

TEST_CASE("a force whose tissue stays away falls to nothing within 20 ms of being stale") {
  // no exchange after the first: the hand goes on in less time than the tissue needs for one
  const Scene scene = slow_scene(100.0);
  SlowSide tissue(scene, 10);
  Exchange exchange(tissue.world());
  FastSide hands(scene, LocalForceMode::local_stiffness, 1e-3, 10);
  ScriptedDevice script = press_script(0.005, 0.5);
  HapticCommand command;
  double at_40 = 0.0, at_60 = 0.0;
  for (int t = 0; t < 400; ++t) {
    // down, where it stays
    const HapticSample sample = script.read(1e-3 * std::min(t, 240));
    hands.follow({&sample, 1});
    if (hands.is_due() && t <= 300) {
      if (hands.has_told()) hands.take(exchange);
      hands.tell(exchange);
      tissue.follow(exchange);
    }
    hands.render({&command, 1});
    if (t == 315) at_40 = command.force.norm();  // its model is of the hand of 25 ms before
    if (t == 345) at_60 = command.force.norm();
  }

  CHECK(at_40 > 0.1);
  CHECK(at_60 == 0.0);
}

TEST_CASE("a tick with a slow tissue allocates and locks nothing") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  const Scene scene = slow_scene(100.0);
  TissueWorker worker(scene);
  World shown(scene);
  TickLog log;
  ScriptedDevice hand = press_script(0.005, 0.5);
  HapticCommand command;
  const Calls before = count_calls_of_this_thread();
  for (int t = 0; t < kTicks; ++t) {
    const HapticSample sample = hand.read(1e-3 * t);
    worker.tick({&sample, 1}, shown, {&command, 1}, &log);
  }
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("a loop with a slow tissue says how often it was told, and shows it") {
  const Scene scene = slow_scene(50.0);
  Puppet puppet = make_puppet(0.006, 0.5);
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.3}, &log);

  run(loop);

  const LoopReport report = loop.report();
  const Taken taken(log);
  CHECK(report.exchanges >= 5);
  CHECK(taken.count(EventKind::tissue_exchanged) == report.exchanges);
  CHECK(report.exchange_cost.median > 0.0);
  CHECK(report.peak_force > 0.05);
  CHECK(report.touch_ticks > 0);
  REQUIRE(loop.take_snapshot());
  const Snapshot& seen = loop.snapshot();
  CHECK(seen.bodies[0].substeps >= 1);
  double moved = 0.0;
  for (std::size_t v = 0; v < seen.bodies[0].position.size(); ++v) {
    moved = std::max(moved,
                     (seen.bodies[0].position[v] - scene.bodies[0].tissue.rest_position[v]).norm());
  }
  CHECK(moved > 1e-3);
}

TEST_CASE(
    "an exchange rate that the ticks cannot keep is refused, with the nearest that they can") {
  const auto refusal = [](double rate) { return find_refusal([&] { slow_scene(rate); }); };

  CHECK(refusal(300.0) ==
        "scene: exchange_rate [Hz]: got 300, expected one that goes into the rate of 1000 Hz a "
        "whole number of times, as 250 or 333.333");
  CHECK(refusal(5.0) ==
        "scene: exchange_rate [Hz]: got 5, expected 0 for none, or 10 to the rate of 1000 Hz");
  CHECK(refusal(-1.0).find("expected 0 for none") != std::string::npos);
  CHECK(refusal(1000.0 / 3.0).empty());
  CHECK(refusal(0.0).empty());
}

TEST_CASE("a hold is told to readers and records of a slow tissue too") {
  const Scene scene = slow_scene(50.0);
  Puppet puppet(press_script(0.005, 0.6, true));
  TickLog log;
  // a busy machine tells of a release late
  Loop loop(scene, puppet, {.duration = 1.6}, &log);

  run(loop);

  const Taken taken(log);
  CHECK(taken.count(EventKind::attached) == 1);
  CHECK(taken.count(EventKind::released) == 1);
  CHECK(std::ranges::any_of(taken.ticks,
                            [](const auto& row) { return (row.felt.touched & kAttached) != 0; }));
}
