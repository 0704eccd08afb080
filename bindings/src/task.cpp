// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/task/task.h"

#include <pybind11/stl.h>

#include <algorithm>

#include "bindings.h"
#include "border.h"
#include "rows.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_place(py::module_& m) {
  py::class_<Band> band(m, "Band", "From least to most, both included.");
  band.def(py::init([](double least, double most) {
             return Band{least, most};
           }),
           "least"_a = Band().least, "most"_a = Band().most)
      .def_readwrite("least", &Band::least, "[N] or [m]; minus infinity for no bound.")
      .def_readwrite("most", &Band::most, "[N] or [m]; infinity for no bound.");
  def_value(band, &Band::least, &Band::most);
  def_repr(band, {"least", "most"});

  py::class_<TaskPlace> place(m, "TaskPlace",
                              "Where a step or a limit is: of a tissue at rest, which moves "
                              "with it, an object of the scene, or a space in it.");
  place
      .def(py::init([](PlaceKind kind, int body, const std::vector<int>& vertices,
                       const Vec3Array& points, double radius) {
             return TaskPlace{kind, body, vertices, points, radius, {}, {}, {}};
           }),
           py::kw_only(), "kind"_a = PlaceKind::ball, "body"_a = 0,
           "vertices"_a = std::vector<int>(), "points"_a = Vec3Array(), "radius"_a = 0.0)
      .def_readwrite("kind", &TaskPlace::kind, "What it is.")
      .def_readwrite("body", &TaskPlace::body, "Of the scene; of an object: of Scene.rigid.")
      .def_readwrite("vertices", &TaskPlace::vertices, "Of a region: of the body's surface.")
      .def_readwrite("points", &TaskPlace::points,
                     "[m] shape (k, 3) when set: of a path two or more, of a ball or a space its "
                     "centre.")
      .def_readwrite(
          "radius", &TaskPlace::radius,
          "[m] of a ball or a space; of a path, how far beside it still counts as on it.")
      .def_readonly("members", &TaskPlace::members,
                    "Of a region: per vertex of the surface 1 or 0; filled in by build_task.")
      .def_readonly("arc_length", &TaskPlace::arc_length,
                    "[m] of a path: per point, from its beginning; filled in by build_task.")
      .def_readonly("seen", &TaskPlace::seen,
                    "Of a region or a ball: vertices of the surface by which a camera sees it; "
                    "filled in by build_task.");
  def_value(place, &TaskPlace::kind, &TaskPlace::body, &TaskPlace::vertices, &TaskPlace::points,
            &TaskPlace::radius, &TaskPlace::members, &TaskPlace::arc_length, &TaskPlace::seen);
  def_repr(place, {"kind", "body", "radius"});
}

void bind_step(py::module_& m) {
  py::class_<TaskStep> step(m, "TaskStep", "Something that a trainee is asked to do.");
  step.def(py::init([](TaskVerb verb, int instrument, int place, int space, const Band& force,
                       const Band& depth, const Band& distance, double duration, double share,
                       double time_limit, const std::vector<int>& after) {
             return TaskStep{verb,     instrument, place, space,      force, depth,
                             distance, duration,   share, time_limit, after};
           }),
           py::kw_only(), "verb"_a = TaskVerb::touch, "instrument"_a = 0, "place"_a = -1,
           "space"_a = -1, "force"_a = Band(), "depth"_a = Band(), "distance"_a = Band(),
           "duration"_a = 0.0, "share"_a = 1.0, "time_limit"_a = 0.0,
           "after"_a = std::vector<int>())
      .def_readwrite("verb", &TaskStep::verb, "What it asks for.")
      .def_readwrite("instrument", &TaskStep::instrument, "Of the scene.")
      .def_readwrite("place", &TaskStep::place,
                     "Of the task; -1 for none, which only release may have.")
      .def_readwrite("space", &TaskStep::space,
                     "Of the task: that remove is from, and carry into; else -1.")
      .def_readwrite("force", &TaskStep::force, "[N] size of what the hand feels.")
      .def_readwrite("depth", &TaskStep::depth, "[m] of the tip below the surface at rest.")
      .def_readwrite("distance", &TaskStep::distance,
                     "[m] of what is held from where it is at rest; to look, of the lens.")
      .def_readwrite("duration", &TaskStep::duration,
                     "[s] for which it must be so; gaps of up to 0.1 s are left out.")
      .def_readwrite("share", &TaskStep::share, "[-] of a path, 0 to 1.")
      .def_readwrite("time_limit", &TaskStep::time_limit,
                     "[s] since it began; once longer is an error. 0 for none.")
      .def_readwrite("after", &TaskStep::after, "Steps that must be done before it begins.");
  def_value(step, &TaskStep::verb, &TaskStep::instrument, &TaskStep::place, &TaskStep::space,
            &TaskStep::force, &TaskStep::depth, &TaskStep::distance, &TaskStep::duration,
            &TaskStep::share, &TaskStep::time_limit, &TaskStep::after);
  def_repr(step, {"verb", "instrument", "place", "duration"});
}

