// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: the way through a
// tree.
#if defined(PALPATE_TREE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_WALK_INL_H
#undef PALPATE_TREE_WALK_INL_H
#else
#define PALPATE_TREE_WALK_INL_H
#endif

#include "palpate/sim/tree/private/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

/// A leaf or a node still to visit.
struct Child {
  std::int32_t key;  ///< the least that a triangle in its box can offer, in a form that sorts
  int first, count;
};

/// At most seven of every level above, and the next.
class Stack {
 public:
  /// Room for that many more; the last of them is on top.
  Child* push(std::size_t count) noexcept {
    size_ += count;
    return entries_ + (size_ - count);
  }
  /// The next that can offer no more than `most`; false when there is none.
  bool pop(float most, Child& child) noexcept {
    while (size_ > 0) {
      child = entries_[--size_];
      if (least_of(child.key) <= most) return true;
    }
    return false;
  }

 private:
  // and the one that is visited next
  static constexpr std::size_t kSize = (AabbTree::kWidth - 1) * AabbTree::kMaxDepth + 2;
  Child entries_[kSize];  // not set to zero: that would cost more than a query
  std::size_t size_ = 0;
};

/// Bits of the children that a node has.
PALPATE_TREE_INLINE unsigned list_present(const AabbTree::Node& node) {
  return ~find_negative(node.count) & 0xffu;
}

/// Where a walk goes on from a node: to its only child that can offer no more than `most`, or to
/// the nearest of them, the others on the stack. False where there is none.
///
/// Each finds its place by counting those before it: where to go is not to be guessed by branches.
PALPATE_TREE_INLINE bool descend(const AabbTree::Node& node, Eight least, float most, Stack& stack,
                                 Child& child) {
  unsigned wanted = bits(least <= set_eight(most)) & list_present(node);
  if (wanted == 0) return false;
  const unsigned all = wanted;
  const std::size_t k = take_lowest(wanted);
  if (wanted == 0) {
    child = {0, node.first[k], node.count[k]};
    return true;
  }
  alignas(32) std::int32_t keys[AabbTree::kWidth];
  make_keys(least, keys);
  const int others = std::popcount(wanted);
  // the nearest last: there it is overwritten by what comes next
  Child* places = stack.push(static_cast<std::size_t>(others)) + others;
  for (unsigned rest = all; rest != 0;) {
    const std::size_t c = take_lowest(rest);
    const int before = std::popcount(find_less(keys, keys[c]) & all);
    places[-before] = {keys[c], node.first[c], node.count[c]};
  }
  child = *places;
  return true;
}

/// Visits the leaves of a tree, nearer ones first. `measure(node)` is the least that triangles in
/// the boxes of its children can offer, `most()` what is still wanted, `visit(first, count)` takes
/// a leaf.
template <class Measure, class Most, class Visit>
PALPATE_TREE_INLINE void walk_nearest_first(const AabbTree& tree, Measure measure, Most most,
                                            Visit visit) {
  const AabbTree::Node* nodes = tree.nodes().data();
  if (nodes == nullptr) return;
  Stack stack;
  Child child = {0, 0, 0};
  do {
    bool found = true;
    while (found && child.count == 0) {
      const AabbTree::Node& node = nodes[child.first];
      found = descend(node, measure(node), most(), stack, child);
    }
    if (found) visit(child.first, child.count);
  } while (stack.pop(most(), child));
}

/// Visits all leaves that offer no more than `most`, in any order.
///
/// Whether a child is a node or a leaf cannot be guessed, so it is put down as both and counts as
/// one; leaves are visited together.
template <class Measure, class Visit>
PALPATE_TREE_INLINE void walk(const AabbTree& tree, Measure measure, float most, Visit visit) {
  const AabbTree::Node* nodes = tree.nodes().data();
  if (nodes == nullptr) return;
  constexpr std::size_t kTogether = 64;
  struct Leaf {
    int first, count;
  };
  int stack[(AabbTree::kWidth - 1) * AabbTree::kMaxDepth + 2];
  Leaf leaves[kTogether + AabbTree::kWidth];
  std::size_t size = 1, found = 0;
  stack[0] = 0;
  while (size > 0) {
    const AabbTree::Node& node = nodes[stack[--size]];
    unsigned wanted = bits(measure(node) <= set_eight(most)) & list_present(node);
    while (wanted != 0) {
      const std::size_t k = take_lowest(wanted);
      const bool is_leaf = node.count[k] > 0;
      stack[size] = node.first[k];
      leaves[found] = {node.first[k], node.count[k]};
      size += is_leaf ? 0 : 1;
      found += is_leaf ? 1 : 0;
    }
    if (size > 0 && found < kTogether) continue;
    for (std::size_t i = 0; i < found; ++i) visit(leaves[i].first, leaves[i].count);
    found = 0;
  }
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_WALK_INL_H
