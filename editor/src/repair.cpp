// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "palpate/authoring/remesh_surface.h"
#include "palpate/authoring/remove_crossings.h"
#include "palpate/authoring/smooth_surface.h"
#include "palpate/authoring/stitch_borders.h"
#include "palpate/authoring/wrap_surface.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

void bind_results(py::module_& m) {
  py::class_<UncrossedMesh>(m, "UncrossedMesh",
                            "What one round made of a surface that crosses itself.")
      .def_readonly("mesh", &UncrossedMesh::mesh)
      .def_readonly("replaced_triangles", &UncrossedMesh::replaced_triangles)
      .def_readonly("dropped_pieces", &UncrossedMesh::dropped_pieces);
  py::class_<StitchedMesh>(m, "StitchedMesh",
                           "A surface whose borders were joined where they lie on each other.")
      .def_readonly("mesh", &StitchedMesh::mesh)
      .def_readonly("split_edges", &StitchedMesh::split_edges)
      .def_readonly("joined_vertices", &StitchedMesh::joined_vertices);
  py::class_<SurfaceDistance>(m, "SurfaceDistance",
                              "How far the points of one surface are from another.")
      .def_readonly("mean", &SurfaceDistance::mean, "[m] over the area.")
      .def_readonly("least", &SurfaceDistance::least, "[m] One point is at least so far away.")
      .def_readonly("most", &SurfaceDistance::most, "[m] No point is further away.");
  py::class_<DroppedPiece>(m, "DroppedPiece", "What of a surface hung together and is gone.")
      .def_readonly("triangles", &DroppedPiece::triangles)
      .def_readonly("size", &DroppedPiece::size, "[m] From corner to corner.")
      .def_readonly("middle", &DroppedPiece::middle, "[m] Of its box.");
  py::class_<WrappedMesh>(m, "WrappedMesh", "A surface around another one, and what it cost.")
      .def_readonly("mesh", &WrappedMesh::mesh)
      .def_readonly("to_source", &WrappedMesh::to_source, "From the new surface to the source.")
      .def_readonly("from_source", &WrappedMesh::from_source,
                    "From what is seen of the source from outside to the new surface.")
      .def_readonly("volume", &WrappedMesh::volume, "[m³] inside the new surface.")
      .def_readonly("dropped", &WrappedMesh::dropped,
                    "Pieces of the source that lie inside, the largest first.");
}

}  // namespace

void bind_repair(py::module_& m) {
  bind_results(m);
  m.attr("SHARP_EDGE") = kSharpEdge;
  m.def("remove_crossings", &remove_crossings, "mesh"_a, "rings"_a,
        py::call_guard<py::gil_scoped_release>(),
        "Take out the triangles that cross others with `rings` rings around them, and close what "
        "was opened with patches that cross nothing. Raises ValueError.");
  m.def("stitch_borders", &stitch_borders, "mesh"_a, "tolerance"_a,
        py::call_guard<py::gil_scoped_release>(),
        "Join borders that lie within `tolerance` [m] of each other, T-junctions too.");
  m.def("smooth_surface", &smooth_surface, "mesh"_a, "steps"_a,
        py::call_guard<py::gil_scoped_release>(),
        "Smooth without shrinking: a closed surface keeps its volume, borders stay. Raises "
        "ValueError.");
  m.def("wrap_surface", &wrap_surface, "mesh"_a, "alpha"_a,
        py::call_guard<py::gil_scoped_release>(),
        "Wrap any triangles in a closed surface that crosses nothing; what is narrower than alpha "
        "[m] is bridged. Raises ValueError.");
  m.def(
      "remesh_surface",
      [](const SurfaceMesh& mesh, const std::vector<double>& edge_lengths) {
        return remesh_surface(mesh, edge_lengths);
      },
      "mesh"_a, "edge_lengths"_a, py::call_guard<py::gil_scoped_release>(),
      "Even triangles with edges about as long as asked for at each vertex [m]; borders and sharp "
      "edges stay. Raises ValueError.");
  m.def(
      "measure_distance",
      [](const SurfaceMesh& mesh, const SurfaceMesh& onto) {
        return measure_distance(mesh, onto, SourceSurface(onto));
      },
      "mesh"_a, "onto"_a, py::call_guard<py::gil_scoped_release>(),
      "How far the points of a surface are from another.");
  m.def(
      "measure_seen_distance",
      [](const SurfaceMesh& mesh, const SurfaceMesh& onto) {
        return measure_seen_distance(mesh, SourceSurface(onto));
      },
      "mesh"_a, "onto"_a, py::call_guard<py::gil_scoped_release>(),
      "How far what is seen of a surface from outside is from another; `most` within a hundredth "
      "of its diagonal.");
}

}  // namespace palpate::authoring
