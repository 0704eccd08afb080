// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/mesh/mesh.h"
#include "value.h"

namespace palpate::bindings {

namespace {

SolidMesh make_solid(const Numbers& vertices, const Integers& tetrahedra) {
  SolidMesh solid{copy_points(vertices, "vertices"), copy_index_rows<4>(tetrahedra, "tetrahedra")};
  require_below<4>(solid.tetrahedra, solid.vertices.size(), "tetrahedra");
  return solid;
}

}  // namespace

void bind_solid_mesh(py::module_& m) {
  py::class_<SolidMesh> solid(m, "SolidMesh", "A body cut into tetrahedra.");
  solid.def(py::init(&make_solid), "vertices"_a, "tetrahedra"_a,
            "Copies vertices [m], shape (n, 3), and tetrahedra, shape (t, 4), each with "
            "(b - a) x (c - a) towards d.");
  def_view(solid, "vertices", &SolidMesh::vertices,
           "Positions [m], shape (n, 3); a view, so writing moves the vertices.");
  def_table(solid, "tetrahedra", &SolidMesh::tetrahedra,
            "Vertex indices, shape (t, 4); a view, read-only.");
  def_value(solid, &SolidMesh::vertices, &SolidMesh::tetrahedra);
  solid.def("__repr__", [](const SolidMesh& self) {
    return "SolidMesh(" + std::to_string(self.vertices.size()) + " vertices, " +
           std::to_string(self.tetrahedra.size()) + " tetrahedra)";
  });

  m.def("validate", py::overload_cast<const SolidMesh&>(&validate), "solid"_a,
        "Raises ValueError, naming the first offender, unless every vertex is finite and used, "
        "every tetrahedron has a positive volume, and no face has more than two.");
  m.def("compute_volume",
        py::overload_cast<const Vec3&, const Vec3&, const Vec3&, const Vec3&>(&compute_volume),
        "a"_a, "b"_a, "c"_a, "d"_a,
        "[m³] of the tetrahedron a b c d, negative where it is turned inside out.");
  m.def("compute_volume", py::overload_cast<const SolidMesh&>(&compute_volume), "solid"_a,
        "[m³] in all.");
  m.def(
      "find_boundary", [](const SolidMesh& its) { return own(find_boundary(its)); }, "solid"_a,
      "The faces that only one tetrahedron has, counter-clockwise from outside, (f, 3).");
  m.def(
      "find_edges", [](const SolidMesh& its) { return own(find_edges(its)); }, "solid"_a,
      "Vertex pairs along which some tetrahedron has an edge, ends ascending, sorted, (e, 2).");
  m.def("compute_smallest_dihedral", &compute_smallest_dihedral, "solid"_a,
        "[rad] The smallest angle between two faces of any tetrahedron.");
}

}  // namespace palpate::bindings
