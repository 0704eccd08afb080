// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/task/staged_world.h"
#include "palpate/sim/task/private/measure.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A path over the middle row of the sheet's vertices at rest, 10 to 14, 3 mm to both sides.
Task trace_task(const TaskStep& step) {
  Task task = one_step(step);
  const TaskSurface surface = StagedWorld(one_step({})).task.surfaces[0];
  Vec3Array points(surface.vertices.begin() + 10, surface.vertices.begin() + 15);
  task.places[0] = {.kind = PlaceKind::path, .points = std::move(points), .radius = 0.006};
  return task;
}

}  // namespace

TEST_CASE("a touch is done in the tick in which half of the force is at its place") {
  StagedWorld staged(one_step({.verb = TaskVerb::touch}));
  staged.judge(10);
  CHECK_FALSE(staged.is_done(0));

  staged.press(12, 0.49);
  staged.press(3, 0.51, 0.001, true);
  staged.judge(10);
  CHECK_FALSE(staged.is_done(0));

  staged.press(12, 0.5);
  staged.press(3, 0.5, 0.001, true);
  staged.judge();
  CHECK(staged.is_done(0));
  CHECK(staged.step(0).until_tick == 20);
  CHECK(staged.progress.state.outcome == Outcome::done);
  CHECK(staged.last(TaskEvent::step_done).tick == 20);
  CHECK(staged.last(TaskEvent::step_done).value == doctest::Approx(0.021));
  CHECK(staged.last(TaskEvent::task_ended).index == static_cast<int>(Outcome::done));
}

