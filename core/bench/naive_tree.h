// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/world.h"
#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/queries.h"

namespace palpate::bench {

/// The tree of a textbook [Ericson04]: two children, split at the median of the longest side of
/// the box, plain double, walked by recursion. The yardstick for the tree of palpate::sim.
class NaiveTree {
 public:
  NaiveTree(std::span<const Vec3> x, std::span<const Triangle> triangles);

  /// Every box again from the positions, the shape of the tree unchanged.
  void refit(std::span<const Vec3> x) noexcept;

  /// [m] The corners of the box around the whole surface.
  const Vec3& low() const noexcept { return nodes_.front().box.low; }
  const Vec3& high() const noexcept { return nodes_.front().box.high; }

  std::optional<SurfacePoint> find_segment_hit(std::span<const Vec3> x, const Vec3& from,
                                               const Vec3& to) const noexcept;
  std::optional<SurfacePoint> find_closest_point(std::span<const Vec3> x,
                                                 const Vec3& p) const noexcept;
  /// How many triangles have a point in the ball; writes as many as `out` holds.
  int find_in_sphere(std::span<const Vec3> x, const Vec3& centre, double radius,
                     std::span<int> out) const noexcept;

 private:
  struct Node {
    Box box;
    int left = -1, right = -1;  ///< nodes; -1 for a leaf
    int begin = 0, end = 0;     ///< a leaf's entries of order_
  };

  int build(std::span<const Vec3> middles, int begin, int end);
  void refit_node(std::span<const Vec3> x, Node& node) noexcept;
  void cross(std::span<const Vec3> x, const Node& node, const Vec3& from, const Vec3& to,
             std::optional<SurfacePoint>& hit, double& nearest) const noexcept;
  void approach(std::span<const Vec3> x, const Node& node, const Vec3& p,
                std::optional<SurfacePoint>& best) const noexcept;
  void collect(std::span<const Vec3> x, const Node& node, const Vec3& centre, double radius,
               std::span<int> out, int& count) const noexcept;

  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::span<const Triangle> triangles_;
};

/// What a first program's tick begins with: the whole tree refitted, and world.pairs[0].candidates
/// found in it for the tool on its way to the hand.
void find_naively(const Scene& scene, const HapticSample& sample, NaiveTree& tree,
                  World& world) noexcept;

}  // namespace palpate::bench
