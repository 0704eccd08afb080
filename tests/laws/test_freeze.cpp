// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "core/session/some_record.h"
#include "core/tick/safeguard_scenes.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/session/record.h"
#include "scenes/tissues.h"

// What follows an alarm [motion: alarm]: from one tick to the next the tissue stands as it last was
// sound, and the force falls to zero in 20 ms.

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kTick = 1e-3;
constexpr int kFade = 20;  // [ticks]

/// A tool so hard that a light touch gives the tissue energy, whose memory keeps it from being
/// stepped implicitly.
Scene hard_scene() {
  Scene scene = press_scene();
  scene.bodies[0].tissue.maxwell = {.ratio = 0.5, .time = 0.4};
  scene.instruments[0].tool.stiffness = 3e11;
  return build_scene(std::move(scene));
}

}  // namespace

TEST_CASE("a tissue that blows up is put back to where the last sound tick left it") {
  const Scene scene = hard_scene();
  ScriptedDevice hand = press_script(0.004, 0.5);
  World world(scene);
  Vec3Array sound;
  Vec3 felt = Vec3::Zero(), before = Vec3::Zero();
  int i = 0;
  for (; i < 500 && !world.alarm; ++i) {
    sound = world.bodies[0].tissue.position;
    before = felt;
    felt = tick(scene, hand.read(kTick * i), kTick, world).force;
  }
  REQUIRE(world.alarm);
  REQUIRE(before.norm() > 1e-3);

  // a tick is whole or not at all: not one of its substeps is left
  CHECK(scenes::max_difference(world.bodies[0].tissue.position, sound) < 1e-9);
  for (const Vec3& v : world.bodies[0].tissue.velocity) CHECK(v == Vec3::Zero());
  for (int n = 1; n <= 2 * kFade; ++n) {
    const Vec3 expected = before * std::max(0.0, 1.0 - double(n) / kFade);
    CHECK((felt - expected).norm() <= 1e-12 * before.norm());
    felt = tick(scene, hand.read(kTick * (i + n)), kTick, world).force;
  }
  CHECK(felt == Vec3::Zero());
  CHECK(scenes::max_difference(world.bodies[0].tissue.position, sound) < 1e-9);
}

TEST_CASE("a freeze is told at its tick in the record, and a replay freezes in the same tick") {
  const Folder folder;
  const Scene scene = hard_scene();
  ScriptedDevice hand = press_script(0.004, 0.5);
  Recorder recorder(folder.file("frozen.prec"), "{}");
  Loop loop(scene, hand, {.duration = 0.5}, &recorder.log());
  loop.start();
  while (!loop.wait(10.0)) {
  }
  loop.stop();
  recorder.finish();
  REQUIRE(loop.report().alarm);

  const Record record = read_record(folder.file("frozen.prec"));
  const ReplayReport again = replay(scene, record);

  CHECK(again.equal);
  const auto told = std::find_if(record.events.begin(), record.events.end(),
                                 [](const Event& e) { return e.kind == EventKind::alarm; });
  REQUIRE(told != record.events.end());
  CHECK(told->index == static_cast<int>(loop.report().alarm.kind));
  CHECK(told->value == loop.report().alarm.value);
  // up to that tick a force that changes, from there on one that falls to zero and stays
  const auto row = static_cast<std::size_t>(told->tick);
  float last = record.felt[row - 1].force.norm();
  REQUIRE(last > 0.0f);
  for (std::size_t i = row; i < std::min(row + 60, record.felt.size()); ++i) {
    const float now = record.felt[i].force.norm();
    CHECK(now <= last);
    last = now;
  }
  CHECK(last == 0.0f);
}

TEST_CASE(
    "a run held together by safeguards is told in the record, and a replay climbs in the same "
    "ticks") {
  const Folder folder;
  Scene scene = press_scene();
  const double limit = stable_step(scene.bodies[0].tissue) / 0.9;
  scene.bodies[0].substeps = 1;
  scene.rate = 1.0 / (1.5 * limit);
  ScriptedDevice hand = press_script(0.002, 0.5);
  Recorder recorder(folder.file("held.prec"), "{}");
  Loop loop(scene, hand, {.duration = 1.0}, &recorder.log());
  loop.start();
  while (!loop.wait(10.0)) {
  }
  loop.stop();
  recorder.finish();
  const LoopReport report = loop.report();
  REQUIRE_FALSE(report.alarm);
  REQUIRE(report.safeguarded_ticks > 0);
  CHECK(report.averted);
  CHECK(report.averted_body == 0);

  const Record record = read_record(folder.file("held.prec"));
  CHECK(replay(scene, record).equal);
  const auto told = std::find_if(record.events.begin(), record.events.end(),
                                 [](const Event& e) { return e.kind == EventKind::safeguard; });
  REQUIRE(told != record.events.end());
  CHECK(told->index == static_cast<int>(Safeguard::half_steps));
  CHECK(static_cast<AlarmKind>(static_cast<int>(told->value)) == report.averted.kind);
  CHECK(told->source == 0);
  World world(scene);
  for (std::int64_t t = 0; t <= told->tick; ++t) {
    CHECK(world.bodies[0].safeguard == Safeguard::none);
    tick(scene, record.hand[static_cast<std::size_t>(t)], 1.0 / scene.rate, world);
  }
  CHECK(world.bodies[0].safeguard == Safeguard::half_steps);
}

TEST_CASE("a run that implicit Euler holds together is replayed to the bit") {
  const Folder folder;
  const Scene scene = make_stiff_link().scene;
  ScriptedDevice hand = press_script(0.002, 0.5);
  Recorder recorder(folder.file("solved.prec"), "{}");
  Loop loop(scene, hand, {.duration = 0.6}, &recorder.log());
  loop.start();
  while (!loop.wait(10.0)) {
  }
  loop.stop();
  recorder.finish();
  REQUIRE_FALSE(loop.report().alarm);

  const Record record = read_record(folder.file("solved.prec"));
  const auto index = static_cast<int>(Safeguard::implicit_euler);
  CHECK(std::ranges::any_of(record.events, [&](const Event& e) {
    return e.kind == EventKind::safeguard && e.index == index;
  }));
  CHECK(replay(scene, record).equal);
}
