// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/base/types.h"

namespace palpate {

/// Axis-aligned boxes around the triangles of a deforming surface.
///
/// Built once over the surface at rest; refit() follows the deformation in one sweep without
/// changing the shape of the tree. Queries (queries.h) are right for any positions the tree has
/// been refitted to; large deformations only make them slower.
class AabbTree {
 public:
  static constexpr int kLeafSize = 4;
  /// No leaf lies deeper, whatever the triangles: a query's stack of so many entries is enough.
  static constexpr int kMaxDepth = 64;

  /// Nodes stand depth first, children behind their parent.
  struct Node {
    Eigen::Vector3d low, high;
    int first =
        0;  ///< leaf: first entry in order(); inner: index of the right child, the left is next
    int count = 0;  ///< triangles of a leaf; 0 for an inner node
  };

  AabbTree() = default;
  /// Throws std::invalid_argument for no triangles, an index out of range or a position that is
  /// not finite.
  AabbTree(std::span<const Vec3> x, std::span<const Triangle> triangles);

  /// Follows the surface to positions x; the same particle count as at the start.
  void refit(std::span<const Vec3> x) noexcept;

  std::span<const Node> nodes() const noexcept { return nodes_; }
  std::span<const int> order() const noexcept { return order_; }
  std::span<const Triangle> triangles() const noexcept { return triangles_; }

 private:
  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<Triangle> triangles_;
  // for refit: the particles of every leaf, each once, in blocks of kBlock that repeat the last
  static constexpr int kBlock = 6;
  struct Leaf {
    int node, first, count;
  };
  std::vector<Leaf> leaves_;
  std::vector<int> leaf_particles_;
  std::vector<int> inner_;  // nodes that are no leaves, the last one first

  friend struct TreeBoxes;
};

}  // namespace palpate
