// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/task/task.h"

#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "border.h"
#include "rows.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_kinds(py::module_& m) {
  py::native_enum<PlaceKind>(m, "PlaceKind", "enum.Enum",
                             "Where on a tissue a step or a limit is, at rest.")
      .value("region", PlaceKind::region, "A set of vertices of the surface.")
      .value("path", PlaceKind::path, "A line over it, followed from its first point to its last.")
      .value("ball", PlaceKind::ball, "All of it within a radius of a point.")
      .finalize();
  py::native_enum<TaskVerb>(m, "TaskVerb", "enum.Enum", "What a step asks for.")
      .value("touch", TaskVerb::touch, "Contact at the place.")
      .value("hold", TaskVerb::hold, "Contact there, and the force within its band.")
      .value("push", TaskVerb::push, "Contact there, and force and depth within their bands.")
      .value("pull", TaskVerb::pull,
             "A hold there, moved outwards, and force and distance within their bands.")
      .value("grasp", TaskVerb::grasp, "A hold there.")
      .value("release", TaskVerb::release, "No hold there; anywhere, for no place.")
      .value("trace", TaskVerb::trace,
             "A share of a path touched in order, with the force within its band.")
      .value("find", TaskVerb::find, "A click while what is touched is there.")
      .finalize();
  py::native_enum<TaskMeasure>(m, "TaskMeasure", "enum.Enum", "What a limit watches.")
      .value("force", TaskMeasure::force, "[N] on the hand; with a place, the part there.")
      .value("force_rate", TaskMeasure::force_rate, "[N/s] of it, over 20 ms.")
      .value("contact", TaskMeasure::contact, "[N] any contact at the place at all.")
      .value("depth", TaskMeasure::depth, "[m] of the tip below the surface at rest.")
      .value("distance", TaskMeasure::distance, "[m] of what is held from where it is at rest.")
      .value("speed", TaskMeasure::speed, "[m/s] of the tool, over 20 ms.")
      .value("clearance", TaskMeasure::clearance, "[m] from the tip's surface to a ball.")
      .value("off_path", TaskMeasure::off_path, "[m] from what is touched to a path.")
      .value("strain", TaskMeasure::strain,
             "[-] the largest principal one of what the tool touches or holds.")
      .finalize();
  py::native_enum<LimitConsequence>(m, "LimitConsequence", "enum.Enum",
                                    "What becomes of a limit that opens.")
      .value("warn", LimitConsequence::warn)
      .value("error", LimitConsequence::error)
      .value("end", LimitConsequence::end)
      .finalize();
  py::native_enum<Outcome>(m, "Outcome", "enum.IntEnum", "How an attempt at a task came out.")
      .value("running", Outcome::running)
      .value("done", Outcome::done)
      .value("failed", Outcome::failed, "More errors than it may have, or a limit that ends it.")
      .value("timed_out", Outcome::timed_out, "Of ticks: a pause takes no time.")
      .value("left", Outcome::left, "Ended by the trainee.")
      .value("device_fault", Outcome::device_fault, "The device failed, or gave no force any more.")
      .value("diverged", Outcome::diverged, "An alarm: the tissue could not be simulated on.")
      .value("interrupted", Outcome::interrupted, "The program ended; the record has no end.")
      .finalize();
  // an integer in Python too, to be compared with the column of a structured array
  py::native_enum<TaskEvent>(m, "TaskEvent", "enum.IntEnum",
                             "Kinds of an Event that a judge tells of, beside those of EventKind.")
      .value("step_begun", TaskEvent::step_begun, "index: step of the task")
      .value("step_done", TaskEvent::step_done, "index: step; value: how long [s] it has taken")
      .value("step_overdue", TaskEvent::step_overdue, "index: step; value: its time limit [s]")
      .value("click_missed", TaskEvent::click_missed,
             "index: step; value: how far [m] from the place, -1 where nobody can tell")
      .value("limit_opened", TaskEvent::limit_opened, "index: limit; value: of its measure")
      .value("limit_closed", TaskEvent::limit_closed,
             "index: limit; value: how long [s] it was open")
      .value("task_ended", TaskEvent::task_ended, "index: Outcome; value: [s] since the task began")
      .finalize();
  py::native_enum<StepStatus>(m, "StepStatus", "enum.Enum", "How far a step is.")
      .value("waiting", StepStatus::waiting)
      .value("active", StepStatus::active)
      .value("done", StepStatus::done)
      .finalize();
}

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
                              "Where on a tissue a step or a limit is: of the tissue at rest, "
                              "which moves with it.");
  place
      .def(py::init([](PlaceKind kind, int body, const std::vector<int>& vertices,
                       const Vec3Array& points, double radius) {
             return TaskPlace{kind, body, vertices, points, radius, {}, {}};
           }),
           py::kw_only(), "kind"_a = PlaceKind::ball, "body"_a = 0,
           "vertices"_a = std::vector<int>(), "points"_a = Vec3Array(), "radius"_a = 0.0)
      .def_readwrite("kind", &TaskPlace::kind, "What it is.")
      .def_readwrite("body", &TaskPlace::body, "Of the scene.")
      .def_readwrite("vertices", &TaskPlace::vertices, "Of a region: of the body's surface.")
      .def_readwrite("points", &TaskPlace::points,
                     "[m] shape (k, 3) when set: of a path two or more, of a ball its centre.")
      .def_readwrite("radius", &TaskPlace::radius,
                     "[m] of a ball; of a path, how far beside it still counts as on it.")
      .def_readonly("members", &TaskPlace::members,
                    "Of a region: per vertex of the surface 1 or 0; filled in by build_task.")
      .def_readonly("arc_length", &TaskPlace::arc_length,
                    "[m] of a path: per point, from its beginning; filled in by build_task.");
  def_value(place, &TaskPlace::kind, &TaskPlace::body, &TaskPlace::vertices, &TaskPlace::points,
            &TaskPlace::radius, &TaskPlace::members, &TaskPlace::arc_length);
  def_repr(place, {"kind", "body", "radius"});
}

