// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/queries.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "palpate/sim/contact/box.h"

namespace palpate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// the largest distance asked for; a box that is missed measures infinity and is never wanted
constexpr double kMost = std::numeric_limits<double>::max();

/// Nodes still to visit, each with the least a triangle in it can offer.
class Stack {
 public:
  void push(int node, double least) noexcept {
    assert(size_ < AabbTree::kMaxDepth);
    entries_[static_cast<std::size_t>(size_++)] = {node, least};
  }
  /// The next node that can offer no more than `most`; -1 when there is none.
  int pop(double most) noexcept {
    while (size_ > 0) {
      const Entry& entry = entries_[static_cast<std::size_t>(--size_)];
      if (entry.least <= most) return entry.node;
    }
    return -1;
  }

 private:
  struct Entry {
    int node;
    double least;
  };
  std::array<Entry, AabbTree::kMaxDepth> entries_;
  int size_ = 0;
};

/// Visits the leaves of a tree, nearer child first. `measure(node)` is the least that a triangle
/// in the node's box can offer, `most()` what is still wanted, `visit(triangle)` takes one.
template <class Measure, class Most, class Visit>
void traverse(const AabbTree& tree, Measure measure, Most most, Visit visit) noexcept {
  const auto nodes = tree.nodes();
  if (nodes.empty()) return;
  Stack stack;
  stack.push(0, measure(nodes[0]));
  for (int i = stack.pop(most()); i >= 0; i = stack.pop(most())) {
    const AabbTree::Node* node = &nodes[static_cast<std::size_t>(i)];
    while (node && node->count == 0) {
      int near = static_cast<int>(node - nodes.data()) + 1, far = node->first;
      double near_least = measure(nodes[static_cast<std::size_t>(near)]);
      double far_least = measure(nodes[static_cast<std::size_t>(far)]);
      if (far_least < near_least) {
        std::swap(near, far);
        std::swap(near_least, far_least);
      }
      if (far_least <= most()) stack.push(far, far_least);
      node = near_least <= most() ? &nodes[static_cast<std::size_t>(near)] : nullptr;
    }
    if (!node) continue;
    for (int k = node->first; k < node->first + node->count; ++k) {
      visit(tree.order()[static_cast<std::size_t>(k)]);
    }
  }
}

/// The corners of a triangle.
struct Corners {
  Corners(const AabbTree& tree, std::span<const Vec3> x, int triangle) noexcept
      : t(tree.triangles()[static_cast<std::size_t>(triangle)]),
        a(x[static_cast<std::size_t>(t[0])]),
        b(x[static_cast<std::size_t>(t[1])]),
        c(x[static_cast<std::size_t>(t[2])]) {}
  const Triangle& t;
  const Vec3 &a, &b, &c;
};

bool is_better(double distance, int triangle, const SurfacePoint& best) noexcept {
  if (distance != best.distance) return distance < best.distance;
  return best.triangle < 0 || triangle < best.triangle;
}

/// Squares a distance so that no square whose rounded root is that distance lies above it.
double square_upwards(double distance) noexcept {
  return distance * distance * (1.0 + 4.0 * kEpsilon);
}

/// [m] How far rounding may shift points of this box or of a way.
double compute_slack(const Vec3& low, const Vec3& high, const Vec3& from, const Vec3& to) noexcept {
  const Vec3 largest =
      low.cwiseAbs().cwiseMax(high.cwiseAbs()).cwiseMax(from.cwiseAbs()).cwiseMax(to.cwiseAbs());
  return 16.0 * kEpsilon * largest.maxCoeff();
}

double compute_slack(const AabbTree& tree, const Vec3& from, const Vec3& to) noexcept {
  if (tree.nodes().empty()) return 0.0;
  return compute_slack(tree.nodes().front().low, tree.nodes().front().high, from, to);
}

