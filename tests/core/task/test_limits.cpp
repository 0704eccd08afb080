// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/task/staged_world.h"
#include "scenes/grasped.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A step that is never done, and a limit.
Task limited(TaskLimit limit) {
  Task task = one_step({.verb = TaskVerb::hold, .force = {100.0, 200.0}});
  task.places.push_back(region_of({3}));
  task.limits = {limit};
  return task;
}

}  // namespace

TEST_CASE("a limit opens once its condition has held for its time, and no tick sooner") {
  StagedWorld staged(limited({.bound = 1.5, .duration = 0.05}));
  staged.press(12, 1.6);
  staged.judge(49);
  staged.press(12, 1.5);  // at the bound is not above it
  staged.judge();
  staged.press(12, 1.6);
  staged.judge(49);
  CHECK(staged.limit(0).count == 0);

  staged.judge();
  CHECK(staged.limit(0).open);
  CHECK(staged.limit(0).count == 1);
  CHECK(staged.progress.state.errors == 1);
  CHECK(staged.last(TaskEvent::limit_opened).tick == 99);
  CHECK(staged.last(TaskEvent::limit_opened).value == doctest::Approx(1.6));
}

TEST_CASE("one long press is one error, until it has been below nine tenths for 0.1 s") {
  StagedWorld staged(limited({.bound = 1.0}));
  staged.press(12, 2.0);
  staged.judge_for(0.5);
  for (int k = 0; k < 20; ++k) {  // tremor around the bound
    staged.press(12, k % 2 == 0 ? 0.95 : 1.05);
    staged.judge(50);
  }
  staged.press(12, 0.89);
  staged.judge(99);
  CHECK(staged.limit(0).open);
  CHECK(staged.limit(0).count == 1);
  staged.judge();
  CHECK_FALSE(staged.limit(0).open);
  // 0.5 s, 20 times 50 ms, and the 0.1 s, less the 19 ticks in which it was not yet open
  CHECK(staged.last(TaskEvent::limit_closed).value == doctest::Approx(1.6 - 0.019));
  CHECK(staged.limit(0).duration == doctest::Approx(1.6 - 0.019));
  CHECK(staged.limit(0).excess == doctest::Approx((0.5 - 0.019) * 1.0 + 10 * 0.05 * 0.05));
  CHECK(staged.limit(0).worst == doctest::Approx(2.0));

  staged.press(12, 1.1);
  staged.judge(20);
  CHECK(staged.limit(0).count == 2);
  CHECK(staged.progress.state.errors == 2);
}

TEST_CASE("a glitch of one tick opens no limit and is no peak") {
  StagedWorld staged(limited({.bound = 1.0}));
  staged.press(12, 0.5);
  staged.judge(50);
  staged.press(12, 6.0);
  staged.judge();
  staged.press(12, 0.5);
  staged.judge(50);
  CHECK(staged.limit(0).count == 0);
  CHECK(staged.progress.state.peak_force == doctest::Approx(0.5));

  staged.press(12, 0.8);
  staged.judge(9);
  CHECK(staged.progress.state.peak_force == doctest::Approx(0.5));
  staged.judge();
  CHECK(staged.progress.state.peak_force == doctest::Approx(0.8));
}

TEST_CASE("a warning is no error, and a limit that ends the task has failed it") {
  Task task = limited({.bound = 1.0, .then = LimitConsequence::warn});
  task.limits.push_back({.bound = 2.0, .then = LimitConsequence::end});
  StagedWorld staged(task);
  staged.press(12, 1.5);
  staged.judge(100);
  CHECK(staged.progress.state.warnings == 1);
  CHECK(staged.progress.state.errors == 0);
  CHECK(staged.progress.state.outcome == Outcome::running);

  staged.press(12, 2.5);
  staged.judge(20);
  CHECK(staged.progress.state.outcome == Outcome::failed);
  CHECK_FALSE(staged.limit(0).open);  // closed at the end
  const std::size_t events = staged.events.size();
  staged.judge(100);
  CHECK(staged.events.size() == events);
  CHECK(staged.progress.state.ticks == 120);
}

TEST_CASE("too much in the tick that would finish the task has failed it") {
  Task task = one_step({.verb = TaskVerb::push, .force = {1.0}, .duration = 0.02});
  task.limits = {{.bound = 1.5, .duration = 0.02, .then = LimitConsequence::end}};
  StagedWorld staged(task);
  staged.press(12, 2.0);
  staged.judge(20);
  CHECK(staged.is_done(0));
  CHECK(staged.progress.state.outcome == Outcome::failed);
}

