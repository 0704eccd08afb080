// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {

template <>
py::dtype row_dtype<AabbTree::Node>() {
  using Node = AabbTree::Node;
  const auto shaped = [](const py::dtype& type, auto... shape) {
    return py::make_tuple(type, py::make_tuple(shape...));
  };
  const auto number = py::dtype::of<float>(), index = py::dtype::of<int>();
  py::list names, formats, offsets;
  for (const char* name : {"low", "high", "first", "count"}) names.append(name);
  for (int side = 0; side < 2; ++side) formats.append(shaped(number, 3, AabbTree::kWidth));
  for (int list = 0; list < 2; ++list) formats.append(shaped(index, AabbTree::kWidth));
  for (const std::size_t offset :
       {offsetof(Node, low), offsetof(Node, high), offsetof(Node, first), offsetof(Node, count)}) {
    offsets.append(offset);
  }
  return py::dtype(names, formats, offsets, sizeof(Node));
}

namespace {

template <class T>
ArrayOf<T> view_span(std::span<const T> table, py::handle owner) {
  return read_only(view_entries(const_cast<T*>(table.data()), table.size(), owner));
}

}  // namespace

void bind_tree(py::module_& m) {
  py::class_<AabbTree> tree(
      m, "AabbTree",
      "Axis-aligned boxes around the triangles of a deforming surface. Built once over the surface "
      "at rest; refit follows the deformation without changing the shape of the tree.");
  tree.def(py::init([](const Numbers& x, const Integers& triangles) {
             const auto xs = points(x, "x");
             const auto rows = copy_index_rows<3>(triangles, "triangles");
             const py::gil_scoped_release released;
             return AabbTree(xs, rows);
           }),
           "x"_a, "triangles"_a,
           "Raises ValueError for no triangles, an index out of range or a position that is not "
           "finite.");
  tree.def(
          "refit",
          [](AabbTree& self, const Numbers& x) {
            const auto xs = points(x, "x");
            require_fit(self, xs);
            self.refit(xs);
          },
          "x"_a, "Follows the surface to positions x; the same particle count as at the start.")
      .def(
          "nodes",
          [](const py::object& self) {
            const auto rows = self.cast<const AabbTree&>().nodes();
            return read_only(view_rows(rows.data(), rows.size(), self));
          },
          "Eight boxes each [m], rounded outwards, depth first, a structured array of shape (k,): "
          "low and high "
          "(3, 8) by axis and child, first and count (8,); a view.")
      .def("low", &AabbTree::low, "The corner of the box around the whole surface [m], shape (3,).")
      .def("high", &AabbTree::high, "The opposite corner [m], shape (3,).")
      .def(
          "leaf_triangles",
          [](const py::object& self) {
            return view_span(self.cast<const AabbTree&>().leaf_triangles(), self);
          },
          "triangles() in the sequence of order(), shape (t, 3); a view, read-only.")
      .def(
          "order",
          [](const py::object& self) {
            return view_span(self.cast<const AabbTree&>().order(), self);
          },
          "Triangles in the sequence of the leaves, shape (t,); a view, read-only.")
      .def(
          "triangles",
          [](const py::object& self) {
            return view_span(self.cast<const AabbTree&>().triangles(), self);
          },
          "Shape (t, 3); a view, read-only.");
  m.def("compute_query_cost", &compute_query_cost, "tree"_a,
        "[-] What a query of the tree costs on average, in nodes and leaves visited.");
  tree.attr("WIDTH") = AabbTree::kWidth;
  tree.attr("LEAF_SIZE") = AabbTree::kLeafSize;
  tree.attr("MAX_DEPTH") = AabbTree::kMaxDepth;
  def_copy(tree);
  def_summary(tree, [](const AabbTree& self) {
    return write_text(self.triangles().size(), " triangles in ", self.nodes().size(), " nodes");
  });
}

}  // namespace palpate::bindings
