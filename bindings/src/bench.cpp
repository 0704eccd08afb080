// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/bench.h"

#include "bindings.h"
#include "border.h"
#include "value.h"

namespace palpate::bindings {

using bench::BenchOptions;
using bench::BenchRow;

void bind_bench(py::module_& m) {
  const BenchOptions usual;
  py::class_<BenchRow> row(
      m, "BenchRow",
      "What one piece of work costs, beside the same work done naively in the same process.");
  row.def_readonly("work", &BenchRow::work, "'mss_step', 'refit', 'mms_tick', ...")
      .def_readonly("vertices", &BenchRow::vertices, "Of the surface.")
      .def_readonly("substeps", &BenchRow::substeps, "Of a tick; 0 for other work.")
      .def_readonly("median", &BenchRow::median, "[s] CPU time of the calling thread.")
      .def_readonly("p99", &BenchRow::p99, "[s]")
      .def_readonly("naive_median", &BenchRow::naive_median, "[s] of the naive form.")
      .def_readonly("ratio_to_naive", &BenchRow::ratio_to_naive,
                    "[-] naive_median / median: above 1 is faster than naive.")
      .def_readonly("elements", &BenchRow::elements,
                    "[-] Links, triangles, queries, ... that the time is for; 1 for a tick.")
      .def_readonly("share_of_bound", &BenchRow::share_of_bound,
                    "[-] The least time this machine needs, by its measured arithmetic and memory, "
                    "over median; 0 where no such time is stated.")
      .def_readonly("simd_target", &BenchRow::simd_target,
                    "'AVX3', 'AVX2', ...; empty for plain code.")
      .def_readonly("compiler_flags", &BenchRow::compiler_flags, "Of all forms alike.")
      .def("ns_per_element", &BenchRow::ns_per_element, "[ns]")
      .def_readonly("physics", &BenchRow::physics, "What is in it, in words.");
  def_value(row, &BenchRow::work, &BenchRow::vertices, &BenchRow::substeps, &BenchRow::median,
            &BenchRow::p99, &BenchRow::naive_median, &BenchRow::ratio_to_naive, &BenchRow::elements,
            &BenchRow::share_of_bound, &BenchRow::simd_target, &BenchRow::compiler_flags,
            &BenchRow::physics);
  def_repr(row, {"work", "vertices", "median", "p99", "naive_median", "ratio_to_naive",
                 "share_of_bound", "simd_target", "physics"});
  py::class_<BenchOptions> options(m, "BenchOptions", "What is timed, and for how long.");
  options
      .def(py::init([](double budget, int least_runs, const std::vector<std::string>& works,
                       const std::vector<int>& air_substeps, bool press) {
             return BenchOptions{budget, least_runs, works, air_substeps, press};
           }),
           py::kw_only(), "budget"_a = usual.budget, "least_runs"_a = usual.least_runs,
           "works"_a = usual.works, "air_substeps"_a = usual.air_substeps, "press"_a = usual.press)
      .def_readwrite("budget", &BenchOptions::budget,
                     "[s] of CPU time per row, the naive form not counted.")
      .def_readwrite("least_runs", &BenchOptions::least_runs,
                     "Fewer where a run takes so long that they would take 20 budgets.")
      .def_readwrite("works", &BenchOptions::works, "Of bench_works(); all where empty.")
      .def_readwrite("air_substeps", &BenchOptions::air_substeps,
                     "Of ticks with the hand in the air: a row for each.")
      .def_readwrite("press", &BenchOptions::press,
                     "And a row with a press held, at its own substeps.");
  def_value(options, &BenchOptions::budget, &BenchOptions::least_runs, &BenchOptions::works,
            &BenchOptions::air_substeps, &BenchOptions::press);
  def_repr(options, {"budget", "least_runs", "works", "air_substeps", "press"});
  m.def("bench_works", &bench::bench_works,
        "Every work this machine can do, in the order of the rows.");
  m.def(
      "run_bench",
      [](const Scene& mass_spring, const Scene& molecular, const BenchOptions& chosen) {
        require_built(mass_spring);
        require_built(molecular);
        const py::gil_scoped_release released;
        return bench::run_bench(mass_spring, molecular, chosen);
      },
      "mass_spring"_a, "molecular"_a, "options"_a = usual,
      "Times the steps, queries and ticks of two scenes on the same surface, one of the "
      "mass-spring "
      "and one of the molecular model. Raises RuntimeError where ours and the naive form disagree, "
      "ValueError where the scenes do not fit or a work is not known.");
  m.def("bench_body_works", &bench::bench_body_works,
        "Every work of bodies: walls of prisms, solids of springs and volumes, linear solids.");
  m.def(
      "run_body_bench",
      [](const Scene& scene, const BenchOptions& chosen) {
        require_built(scene);
        const py::gil_scoped_release released;
        return bench::run_body_bench(scene, chosen);
      },
      "scene"_a, "options"_a = usual,
      "Times the step and the tick of one body beside its naive form, as run_bench does. What is "
      "asked for and not of this kind of body is left out. A linear solid has one row in the air, "
      "since its ticks there have one substep. Raises as run_bench does, and ValueError for a "
      "tissue of another kind or under a skin.");
}

}  // namespace palpate::bindings
