// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/tree/queries.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_point_queries(py::module_& m) {
  py::class_<SurfacePoint> point(m, "SurfacePoint", "A point of a surface, found by a query.");
  point.def_readonly("triangle", &SurfacePoint::triangle, "Row of the surface.")
      .def_readonly("distance", &SurfacePoint::distance, "[m] from where the query began.");
  def_vector(point, "weights", &SurfacePoint::weights, "[-] Barycentric, from 0 to 1, sum 1.");
  def_vector(point, "point", &SurfacePoint::point, "[m]");
  def_value(point, &SurfacePoint::triangle, &SurfacePoint::weights, &SurfacePoint::point,
            &SurfacePoint::distance);
  def_repr(point, {"triangle", "weights", "point", "distance"});

  m.def("find_closest_on_triangle", &find_closest_on_triangle, "p"_a, "a"_a, "b"_a, "c"_a,
        "The closest point of one triangle; degenerate triangles are segments or points. Fills "
        "weights, point and distance.");
  m.def(
      "find_closest_point",
      [](const AabbTree& tree, const Numbers& x, const Vec3& p, double max_distance) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        require_finite("p", p);
        return find_closest_point(tree, xs, p, max_distance);
      },
      "tree"_a, "x"_a, "p"_a, "max_distance"_a = std::numeric_limits<double>::infinity(),
      "The closest surface point within max_distance [m], or None.");
}

void bind_way_queries(py::module_& m) {
  m.def(
      "find_segment_hit",
      [](const AabbTree& tree, const Numbers& x, const Vec3& from, const Vec3& to) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        require_finite("from_", from);
        require_finite("to", to);
        return find_segment_hit(tree, xs, from, to);
      },
      "tree"_a, "x"_a, "from_"_a, "to"_a,
      "The first triangle on the segment from from_ to to, both sides counting; None if it is "
      "clear. No segment slips between triangles that share an edge.");
  m.def(
      "find_ray_hit",
      [](const AabbTree& tree, const Numbers& x, const Vec3& origin, const Vec3& direction) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        require_finite("origin", origin);
        require_finite("direction", direction);
        if (direction.isZero(0.0)) refuse("direction", "(0, 0, 0)", "any other");
        return find_ray_hit(tree, xs, origin, direction);
      },
      "tree"_a, "x"_a, "origin"_a, "direction"_a,
      "The first triangle along a ray, or None; direction of any length but zero, distances in "
      "metres.");
}

void bind_range_queries(py::module_& m) {
  m.def(
      "find_in_sphere",
      [](const AabbTree& tree, const Numbers& x, const Vec3& centre, double radius,
         const IntegersOut& out) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        require_finite("centre", centre);
        return find_in_sphere(tree, xs, centre, radius, entries_out(out, "out"));
      },
      "tree"_a, "x"_a, "centre"_a, "radius"_a, "out"_a,
      "Triangles with a point inside the ball or on it; ascending, written into out, an int32 "
      "array. Returns how many there are; only as many as out holds are written.");
  m.def(
      "find_near_segment",
      [](const AabbTree& tree, const Numbers& x, const Vec3& from, const Vec3& to, double radius,
         const IntegersOut& out) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        require_finite("from_", from);
        require_finite("to", to);
        return find_near_segment(tree, xs, from, to, radius, entries_out(out, "out"));
      },
      "tree"_a, "x"_a, "from_"_a, "to"_a, "radius"_a, "out"_a,
      "Triangles whose boxes, grown by radius [m], meet the segment: a superset of those that "
      "touch the capsule; ascending, written into out, an int32 array. Returns how many there "
      "are; only as many as out holds are written.");
}

}  // namespace

void bind_queries(py::module_& m) {
  bind_point_queries(m);
  bind_way_queries(m);
  bind_range_queries(m);
}

}  // namespace palpate::bindings
