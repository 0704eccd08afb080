// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/naive_tree.h"

#include <algorithm>
#include <numeric>

namespace palpate::bench {
namespace {

constexpr int kLeafSize = 4;

double distance_to(const Box& box, const Vec3& p) noexcept {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).norm();
}

/// Slab by slab, the part of the segment from 0 to `nearest` that lies in the box.
bool meets(const Box& box, const Vec3& from, const Vec3& segment, double nearest) noexcept {
  double begin = 0.0, end = nearest;
  for (int axis = 0; axis < 3; ++axis) {
    if (segment[axis] == 0.0) {
      if (from[axis] < box.low[axis] || from[axis] > box.high[axis]) return false;
      continue;
    }
    const double a = (box.low[axis] - from[axis]) / segment[axis];
    const double b = (box.high[axis] - from[axis]) / segment[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin <= end;
}

SurfacePoint closest_of(const Triangle& t, std::span<const Vec3> x, const Vec3& p) noexcept {
  return find_closest_on_triangle(p, x[static_cast<std::size_t>(t[0])],
                                  x[static_cast<std::size_t>(t[1])],
                                  x[static_cast<std::size_t>(t[2])]);
}

/// Möller-Trumbore on one triangle.
void cross_triangle(const Triangle& triangle, int t, std::span<const Vec3> x, const Vec3& from,
                    const Vec3& segment, std::optional<SurfacePoint>& hit,
                    double& nearest) noexcept {
  const Vec3& a = x[static_cast<std::size_t>(triangle[0])];
  const Vec3 ab = x[static_cast<std::size_t>(triangle[1])] - a;
  const Vec3 ac = x[static_cast<std::size_t>(triangle[2])] - a;
  const Vec3 p = segment.cross(ac);
  const double det = ab.dot(p);
  if (det == 0.0) return;
  const Vec3 s = from - a;
  const double u = s.dot(p) / det;
  if (u < 0.0 || u > 1.0) return;
  const Vec3 q = s.cross(ab);
  const double v = segment.dot(q) / det;
  if (v < 0.0 || u + v > 1.0) return;
  const double fraction = ac.dot(q) / det;
  if (fraction < 0.0 || fraction > nearest || (hit && fraction == nearest)) return;
  nearest = fraction;
  hit = SurfacePoint{.triangle = t,
                     .weights = {1.0 - u - v, u, v},
                     .point = from + fraction * segment,
                     .distance = fraction * segment.norm()};
}

}  // namespace

NaiveTree::NaiveTree(std::span<const Vec3> x, std::span<const Triangle> triangles)
    : order_(triangles.size()), triangles_(triangles) {
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vec3> middles;
  for (const auto& [i, j, k] : triangles) {
    middles.push_back((x[static_cast<std::size_t>(i)] + x[static_cast<std::size_t>(j)] +
                       x[static_cast<std::size_t>(k)]) /
                      3.0);
  }
  build(middles, 0, static_cast<int>(triangles.size()));
  refit(x);
}

int NaiveTree::build(std::span<const Vec3> middles, int begin, int end) {
  const int at = static_cast<int>(nodes_.size());
  nodes_.push_back({});
  nodes_.back().begin = begin;
  nodes_.back().end = end;
  if (end - begin <= kLeafSize) return at;
  Box box;
  for (int e = begin; e < end; ++e) {
    box.add(middles[static_cast<std::size_t>(order_[static_cast<std::size_t>(e)])]);
  }
  int axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const int half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](int a, int b) {
                     return middles[static_cast<std::size_t>(a)][axis] <
                            middles[static_cast<std::size_t>(b)][axis];
                   });
  const int left = build(middles, begin, half);
  const int right = build(middles, half, end);
  nodes_[static_cast<std::size_t>(at)].left = left;
  nodes_[static_cast<std::size_t>(at)].right = right;
  return at;
}

void NaiveTree::refit(std::span<const Vec3> x) noexcept { refit_node(x, nodes_.front()); }

void NaiveTree::refit_node(std::span<const Vec3> x, Node& node) noexcept {
  node.box = Box();
  if (node.left < 0) {
    for (int e = node.begin; e < node.end; ++e) {
      const auto t = static_cast<std::size_t>(order_[static_cast<std::size_t>(e)]);
      node.box.add(bound_triangle(x, triangles_[t]));
    }
    return;
  }
  for (const int child : {node.left, node.right}) {
    Node& below = nodes_[static_cast<std::size_t>(child)];
    refit_node(x, below);
    node.box.add(below.box);
  }
}

