// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "palpate/authoring/inspect_mesh.h"
#include "palpate/authoring/part_touching_edges.h"
#include "palpate/authoring/repair_mesh.h"
#include "palpate/authoring/self_intersections.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

py::dict as_dict(const MeshReport& report) {
  return py::dict(
      "vertices"_a = report.vertices, "triangles"_a = report.triangles, "shells"_a = report.shells,
      "border_loops"_a = report.border_loops, "genus"_a = report.genus, "closed"_a = report.closed,
      "outward"_a = report.outward, "non_manifold_edges"_a = report.non_manifold_edges,
      "self_intersecting_faces"_a = report.self_intersecting_faces,
      "orientable"_a = report.orientable, "smallest_angle_deg"_a = report.smallest_angle_deg,
      "size_mm"_a = report.size_mm, "volume_ml"_a = report.volume_ml);
}

void bind_report(py::module_& m) {
  py::class_<MeshReport>(m, "MeshReport",
                         "What a surface is like; None where a number is not defined.")
      .def_readonly("vertices", &MeshReport::vertices)
      .def_readonly("triangles", &MeshReport::triangles)
      .def_readonly("shells", &MeshReport::shells)
      .def_readonly("border_loops", &MeshReport::border_loops,
                    "Vertices of each border loop, longest first; empty when closed.")
      .def_readonly("genus", &MeshReport::genus)
      .def_readonly("closed", &MeshReport::closed)
      .def_readonly("outward", &MeshReport::outward)
      .def_readonly("non_manifold_edges", &MeshReport::non_manifold_edges)
      .def_readonly("self_intersecting_faces", &MeshReport::self_intersecting_faces,
                    "Faces, not pairs; None where counting would take too long.")
      .def_readonly("crossing_faces", &MeshReport::crossing_faces,
                    "Those triangles, ascending; empty where they are not counted.")
      .def_readonly("orientable", &MeshReport::orientable,
                    "Whether neighbours can agree on a side; not of a Moebius band.")
      .def_readonly("smallest_angle_deg", &MeshReport::smallest_angle_deg)
      .def_readonly("size_mm", &MeshReport::size_mm)
      .def_readonly("volume_ml", &MeshReport::volume_ml)
      .def("as_dict", &as_dict, "The fields by name, ready for JSON.");
}

void bind_repaired(py::module_& m) {
  py::class_<RepairedMesh>(m, "RepairedMesh",
                           "A surface without the faults a triangle list can have, and what was "
                           "done for that.")
      .def_readonly("mesh", &RepairedMesh::mesh)
      .def_readonly("duplicate_triangles", &RepairedMesh::duplicate_triangles)
      .def_readonly("degenerate_triangles", &RepairedMesh::degenerate_triangles)
      .def_readonly("unused_vertices", &RepairedMesh::unused_vertices)
      .def_readonly("split_vertices", &RepairedMesh::split_vertices)
      .def_readonly("parted_edges", &RepairedMesh::parted_edges)
      .def_readonly("dropped_islands", &RepairedMesh::dropped_islands)
      .def_readonly("turned_triangles", &RepairedMesh::turned_triangles)
      .def_readonly("orientable", &RepairedMesh::orientable);
}

}  // namespace

void bind_inspect(py::module_& m) {
  bind_report(m);
  bind_repaired(m);
  m.def("inspect_mesh", &inspect_mesh, "mesh"_a, py::call_guard<py::gil_scoped_release>(),
        "Measure a surface as it is.");
  m.def("repair_mesh", &repair_mesh, "mesh"_a, py::call_guard<py::gil_scoped_release>(),
        "Drop what is double, flat, unused or a speck, take apart what touches only in a vertex or "
        "along an edge, orient outwards.");
  m.def(
      "cut_crowded_edges",
      [](const SurfaceMesh& mesh) {
        SurfaceMesh cut = mesh;
        cut_crowded_edges(cut);
        return cut;
      },
      "mesh"_a, py::call_guard<py::gil_scoped_release>(),
      "Cut along every edge of more than two triangles: the flattest two that agree stay "
      "neighbours, "
      "and so on; each that is left ends there.");
  m.def(
      "find_self_intersecting_faces",
      [](const SurfaceMesh& mesh) { return find_self_intersecting_faces(mesh); }, "mesh"_a,
      py::call_guard<py::gil_scoped_release>(),
      "Triangles that cross or overlap others, ascending; None where finding them would take too "
      "long.");
  m.def(
      "find_crossing_groups",
      [](const SurfaceMesh& mesh, const std::vector<int>& group) {
        if (group.size() != mesh.triangles.size()) {
          throw std::invalid_argument("find_crossing_groups: group: got " +
                                      std::to_string(group.size()) + " numbers, expected one for " +
                                      "each of " + std::to_string(mesh.triangles.size()) +
                                      " triangles");
        }
        const auto found = find_crossing_groups(mesh, group);
        using Pair = std::pair<std::vector<std::array<int, 2>>, std::vector<int>>;
        return found ? std::optional(Pair(found->pairs, found->own_faces)) : std::nullopt;
      },
      "mesh"_a, "group"_a, py::call_guard<py::gil_scoped_release>(),
      "Pairs of groups that cross, and triangles that cross others of their own group; None where "
      "finding them would take too long. group has a number for each triangle.");
}

}  // namespace palpate::authoring
