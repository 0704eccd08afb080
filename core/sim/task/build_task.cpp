// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/task/task.h"

namespace palpate {
namespace {

/// [s] No attempt lasts longer, nor anything in it: 2 h, which a record holds.
constexpr double kLongest = 7200.0;

std::string name_row(const char* table, std::size_t row, const char* field) {
  return write_text("task: ", table, "[", row, "].", field);
}

void check_count(const char* table, std::size_t count, int least, int most) {
  if (count >= static_cast<std::size_t>(least) && count <= static_cast<std::size_t>(most)) return;
  refuse(write_text("task: ", table), std::to_string(count), write_text(least, " to ", most));
}

void check_index(const std::string& where, int index, int least, std::size_t count) {
  if (index >= least && index < static_cast<int>(count)) return;
  refuse(where, std::to_string(index), write_text(least, " to ", static_cast<long>(count) - 1));
}

void check_number(const std::string& where, double value, double least, double most) {
  if (value >= least && value <= most) return;  // refuses what is not a number too
  refuse(where, write_text(value), write_text(least, " to ", most));
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

void build_region(std::size_t p, const TaskSurface& surface, TaskPlace& place) {
  const std::string where = name_row("places", p, "vertices");
  if (place.vertices.empty()) refuse(where, "none", "at least one vertex of the surface");
  place.members.assign(surface.vertices.size(), 0);
  for (const int v : place.vertices) {
    check_index(where, v, 0, surface.vertices.size());
    place.members[static_cast<std::size_t>(v)] = 1;
  }
}

void build_path(std::size_t p, TaskPlace& place) {
  place.arc_length.assign(1, 0.0);
  for (std::size_t i = 1; i < place.points.size(); ++i) {
    const double step = (place.points[i] - place.points[i - 1]).norm();
    if (!(step > 0.0)) {
      refuse(name_row("places", p, "points"), write_text("twice the same, in row ", i),
             "each elsewhere than the one before");
    }
    place.arc_length.push_back(place.arc_length.back() + step);
  }
}

void build_place(const Task& task, std::size_t p, TaskPlace& place) {
  check_index(name_row("places", p, "body"), place.body, 0, task.surfaces.size());
  place.members.clear();
  place.arc_length.clear();
  const auto& surface = task.surfaces[static_cast<std::size_t>(place.body)];
  if (place.kind == PlaceKind::region) return build_region(p, surface, place);

  const std::string where = name_row("places", p, "points");
  const bool is_path = place.kind == PlaceKind::path;
  const std::size_t count = place.points.size();
  if (is_path ? count < 2 || count > 10000 : count != 1) {
    refuse(where, std::to_string(count), is_path ? "2 to 10000 of a path" : "1 of a ball");
  }
  for (const Vec3& point : place.points) {
    if (!point.allFinite()) refuse(where, "a number that is not finite", "finite ones");
  }
  check_number(name_row("places", p, "radius"), place.radius, 1e-5, 1.0);
  if (is_path) build_path(p, place);
}

bool needs_place(TaskVerb verb) { return verb != TaskVerb::release; }

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
  if (step.verb != TaskVerb::trace) return;
  const TaskPlace& place = task.places[static_cast<std::size_t>(step.place)];
  if (place.kind != PlaceKind::path) {
    refuse(name_row("steps", s, "place"), "no path", "a path, which is what is traced");
  }
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

void check_measure(const Task& task, std::size_t l) {
  const TaskLimit& limit = task.limits[l];
  const std::string where = name_row("limits", l, "place");
  const bool of_contact = limit.measure == TaskMeasure::contact;
  const bool needs_ball = limit.measure == TaskMeasure::clearance;
  const bool needs_path = limit.measure == TaskMeasure::off_path;
  const bool needs = of_contact || needs_ball || needs_path;
  const bool may =
      needs || limit.measure == TaskMeasure::force || limit.measure == TaskMeasure::strain;
  if (limit.place >= 0 && !may) refuse(where, "one", "none, for this is measured of the tool");
  if (!needs) return;
  check_index(where, limit.place, 0, task.places.size());
  const PlaceKind kind = task.places[static_cast<std::size_t>(limit.place)].kind;
  if (needs_ball && kind != PlaceKind::ball) refuse(where, "another place", "a ball");
  if (needs_path && kind != PlaceKind::path) refuse(where, "another place", "a path");
  if (of_contact && !limit.above) {
    refuse(name_row("limits", l, "above"), "false", "true: contact is what can be wrong");
  }
}

void check_limit(const Scene& scene, const Task& task, std::size_t l) {
  const TaskLimit& limit = task.limits[l];
  check_index(name_row("limits", l, "instrument"), limit.instrument, 0, scene.instruments.size());
  check_index(name_row("limits", l, "place"), limit.place, -1, task.places.size());
  check_measure(task, l);
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
  for (std::size_t p = 0; p < task.places.size(); ++p) build_place(task, p, task.places[p]);
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