void bind_limit(py::module_& m) {
  py::class_<TaskLimit> limit(m, "TaskLimit", "What must not be, and what becomes of it.");
  limit
      .def(py::init([](TaskMeasure measure, int instrument, int place, bool above, double bound,
                       double duration, LimitConsequence then, const std::vector<int>& during) {
             return TaskLimit{measure, instrument, place, above, bound, duration, then, during};
           }),
           py::kw_only(), "measure"_a = TaskMeasure::force, "instrument"_a = 0, "place"_a = -1,
           "above"_a = true, "bound"_a = 0.0, "duration"_a = TaskLimit().duration,
           "then"_a = LimitConsequence::error, "during"_a = std::vector<int>())
      .def_readwrite("measure", &TaskLimit::measure, "What it watches.")
      .def_readwrite("instrument", &TaskLimit::instrument, "Of the scene.")
      .def_readwrite("place", &TaskLimit::place, "Of the task; -1 for none.")
      .def_readwrite("above", &TaskLimit::above, "Wrong above the bound; else below it.")
      .def_readwrite("bound", &TaskLimit::bound, "[N], [N/s], [m] or [m/s], as the measure is.")
      .def_readwrite("duration", &TaskLimit::duration, "[s] for which it must be so.")
      .def_readwrite("then", &TaskLimit::then, "What becomes of it.")
      .def_readwrite("during", &TaskLimit::during,
                     "Steps while one of which it is watched; empty for always.");
  def_value(limit, &TaskLimit::measure, &TaskLimit::instrument, &TaskLimit::place,
            &TaskLimit::above, &TaskLimit::bound, &TaskLimit::duration, &TaskLimit::then,
            &TaskLimit::during);
  def_repr(limit, {"measure", "above", "bound", "then"});
}

void bind_surface_at_rest(py::module_& m) {
  py::class_<TaskSurface> surface(m, "TaskSurface", "A body's surface at rest.");
  surface.def(py::init<>());
  def_view(surface, "vertices", &TaskSurface::vertices, "[m] shape (n, 3); a view.");
  def_view(surface, "normals", &TaskSurface::normals, "[-] unit, outwards, shape (n, 3); a view.");
  surface.def_property_readonly(
      "triangles",
      [](const TaskSurface& self) { return read_only(own(std::vector<Triangle>(self.triangles))); },
      "Shape (t, 3); a copy, read-only.");
  def_value(surface, &TaskSurface::vertices, &TaskSurface::normals, &TaskSurface::triangles);
  def_repr(surface, {"vertices"});
}

