// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/base/cache_aligned.h"
#include "palpate/sim/base/types.h"
#include "palpate/sim/tree/tree_refit.h"

namespace palpate {

/// Axis-aligned boxes around the triangles of a deforming surface, eight to a node.
///
/// Built once over the surface at rest; refit() follows the deformation in one sweep without
/// changing the shape of the tree. Queries (queries.h) are right for any positions the tree has
/// been refitted to; large deformations only make them slower.
class AabbTree {
 public:
  static constexpr int kWidth = 8;  ///< children of a node
  static constexpr int kLeafSize = 4;
  /// No leaf lies deeper, whatever the triangles.
  static constexpr int kMaxDepth = 64;

  using Lanes = std::array<float, kWidth>;

  /// Eight boxes, rounded outwards. Nodes stand depth first, children behind their parent.
  struct alignas(64) Node {
    std::array<Lanes, 3> low{};       ///< [m] by axis, then by child
    std::array<Lanes, 3> high{};      ///< [m]
    std::array<int, kWidth> first{};  ///< leaf: first entry in order(); else: index of a node
    std::array<int, kWidth> count{};  ///< triangles of a leaf, 0 for a node, -1 for no child
  };

  AabbTree() = default;
  /// Throws std::invalid_argument for no triangles, an index out of range or a position that is
  /// not finite.
  AabbTree(std::span<const Vec3> x, std::span<const Triangle> triangles);

  /// Follows the surface to positions x; the same particle count as at the start.
  void refit(std::span<const Vec3> x) noexcept;

  /// A refit in parts: of refit_step_count() steps those from `begin` to `end`. A caller that has
  /// taken all of them in their sequence has refitted the tree. Where the surface moves on
  /// meanwhile every box is one of those it has had since the first of them.
  void refit_steps(std::span<const Vec3> x, std::size_t begin, std::size_t end) noexcept;
  std::size_t refit_step_count() const noexcept { return refit_.step_count(); }

  /// From now on refit_moving() follows these particles, or no longer does; at first, none.
  void set_moving(std::span<const int> particles, bool moving) noexcept;
  /// As refit(), for when no others have moved since: the same boxes, in less time.
  void refit_moving(std::span<const Vec3> x) noexcept;

  /// [m] The corners of the box around the whole surface.
  Vec3 low() const noexcept { return corner(0); }
  Vec3 high() const noexcept { return corner(4); }

  std::span<const Node> nodes() const noexcept { return nodes_; }
  std::span<const int> order() const noexcept { return order_; }
  std::span<const Triangle> triangles() const noexcept { return triangles_; }
  /// triangles() in the sequence of order(): what a leaf reads on.
  std::span<const Triangle> leaf_triangles() const noexcept { return leaf_triangles_; }

 private:
  Vec3 corner(std::size_t at) const noexcept {
    const auto& row = refit_.rows.front();
    return {row[at], row[at + 1], row[at + 2]};
  }

  CacheAligned<Node> nodes_;
  std::vector<int> order_;
  std::vector<Triangle> triangles_;
  std::vector<Triangle> leaf_triangles_;
  TreeRefit refit_;
};

}  // namespace palpate
