// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/decimate.h"

#include "bindings.h"

namespace palpate::authoring {

namespace py = pybind11;
using namespace pybind11::literals;

void bind_decimate(py::module_& m) {
  py::class_<DecimatedMesh>(m, "DecimatedMesh",
                            "A coarser surface, and how far it is from the one it was made of.")
      .def_readonly("mesh", &DecimatedMesh::mesh)
      .def_readonly("smallest_angle_before_deg", &DecimatedMesh::smallest_angle_before_deg,
                    "Right after the edges were collapsed, before the triangles were improved.")
      .def_readonly("smallest_angle_deg", &DecimatedMesh::smallest_angle_deg)
      .def_readonly("mean_distance", &DecimatedMesh::mean_distance,
                    "[m] from the new surface to the source.")
      .def_readonly("max_distance", &DecimatedMesh::max_distance, "[m]")
      .def_readonly("self_intersecting_faces", &DecimatedMesh::self_intersecting_faces)
      .def_readonly("kept_length", &DecimatedMesh::kept_length,
                    "[m] Of ridges and borders of regions that are kept as lines.")
      .def_readonly("left_out_length", &DecimatedMesh::left_out_length,
                    "[m] Of those that so few vertices have no room for.");
  m.def(
      "decimate",
      [](const SurfaceMesh& mesh, int vertex_count, std::vector<int> regions,
         std::vector<int> names, bool features) {
        return decimate(mesh, vertex_count, {std::move(regions), std::move(names), features});
      },
      "mesh"_a, "vertex_count"_a, "regions"_a = std::vector<int>(), "names"_a = std::vector<int>(),
      "features"_a = false, py::call_guard<py::gil_scoped_release>(),
      "Make a surface of exactly vertex_count vertices with well-shaped triangles. regions has a "
      "number for each triangle: borders between different ones stay on their lines; so do those "
      "of names where there are vertices enough. With features ridges do too, and thin parts count "
      "for more.");
}

}  // namespace palpate::authoring