/// A way seen along its largest component, which turns the crossing of a triangle into a
/// question about signs in the plane.
struct Shear {
  explicit Shear(const Vec3& direction) noexcept {
    direction.cwiseAbs().maxCoeff(&kz);
    kx = (kz + 1) % 3;
    ky = (kz + 2) % 3;
    sx = direction[kx] / direction[kz];
    sy = direction[ky] / direction[kz];
    sz = 1.0 / direction[kz];
  }
  Vec3 apply(const Vec3& p) const noexcept {
    return {p[kx] - sx * p[kz], p[ky] - sy * p[kz], sz * p[kz]};
  }
  int kx, ky, kz;
  double sx, sy, sz;
};

// weights of a triangle seen edge on are noise; a crossing whose point lies farther than this
// part of the triangle's extent beside the way is none
constexpr double kBeside = 1e-6;

/// The crossing of a way with a triangle [Woop13]: in sheared coordinates the way is the z axis,
/// and it passes inside where the three edge functions u, v, w have one sign. Neighbours compute
/// the function of their common edge from the same products, so one of the two sees the way pass.
/// Its ends count, by `tolerance` in parameters of the way.
std::optional<Vec3> find_crossing(const Shear& shear, const Way& way, const Corners& corners,
                                  double tolerance, double& parameter) noexcept {
  const Vec3 a = shear.apply(corners.a - way.from);
  const Vec3 b = shear.apply(corners.b - way.from);
  const Vec3 c = shear.apply(corners.c - way.from);
  const double u = c.x() * b.y() - c.y() * b.x();
  const double v = a.x() * c.y() - a.y() * c.x();
  const double w = b.x() * a.y() - b.y() * a.x();
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return std::nullopt;
  const double determinant = u + v + w;
  if (determinant == 0.0) return std::nullopt;

  const Vec3 weights = Vec3(u, v, w) / determinant;
  const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
  if (!(point.z() >= -tolerance && point.z() <= way.end + tolerance)) return std::nullopt;
  const double extent = a.head<2>()
                            .cwiseAbs()
                            .cwiseMax(b.head<2>().cwiseAbs())
                            .cwiseMax(c.head<2>().cwiseAbs())
                            .maxCoeff();
  if (!(point.head<2>().cwiseAbs().maxCoeff() <= kBeside * extent)) return std::nullopt;
  parameter = std::clamp(point.z(), 0.0, way.end);
  return weights;
}

/// One triangle on its own: nothing here depends on the tree, so neither does the answer.
std::optional<SurfacePoint> find_hit(const Shear& shear, Way way, double length,
                                     const Corners& corners) noexcept {
  const Box box = bound_triangle(corners.a, corners.b, corners.c);
  way.grow = compute_slack(box.low, box.high, way.from, way.from);
  const double in = enter_box(way, box.low, box.high);
  if (in > kMost) return std::nullopt;
  double parameter = 0.0;
  const auto w = find_crossing(shear, way, corners, way.grow / length, parameter);
  if (!w) return std::nullopt;
  // no triangle is reached before its box: with this, pruning by boxes is exact
  return SurfacePoint{-1, *w, (*w)[0] * corners.a + (*w)[1] * corners.b + (*w)[2] * corners.c,
                      std::max(parameter, in) * length};
}

/// The first triangle along `way`; `length` [m] per parameter.
std::optional<SurfacePoint> find_first_hit(const AabbTree& tree, std::span<const Vec3> x,
                                           const Way& way, double length) noexcept {
  const Shear shear(way.direction);
  SurfacePoint best;
  best.distance = kMost;
  const auto measure = [&](const AabbTree::Node& node) noexcept {
    return enter_box(way, node.low, node.high) * length;
  };
  traverse(
      tree, measure, [&]() noexcept { return best.distance; },
      [&](int triangle) noexcept {
        const auto hit = find_hit(shear, way, length, Corners(tree, x, triangle));
        if (!hit || !is_better(hit->distance, triangle, best)) return;
        best = *hit;
        best.triangle = triangle;
      });
  if (best.triangle < 0) return std::nullopt;
  return best;
}

/// Takes triangle indices into a buffer of fixed size, the lowest ones when there are too many.
class Collector {
 public:
  explicit Collector(std::span<int> out) noexcept : out_(out) {}

