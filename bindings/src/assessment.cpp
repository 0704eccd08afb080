// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/assessment.h"

#include <pybind11/stl.h>

#include "bindings.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

using scenario::DrawnTask;
using scenario::DrawnValue;

void bind_assessment(py::module_& m) {
  m.attr("MOST_PARAMETERS") = scenario::kMostParameters;
  m.attr("MOST_LEVELS") = scenario::kMostLevels;
  m.attr("MOST_TEXTS") = scenario::kMostTexts;

  py::class_<DrawnValue> value(m, "DrawnValue", "A parameter of an attempt.");
  value.def(py::init<>())
      .def_readonly("name", &DrawnValue::name, "As the assessment calls it.")
      .def_readonly("unit", &DrawnValue::unit, "N, m, s, rad, m3, place, or 1 for none.")
      .def_readonly("value", &DrawnValue::value, "[N], [m] ... in that unit; 0 of a place.")
      .def_readonly("place", &DrawnValue::place, "Its id; else empty.");
  def_value(value, &DrawnValue::name, &DrawnValue::unit, &DrawnValue::value, &DrawnValue::place);
  def_repr(value, {"name", "unit", "value", "place"});

  py::class_<DrawnTask> drawn(m, "DrawnTask",
                              "What is judged in one attempt, and the names of its rows.");
  drawn.def(py::init<>())
      .def_property_readonly(
          "task",
          [](const py::object& self) {
            return py::cast(&self.cast<DrawnTask&>().task,
                            py::return_value_policy::reference_internal, self);
          },
          "The Task, of build_task.")
      .def_readonly("id", &DrawnTask::id, "Of the assessment.")
      .def_readonly("version", &DrawnTask::version, "Of the assessment.")
      .def_readonly("level", &DrawnTask::level, "Empty where there are none.")
      .def_readonly("seed", &DrawnTask::seed, "Of the parameters that are drawn.")
      .def_readonly("sha256", &DrawnTask::sha256, "Of the assessment, whatever level and seed.")
      .def_readonly("steps", &DrawnTask::steps, "Their ids, in order of the task's.")
      .def_readonly("limits", &DrawnTask::limits, "Likewise.")
      .def_readonly("places", &DrawnTask::places,
                    "Likewise; of a path with another width, once more.")
      .def_readonly("values", &DrawnTask::values, "A DrawnValue each, by name.")
      .def_readonly("inclusion", &DrawnTask::inclusion,
                    "Id of the place whose inclusion, a stiff spot, this attempt has; else empty.");
  def_value(drawn, &DrawnTask::task, &DrawnTask::id, &DrawnTask::version, &DrawnTask::level,
            &DrawnTask::seed, &DrawnTask::sha256, &DrawnTask::steps, &DrawnTask::limits,
            &DrawnTask::places, &DrawnTask::values, &DrawnTask::inclusion,
            &DrawnTask::inclusion_body);
  def_repr(drawn, {"id", "version", "level", "seed"});

  m.def("draw", &scenario::draw, "seed"_a, "id"_a, "name"_a,
        "[-] A number from 0 to below 1 for a parameter of a scenario, the same wherever it is "
        "drawn: of the first 53 bits of the SHA-256 of seed, id and name, in text with a line feed "
        "between them.");
  m.def("list_levels", &scenario::list_levels, "scenario"_a,
        "The levels of a scenario's assessment; empty where there are none.");
  m.def("draw_task", &scenario::draw_task, "scenario"_a, "level"_a = "", "seed"_a = 0,
        py::call_guard<py::gil_scoped_release>(),
        "The task of an attempt. An empty level is normal, or the first where there is no such. "
        "Raises ValueError for a level that is not there, a scenario without an assessment, and "
        "one that cannot be judged, naming the place in it, what it got and what was expected.");
  m.def("draw_scene", &scenario::draw_scene, "scenario"_a, "drawn"_a,
        py::call_guard<py::gil_scoped_release>(),
        "The scene of an attempt: the scenario's, with the constants of the inclusion that was "
        "drawn, and as many substeps as those need. Raises ValueError for constants that cannot be "
        "built.");
}

}  // namespace palpate::bindings