std::optional<SurfacePoint> NaiveTree::find_segment_hit(std::span<const Vec3> x, const Vec3& from,
                                                        const Vec3& to) const noexcept {
  std::optional<SurfacePoint> hit;
  double nearest = 1.0;
  cross(x, nodes_.front(), from, to, hit, nearest);
  return hit;
}

void NaiveTree::cross(std::span<const Vec3> x, const Node& node, const Vec3& from, const Vec3& to,
                      std::optional<SurfacePoint>& hit, double& nearest) const noexcept {
  const Vec3 segment = to - from;
  if (!meets(node.box, from, segment, nearest)) return;
  if (node.left >= 0) {
    cross(x, nodes_[static_cast<std::size_t>(node.left)], from, to, hit, nearest);
    cross(x, nodes_[static_cast<std::size_t>(node.right)], from, to, hit, nearest);
    return;
  }
  for (int e = node.begin; e < node.end; ++e) {
    const int t = order_[static_cast<std::size_t>(e)];
    cross_triangle(triangles_[static_cast<std::size_t>(t)], t, x, from, segment, hit, nearest);
  }
}

std::optional<SurfacePoint> NaiveTree::find_closest_point(std::span<const Vec3> x,
                                                          const Vec3& p) const noexcept {
  std::optional<SurfacePoint> best;
  approach(x, nodes_.front(), p, best);
  return best;
}

void NaiveTree::approach(std::span<const Vec3> x, const Node& node, const Vec3& p,
                         std::optional<SurfacePoint>& best) const noexcept {
  if (node.left < 0) {
    for (int e = node.begin; e < node.end; ++e) {
      const int t = order_[static_cast<std::size_t>(e)];
      SurfacePoint found = closest_of(triangles_[static_cast<std::size_t>(t)], x, p);
      if (best && found.distance >= best->distance) continue;
      found.triangle = t;
      best = found;
    }
    return;
  }
  const Node* near = &nodes_[static_cast<std::size_t>(node.left)];
  const Node* far = &nodes_[static_cast<std::size_t>(node.right)];
  double near_distance = distance_to(near->box, p), far_distance = distance_to(far->box, p);
  if (far_distance < near_distance) {
    std::swap(near, far);
    std::swap(near_distance, far_distance);
  }
  if (!best || near_distance < best->distance) approach(x, *near, p, best);
  if (!best || far_distance < best->distance) approach(x, *far, p, best);
}

int NaiveTree::find_in_sphere(std::span<const Vec3> x, const Vec3& centre, double radius,
                              std::span<int> out) const noexcept {
  int count = 0;
  collect(x, nodes_.front(), centre, radius, out, count);
  return count;
}

void NaiveTree::collect(std::span<const Vec3> x, const Node& node, const Vec3& centre,
                        double radius, std::span<int> out, int& count) const noexcept {
  if (distance_to(node.box, centre) > radius) return;
  if (node.left >= 0) {
    collect(x, nodes_[static_cast<std::size_t>(node.left)], centre, radius, out, count);
    collect(x, nodes_[static_cast<std::size_t>(node.right)], centre, radius, out, count);
    return;
  }
  for (int e = node.begin; e < node.end; ++e) {
    const int t = order_[static_cast<std::size_t>(e)];
    if (closest_of(triangles_[static_cast<std::size_t>(t)], x, centre).distance > radius) continue;
    if (count < static_cast<int>(out.size())) out[static_cast<std::size_t>(count)] = t;
    ++count;
  }
}

void find_naively(const Scene& scene, const HapticSample& sample, NaiveTree& tree,
                  World& world) noexcept {
  tree.refit(world.bodies[0].tissue.position);
  world.pairs[0].candidates.count =
      tree.find_in_sphere(world.bodies[0].tissue.position, world.instruments[0].tool.position,
                          scene.instruments[0].tool.radius + kCandidateMargin +
                              (sample.position - world.instruments[0].tool.position).norm(),
                          world.pairs[0].candidates.triangles);
  for (int i = 0; i < world.pairs[0].candidates.count; ++i) {
    const auto slot = static_cast<std::size_t>(i);
    world.pairs[0].candidates.areas[slot] =
        scene.bodies[0]
            .rest_areas[static_cast<std::size_t>(world.pairs[0].candidates.triangles[slot])];
  }
}

}  // namespace palpate::bench