  void add(int triangle) noexcept {
    if (found_ < out_.size()) {
      out_[found_] = triangle;
      if (found_ + 1 == out_.size()) std::make_heap(out_.begin(), out_.end());
    } else if (!out_.empty() && triangle < out_.front()) {
      std::pop_heap(out_.begin(), out_.end());
      out_.back() = triangle;
      std::push_heap(out_.begin(), out_.end());
    }
    ++found_;
  }
  int finish() noexcept {
    const std::size_t written = std::min(found_, out_.size());
    std::sort(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(written));
    return static_cast<int>(found_);
  }

 private:
  std::span<int> out_;
  std::size_t found_ = 0;
};

}  // namespace

std::optional<SurfacePoint> find_segment_hit(const AabbTree& tree, std::span<const Vec3> x,
                                             const Vec3& from, const Vec3& to) noexcept {
  const Vec3 direction = to - from;
  const double length = direction.stableNorm();
  if (!(length > 0.0)) return std::nullopt;
  return find_first_hit(tree, x, {from, direction, 1.0, compute_slack(tree, from, to)}, length);
}

std::optional<SurfacePoint> find_ray_hit(const AabbTree& tree, std::span<const Vec3> x,
                                         const Vec3& origin, const Vec3& direction) noexcept {
  const double length = direction.stableNorm();
  if (!(length > 0.0)) return std::nullopt;
  const Vec3 unit = direction.stableNormalized();
  return find_first_hit(tree, x, {origin, unit, kMost, compute_slack(tree, origin, origin)}, 1.0);
}

std::optional<SurfacePoint> find_closest_point(const AabbTree& tree, std::span<const Vec3> x,
                                               const Vec3& p, double max_distance) noexcept {
  if (!(max_distance >= 0.0)) return std::nullopt;
  SurfacePoint best;
  best.distance = max_distance;
  double most = square_upwards(max_distance);
  const auto measure = [&](const AabbTree::Node& node) noexcept {
    return compute_squared_distance(p, node.low, node.high);
  };
  traverse(
      tree, measure, [&]() noexcept { return most; },
      [&](int triangle) noexcept {
        const Corners corners(tree, x, triangle);
        SurfacePoint found = find_closest_on_triangle(p, corners.a, corners.b, corners.c);
        if (!is_better(found.distance, triangle, best)) return;
        found.triangle = triangle;
        best = found;
        most = square_upwards(best.distance);
      });
  if (best.triangle < 0) return std::nullopt;
  return best;
}

int find_in_sphere(const AabbTree& tree, std::span<const Vec3> x, const Vec3& centre, double radius,
                   std::span<int> out) noexcept {
  if (!(radius >= 0.0)) return 0;
  Collector collector(out);
  const double most = square_upwards(radius);
  const auto measure = [&](const AabbTree::Node& node) noexcept {
    return compute_squared_distance(centre, node.low, node.high);
  };
  traverse(
      tree, measure, [&]() noexcept { return most; },
      [&](int triangle) noexcept {
        const Corners corners(tree, x, triangle);
        if (find_closest_on_triangle(centre, corners.a, corners.b, corners.c).distance <= radius) {
          collector.add(triangle);
        }
      });
  return collector.finish();
}

int find_near_segment(const AabbTree& tree, std::span<const Vec3> x, const Vec3& from,
                      const Vec3& to, double radius, std::span<int> out) noexcept {
  // a slab test passes over NaN, so it must not get as far
  if (!(radius >= 0.0) || !from.allFinite() || !to.allFinite()) return 0;
  Collector collector(out);
  const Way way{from, to - from, 1.0, radius + compute_slack(tree, from, to)};
  const auto measure = [&](const AabbTree::Node& node) noexcept {
    return enter_box(way, node.low, node.high);
  };
  traverse(
      tree, measure, []() noexcept { return 1.0; },
      [&](int triangle) noexcept {
        const Corners corners(tree, x, triangle);
        const Box box = bound_triangle(corners.a, corners.b, corners.c);
        if (enter_box(way, box.low, box.high) <= 1.0) collector.add(triangle);
      });
  return collector.finish();
}

}  // namespace palpate
