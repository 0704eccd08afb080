// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <filesystem>

#include "core/loop/puppet.h"
#include "core/model/refusal.h"
#include "core/session/some_record.h"
#include "palpate/sim/loop/private/tissue_worker.h"
#include "palpate/sim/session/record.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

Scene slow_scene(double exchange_rate) {
  Scene scene = press_scene();
  scene.exchange_rate = exchange_rate;
  return build_scene(std::move(scene));
}

Record to_record(TickLog& log) {
  const Taken taken(log);
  Record record;
  record.header = "{}";
  for (const TickLog::Tick& row : taken.ticks) {
    record.hand.push_back(row.sample);
    record.felt.push_back(row.felt);
  }
  record.events = taken.events;
  record.hashes = taken.hashes;
  return record;
}

/// A press through a worker that now and then gets no time at all, so that it is late.
Record record_late(const Scene& scene) {
  TissueWorker worker(scene);
  World shown(scene);
  TickLog log;
  ScriptedDevice hand = press_script(0.005, 0.5);
  HapticCommand command;
  for (int t = 0; t < 500; ++t) {
    const HapticSample sample = hand.read(1e-3 * t);
    if (t == 200) worker.ask_for_hash();
    worker.tick({&sample, 1}, shown, {&command, 1}, &log);
    log.push(TickLog::Tick{t, sample, compute_felt(command, shown)});
    if (t % 40 >= 12) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  REQUIRE(worker.late_exchanges() > 0);
  return to_record(log);
}

}  // namespace

TEST_CASE("what a tissue in a thread of its own gave is replayed to the bit, however late it was") {
  const Scene scene = slow_scene(250.0);
  const Record record = record_late(scene);
  REQUIRE(record.hashes.size() == 1);

  const ReplayReport report = replay(scene, record);

  CHECK(report.equal);
  CHECK(report.ticks == 500);
  float most = 0.0f;
  for (const Felt& felt : report.felt) most = std::max(most, felt.force.norm());
  CHECK(most > 0.05f);
}

TEST_CASE("a live run with a slow tissue is replayed to the bit, hashes included") {
  const Scene scene = slow_scene(100.0);
  Puppet puppet(press_script(0.005, 1.1, true));
  TickLog log;
  Loop loop(scene, puppet, {.duration = 1.2}, &log);
  run(loop);
  Record record = to_record(log);
  REQUIRE(loop.report().exchanges > 20);
  CHECK(record.hashes.size() == 1);

  CHECK(replay(scene, record).equal);

  record.hashes[0].hash[0] ^= 1;
  CHECK_FALSE(replay(scene, record).equal);
}

TEST_CASE("exchanges that no run has are refused, and others are felt otherwise") {
  const Scene scene = slow_scene(100.0);
  Puppet puppet = make_puppet(0.005, 0.4);
  TickLog log;
  Loop loop(scene, puppet, {.duration = 0.4}, &log);
  run(loop);
  const Record record = to_record(log);
  Record gap = record, early = record, later = record;
  std::erase_if(gap.events, [](const Event& e) { return e.tick < 50; });
  early.events = {{5, EventKind::tissue_exchanged, 5, 0.0, 0}};
  const auto first = record.events.front().tick;  // how many follow is the machine's
  std::erase_if(later.events, [&](const Event& e) { return e.tick > first; });

  CHECK(find_refusal([&] { replay(scene, gap); }).find("replay: tissue exchanged at tick ") == 0);
  CHECK(find_refusal([&] { replay(scene, early); }) ==
        "replay: tissue exchanged at tick 5: got 5 ticks after its hands were told, expected 5, "
        "since the exchange before it, and no fewer than 10");
  CHECK_FALSE(replay(scene, later).equal);
}