TEST_CASE("contact with a forbidden place is any force there at all") {
  StagedWorld staged(limited({.measure = TaskMeasure::contact, .place = 1}));
  staged.press(12, 1.0);
  staged.judge(100);
  CHECK(staged.limit(0).count == 0);
  staged.press(3, 0.001, 0.001, true);
  staged.judge(20);
  CHECK(staged.limit(0).count == 1);
  staged.leave();
  staged.judge(100);
  CHECK_FALSE(staged.limit(0).open);
}

TEST_CASE("a limit of force with a place counts the part that is there") {
  StagedWorld staged(limited({.place = 1, .bound = 0.5}));
  staged.press(12, 2.0);
  staged.press(3, 0.4, 0.001, true);
  staged.judge(100);
  CHECK(staged.limit(0).count == 0);
  staged.press(3, 0.2, 0.001, true);
  staged.judge(20);
  CHECK(staged.limit(0).count == 1);
  CHECK(staged.last(TaskEvent::limit_opened).value == doctest::Approx(0.6));
}

TEST_CASE("a limit is watched during its steps alone, and closes with them") {
  Task task = limited({.bound = 1.0, .during = {1}});
  task.steps = {{.verb = TaskVerb::touch, .place = 0},
                {.verb = TaskVerb::hold, .place = 0, .force = {.least = 3.0}, .after = {0}},
                {.verb = TaskVerb::touch, .place = 1, .after = {1}}};
  StagedWorld staged(task);
  staged.press(3, 2.0);
  staged.judge(100);
  CHECK(staged.limit(0).count == 0);
  staged.press(12, 2.0);
  staged.judge(1 + 20);
  CHECK(staged.limit(0).open);
  staged.press(12, 3.5);
  staged.judge(2);
  CHECK_FALSE(staged.limit(0).open);
}

TEST_CASE("a limit may ask for no less than something") {
  StagedWorld staged(limited({.above = false, .bound = 0.2}));
  staged.press(12, 0.2);
  staged.judge(50);
  CHECK(staged.limit(0).count == 0);
  staged.press(12, 0.1);
  staged.judge(20);
  CHECK(staged.limit(0).count == 1);
  CHECK(staged.limit(0).excess == doctest::Approx(0.1 * kTick));
  staged.press(12, 0.21);
  staged.judge(200);
  CHECK(staged.limit(0).open);
  staged.press(12, 0.23);
  staged.judge(100);
  CHECK_FALSE(staged.limit(0).open);
}

TEST_CASE("force rate and speed are over 20 ms") {
  Task task = limited({.measure = TaskMeasure::force_rate, .bound = 19.0, .duration = 0.0});
  task.limits.push_back({.measure = TaskMeasure::speed, .bound = 0.049, .duration = 0.0});
  StagedWorld staged(task);
  for (int k = 0; k < 40; ++k) {  // 20 N/s, 50 mm/s
    staged.press(12, 0.02 * k, 5e-5 * k);
    staged.judge();
    if (k == 19) CHECK(staged.progress.state.errors == 0);  // the history is not full
  }
  CHECK(staged.last(TaskEvent::limit_opened).tick == 20);
  CHECK(staged.count(TaskEvent::limit_opened) == 2);
  CHECK(staged.limit(0).worst == doctest::Approx(20.0));
  CHECK(staged.limit(1).worst == doctest::Approx(0.05));
}

TEST_CASE("depth, distance, clearance and the way off a path are measured") {
  Task task = limited({.measure = TaskMeasure::depth, .bound = 0.005, .duration = 0.0});
  const Vec3Array x = StagedWorld(task).task.surfaces[0].vertices;
  task.places[0] = {.kind = PlaceKind::ball, .points = {x[12]}, .radius = 0.002};
  task.places.push_back({.kind = PlaceKind::path, .points = {x[10], x[14]}, .radius = 0.003});
  task.limits.push_back({.measure = TaskMeasure::distance, .bound = 0.01, .duration = 0.0});
  task.limits.push_back({.measure = TaskMeasure::clearance,
                         .place = 0,
                         .above = false,
                         .bound = 0.01,
                         .duration = 0.0});
  task.limits.push_back(
      {.measure = TaskMeasure::off_path, .place = 2, .bound = 0.005, .duration = 0.0});
  StagedWorld staged(task);
  staged.judge();
  CHECK(staged.progress.state.errors == 0);

  staged.world.instruments[0].tool.position = x[12] + Vec3(0, 0, 0.002 + 0.003 + 0.0099);
  staged.judge();
  CHECK(staged.limit(2).worst == doctest::Approx(0.0099));
  staged.hold(12, {0, 0, 0.011}, 0.5);
  staged.judge();
  CHECK(staged.limit(1).worst == doctest::Approx(0.011));
  staged.press(22, 0.5, 0.006);
  staged.judge();
  CHECK(staged.limit(0).worst == doctest::Approx(0.006));
  const Vec3 along = (x[14] - x[10]).normalized();
  const Vec3 off = x[22] - x[10];
  CHECK(staged.limit(3).worst == doctest::Approx((off - off.dot(along) * along).norm()));
}

