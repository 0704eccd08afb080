// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "core/loop/puppet.h"
#include "palpate/sim/session/record.h"

// A device that bears less than the instrument's coupling, live and replayed [stability: weak
// coupling].

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A hand that follows a script through a device that declares this.
struct Damped : Puppet {
  Damped(const DeviceDynamics& declared_in, double depth, double duration)
      : Puppet(make_puppet(depth, duration)), declared(declared_in) {}
  DeviceDynamics dynamics() const noexcept override { return declared; }

  DeviceDynamics declared;
};

constexpr DeviceDynamics kWeak = {.damping = 0.1, .delay = 1.5e-3};  // keeps 50 N/m passive

struct Run {
  LoopReport report;
  Record record;
  double shown = 0.0;  ///< [-] the largest error that a reader saw
};

Run run_press(const Scene& scene, const DeviceDynamics& declared) {
  Damped device(declared, 0.006, 0.8);
  TickLog log;
  Loop loop(scene, device, {.duration = 0.8}, &log);
  Run run;
  loop.start();
  while (!loop.wait(0.01)) {
    if (loop.take_snapshot()) {
      run.shown = std::max(run.shown, loop.snapshot().instruments[0].stiffness_error);
    }
  }
  loop.stop();
  run.report = loop.report();
  const Taken taken(log);
  run.record.header = "{}";
  for (const TickLog::Tick& row : taken.ticks) {
    run.record.hand.push_back(row.sample);
    run.record.felt.push_back(row.felt);
  }
  run.record.events = taken.events;
  run.record.hashes = taken.hashes;
  return run;
}

long count(const Record& record, EventKind kind) {
  return std::ranges::count_if(record.events, [&](const Event& e) { return e.kind == kind; });
}

}  // namespace

TEST_CASE("what a weak device bears is recorded, shown and replayed to the bit") {
  for (const double exchange_rate : {0.0, 100.0}) {
    CAPTURE(exchange_rate);
    Scene scene = press_scene();
    scene.exchange_rate = exchange_rate;
    scene = build_scene(std::move(scene));

    Run run = run_press(scene, kWeak);

    const DeviceReport& device = run.report.devices[0];
    CHECK(device.passive_stiffness == doctest::Approx(50.0));
    CHECK(device.follows_tissue_ticks > 50);
    CHECK(device.tissue_stiffness > 10.0);
    CHECK(device.stiffness_error > 0.05);
    CHECK(run.shown > 0.0);
    CHECK(run.shown <= device.stiffness_error);
    CHECK(count(run.record, EventKind::coupling_limited) == 1);
    CHECK(count(run.record, EventKind::coupling_follows) >= 2);
    CHECK(replay(scene, run.record).equal);

    // without what was recorded of the device it is another run
    std::erase_if(run.record.events,
                  [](const Event& e) { return e.kind == EventKind::coupling_limited; });
    CHECK_FALSE(replay(scene, run.record).equal);
  }
}

TEST_CASE("a device that bears the instrument's coupling, or declares nothing, is told nothing") {
  const Scene scene = press_scene();
  for (const DeviceDynamics& declared : {DeviceDynamics{}, DeviceDynamics{.damping = 10.0}}) {
    const Run run = run_press(scene, declared);

    CHECK(run.report.devices[0].follows_tissue_ticks == 0);
    CHECK(run.report.devices[0].stiffness_error == 0.0);
    CHECK(run.shown == 0.0);
    CHECK(count(run.record, EventKind::coupling_limited) == 0);
    CHECK(count(run.record, EventKind::coupling_follows) == 0);
  }
}

TEST_CASE("a record that bounds the coupling where no run does is refused") {
  const Scene scene = press_scene();
  const Run run = run_press(scene, kWeak);
  const auto refuses = [&](void (*change)(Event&)) {
    Record record = run.record;
    for (Event& event : record.events) {
      if (event.kind == EventKind::coupling_limited) change(event);
    }
    CHECK_THROWS_AS(replay(scene, record), std::invalid_argument);
  };

  refuses([](Event& event) { event.tick = 3; });
  refuses([](Event& event) { event.source = 1; });
  refuses([](Event& event) { event.source = -1; });
  refuses([](Event& event) { event.value = -50.0; });
  refuses([](Event& event) { event.value = NAN; });
}
