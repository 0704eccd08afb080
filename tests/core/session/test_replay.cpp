// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/loop/collapse_scene.h"
#include "core/loop/pair_scene.h"
#include "core/session/some_record.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/session/record.h"

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

/// The tree exchanges of a record.
std::vector<Event> list_exchanges(const Record& record) {
  std::vector<Event> exchanges;
  for (const Event& event : record.events) {
    if (event.kind == EventKind::tree_exchanged) exchanges.push_back(event);
  }
  return exchanges;
}

std::string refusal_of(const Scene& scene, const Record& record) {
  try {
    replay(scene, record);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a replay that is stopped has run the ticks until then, and is not equal") {
  const Scene scene = press_scene();
  const Record record = press_record(scene);
  int asked = 0;

  const ReplayReport some = replay(scene, record, nullptr, [&] { return ++asked > 100; });
  const ReplayReport whole = replay(scene, record, nullptr, [] { return false; });

  CHECK(some.ticks == 100);
  CHECK(some.felt.size() == 100);
  CHECK(!some.equal);
  CHECK(some.first_difference == 100);
  CHECK(whole.equal);
  CHECK(whole.ticks == 500);
}

TEST_CASE("a record with an alarm replays, also one made before forces faded after it") {
  const Scene scene = press_scene();
  Record record = press_record(scene);
  record.hashes.clear();
  World world(scene);
  for (std::size_t i = 0; i < record.hand.size(); ++i) {
    if (i == 200) record.hand[i].position.x() = 2e3;  // farther than any hand is
    record.felt[i] = compute_felt(tick(scene, record.hand[i], 1e-3, world), world);
  }
  REQUIRE(world.alarm);
  REQUIRE(record.felt[205].force.norm() > 0.01f);
  CHECK(replay(scene, record).equal);

  Record older = record;
  for (std::size_t i = 200; i < older.felt.size(); ++i) older.felt[i].force.setZero();
  CHECK(replay(scene, older).equal);

  older.felt[190].force.setZero();
  CHECK(replay(scene, older).first_difference == 190);
}

TEST_CASE("ticks that the motors did not give are kept in a record, and it replays to the bit") {
  const Scene scene = press_scene();
  Record record = press_record(scene);
  for (std::size_t i = 200; i < 300; ++i) record.felt[i].touched |= kNotRendered;
  record.events = {{200, EventKind::motors_off, int(MotorState::cut), 0.0},
                   {200, EventKind::fault, int(DeviceFault::motors_cut), 0.0},
                   {300, EventKind::motors_on, 0, 0.0}};
  const Folder folder;
  const std::string path = folder.file("cut.prec");
  write_record(path, record);

  const Record read = read_record(path);

  const ReplayReport report = replay(scene, read);
  CHECK(report.equal);
  REQUIRE(read.events.size() == 3);
  CHECK(read.events[0].kind == EventKind::motors_off);
  CHECK(read.events[2].kind == EventKind::motors_on);
  for (std::size_t i : {199u, 200u, 299u, 300u}) {
    CHECK((read.felt[i].touched & kNotRendered) == (i >= 200 && i < 300 ? kNotRendered : 0));
    CHECK(report.felt[i].touched == read.felt[i].touched);
  }
}

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

TEST_CASE("a loop with a recorder, a reader and a tree built meanwhile replays to the same bits") {
  const Folder folder;
  const Scene scene = collapse_scene();
  ScriptedDevice hand = sweep_script(1.2);
  Recorder recorder(folder.file("run.prec"), "{}");
  Loop loop(scene, hand, {.duration = 1.2}, &recorder.log());

  loop.start();
  long seen = 0;
  std::thread reader([&] {
    while (loop.running()) {
      seen += loop.take_snapshot() && loop.snapshot().bodies[0].position.size() == 162;
      seen += loop.report().ticks < 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  while (!loop.wait(10.0)) {
  }
  reader.join();
  loop.stop();
  recorder.finish();

  const Record record = read_record(folder.file("run.prec"));
  const ReplayReport report = replay(scene, record);
  CHECK(seen > 0);
  CHECK_FALSE(loop.report().alarm);
  CHECK_FALSE(list_exchanges(record).empty());
  CHECK(report.ticks == loop.report().ticks);
  CHECK(report.equal);
}

TEST_CASE("two bodies under two devices replay to the same bits, each with its own trees") {
  const Folder folder;
  const Scene scene = pair_of(collapse_scene());
  Puppet first(sweep_script(1.2)), second(sweep_script(0.9));
  for (Puppet* puppet : {&first, &second}) {
    puppet->times.reserve(2000);
    puppet->forces.reserve(2000);
  }
  second.on_read = [](int, HapticSample& sample) { sample.position += kAside; };
  Recorder recorder(folder.file("run.prec"), "{}", RecordCodec::deflate, 2, 2);
  Loop loop(scene, std::array<HapticDevice*, 2>{&first, &second}, {.duration = 1.2},
            &recorder.log());
  run(loop);
  recorder.finish();

  const Record record = read_record(folder.file("run.prec"));
  const ReplayReport report = replay(scene, record);

  CHECK_FALSE(loop.report().alarm);
  CHECK(record.complete);
  CHECK(record.instruments == 2);
  CHECK_FALSE(record.hashes.empty());
  const std::vector<Event> exchanges = list_exchanges(record);
  for (const int body : {0, 1}) {
    CHECK(std::ranges::any_of(exchanges, [&](const Event& e) { return e.source == body; }));
  }
  for (const DeviceReport& device : loop.report().devices) CHECK(device.touch_ticks > 0);
  CHECK(report.ticks == loop.report().ticks);
  CHECK(report.equal);

  Record changed = record;
  Felt& felt = changed.felt[2 * 700 + 1];  // of the second instrument
  felt.force.x() = std::nextafter(felt.force.x(), 1.0f);
  CHECK(replay(scene, changed).first_difference == 700);
}

TEST_CASE("a record of two bodies made while exchanges were told of one only still replays") {
  const Scene one = collapse_scene();
  Scene two = pair_of(one);
  two.instruments.resize(1);
  two = build_scene(two);
  const Record record = press_record(two);  // has no exchanges, and one hand

  CHECK(replay(two, record).equal);
}

TEST_CASE("a tree of a body that the scene has not, or another number of hands, is refused") {
  const Scene scene = press_scene();
  Record other = press_record(scene), pair = other;
  other.events = {{5, EventKind::tree_exchanged, 1, 2.0, 1}};
  pair.instruments = 2;

  CHECK(refusal_of(scene, other) == "replay: got at tick 5 a tree of body 1, expected 0 to 0");
  CHECK(refusal_of(scene, pair) ==
        "replay: got a scene of 1 instruments, expected 2, as many as the record has hands");
}

TEST_CASE("trees are exchanged in a replay where the record says, even in its last ticks") {
  const Scene scene = press_scene();
  Record record = press_record(scene);
  for (const auto& [tick, age] : {std::pair{0, 0}, {17, 3}, {200, 100}, {200, 0}, {499, 1}}) {
    record.events.push_back({tick, EventKind::tree_exchanged, age, 2.0});
  }
  record.events.push_back({500, EventKind::tree_exchanged, 1, 2.0});  // never taken up

  CHECK(replay(scene, record).equal);
}

TEST_CASE("a record whose trees no run could have built is refused with where and why") {
  const Scene scene = press_scene();
  Record early = press_record(scene), negative = early, crossed = early;
  early.events = {{5, EventKind::tree_exchanged, 6, 2.0}};
  negative.events = {{5, EventKind::tree_exchanged, -1, 2.0}};
  crossed.events = {{50, EventKind::tree_exchanged, 10, 2.0},
                    {60, EventKind::tree_exchanged, 15, 2.0}};

  CHECK(refusal_of(scene, early) ==
        "replay: got at tick 5 a tree built 6 ticks before, expected 0 to 5, after the exchange "
        "before it");
  CHECK(refusal_of(scene, negative).starts_with("replay: got at tick 5 a tree built -1"));
  CHECK(refusal_of(scene, crossed).starts_with("replay: got at tick 60 a tree built 15"));
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
  scene.instruments[0].coupling.stiffness *= 1.01;

  CHECK_FALSE(replay(scene, record).equal);
}

TEST_CASE(
    "each kernel and vector target replays its own record to the bit, and the others' nearly") {
  std::vector<Scene> scenes(1, press_scene());
  scenes[0].bodies[0].kernel = Kernel::reference;
  for (const std::string& target : simd_targets()) {
    scenes.push_back(scenes[0]);
    scenes.back().bodies[0].kernel = Kernel::packed;
    scenes.back().bodies[0].simd_target = target;
  }
  for (const Scene& made_with : scenes) {
    CAPTURE(made_with.bodies[0].simd_target);
    const Record record = press_record(made_with);
    for (const Scene& run_with : scenes) {
      CAPTURE(run_with.bodies[0].simd_target);
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
  gap.events.push_back({100, EventKind::record_gap, 5, 0.0});
  uneven.felt.pop_back();
  poisoned.hand[7].position.x() = std::numeric_limits<double>::quiet_NaN();

  CHECK_THROWS_AS(replay(scene, gap), std::invalid_argument);
  CHECK_THROWS_AS(replay(scene, uneven), std::invalid_argument);
  CHECK_THROWS_AS(replay(scene, poisoned), std::invalid_argument);
}