TEST_CASE("strain is the largest principal one of the triangles that the tool touches or holds") {
  Task task = limited({.measure = TaskMeasure::strain, .bound = 0.25, .duration = 0.0});
  task.limits.push_back(
      {.measure = TaskMeasure::strain, .place = 1, .bound = 0.01, .duration = 0.0});
  StagedWorld staged(task);
  const Vec3Array& rest = staged.task.surfaces[0].vertices;
  // along x by a third, along y to half, and turned about x: a turn strains nothing
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3::UnitX()).toRotationMatrix();
  Vec3Array& now = staged.world.bodies[0].tissue.position;
  for (std::size_t v = 0; v < now.size(); ++v) {
    now[v] = turn * rest[v].cwiseProduct(Vec3(4.0 / 3.0, 0.5, 1.0)) + Vec3(0.1, 0, 0);
  }
  staged.judge();
  CHECK(staged.limit(0).count == 0);  // nothing is touched
  staged.press(12, 0.5);
  staged.judge();
  CHECK(staged.limit(0).worst == doctest::Approx(1.0 / 3.0));
  CHECK(staged.limit(1).count == 0);  // what is touched lies elsewhere
  staged.hold(3, {0, 0, 0.001}, 0.5);
  staged.judge();
  CHECK(staged.limit(1).worst == doctest::Approx(1.0 / 3.0));

  // simple shear by g: 1/2 (sqrt(4 + g²) + g) - 1, along no side of any triangle
  for (std::size_t v = 0; v < now.size(); ++v) now[v] = rest[v] + Vec3(0.8 * rest[v].y(), 0, 0);
  staged.press(12, 0.5);
  staged.judge();
  CHECK(staged.limit(0).worst == doctest::Approx(0.5 * (std::sqrt(4.64) + 0.8) - 1.0));
  // what is squeezed to both sides is not stretched
  for (std::size_t v = 0; v < now.size(); ++v) now[v] = 0.8 * rest[v];
  staged.judge(200);
  CHECK_FALSE(staged.limit(0).open);
}

TEST_CASE("jaws that press too hard are told, and tissue that has torn") {
  Scene scene = sheet_scene();
  scene.instruments[0].tool = scenes::make_grasper(0.5, 5.0);
  scene.bodies[0].tear_stretch = 1.6;
  Task task = limited({.measure = TaskMeasure::pad_pressure, .bound = 150e3});
  task.limits.push_back({.measure = TaskMeasure::torn, .duration = 0.0});
  StagedWorld staged(task, std::move(scene));
  staged.world.instruments[0].tool.pad_pressure = 149e3;
  staged.judge(100);
  CHECK(staged.limit(0).count == 0);
  CHECK(staged.limit(1).count == 0);

  staged.world.instruments[0].tool.pad_pressure = 180e3;
  staged.judge(100);
  CHECK(staged.limit(0).count == 1);
  CHECK(staged.limit(0).worst == doctest::Approx(180e3));

  // it does not grow together again: one error, whatever follows
  staged.world.bodies[0].torn_count = 3;
  staged.judge(1000);
  CHECK(staged.limit(1).count == 1);
  CHECK(staged.limit(1).open);
}

TEST_CASE("time counts ticks, and errors are counted") {
  Task task = limited({.bound = 1.0});
  task.time_limit = 1.0;
  StagedWorld timed(task);
  timed.judge(999);
  CHECK(timed.progress.state.outcome == Outcome::running);
  timed.judge();
  CHECK(timed.progress.state.outcome == Outcome::timed_out);
  CHECK(timed.last(TaskEvent::task_ended).value == doctest::Approx(1.0));

  task.errors_at_most = 1;
  StagedWorld erring(task);
  for (int k = 0; k < 2; ++k) {
    CHECK(erring.progress.state.outcome == Outcome::running);
    erring.press(12, 2.0);
    erring.judge(20);
    erring.leave();
    erring.judge(100);
  }
  CHECK(erring.progress.state.outcome == Outcome::failed);
}

TEST_CASE("an alarm ends a task as diverged") {
  StagedWorld staged(limited({.bound = 1.0}));
  staged.judge(5);
  staged.world.alarm = {AlarmKind::not_finite, 0, 0.0, 0.0, 0.0};
  staged.judge(5);
  CHECK(staged.progress.state.outcome == Outcome::diverged);
  CHECK(staged.count(TaskEvent::task_ended) == 1);
  CHECK(staged.last(TaskEvent::task_ended).tick == 5);
}
