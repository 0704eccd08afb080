// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "calls.h"
#include "core/task/staged_world.h"
#include "palpate/sim/device/simulated_devices.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// The sentence with which a change of a good task is refused.
std::string refusal(const std::function<void(Task&)>& change) {
  Task task = one_step({.verb = TaskVerb::hold, .force = {0.1, 0.4}, .duration = 1.0});
  task.limits = {{.bound = 1.0}};
  change(task);
  try {
    build_task(sheet_scene(), task);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "not refused";
}

}  // namespace

TEST_CASE("a task that cannot be judged is refused, with place, value and what was expected") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<std::function<void(Task&)>, const char*> refused[] = {
      {[](Task& t) { t.steps.clear(); }, "task: steps: got 0, expected 1 to 200"},
      {[](Task& t) { t.steps.resize(1000000, t.steps[0]); }, "task: steps: got 1000000"},
      {[](Task& t) { t.limits.resize(101, t.limits[0]); }, "task: limits: got 101"},
      {[](Task& t) { t.places.resize(101, t.places[0]); }, "task: places: got 101"},
      {[](Task& t) { t.time_limit = 0.0; }, "task: time_limit: got 0"},
      {[](Task& t) { t.time_limit = 1e308; }, "task: time_limit: got 1e+308"},
      {[&](Task& t) { t.time_limit = nan; }, "task: time_limit: got nan"},
      {[](Task& t) { t.errors_at_most = -2; }, "task: errors_at_most: got -2"},
      {[](Task& t) { t.steps[0].place = 1; }, "task: steps[0].place: got 1, expected 0 to 0"},
      {[](Task& t) { t.steps[0].place = -1; }, "task: steps[0].place: got -1"},
      {[](Task& t) { t.steps[0].instrument = 1; }, "task: steps[0].instrument: got 1"},
      {[](Task& t) {
         t.steps[0].force = {0.4, 0.1};
       },
       "task: steps[0].force: got 0.4 to 0.1"},
      {[&](Task& t) {
         t.steps[0].force = {nan, 0.1};
       },
       "task: steps[0].force: got nan to 0.1"},
      {[](Task& t) { t.steps[0].duration = -1.0; }, "task: steps[0].duration: got -1"},
      {[](Task& t) { t.steps[0].share = 0.0; }, "task: steps[0].share: got 0"},
      {[](Task& t) { t.steps[0].verb = TaskVerb::trace; }, "task: steps[0].place: got no path"},
      {[](Task& t) { t.steps[0].after = {3}; }, "task: steps[0].after: got 3"},
      {[](Task& t) { t.steps[0].after = {0}; }, "in a circle"},
      {[](Task& t) {
         t.steps.resize(3, t.steps[0]);
         t.steps[1].after = {2};
         t.steps[2].after = {1};
       },
       "task: steps[1].after: got steps that wait for each other in a circle"},
      {[](Task& t) { t.limits[0].during = {1}; }, "task: limits[0].during: got 1"},
      {[](Task& t) { t.limits[0].bound = -1.0; }, "task: limits[0].bound: got -1"},
      {[](Task& t) { t.limits[0].measure = TaskMeasure::contact; },
       "task: limits[0].place: got -1"},
      {[](Task& t) {
         t.limits[0].measure = TaskMeasure::speed;
         t.limits[0].place = 0;
       },
       "task: limits[0].place: got one, expected none"},
      {[](Task& t) {
         t.limits[0].measure = TaskMeasure::clearance;
         t.limits[0].place = 0;
       },
       "task: limits[0].place: got a region, expected a ball"},
      {[](Task& t) { t.limits[0].measure = TaskMeasure::pad_pressure; },
       "task: limits[0].instrument: got one without jaws"},
      {[](Task& t) { t.limits[0].measure = TaskMeasure::torn; },
       "task: limits[0].measure: got what has torn, expected another: no tissue"},
      {[](Task& t) { t.places[0].vertices = {25}; }, "task: places[0].vertices: got 25"},
      {[](Task& t) { t.places[0].vertices.clear(); }, "task: places[0].vertices: got none"},
      {[](Task& t) { t.places[0].body = 1; }, "task: places[0].body: got 1"},
      {[](Task& t) { t.places[0].kind = PlaceKind::ball; }, "task: places[0].points: got 0"},
      {[](Task& t) {
         t.places[0] = {.points = {{0, 0, 0}}};
       },
       "task: places[0].radius: got 0"},
      {[&](Task& t) {
         t.places[0] = {.points = {{nan, 0, 0}}, .radius = 0.01};
       },
       "task: places[0].points: got a number that is not finite"},
      {[](Task& t) {
         t.places[0] = {
             .kind = PlaceKind::path, .points = Vec3Array(3, Vec3::Zero()), .radius = 0.01};
       },
       "task: places[0].points: got twice the same, in row 1"},
  };
  for (const auto& [change, sentence] : refused) {
    CHECK_MESSAGE(refusal(change).find(sentence) != std::string::npos, refusal(change));
  }
  CHECK(refusal([](Task&) {}) == "not refused");
  CHECK_THROWS_AS(Progress{Task()}, std::invalid_argument);
}

TEST_CASE("judging ten thousand ticks of a press, a pull and its release allocates nothing") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  Task plan = one_step({.verb = TaskVerb::touch});
  plan.places.push_back(
      {.kind = PlaceKind::path, .points = {{0.01, 0.02, 0}, {0.03, 0.02, 0}}, .radius = 0.01});
  plan.steps.push_back({.verb = TaskVerb::pull, .place = 0, .force = {.least = 1e6}});
  plan.steps.push_back({.verb = TaskVerb::trace, .place = 1, .force = {.least = 1e6}});
  plan.limits = {{.bound = 0.05},
                 {.measure = TaskMeasure::off_path, .place = 1, .bound = 1e-3},
                 {.measure = TaskMeasure::contact, .place = 0},
                 {.measure = TaskMeasure::strain, .bound = 1e-3}};
  const Scene scene = sheet_scene();
  const Task task = build_task(scene, plan);
  World world(scene);
  Progress progress(task);
  const Vec3 above(0.02, 0.02, 0.01), below(0.02, 0.02, 0.001);
  ScriptedDevice hand({{0.0, above, 0},
                       {0.2, below, 0},
                       {0.25, below, kAttachButton},
                       {0.45, above, kAttachButton},
                       {0.5, above, 0}});
  long held = 0, opened = 0;

  for (int t = 0; t < 10000; ++t) {
    const HapticSample sample = hand.read(1e-3 * (t % 500));
    const HapticCommand command = tick(scene, sample, kTick, world);
    const Calls before = count_calls_of_this_thread();
    judge(task, world, {&sample, 1}, {&command, 1}, kTick, progress);
    const Calls after = count_calls_of_this_thread();
    REQUIRE(after.allocations == before.allocations);
    REQUIRE(after.locks == before.locks);
    held += world.instruments[0].tool.hold_count > 0;
    opened = progress.state.limits[0].count;
  }
  CHECK(progress.state.limits[3].count > 5);

  CHECK_FALSE(world.alarm);
  CHECK(held > 1000);
  CHECK(opened > 5);
  CHECK(progress.state.steps[0].status == StepStatus::done);
}