TEST_CASE("a hold is done once the force has been in its band, ends included, for its time") {
  StagedWorld staged(one_step({.verb = TaskVerb::hold, .force = {0.1, 0.4}, .duration = 3.0}));
  staged.press(12, 0.1);
  staged.judge_for(1.5);
  staged.press(12, 0.4);
  staged.judge_for(1.499);
  CHECK_FALSE(staged.is_done(0));
  CHECK(staged.step(0).dwell == doctest::Approx(2.999));

  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("a dwell goes on after a gap of a tenth of a second, and begins again after more") {
  StagedWorld staged(one_step({.verb = TaskVerb::hold, .force = {0.1, 0.4}, .duration = 1.0}));
  staged.press(12, 0.2);
  staged.judge_for(0.5);
  staged.press(12, 0.5);
  staged.judge_for(0.1);
  staged.press(12, 0.2);
  staged.judge();
  CHECK(staged.step(0).dwell == doctest::Approx(0.501));

  staged.leave();
  staged.judge_for(0.101);
  CHECK(staged.step(0).dwell == 0.0);
  staged.press(12, 0.2);
  staged.judge_for(0.999);
  CHECK_FALSE(staged.is_done(0));
  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("a push counts the depth of the tip below the surface at rest") {
  StagedWorld staged(one_step({.verb = TaskVerb::push, .depth = {0.006, 0.010}}));
  staged.press(12, 0.3, 0.0059);
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.press(12, 0.3, 0.0101);
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.press(12, 0.3, 0.0061);
  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("a push with a least force is not done with less") {
  StagedWorld staged(one_step({.verb = TaskVerb::push, .force = {.least = 0.6}}));
  staged.press(12, 0.59);
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.press(12, 0.61);
  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("a pull counts how far what is held has been moved outwards, whatever the hand does") {
  StagedWorld staged(one_step({.verb = TaskVerb::pull, .distance = {0.012, 0.020}}));
  staged.hold(12, {0, 0, 0.0119}, 2.0);
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.hold(12, {0, 0, -0.015}, 2.0);  // inwards
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.hold(3, {0, 0, 0.015}, 2.0);  // elsewhere
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.press(12, 2.0);  // not held
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.hold(12, {0, 0, 0.0121}, 2.0);
  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("a pull with a band of force is of the force on the hand") {
  StagedWorld staged(one_step({.verb = TaskVerb::pull, .force = {0.4, 0.9}}));
  staged.hold(12, {0, 0, 0.005}, 0.39);
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.hold(12, {0, 0, 0.005}, 0.5);
  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("a grasp is done while its place is held, a release once it is not") {
  Task task = one_step({.verb = TaskVerb::grasp});
  task.steps.push_back({.verb = TaskVerb::release, .after = {0}});
  StagedWorld staged(task);
  staged.press(12, 1.0);
  staged.judge();
  staged.hold(3, {0, 0, 0.001}, 0.1);
  staged.judge();
  CHECK_FALSE(staged.is_done(0));

  staged.hold(12, {0, 0, 0.001}, 0.1);
  staged.judge(5);
  CHECK(staged.is_done(0));
  CHECK_FALSE(staged.is_done(1));
  staged.leave();
  staged.judge();
  CHECK(staged.progress.state.outcome == Outcome::done);
}

TEST_CASE("a path is traced in order: who leaps ahead has to go back to where he left it") {
  StagedWorld staged(trace_task({.verb = TaskVerb::trace, .force = {0.1, 0.6}, .share = 0.9}));
  staged.press(10, 0.3);
  staged.judge();
  const double first = staged.step(0).progress;
  CHECK(first < 0.05);
  staged.press(13, 0.3);  // two vertices further than the next
  staged.judge();
  CHECK(staged.step(0).progress == first);

  for (const int vertex : {11, 12}) {
    staged.press(vertex, 0.3);
    staged.judge();
  }
  const double middle = staged.step(0).progress;
  CHECK(middle == doctest::Approx(0.5).epsilon(0.1));
  staged.press(11, 0.3);  // going back loses nothing
  staged.judge();
  staged.press(13, 0.7);  // too hard
  staged.judge();
  staged.press(18, 0.3);  // beside it
  staged.judge();
  CHECK(staged.step(0).progress == middle);
  for (const int vertex : {13, 14}) {
    staged.press(vertex, 0.3);
    staged.judge();
  }
  CHECK(staged.is_done(0));
  CHECK(staged.step(0).progress == doctest::Approx(1.0));
}

TEST_CASE("a click finds the place that is pressed, and is an error anywhere else") {
  Task task = one_step({.verb = TaskVerb::find});
  const Vec3 middle = StagedWorld(task).task.surfaces[0].vertices[12];
  task.places[0] = {.kind = PlaceKind::ball, .points = {middle}, .radius = 0.004};
  StagedWorld staged(task);
  staged.judge(3);

  staged.judge(1, kAttachButton);  // in the air
  CHECK(staged.progress.state.errors == 1);
  CHECK(staged.last(TaskEvent::click_missed).value == -1.0);
  staged.press(13, 0.2);
  staged.judge(5, kAttachButton);  // the button was down already
  CHECK(staged.progress.state.errors == 1);
  staged.judge(1, 0);
  staged.judge(5, kAttachButton);
  CHECK(staged.progress.state.errors == 2);
  const double away =
      (staged.task.surfaces[0].vertices[13] - middle).norm() - task.places[0].radius;
  CHECK(staged.last(TaskEvent::click_missed).value == doctest::Approx(away));
  CHECK_FALSE(staged.is_done(0));

  staged.press(12, 0.2);
  staged.judge(1, 0);
  staged.judge(1, kAttachButton);
  CHECK(staged.is_done(0));
  CHECK(staged.progress.state.errors == 2);
}

TEST_CASE("a step begins when those before it are done, and others beside it from the start") {
  Task task = one_step({.verb = TaskVerb::touch});
  task.places.push_back(region_of({3}));
  task.steps.push_back({.verb = TaskVerb::touch, .place = 1, .after = {0}});
  task.steps.push_back({.verb = TaskVerb::touch, .place = 1});
  StagedWorld staged(task);

  staged.press(3, 1.0);
  staged.judge(2);
  CHECK(staged.step(1).status == StepStatus::waiting);
  CHECK(staged.is_done(2));

  staged.press(12, 1.0);
  staged.judge();
  CHECK(staged.step(1).status == StepStatus::waiting);
  staged.press(3, 1.0);
  staged.judge();
  CHECK(staged.step(1).from_tick == 3);
  CHECK(staged.progress.state.outcome == Outcome::done);
  CHECK(staged.count(TaskEvent::step_begun) == 3);
  CHECK(staged.count(TaskEvent::step_done) == 3);
}

TEST_CASE("a step that takes longer than it may is one error, and can still be done") {
  StagedWorld staged(one_step({.verb = TaskVerb::touch, .time_limit = 0.5}));
  staged.judge_for(0.5);
  CHECK(staged.progress.state.errors == 0);
  staged.judge_for(0.5);
  CHECK(staged.progress.state.errors == 1);
  CHECK(staged.step(0).overdue);
  CHECK(staged.last(TaskEvent::step_overdue).tick == 500);
  staged.press(12, 1.0);
  staged.judge();
  CHECK(staged.progress.state.outcome == Outcome::done);
}

TEST_CASE("a place of a region counts its part of a triangle by the weights there") {
  StagedWorld staged(one_step({.verb = TaskVerb::touch}));
  const auto& triangles = staged.task.surfaces[0].triangles;
  const auto at = std::ranges::find_if(triangles, [](const Triangle& t) { return t[0] == 12; });
  REQUIRE(at != triangles.end());
  const int t = static_cast<int>(at - triangles.begin());
  staged.world.instruments[0].tool.touching = true;
  Load& load = staged.world.pair(0, 0).load;

  load.add({t, Vec3(0.49, 0.26, 0.25), Vec3(0, 0, -1)});
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  load.clear();
  load.add({t, Vec3(0.51, 0.24, 0.25), Vec3(0, 0, -1)});
  staged.judge();
  CHECK(staged.is_done(0));
}

TEST_CASE("the nearest point of a path is the nearest of all its segments") {
  TaskPlace spiral{.kind = PlaceKind::path, .radius = 0.003};
  for (int i = 0; i < 120; ++i) {
    spiral.points.emplace_back(0.03 * std::cos(0.2 * i), 0.03 * std::sin(0.2 * i), 1e-4 * i);
  }
  Task task = one_step({});
  task.places.push_back(spiral);
  const TaskPlace path = StagedWorld(task).task.places[1];
  for (std::uint32_t k = 0; k < 300; ++k) {
    const Vec3 p =
        0.05 * Vec3(scenes::scatter(3 * k), scenes::scatter(3 * k + 1), scenes::scatter(3 * k + 2));
    const double from = k % 2 ? 0.0 : 0.05, to = k % 3 ? path.arc_length.back() : 0.3;
    double least = 1.0;
    for (double s = from; s <= to; s += 1e-4) {
      const auto i = static_cast<std::size_t>(std::ranges::upper_bound(path.arc_length, s) -
                                              path.arc_length.begin());
      const std::size_t end = std::min(i, path.points.size() - 1);
      const Vec3 &a = path.points[end - 1], &b = path.points[end];
      const double t = (s - path.arc_length[end - 1]) / (b - a).norm();
      least = std::min(least, (a + t * (b - a) - p).norm());
    }
    const OnPath found = find_on_path(path, p, from, to);
    CHECK(found.distance <= least + 1e-12);
    CHECK(found.distance >= least - 1e-4);
    CHECK(found.arc_length >= from);
    CHECK(found.arc_length <= to);
  }
}