void bind_step(py::module_& m) {
  py::class_<TaskStep> step(m, "TaskStep", "Something that a trainee is asked to do.");
  step.def(py::init([](TaskVerb verb, int instrument, int place, const Band& force,
                       const Band& depth, const Band& distance, double duration, double share,
                       double time_limit, const std::vector<int>& after) {
             return TaskStep{verb,     instrument, place, force,      depth,
                             distance, duration,   share, time_limit, after};
           }),
           py::kw_only(), "verb"_a = TaskVerb::touch, "instrument"_a = 0, "place"_a = -1,
           "force"_a = Band(), "depth"_a = Band(), "distance"_a = Band(), "duration"_a = 0.0,
           "share"_a = 1.0, "time_limit"_a = 0.0, "after"_a = std::vector<int>())
      .def_readwrite("verb", &TaskStep::verb, "What it asks for.")
      .def_readwrite("instrument", &TaskStep::instrument, "Of the scene.")
      .def_readwrite("place", &TaskStep::place,
                     "Of the task; -1 for none, which only release may have.")
      .def_readwrite("force", &TaskStep::force, "[N] size of what the hand feels.")
      .def_readwrite("depth", &TaskStep::depth, "[m] of the tip below the surface at rest.")
      .def_readwrite("distance", &TaskStep::distance,
                     "[m] of what is held from where it is at rest.")
      .def_readwrite("duration", &TaskStep::duration,
                     "[s] for which it must be so; gaps of up to 0.1 s are left out.")
      .def_readwrite("share", &TaskStep::share, "[-] of a path, 0 to 1.")
      .def_readwrite("time_limit", &TaskStep::time_limit,
                     "[s] since it began; once longer is an error. 0 for none.")
      .def_readwrite("after", &TaskStep::after, "Steps that must be done before it begins.");
  def_value(step, &TaskStep::verb, &TaskStep::instrument, &TaskStep::place, &TaskStep::force,
            &TaskStep::depth, &TaskStep::distance, &TaskStep::duration, &TaskStep::share,
            &TaskStep::time_limit, &TaskStep::after);
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
  task.def(
          py::init([](const std::vector<TaskPlace>& places, const std::vector<TaskStep>& steps,
                      const std::vector<TaskLimit>& limits, double time_limit, int errors_at_most) {
            return Task{places, steps, limits, time_limit, errors_at_most, {}, {}};
          }),
          py::kw_only(), "places"_a = py::tuple(), "steps"_a = py::tuple(),
          "limits"_a = py::tuple(), "time_limit"_a = 0.0, "errors_at_most"_a = -1,
          "Copies what it is given; build_task checks it.")
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
          "surfaces", [](const Task& self) { return py::tuple(py::cast(self.surfaces)); },
          "A TaskSurface for each body, a tuple of copies; filled in by build_task.");
  def_value(task, &Task::places, &Task::steps, &Task::limits, &Task::time_limit,
            &Task::errors_at_most, &Task::surfaces, &Task::tool_radii);
  def_summary(task, [](const Task& self) {
    return write_text(self.steps.size(), " steps, ", self.limits.size(), " limits, ",
                      self.time_limit, " s");
  });
  m.attr("MOST_STEPS") = kMostSteps;
  m.attr("MOST_LIMITS") = kMostLimits;
  m.attr("MOST_PLACES") = kMostPlaces;
  m.def(
      "is_of_task", [](const Event& event) { return is_of_task(event); }, "event"_a,
      "Whether its kind is one of TaskEvent.");
  m.def(
      "is_kind", [](const Event& event, TaskEvent kind) { return is_kind(event, kind); }, "event"_a,
      "kind"_a, "Whether its kind is that.");
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

void require_task(const Task& task, const World& world, std::size_t samples, std::size_t commands,
                  const Progress& progress) {
  const std::size_t instruments = world.instruments.size();
  if (task.tool_radii.size() != instruments || task.surfaces.size() != world.bodies.size()) {
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
              task.surfaces.size() == scene.bodies.size();
  for (std::size_t b = 0; fits && b < task.surfaces.size(); ++b) {
    fits = task.surfaces[b].triangles == scene.bodies[b].tissue.triangles;
  }
  if (!fits) refuse("task", "one of another scene", "one that build_task made for this scene");
}

void bind_task(py::module_& m) {
  bind_kinds(m);
  bind_place(m);
  bind_step(m);
  bind_limit(m);
  bind_surface_at_rest(m);
  bind_task_type(m);
  bind_states(m);
  bind_progress(m);
}

}  // namespace palpate::bindings
