// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "palpate/authoring/fill_holes.h"
#include "palpate/authoring/fill_interior.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

void bind_fill(py::module_& m) {
  m.attr("MOST_HOLE_EDGES") = kMostHoleEdges;
  py::class_<FilledHoles>(m, "FilledHoles", "A surface with some of its holes closed.")
      .def_readonly("mesh", &FilledHoles::mesh,
                    "Vertices and triangles of the source first, in their order.")
      .def_readonly("filled", &FilledHoles::filled, "Holes that are closed now.")
      .def_readonly("left_open", &FilledHoles::left_open,
                    "Those asked for that no patch was found for, ascending.");
  m.def(
      "fill_holes",
      [](const SurfaceMesh& mesh, const std::vector<int>& holes) {
        return fill_holes(mesh, holes);
      },
      "mesh"_a, "holes"_a, py::call_guard<py::gil_scoped_release>(),
      "Close holes, numbered as palpate.find_border_loops lists them, with refined and smoothly "
      "bent patches; those whose patch would cross the surface stay open. Raises ValueError.");
  m.attr("MOST_TETRAHEDRA") = kMostTetrahedra;
  m.def("choose_cell_size", &choose_cell_size, "surface"_a, "tetrahedron_count"_a,
        py::call_guard<py::gil_scoped_release>(),
        "[m] The cell size at which about tetrahedron_count tetrahedra fill the surface; good to a "
        "third.");
  m.attr("COUNT_ERROR") = kCountError;
  m.def(
      "fill_to_count",
      [](const SurfaceMesh& surface, int tetrahedron_count, std::vector<int> fine, double ratio) {
        return fill_to_count(surface, tetrahedron_count, {std::move(fine), ratio});
      },
      "surface"_a, "tetrahedron_count"_a, "fine"_a = std::vector<int>(), "ratio"_a = 1.0,
      py::call_guard<py::gil_scoped_release>(),
      "tetrahedron_count tetrahedra, to a tenth, that fill a closed surface; cells at its "
      "triangles "
      "`fine` are smaller by `ratio` than far away from them. Raises ValueError as fill_interior "
      "does.");
  m.def("fill_interior", &fill_interior, "surface"_a, "cell_size"_a,
        py::call_guard<py::gil_scoped_release>(),
        "Tetrahedra of about cell_size [m] that fill a closed surface. Raises ValueError for a "
        "surface that is open, faces inwards or crosses itself.");
}

}  // namespace palpate::authoring
