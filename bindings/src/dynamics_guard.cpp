// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/tick/private/check_input.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_alarm(py::module_& m) {
  py::native_enum<AlarmKind>(m, "AlarmKind", "enum.Enum",
                             "What may be wrong with a running tissue.")
      .value("none", AlarmKind::none)
      .value("not_finite", AlarmKind::not_finite, "index: particle")
      .value("moved_far", AlarmKind::moved_far,
             "index: particle; more than 0.3 of the shortest rest length in one step")
      .value("overstretched", AlarmKind::overstretched, "index: link; strain above 2")
      .value("collapsed", AlarmKind::collapsed, "index: link; shorter than 0.05 of its rest length")
      .value("energy", AlarmKind::energy,
             "index: -1; elastic and kinetic energy exceed what was given")
      .value("inverted", AlarmKind::inverted,
             "index: tetrahedron; volume below 0.05 of that at rest")
      .value("pressed_deep", AlarmKind::pressed_deep,
             "index: vertex of the surface; a linear solid moved beyond SHALLOW")
      .value("invalid_input", AlarmKind::invalid_input,
             "index: TickInput; a tick cannot use what it was given")
      .value("not_solved", AlarmKind::not_solved,
             "index: -1; an implicit step, of value [s], found no solution")
      .finalize();
  py::class_<Alarm> alarm(m, "Alarm",
                          "What is wrong with a running tissue, as a value; false for nothing.");
  alarm.def(py::init<>())
      .def_readwrite("kind", &Alarm::kind, "What is wrong; none for nothing.")
      .def_readwrite("index", &Alarm::index,
                     "Particle, link, ...: AlarmKind says of what; -1 for none.")
      .def_readwrite("value", &Alarm::value,
                     "What was measured, in the unit of its kind: [m], [-] or [J].")
      .def_readwrite("limit", &Alarm::limit, "What it may be, likewise: [m], [-] or [J].")
      .def_readwrite("time", &Alarm::time, "[s]")
      .def("__bool__", [](const Alarm& self) { return static_cast<bool>(self); });
  def_value(alarm, &Alarm::kind, &Alarm::index, &Alarm::value, &Alarm::limit, &Alarm::time);
  def_repr(alarm, {"kind", "index", "value", "limit", "time"});
}

void bind_input(py::module_& m) {
  m.attr("FARTHEST_HAND") = kFarthestHand;
  py::native_enum<TickInput>(m, "TickInput", "enum.IntEnum",
                             "What a tick cannot use: the index of an invalid_input alarm.")
      .value("time", TickInput::time, "[s] of the sample")
      .value("position", TickInput::position, "[m] of the sample, its largest coordinate")
      .value("orientation", TickInput::orientation, "of the sample")
      .value("velocity", TickInput::velocity, "[m/s] of the sample")
      .value("grip", TickInput::grip, "[rad] of the sample")
      .value("dt", TickInput::dt, "[s]")
      .value("scene", TickInput::scene, "not the scene of the world")
      .value("tool_radius", TickInput::tool_radius, "[m]")
      .value("tool_stiffness", TickInput::tool_stiffness, "[N/m^3]")
      .value("coupling_stiffness", TickInput::coupling_stiffness, "[N/m]")
      .value("coupling_force_max", TickInput::coupling_force_max, "[N]")
      .value("hold_stiffness", TickInput::hold_stiffness, "[N/m]")
      .value("gravity", TickInput::gravity, "[m/s^2]")
      .value("substeps", TickInput::substeps)
      .value("substeps_max", TickInput::substeps_max)
      .value("tool_friction", TickInput::tool_friction, "[-]")
      .finalize();
}

void bind_memory(py::module_& m) {
  py::class_<Guard> guard(m, "Guard", "The memory of the blow-up alarm between checks.");
  guard.def(py::init([](const TissueModel& model, const Vec3& gravity, const State& state) {
              require_fit(model, state);
              return Guard(model, gravity, state);
            }),
            "model"_a, "gravity"_a, "state"_a, "Of a tissue as it is now.");
  def_view(guard, "last_position", &Guard::last_position,
           "[m] at the last check that found nothing wrong, shape (n, 3); a view.");
  guard.def_readwrite("last_time", &Guard::last_time, "[s] of the last check.")
      .def_readwrite("shortest_rest_length", &Guard::shortest_rest_length, "[m]")
      .def_readwrite("start_energy", &Guard::start_energy, "[J] elastic and kinetic.")
      .def_readwrite("last_energy", &Guard::last_energy, "[J] elastic and kinetic.")
      .def_readwrite("work", &Guard::work,
                     "[J] done by pushes, gravity and pressure since the start.")
      .def_readwrite("unnoticed_energy", &Guard::unnoticed_energy,
                     "[J] less than can be seen or felt.")
      .def_readwrite("given_energy", &Guard::given_energy,
                     "[J] of start and work, less what has long been lost.")
      .def_readwrite("reference_energy", &Guard::reference_energy,
                     "[J] the most that has lately been given.")
      .def_readwrite("rising_steps", &Guard::rising_steps,
                     "Checks in a row at which energy rose without work.")
      .def_readwrite("strained_checks", &Guard::strained_checks,
                     "Checks in a row at which a link was out of its bounds.")
      .def_readwrite("torn_energy", &Guard::torn_energy,
                     "[J] of what has torn: the model has it, and the tissue has not.")
      .def_readwrite("torn_links", &Guard::torn_links,
                     "1 of each link that has torn and may have any length, springs before bonds; "
                     "a list, empty where nothing tears.");
  def_value(guard, &Guard::last_position, &Guard::last_time, &Guard::shortest_rest_length,
            &Guard::start_energy, &Guard::last_energy, &Guard::work, &Guard::given_energy,
            &Guard::unnoticed_energy, &Guard::reference_energy, &Guard::rising_steps,
            &Guard::strained_checks, &Guard::torn_energy, &Guard::torn_links);
  def_repr(guard, {"last_time", "work", "last_energy", "reference_energy", "rising_steps"});
  m.def(
      "check",
      [](const TissueModel& model, const Vec3& gravity, const State& state, double work,
         Guard& memory, int steps) {
        require_fit(model, state);
        require_fit(model, memory);
        require_positive("steps", steps);
        return check(model, gravity, state, work, memory, steps);
      },
      "model"_a, "gravity"_a, "state"_a, "work"_a, "guard"_a, "steps"_a = 1,
      "Checks a tissue after a step; the first thing wrong comes back. work [J] is what pushes "
      "have done to the tissue since the last check; what gravity and pressure have done is found "
      "here. steps taken since then may have moved a particle that many times as far.");
}

}  // namespace

void bind_guard(py::module_& m) {
  bind_alarm(m);
  bind_input(m);
  bind_memory(m);
}

}  // namespace palpate::bindings
