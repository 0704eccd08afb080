// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/task/task.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/scenes.h"

namespace palpate::testing {

inline constexpr double kTick = 1e-3;  // [s]

/// A flat sheet of 5 x 5 vertices in z = 0, 40 mm wide, held at its border, outside +z, and a tip
/// of 3 mm. Vertex (i, j) is j * 5 + i.
inline Scene sheet_scene() {
  const SurfaceMesh mesh = scenes::make_sheet(5, 5, 0.04);
  SurfaceOptions options;
  for (int v = 0; v < 25; ++v) {
    if (v / 5 % 4 == 0 || v % 5 % 4 == 0) options.fixed.push_back(v);
  }
  options.home_stiffness = 4e5;
  Scene scene;
  scene.bodies[0].kernel = Kernel::reference;
  scene.bodies[0].tissue = build_mass_spring(mesh, {.wall_thickness = 0.003}, 100.0, options);
  return build_scene(std::move(scene));
}

/// A world as a tick would have left it, with numbers that a reader can do the sum with: the tool
/// is put where a test wants it, and its pushes and holds as well.
class StagedWorld {
 public:
  explicit StagedWorld(Task asked, Scene staged = sheet_scene())
      : scene(std::move(staged)),
        task(build_task(scene, std::move(asked))),
        world(scene),
        progress(task) {
    world.instruments[0].tool.placed = true;
    leave();
  }

  /// The tool presses with a force [N] on a vertex, or its corner of a triangle, its tip `depth`
  /// [m] below the sheet. Adds to what it presses on already where `adds`.
  void press(int vertex, double force, double depth = 0.001, bool adds = false) {
    if (!adds) leave();
    const auto [triangle, weights] = find_corner(vertex);
    ToolState& tool = world.instruments[0].tool;
    tool.touching = true;
    tool.position = task.surfaces[0].vertices[static_cast<std::size_t>(vertex)];
    tool.position.z() += scene.instruments[0].tool.radius - depth;
    world.pair(0, 0).load.add({triangle, weights, Vec3(0, 0, -force)});
    force_ += force;
  }

  /// Holds a vertex that has been moved by `displacement` [m], with the tool on it and no offset.
  void hold(int vertex, const Vec3& displacement, double force) {
    leave();
    const auto [triangle, weights] = find_corner(vertex);
    ToolState& tool = world.instruments[0].tool;
    const double k = scene.instruments[0].hold_stiffness;
    const Vec3 patch = task.surfaces[0].vertices[static_cast<std::size_t>(vertex)] + displacement;
    tool.holds[0] = {triangle, weights, k, Vec3::Zero(), 0};
    tool.hold_count = 1;
    tool.position = patch + displacement.normalized() * (force / k);
    world.pair(0, 0).load.add({triangle, weights, k * (tool.position - patch)});
    force_ = force;
  }

  /// Nothing is touched or held, 50 mm above the sheet.
  void leave() {
    ToolState& tool = world.instruments[0].tool;
    tool.touching = false;
    tool.hold_count = 0;
    tool.position = {0.02, 0.02, 0.05};
    world.pair(0, 0).load.clear();
    force_ = 0.0;
  }

  /// Judges so many ticks of that; their events are kept.
  void judge(int ticks = 1, std::uint8_t buttons = 0) {
    HapticSample sample;
    sample.buttons = buttons;
    const HapticCommand command{.force = Vec3(0, 0, force_)};
    for (int t = 0; t < ticks; ++t) {
      ++world.tick_count;
      palpate::judge(task, world, {&sample, 1}, {&command, 1}, kTick, progress);
      events.insert(events.end(), progress.events.begin(),
                    progress.events.begin() + progress.event_count);
    }
  }
  void judge_for(double seconds) { judge(static_cast<int>(std::lround(seconds / kTick))); }

  const StepState& step(int s) const { return progress.state.steps[static_cast<std::size_t>(s)]; }
  const LimitState& limit(int l) const {
    return progress.state.limits[static_cast<std::size_t>(l)];
  }
  bool is_done(int s) const { return step(s).status == StepStatus::done; }
  int count(TaskEvent kind) const {
    return static_cast<int>(
        std::ranges::count_if(events, [&](const Event& event) { return is_kind(event, kind); }));
  }
  Event last(TaskEvent kind) const {
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
      if (is_kind(*event, kind)) return *event;
    }
    return {};
  }

  Scene scene;
  Task task;
  World world;
  Progress progress;
  std::vector<Event> events;

 private:
  std::pair<int, Vec3> find_corner(int vertex) const {
    const std::vector<Triangle>& triangles = task.surfaces[0].triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (triangles[t][c] != vertex) continue;
        return {static_cast<int>(t), Vec3::Unit(static_cast<Eigen::Index>(c))};
      }
    }
    return {0, Vec3::UnitX()};
  }

  double force_ = 0.0;  // [N] on the hand
};

inline TaskPlace region_of(std::vector<int> vertices) {
  return {.kind = PlaceKind::region, .vertices = std::move(vertices)};
}

/// A task of one step at the middle vertex, 12; its limits are added by a test.
inline Task one_step(TaskStep step) {
  Task task;
  task.places = {region_of({12})};
  step.place = step.place < 0 && step.verb != TaskVerb::release ? 0 : step.place;
  task.steps = {step};
  task.time_limit = 60.0;
  return task;
}

}  // namespace palpate::testing
