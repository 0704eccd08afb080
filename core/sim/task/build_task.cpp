// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/task/private/build_places.h"

namespace palpate {
namespace {

/// [s] No attempt lasts longer, nor anything in it: 2 h, which a record holds.
constexpr double kLongest = 7200.0;

void check_count(const char* table, std::size_t count, int least, int most) {
  if (count >= static_cast<std::size_t>(least) && count <= static_cast<std::size_t>(most)) return;
  refuse(write_text("task: ", table), std::to_string(count), write_text(least, " to ", most));
}

void check_band(const std::string& where, const Band& band) {
  if (band.least <= band.most) return;
  refuse(where, write_text(band.least, " to ", band.most),
         "a band, its least no more than its most");
}

TaskSurface build_surface(const SoftBody& body) {
  TaskSurface surface;
  surface.vertices = compute_surface(body.tissue, body.tissue.rest_position);
  surface.triangles = body.tissue.triangles;
  surface.normals = compute_vertex_normals(surface.vertices, surface.triangles);
  return surface;
}

const char* name_kind(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::region:
      return "a region";
    case PlaceKind::path:
      return "a path";
    case PlaceKind::ball:
      return "a ball";
    case PlaceKind::object:
      return "an object";
    case PlaceKind::space:
      return "a space";
  }
  return "";
}

bool needs_place(TaskVerb verb) { return verb != TaskVerb::release; }

bool needs_space(TaskVerb verb) { return verb == TaskVerb::remove || verb == TaskVerb::carry; }

/// What can be done at an object or a space, and what only there.
void check_step_place(const Task& task, std::size_t s) {
  const TaskStep& step = task.steps[s];
  const std::string where = name_row("steps", s, "place");
  check_index(name_row("steps", s, "space"), step.space, needs_space(step.verb) ? 0 : -1,
              needs_space(step.verb) ? task.places.size() : 0);
  if (needs_space(step.verb) && place_of(task, step.space).kind != PlaceKind::space) {
    refuse(name_row("steps", s, "space"), name_kind(place_of(task, step.space).kind), "a space");
  }
  if (step.place < 0) return;
  const PlaceKind kind = place_of(task, step.place).kind;
  if (needs_space(step.verb) && kind != PlaceKind::object) {
    refuse(where, "no object", "an object, which is what is moved");
  }
  const bool may_hold = step.verb == TaskVerb::grasp || step.verb == TaskVerb::release;
  if (kind == PlaceKind::object && !may_hold && !needs_space(step.verb) &&
      step.verb != TaskVerb::look) {
    refuse(where, "an object", "a place on a tissue, or to look, grasp, release, remove or carry");
  }
  if (kind == PlaceKind::space && step.verb != TaskVerb::look) {
    refuse(where, "a space", "a place on a tissue, or to look");
  }
  if (kind == PlaceKind::path && step.verb == TaskVerb::look) {
    refuse(where, "a path", "a region, a ball, an object or a space");
  }
  if (step.verb == TaskVerb::trace && kind != PlaceKind::path) {
    refuse(where, "no path", "a path, which is what is traced");
  }
  if (step.verb != TaskVerb::look) return;
  const auto is_its = [&](const TaskCamera& c) { return c.instrument == step.instrument; };
  if (std::ranges::any_of(task.cameras, is_its)) return;
  refuse(name_row("steps", s, "instrument"), "one without a camera", "one that sees");
}

void check_camera(const Scene& scene, std::size_t c, TaskCamera& camera) {
  constexpr double kNarrowest = 0.05, kWidest = 3.0;
  check_index(name_row("cameras", c, "instrument"), camera.instrument, 0, scene.instruments.size());
  check_number(name_row("cameras", c, "field_of_view"), camera.field_of_view, kNarrowest, kWidest);
  check_number(name_row("cameras", c, "forward"), camera.forward.norm(), 0.99, 1.01);
  check_number(name_row("cameras", c, "at"), camera.at.norm(), 0.0, 1.0);
  camera.forward.normalize();
}

void check_step(const Scene& scene, const Task& task, std::size_t s) {
  const TaskStep& step = task.steps[s];
  check_index(name_row("steps", s, "instrument"), step.instrument, 0, scene.instruments.size());
  check_index(name_row("steps", s, "place"), step.place, needs_place(step.verb) ? 0 : -1,
              task.places.size());
  check_band(name_row("steps", s, "force"), step.force);
  check_band(name_row("steps", s, "depth"), step.depth);
  check_band(name_row("steps", s, "distance"), step.distance);
  check_number(name_row("steps", s, "duration"), step.duration, 0.0, kLongest);
  check_number(name_row("steps", s, "time_limit"), step.time_limit, 0.0, kLongest);
  check_number(name_row("steps", s, "share"), step.share, 1e-3, 1.0);
  for (const int other : step.after) {
    check_index(name_row("steps", s, "after"), other, 0, task.steps.size());
  }
  check_step_place(task, s);
}

/// Every step can begin: the order has no circle.
void check_order(const Task& task) {
  std::vector<std::uint8_t> done(task.steps.size(), 0);
  std::size_t left = task.steps.size();
  for (bool moved = true; moved && left > 0;) {
    moved = false;
    for (std::size_t s = 0; s < task.steps.size(); ++s) {
      const auto is_done = [&](int other) { return done[static_cast<std::size_t>(other)] != 0; };
      if (done[s] || !std::ranges::all_of(task.steps[s].after, is_done)) continue;
      done[s] = 1;
      --left;
      moved = true;
    }
  }
  if (left == 0) return;
  const auto first = std::ranges::find(done, std::uint8_t{0}) - done.begin();
  refuse(name_row("steps", static_cast<std::size_t>(first), "after"),
         "steps that wait for each other in a circle", "an order in which each can begin");
}

void check_measure(const Scene& scene, const Task& task, std::size_t l) {
  const TaskLimit& limit = task.limits[l];
  const TaskMeasure measure = limit.measure;
  const std::string where = name_row("limits", l, "place");
  const auto is = [&](auto... some) { return ((measure == some) || ...); };
  const bool needs_object = is(TaskMeasure::loose, TaskMeasure::object_force);
  const bool needs =
      needs_object || is(TaskMeasure::contact, TaskMeasure::clearance, TaskMeasure::off_path);
  const bool may = is(TaskMeasure::force, TaskMeasure::strain, TaskMeasure::out_of_view);
  if (limit.place >= 0 && !needs && !may) {
    refuse(where, "one", "none, for this is measured of the tool");
  }
  if (is_yes_or_no(measure) && !limit.above) {
    const char* wrong = is(TaskMeasure::contact) ? "contact"
                        : is(TaskMeasure::loose) ? "what is loose"
                        : is(TaskMeasure::torn)  ? "what has torn"
                                                 : "what is not seen";
    refuse(name_row("limits", l, "above"), "false",
           write_text("true: ", wrong, " is what can be wrong"));
  }
  if (is(TaskMeasure::out_of_view) && task.cameras.empty()) {
    refuse(name_row("limits", l, "measure"), "what is out of view", "another: no instrument sees");
  }
  const auto is_others = [&](const TaskCamera& c) { return c.instrument != limit.instrument; };
  if (is(TaskMeasure::out_of_view) && std::ranges::none_of(task.cameras, is_others)) {
    refuse(name_row("limits", l, "instrument"), "the one that sees", "one that another sees");
  }
  const auto tool = static_cast<std::size_t>(limit.instrument);
  const bool needs_jaws = is(TaskMeasure::loose, TaskMeasure::pad_pressure);
  if (needs_jaws && !scene.instruments[tool].tool.jaws) {
    refuse(name_row("limits", l, "instrument"), "one without jaws", "a grasper");
  }
  const auto tears = [](const SoftBody& body) { return body.tear_stretch > 0.0; };
  if (is(TaskMeasure::torn) && std::ranges::none_of(scene.bodies, tears)) {
    refuse(name_row("limits", l, "measure"), "what has torn",
           "another: no tissue of the scene has a tear_stretch");
  }
  if (needs) check_index(where, limit.place, 0, task.places.size());
  if (limit.place < 0) return;
  const PlaceKind kind = place_of(task, limit.place).kind;
  const bool hard = kind == PlaceKind::object, space = kind == PlaceKind::space;
  if (needs_object && !hard) refuse(where, name_kind(kind), "an object");
  if (is(TaskMeasure::out_of_view) && !space) refuse(where, name_kind(kind), "a space or none");
  if (is(TaskMeasure::clearance) && kind != PlaceKind::ball && !space) {
    refuse(where, name_kind(kind), "a ball or a space");
  }
  if (is(TaskMeasure::off_path) && kind != PlaceKind::path) {
    refuse(where, name_kind(kind), "a path");
  }
  if (is(TaskMeasure::contact, TaskMeasure::force) && (hard || space)) {
    refuse(where, hard ? "an object" : "a space", "a place on a tissue");
  }
  if (is(TaskMeasure::strain) && space)
    refuse(where, "a space", "an object or a place on a tissue");
}

void check_limit(const Scene& scene, const Task& task, std::size_t l) {
  const TaskLimit& limit = task.limits[l];
  check_index(name_row("limits", l, "instrument"), limit.instrument, 0, scene.instruments.size());
  check_index(name_row("limits", l, "place"), limit.place, -1, task.places.size());
  check_measure(scene, task, l);
  check_number(name_row("limits", l, "bound"), limit.bound, 0.0, 1e6);
  check_number(name_row("limits", l, "duration"), limit.duration, 0.0, kLongest);
  for (const int step : limit.during) {
    check_index(name_row("limits", l, "during"), step, 0, task.steps.size());
  }
}

}  // namespace

