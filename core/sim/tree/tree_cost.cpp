// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "palpate/sim/tree/aabb_tree.h"
#include "palpate/sim/tree/private/box.h"

namespace palpate {
namespace {

/// [m²] Half the area of the boxes in these nodes.
double sum_half_areas(std::span<const AabbTree::Node> nodes) noexcept {
  std::array<double, AabbTree::kWidth> sums{};
  for (const AabbTree::Node& node : nodes) {
    for (std::size_t k = 0; k < AabbTree::kWidth; ++k) {
      if (node.count[k] < 0) continue;
      const double x = double(node.high[0][k]) - double(node.low[0][k]),
                   y = double(node.high[1][k]) - double(node.low[1][k]),
                   z = double(node.high[2][k]) - double(node.low[2][k]);
      sums[k] += x * y + y * z + z * x;
    }
  }
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// A line that meets a convex box meets a box within it with the ratio of their areas. A child is
/// one visit, of a node or of a leaf whose triangles are tested at once:
///
///     cost = 1 + Σ A_child / A_whole                                            [MacDonald90]
double make_cost(double sum, const AabbTree& tree) noexcept {
  const double whole = Box{tree.low(), tree.high()}.half_area();
  return whole > 0.0 ? 1.0 + sum / whole : 1.0;
}

}  // namespace

double compute_query_cost(const AabbTree& tree) noexcept {
  return tree.nodes().empty() ? 0.0 : make_cost(sum_half_areas(tree.nodes()), tree);
}

TreeCost::TreeCost(const AabbTree& tree) noexcept : start_(compute_query_cost(tree)) {}

void TreeCost::follow(const AabbTree& tree) noexcept {
  const std::span<const AabbTree::Node> nodes = tree.nodes();
  if (nodes.empty()) return;
  const std::size_t part = (nodes.size() + kRound - 1) / kRound;
  const std::size_t end = std::min(next_ + part, nodes.size());
  sum_ += sum_half_areas(nodes.subspan(next_, end - next_));
  next_ = end;
  if (next_ < nodes.size()) return;
  growth_ = make_cost(sum_, tree) / start_;
  sum_ = 0.0;
  next_ = 0;
}

}  // namespace palpate
