// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tree/aabb_tree.h"

#include <stdexcept>
#include <string>

#include "palpate/sim/tree/private/build_tree.h"
#include "palpate/sim/tree/private/tree_kernels.h"

namespace palpate {
namespace {

void validate(std::span<const Vec3> x, std::span<const Triangle> triangles) {
  if (triangles.empty()) throw std::invalid_argument("AabbTree: triangles: got none");
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const int i : triangles[t]) {
      const std::string where = "AabbTree: triangle " + std::to_string(t) + ": ";
      if (i < 0 || i >= static_cast<int>(x.size())) {
        throw std::invalid_argument(where + "particle index must lie in [0, " +
                                    std::to_string(x.size()) + "), got " + std::to_string(i));
      }
      if (!x[static_cast<std::size_t>(i)].allFinite()) {
        throw std::invalid_argument(where + "the position of particle " + std::to_string(i) +
                                    " must be finite");
      }
    }
  }
}

}  // namespace

AabbTree::AabbTree(std::span<const Vec3> x, std::span<const Triangle> triangles) {
  validate(x, triangles);
  triangles_.assign(triangles.begin(), triangles.end());
  TreeShape shape = build_tree(x, triangles);
  refit_ = plan_refit(shape, triangles, x.size());
  nodes_ = std::move(shape.nodes);
  order_ = std::move(shape.order);
  leaf_triangles_.reserve(order_.size());
  for (const int t : order_) leaf_triangles_.push_back(triangles_[static_cast<std::size_t>(t)]);
  refit(x);
}

void AabbTree::refit(std::span<const Vec3> x) noexcept { refit_steps(x, 0, refit_step_count()); }

void AabbTree::refit_steps(std::span<const Vec3> x, std::size_t begin, std::size_t end) noexcept {
  tree_kernels::best().refit(x, begin, end, refit_, nodes_);
}

void AabbTree::set_moving(std::span<const int> particles, bool moving) noexcept {
  for (const int i : particles) {
    const auto at = static_cast<std::size_t>(i);
    for (int n = refit_.first_row[at]; n < refit_.first_row[at + 1]; ++n) {
      const int row = refit_.leaf_rows[static_cast<std::size_t>(n)];
      refit_.moving[static_cast<std::size_t>(row)] += moving ? 1 : -1;
    }
  }
  refit_.listed = false;
}

void AabbTree::refit_moving(std::span<const Vec3> x) noexcept {
  if (!refit_.listed) list_moving(nodes_.size(), refit_);
  tree_kernels::best().refit_moving(x, refit_, nodes_);
}

}  // namespace palpate
