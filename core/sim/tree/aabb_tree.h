// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "palpate/sim/base/types.h"

namespace palpate {

/// How a tree follows its surface: which corners bound each leaf, and which boxes each node.
///
/// Corners that the triangles of a leaf share are read once, and every list has one of two fixed
/// lengths, so that the sweep has no branch to guess wrongly. Boxes are rows: those of the nodes
/// in their sequence, then those of the leaves with few corners, of the leaves with many, and one
/// that is empty.
struct TreeRefit {
  static constexpr std::size_t kFew = 6;
  static constexpr std::size_t kMany = 12;

  std::vector<std::array<int, kFew>> few;      ///< filled up with a corner of the same leaf
  std::vector<std::array<int, kMany>> many;    ///< likewise
  std::vector<std::array<int, 8>> child_rows;  ///< per node
  CacheAligned<std::array<double, 8>> rows;    ///< [m] low and high, a fourth number unused

  // the part of it that is followed where not everything moves
  std::vector<int> first_row;                ///< of each particle in leaf_rows, and the end
  std::vector<int> leaf_rows;                ///< rows of the leaves with that particle
  std::vector<int> moving;                   ///< per row: of its corners that move; nodes 0 or 1
  std::vector<int> moving_few, moving_many;  ///< which of the lists; room for all
  std::vector<int> moving_nodes;             ///< children before parents
  std::size_t few_count = 0, many_count = 0, node_count = 0;  ///< that move
  bool listed = true;                                         ///< the lists are those of `moving`

  /// A refit is so many steps: a leaf with few corners each, with many, and then a node each.
  std::size_t step_count() const noexcept { return few.size() + many.size() + child_rows.size(); }
};

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

/// [-] What a query of the tree costs on average, in nodes and leaves visited [MacDonald90].
double compute_query_cost(const AabbTree& tree) noexcept;

/// Follows how costly the queries of a tree become while its surface deforms, a part of the tree at
/// a time, so that no tick pays for all of it.
class TreeCost {
 public:
  static constexpr int kRound = 64;  ///< calls of follow() at most that see the whole tree
  /// A tree whose cost has grown by this is worth building again.
  static constexpr double kWorthRebuilding = 1.5;

  TreeCost() = default;
  /// From now on, against what this tree costs now.
  explicit TreeCost(const AabbTree& tree) noexcept;

  /// Measures the next part; call it once after every refit of the same tree.
  void follow(const AabbTree& tree) noexcept;

  /// [-] The cost over that at the start, as the last whole round found it; 1 before that.
  double growth() const noexcept { return growth_; }

 private:
  double start_ = 0.0;   // the cost
  double growth_ = 1.0;  // of it
  double sum_ = 0.0;     // [m²] of the round so far
  std::size_t next_ = 0;
};

}  // namespace palpate
