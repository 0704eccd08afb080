// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/mesh/mesh.h"

#include "bindings.h"
#include "border.h"
#include "palpate/sim/mesh/topology.h"
#include "value.h"

namespace palpate::bindings {

namespace {

SurfaceMesh make_mesh(const Numbers& vertices, const Integers& triangles) {
  SurfaceMesh mesh{copy_points(vertices, "vertices"), copy_index_rows<3>(triangles, "triangles")};
  require_triangles(mesh.triangles, mesh.vertices.size());
  return mesh;
}

void bind_types(py::module_& m) {
  py::class_<SurfaceMesh> mesh(m, "SurfaceMesh", "A triangulated surface, closed or open.");
  mesh.def(py::init(&make_mesh), "vertices"_a, "triangles"_a,
           "Copies vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from "
           "outside.");
  def_view(mesh, "vertices", &SurfaceMesh::vertices,
           "Positions [m], shape (n, 3); a view, so writing moves the vertices.");
  def_table(mesh, "triangles", &SurfaceMesh::triangles,
            "Vertex indices, shape (t, 3), counter-clockwise from outside; a view, read-only.");
  def_value(mesh, &SurfaceMesh::vertices, &SurfaceMesh::triangles);
  mesh.def("__repr__", [](const SurfaceMesh& self) {
    return "SurfaceMesh(" + std::to_string(self.vertices.size()) + " vertices, " +
           std::to_string(self.triangles.size()) + " triangles)";
  });

  py::class_<Topology> topology(m, "Topology", "Who is next to whom on a surface.");
  def_table(topology, "edges", &Topology::edges,
            "Vertex pairs, ends ascending, sorted, shape (e, 2); a view, read-only.");
  def_table(topology, "edge_triangles", &Topology::edge_triangles,
            "The one or two triangles of each edge, -1 for none, shape (e, 2); a view, read-only.");
  def_table(topology, "triangle_edges", &Topology::triangle_edges,
            "The edge opposite each corner, shape (t, 3); a view, read-only.");
  def_value(topology, &Topology::edges, &Topology::edge_triangles, &Topology::triangle_edges);
  def_summary(topology, [](const Topology& self) {
    return write_text(self.edges.size(), " edges, ", self.triangle_edges.size(), " triangles");
  });
}

void bind_topology(py::module_& m) {
  m.def(
      "build_topology",
      [](const Integers& triangles) {
        return build_topology(copy_index_rows<3>(triangles, "triangles"));
      },
      "triangles"_a,
      "Edges and their triangles. Only the first two triangles of an edge are kept; "
      "count_non_manifold_edges tells of others.");
  m.def(
      "count_non_manifold_edges",
      [](const Integers& triangles) {
        return count_non_manifold_edges(copy_index_rows<3>(triangles, "triangles"));
      },
      "triangles"_a,
      "Edges with more than two triangles, or whose two triangles run along it in the same "
      "direction.");
  m.def(
      "find_border_loops",
      [](const Integers& triangles) {
        std::vector<ArrayOf<int>> loops;
        for (auto& loop : find_border_loops(copy_index_rows<3>(triangles, "triangles"))) {
          loops.push_back(own(std::move(loop)));
        }
        return loops;
      },
      "triangles"_a,
      "Border loops as arrays of vertices, shape (k,), in the direction that keeps the surface on "
      "the left; "
      "empty for a closed surface. A vertex where two loops touch ends up in both.");
  m.def(
      "find_shells",
      [](int vertex_count, const Integers& triangles) {
        const auto rows = copy_index_rows<3>(triangles, "triangles");
        require_triangles(rows, static_cast<std::size_t>(to_count(vertex_count, "vertex_count")));
        return own(find_shells(vertex_count, rows));
      },
      "vertex_count"_a, "triangles"_a,
      "The shell number of every vertex, shape (n,), counted from 0 in order of first vertex; "
      "vertices no "
      "triangle uses get -1.");
  m.def(
      "compute_euler_number",
      [](const Integers& triangles) {
        return compute_euler_number(copy_index_rows<3>(triangles, "triangles"));
      },
      "triangles"_a, "V - E + F over the vertices in use.");
  m.def(
      "is_closed",
      [](const Integers& triangles) {
        return is_closed(copy_index_rows<3>(triangles, "triangles"));
      },
      "triangles"_a, "Whether the surface has no border.");
}

void bind_measures(py::module_& m) {
  m.def("compute_area", &compute_area, "mesh"_a, "[m²]");
  m.def("compute_volume", py::overload_cast<const SurfaceMesh&>(&compute_volume), "mesh"_a,
        "[m³], positive when the triangles run counter-clockwise from outside; a number without "
        "meaning for an open surface.");
  m.def(
      "compute_vertex_areas",
      [](const SurfaceMesh& mesh) { return own(compute_vertex_areas(mesh)); }, "mesh"_a,
      "[m²] per vertex, shape (n,): a third of every triangle around it. Sums to compute_area.");
  m.def(
      "compute_vertex_normals",
      [](const Numbers& vertices, const Integers& triangles) {
        const auto x = points(vertices, "vertices");
        const auto rows = copy_index_rows<3>(triangles, "triangles");
        require_triangles(rows, x.size());
        return own(compute_vertex_normals(x, rows));
      },
      "vertices"_a, "triangles"_a,
      "[-] Unit normals per vertex, weighted by area, shape (n, 3); zero where the triangles "
      "cancel "
      "out.");
  m.def("compute_smallest_angle", &compute_smallest_angle, "mesh"_a,
        "Smallest corner angle of any triangle [rad].");
  m.def(
      "compute_bounds",
      [](const Numbers& vertices) {
        const auto [low, high] = compute_bounds(points(vertices, "vertices"));
        return std::make_pair(low, high);
      },
      "vertices"_a, "Lower and upper corner of the axis-aligned box [m], shape (3,) each.");
  m.def(
      "compute_diagonal",
      [](const Numbers& vertices) { return compute_diagonal(points(vertices, "vertices")); },
      "vertices"_a, "[m] from corner to corner of the bounding box.");
}

}  // namespace

void bind_mesh(py::module_& m) {
  bind_types(m);
  m.def("validate", py::overload_cast<const SurfaceMesh&>(&validate), "mesh"_a,
        "Raises ValueError, naming the first offender, unless every vertex is finite and used, "
        "every index in range, no triangle uses a vertex twice or has no area, no edge has more "
        "than two triangles, and neighbours agree on which side is outside.");
  bind_topology(m);
  bind_measures(m);
  bind_solid_mesh(m);
}

}  // namespace palpate::bindings
