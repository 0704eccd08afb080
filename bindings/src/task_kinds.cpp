// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include "bindings.h"
#include "palpate/sim/task/task.h"
#include "task_bindings.h"

namespace palpate::bindings {

void bind_task_kinds(pybind11::module_& m) {
  pybind11::native_enum<PlaceKind>(m, "PlaceKind", "enum.Enum",
                                   "Where a step or a limit is, of a tissue at rest.")
      .value("region", PlaceKind::region, "A set of vertices of the surface.")
      .value("path", PlaceKind::path, "A line over it, followed from its first point to its last.")
      .value("ball", PlaceKind::ball, "All of it within a radius of a point.")
      .value("object", PlaceKind::object, "A rigid body, wherever that is.")
      .value("space", PlaceKind::space, "A sphere that stands still in the scene's frame.")
      .finalize();
  pybind11::native_enum<TaskVerb>(m, "TaskVerb", "enum.Enum", "What a step asks for.")
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
      .value("look", TaskVerb::look,
             "The place in the middle of a camera's picture, half of it or more not hidden.")
      .value("remove", TaskVerb::remove, "An object wholly outside a space.")
      .value("carry", TaskVerb::carry, "The middle of an object inside a space.")
      .finalize();
  pybind11::native_enum<TaskMeasure>(m, "TaskMeasure", "enum.Enum", "What a limit watches.")
      .value("force", TaskMeasure::force, "[N] on the hand; with a place, the part there.")
      .value("force_rate", TaskMeasure::force_rate, "[N/s] of it, over 20 ms.")
      .value("contact", TaskMeasure::contact, "[N] any contact at the place at all.")
      .value("depth", TaskMeasure::depth, "[m] of the tip below the surface at rest.")
      .value("distance", TaskMeasure::distance, "[m] of what is held from where it is at rest.")
      .value("speed", TaskMeasure::speed, "[m/s] of the tool, over 20 ms.")
      .value("clearance", TaskMeasure::clearance, "[m] from the tip's surface to a ball.")
      .value("off_path", TaskMeasure::off_path, "[m] from what is touched to a path.")
      .value("strain", TaskMeasure::strain,
             "[-] the largest principal one of what the tool touches or holds; with an object, of "
             "all that is pushed within 2 mm of it.")
      .value("loose", TaskMeasure::loose,
             "[-] 1 where the jaws do not hold an object between them, else 0.")
      .value("out_of_view", TaskMeasure::out_of_view,
             "[-] 1 where no camera has the tip in its picture, or it is hidden, else 0.")
      .value("object_force", TaskMeasure::object_force,
             "[N] all with which tissue pushes an object.")
      .value("pad_pressure", TaskMeasure::pad_pressure,
             "[Pa] of jaws on what is touched of their pads.")
      .value("torn", TaskMeasure::torn, "[-] 1 once a tissue has torn, else 0.")
      .finalize();
  pybind11::native_enum<LimitConsequence>(m, "LimitConsequence", "enum.Enum",
                                          "What becomes of a limit that opens.")
      .value("warn", LimitConsequence::warn)
      .value("error", LimitConsequence::error)
      .value("end", LimitConsequence::end)
      .finalize();
  pybind11::native_enum<Outcome>(m, "Outcome", "enum.IntEnum", "How an attempt at a task came out.")
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
  pybind11::native_enum<TaskEvent>(
      m, "TaskEvent", "enum.IntEnum",
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
  pybind11::native_enum<StepStatus>(m, "StepStatus", "enum.Enum", "How far a step is.")
      .value("waiting", StepStatus::waiting)
      .value("active", StepStatus::active)
      .value("done", StepStatus::done)
      .finalize();
}

}  // namespace palpate::bindings