void bind_task_type(py::module_& m) {
  py::class_<Task> task(m, "Task", "All that judge() knows of a task, and never changes.");
  task.def(py::init([](const std::vector<TaskPlace>& places, const std::vector<TaskStep>& steps,
                       const std::vector<TaskLimit>& limits, double time_limit, int errors_at_most,
                       const std::vector<TaskCamera>& cameras) {
             return Task{places, steps, limits, time_limit, errors_at_most, cameras, {}, {}, {}};
           }),
           py::kw_only(), "places"_a = py::tuple(), "steps"_a = py::tuple(),
           "limits"_a = py::tuple(), "time_limit"_a = 0.0, "errors_at_most"_a = -1,
           "cameras"_a = py::tuple(), "Copies what it is given; build_task checks it.")
      .def_readwrite("time_limit", &Task::time_limit, "[s] of ticks, positive.")
      .def_readwrite("errors_at_most", &Task::errors_at_most,
                     "With more the task has failed; -1 for any number.")
      .def_readonly("tool_radii", &Task::tool_radii,
                    "[m] per instrument; filled in by build_task.");
  // copies: what was checked must stay as it is
  task.def_property_readonly(
          "places", [](const Task& self) { return py::tuple(py::cast(self.places)); },
          "A TaskPlace each, a tuple of copies.")
      .def_property_readonly(
          "steps", [](const Task& self) { return py::tuple(py::cast(self.steps)); },
          "A TaskStep each, a tuple of copies.")
      .def_property_readonly(
          "limits", [](const Task& self) { return py::tuple(py::cast(self.limits)); },
          "A TaskLimit each, a tuple of copies.")
      .def_property_readonly(
          "cameras", [](const Task& self) { return py::tuple(py::cast(self.cameras)); },
          "A TaskCamera each, a tuple of copies.")
      .def_property_readonly(
          "objects", [](const Task& self) { return py::tuple(py::cast(self.objects)); },
          "A TaskObject each, scenery before rigid bodies, a tuple of copies; filled in by "
          "build_task.")
      .def_property_readonly(
          "surfaces", [](const Task& self) { return py::tuple(py::cast(self.surfaces)); },
          "A TaskSurface for each body, a tuple of copies; filled in by build_task.");
  def_value(task, &Task::places, &Task::steps, &Task::limits, &Task::time_limit,
            &Task::errors_at_most, &Task::cameras, &Task::surfaces, &Task::tool_radii,
            &Task::objects);
  def_summary(task, [](const Task& self) {
    return write_text(self.steps.size(), " steps, ", self.limits.size(), " limits, ",
                      self.time_limit, " s");
  });
  m.attr("MOST_STEPS") = kMostSteps;
  m.attr("MOST_LIMITS") = kMostLimits;
  m.attr("MOST_PLACES") = kMostPlaces;
  m.attr("MOST_SEEN_POINTS") = kMostSeenPoints;
  m.def("is_yes_or_no", &is_yes_or_no, "measure"_a,
        "Whether what a limit watches is or is not, so that its bound is 0 and it is wrong above "
        "that.");
  m.def(
      "is_of_task", [](const Event& event) { return is_of_task(event); }, "event"_a,
      "Whether its kind is one of TaskEvent.");
  m.def(
      "is_kind", [](const Event& event, TaskEvent kind) { return is_kind(event, kind); }, "event"_a,
      "kind"_a, "Whether its kind is that.");
  m.def("watches_sight", &watches_sight, "task"_a,
        "Whether its verdict depends on where all of a tissue is, so that World.follows_all must "
        "be on.");
  m.def("build_task", &build_task, "scene"_a, "task"_a,
        "A task, checked once, with what is derived from it and the scene. Raises ValueError "
        "naming the field, what it got and what was expected.");
}

void bind_states(py::module_& m) {
  py::class_<StepState> step(m, "StepState", "How far a trainee has come with a step.");
  step.def(py::init<>())
      .def_readonly("status", &StepState::status, "Waiting, active or done.")
      .def_readonly("dwell", &StepState::dwell, "[s] for which what it asks has been so.")
      .def_readonly("progress", &StepState::progress, "[-] of a path: the share touched so far.")
      .def_readonly("from_tick", &StepState::from_tick, "It began; -1 before.")
      .def_readonly("until_tick", &StepState::until_tick, "It was done; -1 before.")
      .def_readonly("overdue", &StepState::overdue, "It has taken longer than its time limit.");
  def_value(step, &StepState::status, &StepState::dwell, &StepState::progress,
            &StepState::from_tick, &StepState::until_tick, &StepState::overdue);
  def_repr(step, {"status", "dwell", "progress"});

  py::class_<LimitState> limit(m, "LimitState", "How often and how far a limit was passed.");
  limit.def(py::init<>())
      .def_readonly("open", &LimitState::open, "Now.")
      .def_readonly("count", &LimitState::count, "How often it has opened.")
      .def_readonly("duration", &LimitState::duration, "[s] open in all.")
      .def_readonly("excess", &LimitState::excess,
                    "[N s], [m s] ...: integral over that time of what lies beyond the bound.")
      .def_readonly("worst", &LimitState::worst,
                    "[N], [m] ...: the value farthest beyond the bound so far.");
  def_value(limit, &LimitState::open, &LimitState::count, &LimitState::duration,
            &LimitState::excess, &LimitState::worst);
  def_repr(limit, {"open", "count", "duration", "worst"});

  py::class_<TaskState> state(m, "TaskState", "How far a trainee has come.");
  state.def(py::init<>())
      .def_readonly("outcome", &TaskState::outcome, "How it came out; running before.")
      .def_readonly("ticks", &TaskState::ticks, "Judged.")
      .def_readonly("time", &TaskState::time, "[s]")
      .def_readonly("errors", &TaskState::errors, "So far.")
      .def_readonly("warnings", &TaskState::warnings, "So far.")
      .def_readonly("peak_force", &TaskState::peak_force,
                    "[N] the largest that was held for 10 ms, of any instrument.");
  def_elements(state, "steps", &TaskState::steps, "A StepState each, a tuple.");
  def_elements(state, "limits", &TaskState::limits, "A LimitState each, a tuple.");
  def_value(state, &TaskState::outcome, &TaskState::ticks, &TaskState::time, &TaskState::errors,
            &TaskState::warnings, &TaskState::peak_force, &TaskState::steps, &TaskState::limits);
  def_repr(state, {"outcome", "time", "errors", "warnings"});
}

