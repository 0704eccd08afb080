// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: boxes that follow
// the surface.
#if defined(PALPATE_TREE_REFIT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_REFIT_INL_H
#undef PALPATE_TREE_REFIT_INL_H
#else
#define PALPATE_TREE_REFIT_INL_H
#endif

#include "palpate/sim/tree/private/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

struct Row {
  Four low, high;
};

/// Bounds the points of a list, two halves at a time: no step waits for the one before it.
template <std::size_t kCount>
PALPATE_TREE_INLINE Row bound_list(std::span<const Vec3> x, const std::array<int, kCount>& list) {
  Row row;
  const Four first = load_point(x[static_cast<std::size_t>(list[0])]);
  Four other = load_point(x[static_cast<std::size_t>(list[1])]);
  row = {min(first, other), max(first, other)};
  for (std::size_t i = 2; i < kCount; i += 2) {
    const Four p = load_point(x[static_cast<std::size_t>(list[i])]);
    other = load_point(x[static_cast<std::size_t>(list[i + 1])]);
    row.low = min(row.low, min(p, other));
    row.high = max(row.high, max(p, other));
  }
  return row;
}

PALPATE_TREE_INLINE Row load_row(const std::array<double, 8>& row) {
  return {load(row.data()), load(row.data() + 4)};
}
PALPATE_TREE_INLINE void store_row(const Row& row, std::array<double, 8>& to) {
  store(row.low, to.data());
  store(row.high, to.data() + 4);
}

/// Four children of a node, from the one at `first` on; the box around them.
PALPATE_TREE_INLINE Row bound_four(const TreeRefit& refit, const int* child_rows, std::size_t first,
                                   AabbTree::Node& node) {
  Four low[4], high[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const Row child = load_row(refit.rows[static_cast<std::size_t>(child_rows[first + k])]);
    low[k] = child.low;
    high[k] = child.high;
  }
  Points sides;
  transpose(low, sides.x, sides.y, sides.z);
  store_rounded_down(sides.x, node.low[0].data() + first);
  store_rounded_down(sides.y, node.low[1].data() + first);
  store_rounded_down(sides.z, node.low[2].data() + first);
  transpose(high, sides.x, sides.y, sides.z);
  store_rounded_up(sides.x, node.high[0].data() + first);
  store_rounded_up(sides.y, node.high[1].data() + first);
  store_rounded_up(sides.z, node.high[2].data() + first);
  return {min(min(low[0], low[1]), min(low[2], low[3])),
          max(max(high[0], high[1]), max(high[2], high[3]))};
}

PALPATE_TREE_INLINE void bound_node(std::size_t n, TreeRefit& refit,
                                    std::span<AabbTree::Node> nodes) noexcept {
  const int* child_rows = refit.child_rows[n].data();
  const Row a = bound_four(refit, child_rows, 0, nodes[n]);
  const Row b = bound_four(refit, child_rows, 4, nodes[n]);
  store_row({min(a.low, b.low), max(a.high, b.high)}, refit.rows[n]);
}

/// Children stand behind their parent, so steps that go through the nodes from the last one on find
/// every child done.
inline void refit(std::span<const Vec3> x, std::size_t begin, std::size_t end, TreeRefit& refit,
                  std::span<AabbTree::Node> nodes) noexcept {
  std::array<double, 8>* leaves = refit.rows.data() + nodes.size();
  const std::size_t few = refit.few.size(), lists = few + refit.many.size();
  std::size_t step = begin;
  for (; step < std::min(few, end); ++step) store_row(bound_list(x, refit.few[step]), leaves[step]);
  for (; step < std::min(lists, end); ++step) {
    store_row(bound_list(x, refit.many[step - few]), leaves[step]);
  }
  for (; step < end; ++step) bound_node(nodes.size() - 1 - (step - lists), refit, nodes);
}

/// The same for the rows that the lists name.
inline void refit_moving(std::span<const Vec3> x, TreeRefit& refit,
                         std::span<AabbTree::Node> nodes) noexcept {
  std::array<double, 8>* few = refit.rows.data() + nodes.size();
  std::array<double, 8>* many = few + refit.few.size();
  for (std::size_t i = 0; i < refit.few_count; ++i) {
    const auto at = static_cast<std::size_t>(refit.moving_few[i]);
    store_row(bound_list(x, refit.few[at]), few[at]);
  }
  for (std::size_t i = 0; i < refit.many_count; ++i) {
    const auto at = static_cast<std::size_t>(refit.moving_many[i]);
    store_row(bound_list(x, refit.many[at]), many[at]);
  }
  for (std::size_t i = 0; i < refit.node_count; ++i) {
    bound_node(static_cast<std::size_t>(refit.moving_nodes[i]), refit, nodes);
  }
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_REFIT_INL_H
