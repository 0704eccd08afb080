// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/source_surface.h"

// One file for all of CGAL: every translation unit that sees it costs a minute or more to compile.

namespace palpate::authoring {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;

Point to_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Kernel::Triangle_3 to_triangle(const SurfaceMesh& mesh, const Triangle& t) {
  return {to_point(mesh.vertices[t[0]]), to_point(mesh.vertices[t[1]]),
          to_point(mesh.vertices[t[2]])};
}

Triangles to_triangles(const SurfaceMesh& mesh) {
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.push_back(to_triangle(mesh, t));
  return triangles;
}

/// Two triangles over the edge p q with the corners a and b overlap where they lie in one plane
/// with a and b on the same side of the edge.
bool overlap_beside_edge(const Point& p, const Point& q, const Point& a, const Point& b) {
  return CGAL::coplanar(p, q, a, b) && CGAL::coplanar_orientation(p, q, a, b) == CGAL::POSITIVE;
}

/// For each vertex the first of those that lie where it does: one that was split to take surfaces
/// apart is still a corner that both share.
std::vector<int> find_places(const Vec3Array& vertices) {
  std::vector<int> order(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int v) {
    return std::make_tuple(vertices[v].x(), vertices[v].y(), vertices[v].z());
  };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });
  std::vector<int> place(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    place[order[i]] = again ? place[order[i - 1]] : order[i];
  }
  return place;
}

/// Whether two triangles meet anywhere but in the corners they share.
class Crossing {
 public:
  explicit Crossing(const SurfaceMesh& mesh)
      : mesh_(mesh), triangles_(to_triangles(mesh)), place_(find_places(mesh.vertices)) {}

  bool operator()(int i, int j) const {
    const Triangle &s = mesh_.triangles[i], &t = mesh_.triangles[j];
    std::array<int, 3> mine{}, theirs{};  // corners of s and of t that are the same vertex
    int shared = 0;
    for (int c = 0; c < 3; ++c) {
      for (int d = 0; d < 3; ++d) {
        if (place_[s[c]] != place_[t[d]]) continue;
        mine[shared] = c;
        theirs[shared++] = d;
        break;
      }
    }
    if (shared == 3) return true;
    if (triangles_[i].is_degenerate() || triangles_[j].is_degenerate()) return false;
    if (shared == 2) {
      return overlap_beside_edge(point(s[mine[0]]), point(s[mine[1]]),
                                 point(s[3 - mine[0] - mine[1]]),
                                 point(t[3 - theirs[0] - theirs[1]]));
    }
    // of two triangles with one corner in common, one enters the other through its far edge
    if (shared == 1) return meets_far_edge(i, t, theirs[0]) || meets_far_edge(j, s, mine[0]);
    return CGAL::do_intersect(triangles_[i], triangles_[j]);
  }

 private:
  Point point(int vertex) const { return to_point(mesh_.vertices[vertex]); }

  bool meets_far_edge(int i, const Triangle& t, int corner) const {
    const Kernel::Segment_3 far(point(t[(corner + 1) % 3]), point(t[(corner + 2) % 3]));
    return CGAL::do_intersect(triangles_[i], far);
  }

  const SurfaceMesh& mesh_;
  Triangles triangles_;
  std::vector<int> place_;
};

struct OutOfBudget {};

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

std::vector<Box> build_boxes(const SurfaceMesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    boxes.emplace_back(to_triangle(mesh, mesh.triangles[i]).bbox(), static_cast<int>(i));
  }
  return boxes;
}

std::vector<int> list_hit(const std::vector<char>& hit) {
  std::vector<int> faces;
  for (std::size_t i = 0; i < hit.size(); ++i) {
    if (hit[i]) faces.push_back(static_cast<int>(i));
  }
  return faces;
}

}  // namespace

std::optional<std::vector<int>> find_self_intersecting_faces(const SurfaceMesh& mesh,
                                                             std::int64_t pair_budget) {
  const Crossing crosses(mesh);
  std::vector<Box> boxes = build_boxes(mesh);
  std::vector<char> hit(mesh.triangles.size(), 0);
  const auto examine = [&](const Box& a, const Box& b) {
    if (--pair_budget < 0) throw OutOfBudget{};
    if (hit[a.info()] && hit[b.info()]) return;
    if (crosses(a.info(), b.info())) hit[a.info()] = hit[b.info()] = 1;
  };

  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), examine);
  } catch (const OutOfBudget&) {
    return std::nullopt;
  }

  return list_hit(hit);
}

std::optional<CrossingGroups> find_crossing_groups(const SurfaceMesh& mesh,
                                                   std::span<const int> group,
                                                   std::int64_t pair_budget) {
  const Crossing crosses(mesh);
  std::vector<Box> boxes = build_boxes(mesh);
  std::vector<char> hit(mesh.triangles.size(), 0);
  std::set<std::array<int, 2>> pairs;
  const auto examine = [&](const Box& a, const Box& b) {
    if (--pair_budget < 0) throw OutOfBudget{};
    const int g = group[a.info()], h = group[b.info()];
    if (g == h) {
      if (hit[a.info()] && hit[b.info()]) return;
      if (crosses(a.info(), b.info())) hit[a.info()] = hit[b.info()] = 1;
      return;
    }
    const std::array pair{std::min(g, h), std::max(g, h)};
    if (!pairs.contains(pair) && crosses(a.info(), b.info())) pairs.insert(pair);
  };

  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), examine);
  } catch (const OutOfBudget&) {
    return std::nullopt;
  }
  return CrossingGroups{{pairs.begin(), pairs.end()}, list_hit(hit)};
}

struct SourceSurface::Tree {
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  explicit Tree(const SurfaceMesh& mesh)
      : triangles(to_triangles(mesh)), boxes(triangles.begin(), triangles.end()) {
    boxes.build();
  }

  Triangles triangles;
  Boxes boxes;
};

SourceSurface::SourceSurface(const SurfaceMesh& mesh) : tree_(std::make_unique<Tree>(mesh)) {}

SourceSurface::~SourceSurface() = default;

SourceSurface::Closest SourceSurface::find_closest(const Vec3& p) const {
  const auto [point, triangle] = tree_->boxes.closest_point_and_primitive(to_point(p));
  return {{point.x(), point.y(), point.z()},
          static_cast<int>(triangle - tree_->triangles.cbegin())};
}

}  // namespace palpate::authoring
