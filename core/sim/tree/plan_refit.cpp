// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "palpate/sim/tree/private/build_tree.h"

namespace palpate {
namespace {

/// The corners of a leaf, each once; how many.
std::size_t list_corners(const TreeShape& shape, std::span<const Triangle> triangles, int first,
                         int count, std::array<int, TreeRefit::kMany>& corners) {
  std::size_t listed = 0;
  for (int k = first; k < first + count; ++k) {
    const int t = shape.order[static_cast<std::size_t>(k)];
    for (const int corner : triangles[static_cast<std::size_t>(t)]) {
      const auto end = corners.begin() + static_cast<std::ptrdiff_t>(listed);
      if (std::find(corners.begin(), end, corner) == end) corners[listed++] = corner;
    }
  }
  std::fill(corners.begin() + static_cast<std::ptrdiff_t>(listed), corners.end(), corners[0]);
  return listed;
}

/// Calls `take(row, particle)` for every corner of every leaf, each once.
template <class Take>
void for_each_corner(std::size_t node_count, const TreeRefit& refit, Take take) {
  const auto visit = [&](std::size_t row, auto list) {
    std::sort(list.begin(), list.end());
    const auto end = std::unique(list.begin(), list.end());
    for (auto corner = list.begin(); corner != end; ++corner) take(row, *corner);
  };
  std::size_t row = node_count;
  for (const auto& list : refit.few) visit(row++, list);
  for (const auto& list : refit.many) visit(row++, list);
}

/// In which leaves each particle is.
void index_particles(std::size_t particle_count, TreeRefit& refit) {
  const std::size_t nodes = refit.child_rows.size();
  refit.first_row.assign(particle_count + 1, 0);
  for_each_corner(nodes, refit, [&](std::size_t, int particle) {
    ++refit.first_row[static_cast<std::size_t>(particle) + 1];
  });
  for (std::size_t i = 0; i < particle_count; ++i) refit.first_row[i + 1] += refit.first_row[i];
  refit.leaf_rows.resize(static_cast<std::size_t>(refit.first_row.back()));
  std::vector<int> next = refit.first_row;
  for_each_corner(nodes, refit, [&](std::size_t row, int particle) {
    const int slot = next[static_cast<std::size_t>(particle)]++;
    refit.leaf_rows[static_cast<std::size_t>(slot)] = static_cast<int>(row);
  });
  refit.moving.assign(refit.rows.size(), 0);
  refit.moving_few.resize(refit.few.size());
  refit.moving_many.resize(refit.many.size());
  refit.moving_nodes.resize(nodes);
}

}  // namespace

TreeRefit plan_refit(const TreeShape& shape, std::span<const Triangle> triangles,
                     std::size_t particle_count) {
  TreeRefit refit;
  // rows of leaves with many corners are counted from the back, for how many others there are
  // is not known before the end
  for (const AabbTree::Node& node : shape.nodes) {
    std::array<int, AabbTree::kWidth> rows{};
    for (std::size_t k = 0; k < AabbTree::kWidth; ++k) {
      std::array<int, TreeRefit::kMany> corners{};
      if (node.count[k] == 0) {
        rows[k] = node.first[k];
      } else if (node.count[k] > 0 && list_corners(shape, triangles, node.first[k], node.count[k],
                                                   corners) <= TreeRefit::kFew) {
        rows[k] = static_cast<int>(shape.nodes.size() + refit.few.size());
        std::copy_n(corners.begin(), TreeRefit::kFew, refit.few.emplace_back().begin());
      } else if (node.count[k] > 0) {
        refit.many.push_back(corners);
        rows[k] = -static_cast<int>(refit.many.size());
      }
    }
    refit.child_rows.push_back(rows);
  }
  const std::size_t first_many = shape.nodes.size() + refit.few.size();
  refit.rows.resize(first_many + refit.many.size() + 1);
  for (std::size_t n = 0; n < shape.nodes.size(); ++n) {
    for (std::size_t k = 0; k < AabbTree::kWidth; ++k) {
      int& row = refit.child_rows[n][k];
      if (shape.nodes[n].count[k] < 0) row = static_cast<int>(refit.rows.size() - 1);
      if (row < 0) row = static_cast<int>(first_many) - row - 1;
    }
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  refit.rows.back() = {kInfinity,  kInfinity,  kInfinity,  kInfinity,
                       -kInfinity, -kInfinity, -kInfinity, -kInfinity};
  index_particles(particle_count, refit);
  return refit;
}

void list_moving(std::size_t node_count, TreeRefit& refit) noexcept {
  refit.few_count = refit.many_count = refit.node_count = 0;
  const int* few = refit.moving.data() + node_count;
  for (std::size_t i = 0; i < refit.few.size(); ++i) {
    if (few[i] > 0) refit.moving_few[refit.few_count++] = static_cast<int>(i);
  }
  const int* many = few + refit.few.size();
  for (std::size_t i = 0; i < refit.many.size(); ++i) {
    if (many[i] > 0) refit.moving_many[refit.many_count++] = static_cast<int>(i);
  }
  for (std::size_t n = node_count; n-- > 0;) {
    const auto moves = [&](int row) { return refit.moving[static_cast<std::size_t>(row)] > 0; };
    const auto& rows = refit.child_rows[n];
    refit.moving[n] = std::any_of(rows.begin(), rows.end(), moves) ? 1 : 0;
    if (refit.moving[n] > 0) refit.moving_nodes[refit.node_count++] = static_cast<int>(n);
  }
  refit.listed = true;
}

}  // namespace palpate
