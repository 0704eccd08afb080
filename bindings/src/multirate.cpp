// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/multirate/slow_tissue.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_local_model(py::module_& m) {
  py::class_<LocalModel> model(
      m, "LocalModel",
      "What a tissue does to a tool near some place, to first order: F(p) = f0 - K (p - p0), and "
      "nothing where that would pull.");
  model.def(py::init([](double time, const Vec3& position, const Vec3& force, const Vec3& normal,
                        const Mat3& stiffness, bool held) {
              return LocalModel{time, position, force, normal, stiffness, held};
            }),
            py::kw_only(), "time"_a = 0.0, "position"_a = Vec3::Zero().eval(),
            "force"_a = Vec3::Zero().eval(), "normal"_a = Vec3::Zero().eval(),
            "stiffness"_a = Mat3::Zero().eval(), "held"_a = false);
  model.def_readwrite("time", &LocalModel::time, "[s] of the hand that it was taken at.");
  def_vector(model, "position", &LocalModel::position, "[m] p0 of the tool.");
  def_vector(model, "force", &LocalModel::force, "[N] f0 on the tool there.");
  def_vector(model, "normal", &LocalModel::normal,
             "[-] Unit, out of the tissue; 0 where none is near.");
  model.def_readwrite("stiffness", &LocalModel::stiffness, "[N/m] K, shape (3, 3), symmetric.")
      .def_readwrite("held", &LocalModel::held, "The force pulls as well: the tool is attached.");
  def_value(model, &LocalModel::time, &LocalModel::position, &LocalModel::force,
            &LocalModel::normal, &LocalModel::stiffness, &LocalModel::held);
  def_repr(model, {"time", "position", "force", "normal", "stiffness", "held"});
}

}  // namespace

void bind_multirate(py::module_& m) {
  py::native_enum<LocalForceMode>(m, "LocalForceMode", "enum.Enum",
                                  "What is felt between two exchanges with a slow tissue.")
      .value("local_stiffness", LocalForceMode::local_stiffness,
             "F(p) at the tool's place of this very tick.")
      .value("hold", LocalForceMode::hold, "The last force told.")
      .value("extrapolation", LocalForceMode::extrapolation,
             "The line through the last two forces told, over time.")
      .finalize();
  bind_local_model(m);
  py::class_<SlowTissue> slow(
      m, "SlowTissue",
      "A scene whose tissue moves at a rate of its own beside hands that are read faster. Hands "
      "are told to it every so many ticks; it follows them until the next exchange, and is then "
      "told as a local model, which is one to two intervals old while it is felt.");
  slow.def(py::init([](const Scene& scene, double hand_rate, int ticks, LocalForceMode mode) {
             require_built(scene);
             const py::gil_scoped_release released;
             return SlowTissue(scene, hand_rate, ticks, mode);
           }),
           "scene"_a, "hand_rate"_a, "ticks"_a, "mode"_a = LocalForceMode::local_stiffness,
           py::keep_alive<1, 2>(),
           "Hands are read at hand_rate [Hz] and told every `ticks` of theirs; the tissue ticks at "
           "Scene.rate. Raises ValueError where an interval is not a whole number of its ticks.")
      .def(
          "tick",
          [](SlowTissue& self, const HapticSample& sample) {
            const py::gil_scoped_release released;
            return self.tick(sample);
          },
          "sample"_a, "One tick of the hand of a scene with one instrument: the force to be felt.")
      .def(
          "tick",
          [](SlowTissue& self, const std::vector<HapticSample>& samples) {
            const py::gil_scoped_release released;
            return self.tick(samples);
          },
          "samples"_a, "One tick of the hands, with a sample and a command for each instrument.")
      .def("model", &SlowTissue::model, "instrument"_a = 0,
           "What an instrument is rendered from; a copy. Raises IndexError for one that there is "
           "not.",
           py::return_value_policy::copy)
      .def("alarm", &SlowTissue::alarm, "The first of the tissue.", py::return_value_policy::copy)
      .def("interval", &SlowTissue::interval, "[s] between exchanges.")
      .def("tissue_ticks", &SlowTissue::tissue_ticks, "Ticks of the tissue in an interval.");
}

}  // namespace palpate::bindings
