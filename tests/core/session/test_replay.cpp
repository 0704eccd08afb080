// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/haptics/press_scene.h"
#include "core/session/some_record.h"
#include "palpate/sim/dynamics/simd_targets.h"
#include "palpate/sim/haptics/loop.h"
#include "palpate/sim/session/replay.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A press and a pull of half a second, recorded without a clock.
Record press_record(const Scene& scene) {
  Record record;
  record.header = "{}";
  World world(scene);
  ScriptedDevice hand = press_script(0.005, 0.5, true);
  for (int i = 0; i < 500; ++i) {
    record.hand.push_back(hand.read(1e-3 * i));
    record.felt.push_back(compute_felt(tick(scene, record.hand.back(), 1e-3, world), world));
    if (i % 100 == 99) record.hashes.push_back({i, compute_hash(world)});
  }
  return record;
}

}  // namespace

TEST_CASE("a record replays to the same bits in another world") {
  const Scene scene = press_scene();
  const Record record = press_record(scene);

  const ReplayReport report = replay(scene, record);

  CHECK(report.equal);
  CHECK(report.ticks == 500);
  CHECK(report.first_difference == -1);
  CHECK(report.largest_force_difference == 0.0);
  REQUIRE(report.felt.size() == 500);
  CHECK(report.felt[250].force.norm() > 0.0f);
}

TEST_CASE("a run of the live loop replays to the same bits from its file") {
  const Folder folder;
  const Scene scene = press_scene();
  ScriptedDevice hand = press_script(0.004, 0.8, true);
  Recorder recorder(folder.file("run.prec"), R"({"device":"script"})");
  Loop loop(scene, hand, {.duration = 0.8}, &recorder.log());
  loop.start();
  while (!loop.wait(10.0)) {
  }
  loop.stop();
  recorder.finish();

  const Record record = read_record(folder.file("run.prec"));
  const ReplayReport report = replay(scene, record);

  CHECK(record.complete);
  CHECK(report.ticks == loop.report().ticks);
  CHECK(report.equal);
  CHECK_FALSE(record.hashes.empty());
}

TEST_CASE("one changed sample makes the comparison fail, at its tick and in newtons") {
  const Scene scene = press_scene();
  Record record = press_record(scene);
  record.hand[210].position.z() -= 1e-4;

  const ReplayReport report = replay(scene, record);

  CHECK_FALSE(report.equal);
  CHECK(report.first_difference == 210);
  CHECK(report.largest_force_difference > 1e-4);
  CHECK(report.largest_position_difference > 1e-6);
}

TEST_CASE("a force, a tool or a hash that differs by one bit is a difference") {
  const Scene scene = press_scene();
  const Record record = press_record(scene);
  Record force = record, tool = record, hash = record, touched = record;
  force.felt[220].force.x() = std::nextafter(force.felt[220].force.x(), 1.0f);
  tool.felt[230].position.y() = std::nextafter(tool.felt[230].position.y(), 1.0f);
  hash.hashes[2].hash[1] ^= 1;
  touched.felt[240].touched ^= 1;

  CHECK(replay(scene, force).first_difference == 220);
  CHECK(replay(scene, tool).first_difference == 230);
  CHECK(replay(scene, hash).first_difference == 299);
  CHECK(replay(scene, touched).first_difference == 240);
}

TEST_CASE("another scene is another run") {
  Scene scene = press_scene();
  const Record record = press_record(scene);
  scene.coupling.stiffness *= 1.01;

  CHECK_FALSE(replay(scene, record).equal);
}

TEST_CASE(
    "each kernel and vector target replays its own record to the bit, and the others' nearly") {
  std::vector<Scene> scenes(1, press_scene());
  scenes[0].kernel = Kernel::reference;
  for (const std::string& target : simd_targets()) {
    scenes.push_back(scenes[0]);
    scenes.back().kernel = Kernel::packed;
    scenes.back().simd_target = target;
  }
  for (const Scene& made_with : scenes) {
    CAPTURE(made_with.simd_target);
    const Record record = press_record(made_with);
    for (const Scene& run_with : scenes) {
      CAPTURE(run_with.simd_target);
      const ReplayReport report = replay(run_with, record);

      CHECK(report.equal == (&made_with == &run_with));
      CHECK(report.largest_force_difference < 1e-4);     // [N] of a press of newtons
      CHECK(report.largest_position_difference < 1e-6);  // [m]
    }
  }
}

TEST_CASE("a record that cannot be run again is refused") {
  const Scene scene = press_scene();
  Record gap = press_record(scene), uneven = gap, poisoned = gap;
  gap.happenings.push_back({100, HappeningKind::record_gap, 5, 0.0});
  uneven.felt.pop_back();
  poisoned.hand[7].position.x() = std::numeric_limits<double>::quiet_NaN();

  CHECK_THROWS_AS(replay(scene, gap), std::invalid_argument);
  CHECK_THROWS_AS(replay(scene, uneven), std::invalid_argument);
  CHECK_THROWS_AS(replay(scene, poisoned), std::invalid_argument);
}
