// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "palpate/authoring/inspect_mesh.h"
#include "palpate/authoring/measure_exposure.h"
#include "palpate/authoring/part_touching_edges.h"
#include "palpate/authoring/repair_mesh.h"
#include "palpate/authoring/self_intersections.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

py::dict histogram_dict(const Histogram& histogram) {
  return py::dict("limits"_a = histogram.limits, "counts"_a = histogram.counts);
}

/// How many there are of what the report lists by number.
py::dict count_faults(const MeshReport& report) {
  return py::dict("non_manifold_edges"_a = report.non_manifold_edges,
                  "non_manifold_vertices"_a = report.pinched_vertices.size(),
                  "disagreeing_edges"_a = report.disagreeing_edges,
                  "coincident_vertices"_a = report.coincident_vertices,
                  "duplicate_triangles"_a = report.duplicate_faces.size(),
                  "degenerate_triangles"_a = report.degenerate_faces.size(),
                  "self_intersecting_faces"_a = report.self_intersecting_faces);
}

py::dict as_dict(const MeshReport& report) {
  py::dict found(
      "vertices"_a = report.vertices, "triangles"_a = report.triangles, "shells"_a = report.shells,
      "euler_number"_a = report.euler_number, "border_loops"_a = report.border_loops,
      "border_lengths_mm"_a = report.border_lengths_mm, "genus"_a = report.genus,
      "closed"_a = report.closed, "outward"_a = report.outward, "orientable"_a = report.orientable,
      "smallest_angle_deg"_a = report.smallest_angle_deg,
      "angles_deg"_a = histogram_dict(report.angles_deg), "edges_mm"_a = report.edges_mm,
      "edge_lengths_mm"_a = histogram_dict(report.edge_lengths_mm),
      "thinnest_mm"_a = report.thinnest_mm, "thin_triangles"_a = report.thin_faces.size(),
      "thickness_looks"_a = report.thickness_looks, "size_mm"_a = report.size_mm,
      "volume_ml"_a = report.volume_ml);
  found.attr("update")(count_faults(report));
  return found;
}

void bind_histogram(py::module_& m) {
  py::class_<Histogram>(m, "Histogram",
                        "How many values lie between one limit and the next; the last limit "
                        "belongs to the last count.")
      .def_readonly("limits", &Histogram::limits)
      .def_readonly("counts", &Histogram::counts);
}

void bind_report(py::module_& m) {
  py::class_<MeshReport>(m, "MeshReport",
                         "What a surface is like; None where a number is not defined.")
      .def_readonly("vertices", &MeshReport::vertices)
      .def_readonly("triangles", &MeshReport::triangles)
      .def_readonly("shells", &MeshReport::shells)
      .def_readonly("border_loops", &MeshReport::border_loops,
                    "Vertices of each border loop, longest first; empty when closed.")
      .def_readonly("euler_number", &MeshReport::euler_number)
      .def_readonly("border_lengths_mm", &MeshReport::border_lengths_mm,
                    "Of those loops, in their order.")
      .def_readonly("genus", &MeshReport::genus)
      .def_readonly("closed", &MeshReport::closed)
      .def_readonly("outward", &MeshReport::outward)
      .def_readonly("non_manifold_edges", &MeshReport::non_manifold_edges)
      .def_readonly("pinched_vertices", &MeshReport::pinched_vertices,
                    "Where surfaces touch in a point alone, ascending.")
      .def_readonly("disagreeing_edges", &MeshReport::disagreeing_edges,
                    "Edges whose two triangles run along them the same way.")
      .def_readonly("coincident_vertices", &MeshReport::coincident_vertices,
                    "Vertices in the very place of one before.")
      .def_readonly("duplicate_faces", &MeshReport::duplicate_faces,
                    "Triangles of the same three vertices as one before, ascending.")
      .def_readonly("degenerate_faces", &MeshReport::degenerate_faces,
                    "Triangles of no height, ascending.")
      .def_readonly("self_intersecting_faces", &MeshReport::self_intersecting_faces,
                    "Faces, not pairs; None where counting would take too long.")
      .def_readonly("crossing_faces", &MeshReport::crossing_faces,
                    "Those triangles, ascending; empty where they are not counted.")
      .def_readonly("orientable", &MeshReport::orientable,
                    "Whether neighbours can agree on a side; not of a Moebius band.")
      .def_readonly("smallest_angle_deg", &MeshReport::smallest_angle_deg)
      .def_readonly("angles_deg", &MeshReport::angles_deg,
                    "Every corner of every triangle, in steps of ten degrees.")
      .def_readonly("edges_mm", &MeshReport::edges_mm, "Shortest, median and longest.")
      .def_readonly("edge_lengths_mm", &MeshReport::edge_lengths_mm, "In steps of equal ratio.")
      .def_readonly("thinnest_mm", &MeshReport::thinnest_mm,
                    "Of the body behind a triangle; None where no look behind one meets another.")
      .def_readonly("thickness_looks", &MeshReport::thickness_looks,
                    "Triangles behind which the body ends somewhere; at most 4000 are looked "
                    "behind.")
      .def_readonly("thin_faces", &MeshReport::thin_faces,
                    "Of those, the triangles behind which the body is thinner than half their "
                    "edges, ascending.")
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
  bind_histogram(m);
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
  m.def("measure_exposure", &measure_exposure, "mesh"_a, py::call_guard<py::gil_scoped_release>(),
        "The part of each shell's triangles that are seen from outside past all others, in the "
        "order of palpate.find_shells.");
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