std::size_t count_rigid(const Task& task) {
  const auto is_rigid = [](const TaskObject& object) { return object.rigid >= 0; };
  return static_cast<std::size_t>(std::ranges::count_if(task.objects, is_rigid));
}

void require_task(const Task& task, const World& world, std::size_t samples, std::size_t commands,
                  const Progress& progress) {
  const std::size_t instruments = world.instruments.size();
  if (task.tool_radii.size() != instruments || task.surfaces.size() != world.bodies.size() ||
      count_rigid(task) != world.rigid.size()) {
    refuse("task", "one of another scene", "one that build_task made for that of the world");
  }
  for (std::size_t b = 0; b < task.surfaces.size(); ++b) {
    require_count("task", task.surfaces[b].triangles.size(),
                  world.bodies[b].tree.triangles().size());
  }
  require_count("samples", samples, instruments);
  require_count("commands", commands, instruments);
  if (progress.state.steps.size() != task.steps.size() ||
      progress.state.limits.size() != task.limits.size() ||
      progress.signals.size() != instruments) {
    refuse("progress", "one of another task", "one that was made for this task");
  }
}

void bind_progress(py::module_& m) {
  py::class_<Progress> made(m, "Progress", "A running task: everything that judge() needs.");
  made.def(py::init<const Task&>(), "task"_a,
           "At its beginning. Raises ValueError for a task that is not from build_task.")
      .def_property_readonly(
          "state", [](const Progress& self) { return self.state; },
          "How far the trainee has come, a copy.")
      .def_property_readonly(
          "events",
          [](const Progress& self) {
            return own_rows(
                std::vector<Event>(self.events.begin(), self.events.begin() + self.event_count));
          },
          "Of the last judge(), in order, a structured array with the fields of Event, shape (k,).")
      .def_readonly("event_count", &Progress::event_count, "How many these are.");
  def_copy(made);
  def_repr(made, {"state"});
  m.def(
      "judge",
      [](const Task& task, const World& world, const std::vector<HapticSample>& samples,
         const std::vector<HapticCommand>& commands, double dt, Progress& progress) {
        require_positive("dt", dt);
        require_task(task, world, samples.size(), commands.size(), progress);
        judge(task, world, samples, commands, dt, progress);
      },
      "task"_a, "world"_a, "samples"_a, "commands"_a, "dt"_a, "progress"_a,
      "Judges a tick of dt [s] that has just been done: to be called once after every tick() with "
      "what that took and gave, one of each for each instrument. Nothing changes once the outcome "
      "is no longer running.");
}

}  // namespace

void require_fit(const Task& task, const Scene& scene) {
  bool fits = task.tool_radii.size() == scene.instruments.size() &&
              count_rigid(task) == scene.rigid.size() &&
              task.surfaces.size() == scene.bodies.size();
  for (std::size_t b = 0; fits && b < task.surfaces.size(); ++b) {
    fits = task.surfaces[b].triangles == scene.bodies[b].tissue.triangles;
  }
  if (!fits) refuse("task", "one of another scene", "one that build_task made for this scene");
}

void bind_task(py::module_& m) {
  bind_task_kinds(m);
  bind_place(m);
  bind_step(m);
  bind_limit(m);
  bind_surface_at_rest(m);
  bind_task_objects(m);
  bind_task_type(m);
  bind_states(m);
  bind_progress(m);
}

}  // namespace palpate::bindings
