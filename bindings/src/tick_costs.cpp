// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/tick/costs.h"
#include "value.h"

namespace palpate::bindings {
namespace {

void bind_tick_costs(py::module_& m) {
  py::class_<BodyCost> body(m, "BodyCost", "What a body cost in one tick, [s].");
  body.def(py::init<>())
      .def_readonly("follow", &BodyCost::follow, "[s] Its tree brought to where its surface is.")
      .def_readonly("step", &BodyCost::step, "[s] All its substeps.")
      .def_readonly("guard", &BodyCost::guard, "[s] Checked, and brought up to date.")
      .def("total", &BodyCost::total, "[s] All of these.");
  def_value(body, &BodyCost::follow, &BodyCost::step, &BodyCost::guard);
  def_repr(body, {"follow", "step", "guard"});

  py::class_<InstrumentCost> instrument(m, "InstrumentCost",
                                        "What an instrument cost in one tick, [s].");
  instrument.def(py::init<>())
      .def_readonly("read", &InstrumentCost::read, "[s] Hand and button.")
      .def_readonly("balance", &InstrumentCost::balance, "[s] In the air, all substeps.")
      .def("total", &InstrumentCost::total, "[s] All of these.");
  def_value(instrument, &InstrumentCost::read, &InstrumentCost::balance);
  def_repr(instrument, {"read", "balance"});

  py::class_<PairCost> pair(m, "PairCost",
                            "What an instrument cost with a body in one tick, [s]. Where a tool "
                            "may touch several bodies at once it is balanced among all of them, "
                            "and the time for that is shared out by their candidates. Or two "
                            "bodies, a body and scenery, or rigid bodies with all they touch.");
  pair.def(py::init<>())
      .def_readonly("candidates", &PairCost::candidates, "[s] Found in the body's tree.")
      .def_readonly("contact", &PairCost::contact,
                    "[s] The tool balanced against the body, all substeps.")
      .def("total", &PairCost::total, "[s] All of these.");
  def_value(pair, &PairCost::candidates, &PairCost::contact);
  def_repr(pair, {"candidates", "contact"});

  py::class_<TickCosts> costs(
      m, "TickCosts",
      "What the last tick cost, in the order of the parts of its World; zeros unless it measures.");
  costs.def(py::init<>());
  def_elements(costs, "bodies", &TickCosts::bodies, "A tuple.");
  def_elements(costs, "instruments", &TickCosts::instruments, "A tuple.");
  def_elements(costs, "pairs", &TickCosts::pairs, "A tuple.");
  def_elements(costs, "body_pairs", &TickCosts::body_pairs, "As Scene.body_pairs, a tuple.");
  def_elements(costs, "scenery", &TickCosts::scenery,
               "Bodies that it stops, as World.scenery_contacts, a tuple.");
  costs.def_readonly("rigid", &TickCosts::rigid, "All rigid bodies, a PairCost.");
  costs.def_readonly("tick", &TickCosts::tick, "[s] the whole");
  def_value(costs, &TickCosts::bodies, &TickCosts::instruments, &TickCosts::pairs,
            &TickCosts::body_pairs, &TickCosts::scenery, &TickCosts::rigid, &TickCosts::tick);
  def_repr(costs, {"tick", "bodies", "instruments", "pairs", "body_pairs", "scenery", "rigid"});
}

void bind_scene_costs(py::module_& m) {
  py::class_<Percentiles> percentiles(m, "Percentiles",
                                      "[s] Right within 0.4 %, the largest exactly.");
  percentiles.def_readonly("median", &Percentiles::median, "[s] Half of them are shorter.")
      .def_readonly("p99", &Percentiles::p99, "[s] 99 % of them are shorter.")
      .def_readonly("p99_9", &Percentiles::p99_9, "[s] 99.9 % of them are shorter.")
      .def_readonly("max", &Percentiles::max, "[s] The longest.");
  def_value(percentiles, &Percentiles::median, &Percentiles::p99, &Percentiles::p99_9,
            &Percentiles::max);
  def_repr(percentiles, {"median", "p99", "p99_9", "max"});

  py::class_<SceneCosts> costs(m, "SceneCosts", "What the ticks of a run cost.");
  costs.def(py::init<>());
  costs.def_readonly("ticks", &SceneCosts::ticks, "How many.")
      .def_readonly("tick", &SceneCosts::tick, "The whole.");
  def_elements(costs, "bodies", &SceneCosts::bodies,
               "All stages of each, as Scene.bodies, a tuple.");
  def_elements(costs, "instruments", &SceneCosts::instruments, "As Scene.instruments, a tuple.");
  def_elements(costs, "pairs", &SceneCosts::pairs,
               "Every instrument with every body, as World.pairs, a tuple.");
  def_elements(costs, "body_pairs", &SceneCosts::body_pairs, "As Scene.body_pairs, a tuple.");
  def_elements(costs, "scenery", &SceneCosts::scenery,
               "Bodies that it stops, as World.scenery_contacts, a tuple.");
  costs.def_readonly("rigid", &SceneCosts::rigid,
                     "All rigid bodies with what they touch; zeros without any.");
  costs.def_readonly("alarm", &SceneCosts::alarm, "What ended the run early; false for nothing.");
  def_value(costs, &SceneCosts::ticks, &SceneCosts::tick, &SceneCosts::bodies,
            &SceneCosts::instruments, &SceneCosts::pairs, &SceneCosts::body_pairs,
            &SceneCosts::scenery, &SceneCosts::rigid, &SceneCosts::alarm);
  def_repr(costs, {"ticks", "tick", "bodies", "instruments", "pairs", "body_pairs", "scenery",
                   "rigid", "alarm"});
}

}  // namespace

void bind_costs(py::module_& m) {
  bind_tick_costs(m);
  bind_scene_costs(m);
}

}  // namespace palpate::bindings