Task build_task(const Scene& scene, Task task) {
  check_count("steps", task.steps.size(), 1, kMostSteps);
  check_count("limits", task.limits.size(), 0, kMostLimits);
  check_count("places", task.places.size(), 0, kMostPlaces);
  check_count("cameras", task.cameras.size(), 0, kMostLoggedInstruments);
  check_number("task: time_limit", task.time_limit, 1e-3, kLongest);
  check_number("task: errors_at_most", task.errors_at_most, -1, 1000000);
  if (scene.exchange_rate > 0.0) {
    refuse("task: scene.exchange_rate", write_text(scene.exchange_rate),
           "0, for what a tool does to a slow tissue is not known in every tick");
  }
  task.surfaces.clear();
  for (const SoftBody& body : scene.bodies) task.surfaces.push_back(build_surface(body));
  check_count("scene.instruments", scene.instruments.size(), 1, kMostLoggedInstruments);
  task.tool_radii.clear();
  for (const Instrument& each : scene.instruments) task.tool_radii.push_back(each.tool.radius);
  task.objects = build_objects(scene);
  for (std::size_t c = 0; c < task.cameras.size(); ++c) check_camera(scene, c, task.cameras[c]);
  for (std::size_t p = 0; p < task.places.size(); ++p) build_place(scene, task, p);
  for (std::size_t s = 0; s < task.steps.size(); ++s) check_step(scene, task, s);
  for (std::size_t l = 0; l < task.limits.size(); ++l) check_limit(scene, task, l);
  check_order(task);
  return task;
}

Progress::Progress(const Task& task)
    // more than can happen in a tick: a step begins, is late, misses a click and is done, a limit
    // opens and closes
    : events(4 * task.steps.size() + 2 * task.limits.size() + 1),
      signals(task.tool_radii.size()),
      step_timers(task.steps.size()),
      limit_timers(task.limits.size()),
      reached(task.steps.size(), 0.0) {
  if (task.tool_radii.empty() || task.surfaces.empty()) {
    refuse("progress: task", "one whose derived fields are not filled in", "one from build_task");
  }
  state.steps.resize(task.steps.size());
  state.limits.resize(task.limits.size());
}

}  // namespace palpate
