// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <thread>
#include <utility>

#include "core/session/some_record.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/session/record.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// Press where the script does, pull, let go; a limit of force that the press opens.
Task press_task(const Scene& scene, double time_limit = 60.0) {
  Task task;
  task.places = {{.points = {{0.001, 0.002, 0.020}}, .radius = 0.01}};
  task.steps = {{.verb = TaskVerb::push, .place = 0, .depth = {.least = 0.001}, .duration = 0.02},
                {.verb = TaskVerb::pull, .place = 0, .distance = {.least = 0.001}, .after = {0}},
                {.verb = TaskVerb::release, .after = {1}}};
  task.limits = {{.bound = 0.05, .duration = 0.01}};
  task.time_limit = time_limit;
  return build_task(scene, task);
}

struct Live {
  Record record;
  LoopReport report;
  TaskState seen;  // of the last snapshot
};

/// A script through the live loop and its log, paused for a while if asked.
Live run_live(const Scene& scene, HapticDevice& device, const Task& task, double duration,
              bool pauses = false) {
  TickLog log(60000);
  Loop loop(scene, device,
            {.duration = duration, .realtime = false, .on_fault = FaultResponse::end}, &log, &task);
  loop.start();
  if (pauses) {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    loop.pause();
    while (!loop.paused()) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    loop.resume();
  }
  loop.wait(60.0);
  loop.stop();
  Live live{.record = Record(), .report = loop.report(), .seen = {}};
  live.record.header = "{}";
  loop.take_snapshot();
  live.seen = loop.snapshot().task;
  std::vector<TickLog::Tick> ticks;
  log.take(ticks, live.record.events, live.record.hashes);
  for (const TickLog::Tick& tick : ticks) {
    live.record.hand.push_back(tick.sample);
    live.record.felt.push_back(tick.felt);
  }
  return live;
}

std::vector<Event> list_judged(const Record& record) {
  std::vector<Event> judged;
  for (const Event& event : record.events) {
    if (is_of_task(event)) judged.push_back(event);
  }
  return judged;
}

}  // namespace

TEST_CASE("a run, its replay and the same hands without a clock come to the same verdict") {
  for (const bool pauses : {false, true}) {
    const Scene scene = press_scene();
    const Task task = press_task(scene);
    ScriptedDevice hand = press_script(0.006, 1.0, true);

    const Live live = run_live(scene, hand, task, 2.0, pauses);

    CHECK(live.report.outcome == Outcome::done);
    CHECK(live.report.ticks < 1500);  // it ended when the task was decided
    CHECK(live.seen.outcome == Outcome::done);
    CHECK(live.seen.errors == 1);
    CHECK(find_outcome(live.record) == Outcome::done);
    const std::vector<Event> judged = list_judged(live.record);
    REQUIRE(judged.size() == 9);  // three steps begun and done, a limit, the end

    const ReplayReport again = replay(scene, live.record, &task);
    CHECK(again.equal);
    CHECK(again.events_equal);
    CHECK(again.first_event_difference == -1);
    CHECK(again.task.outcome == Outcome::done);
    CHECK(again.task.time == live.seen.time);

    World world(scene);
    Progress progress(task);
    std::size_t next = 0;
    for (const HapticSample& sample : live.record.hand) {
      const HapticCommand command = tick(scene, sample, 1e-3, world);
      judge(task, world, {&sample, 1}, {&command, 1}, 1e-3, progress);
      for (int e = 0; e < progress.event_count; ++e, ++next) {
        const Event& event = progress.events[static_cast<std::size_t>(e)];
        CHECK(event.tick == judged[next].tick);
        CHECK(event.kind == judged[next].kind);
        CHECK(event.index == judged[next].index);
        CHECK(event.value == judged[next].value);
      }
    }
    CHECK(next == judged.size());
  }
}

TEST_CASE("a verdict that was changed in a record is found, with its tick") {
  const Scene scene = press_scene();
  const Task task = press_task(scene);
  ScriptedDevice hand = press_script(0.006, 0.5, true);
  Live live = run_live(scene, hand, task, 1.0);
  Event* opened = nullptr;
  for (Event& event : live.record.events) {
    if (is_kind(event, TaskEvent::limit_opened)) opened = &event;
  }
  REQUIRE(opened);

  opened->value -= 1e-3;
  const ReplayReport changed = replay(scene, live.record, &task);
  CHECK(changed.equal);
  CHECK_FALSE(changed.events_equal);
  CHECK(changed.first_event_difference == opened->tick);

  std::erase_if(live.record.events, is_of_task);
  CHECK_FALSE(replay(scene, live.record, &task).events_equal);
  CHECK(find_outcome(live.record) == Outcome::interrupted);
}

TEST_CASE("a run that ends before its task is left, and one without an end was interrupted") {
  const Scene scene = press_scene();
  const Task task = press_task(scene);
  ScriptedDevice hand = press_script(-0.005, 1.0);  // touches nothing

  Live live = run_live(scene, hand, task, 0.2);

  CHECK(live.report.outcome == Outcome::left);
  CHECK(find_outcome(live.record) == Outcome::left);
  const ReplayReport again = replay(scene, live.record, &task);
  CHECK(again.events_equal);
  CHECK(again.task.outcome == Outcome::left);
  // a late tick may have been noted after the verdict
  const auto is_end = [](const Event& event) { return is_kind(event, TaskEvent::task_ended); };
  REQUIRE(std::erase_if(live.record.events, is_end) == 1);
  CHECK(replay(scene, live.record, &task).task.outcome == Outcome::interrupted);
}

TEST_CASE("time runs out in ticks, a pause takes none of it") {
  const Scene scene = press_scene();
  const Task task = press_task(scene, 0.4);
  ScriptedDevice hand = press_script(-0.005, 1.0);

  const Live live = run_live(scene, hand, task, 5.0, true);

  CHECK(live.report.outcome == Outcome::timed_out);
  CHECK(live.report.ticks == 400);
  CHECK(list_judged(live.record).back().value == doctest::Approx(0.4));
  CHECK(replay(scene, live.record, &task).events_equal);
}

TEST_CASE("a task of another scene is refused by loop and replay") {
  const Scene scene = press_scene();
  Scene two = scene;
  two.instruments.resize(2);
  two = build_scene(two);
  const Task task = press_task(two);
  ScriptedDevice hand = press_script(0.005, 0.5);

  CHECK_THROWS_WITH_AS(Loop(scene, hand, {}, nullptr, &task),
                       "loop: task: got one for 2 instruments, expected one that build_task made "
                       "for the scene, which has 1",
                       std::invalid_argument);
  CHECK_THROWS_AS(replay(scene, Record(), &task), std::invalid_argument);
}

TEST_CASE("a written record keeps the events of a task") {
  const Scene scene = press_scene();
  const Task task = press_task(scene);
  ScriptedDevice hand = press_script(0.006, 0.5, true);
  const Live live = run_live(scene, hand, task, 1.0);
  const Folder folder;

  write_record(folder.file("run.prec"), live.record);
  const Record read = read_record(folder.file("run.prec"));

  CHECK(list_judged(read).size() == list_judged(live.record).size());
  CHECK(replay(scene, read, &task).events_equal);
  CHECK(find_outcome(read) == Outcome::done);
}
