// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: the way through a tree.
#if defined(PALPATE_TREE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_WALK_INL_H
#undef PALPATE_TREE_WALK_INL_H
#else
#define PALPATE_TREE_WALK_INL_H
#endif

#include "palpate/sim/contact/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

/// A child worth a visit, and the least a triangle in its box can offer.
struct Child {
  double least;
  int first, count;
};

/// Nodes still to visit: at most three of every level above, and the next.
class Stack {
 public:
  void push(const Child& child) noexcept { entries_[size_++] = child; }
  /// The next node that can offer no more than `most`; -1 when there is none.
  int pop(double most) noexcept {
    while (size_ > 0) {
      const Child& child = entries_[--size_];
      if (child.least <= most) return child.first;
    }
    return -1;
  }

 private:
  static constexpr std::size_t kSize = (AabbTree::kWidth - 1) * AabbTree::kMaxDepth + 1;
  Child entries_[kSize];  // not set to zero: that would cost more than a query
  std::size_t size_ = 0;
};

/// Those children of a node that can offer no more than `most`, nearest first; how many.
PALPATE_TREE_INLINE std::size_t list_children(const AabbTree::Node& node, Four least, double most,
                                              Child (&children)[4]) {
  unsigned wanted = bits(least <= set(most));
  alignas(32) double leasts[4];
  store(least, leasts);
  std::size_t listed = 0;
  while (wanted != 0) {
    const std::size_t k = take_lowest(wanted);
    if (node.count[k] < 0) continue;
    std::size_t place = listed++;
    for (; place > 0 && children[place - 1].least > leasts[k]; --place) {
      children[place] = children[place - 1];
    }
    children[place] = {leasts[k], node.first[k], node.count[k]};
  }
  return listed;
}

/// Visits the leaves of a tree, nearer ones first. `measure(node)` is the least that triangles in
/// the boxes of its children can offer, `most()` what is still wanted, `visit(first, count)` takes
/// a leaf.
template <class Measure, class Most, class Visit>
PALPATE_TREE_INLINE void walk(const AabbTree& tree, Measure measure, Most most, Visit visit) {
  const AabbTree::Node* nodes = tree.nodes().data();
  if (nodes == nullptr) return;
  Stack stack;
  Child children[4];
  for (int n = 0; n >= 0; n = stack.pop(most())) {
    const AabbTree::Node& node = nodes[n];
    const std::size_t count = list_children(node, measure(node), most(), children);
    // leaves before nodes: what they offer spares visits
    for (std::size_t i = 0; i < count; ++i) {
      const Child& child = children[i];
      if (child.count > 0 && child.least <= most()) visit(child.first, child.count);
    }
    for (std::size_t i = count; i-- > 0;) {
      if (children[i].count == 0 && children[i].least <= most()) stack.push(children[i]);
    }
  }
}

PALPATE_TREE_INLINE Points load_low(const AabbTree::Node& node) {
  return {load(node.low[0].data()), load(node.low[1].data()), load(node.low[2].data())};
}
PALPATE_TREE_INLINE Points load_high(const AabbTree::Node& node) {
  return {load(node.high[0].data()), load(node.high[1].data()), load(node.high[2].data())};
}

/// As compute_squared_distance().
PALPATE_TREE_INLINE Four measure_distances(const Points& p, const Points& low, const Points& high) {
  const Four zero = set(0.0);
  return square(max(max(low - p, p - high), Points{zero, zero, zero}));
}

/// As enter_box().
PALPATE_TREE_INLINE Four enter_boxes(const Way& way, const Points& low, const Points& high) {
  const Four infinity = set(std::numeric_limits<double>::infinity());
  const Four zero = set(0.0), grow = set(way.grow);
  const Four lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
  Four in = zero, out = set(way.end);
  for (int k = 0; k < 3; ++k) {
    const Four from = set(way.from[k]);
    const Four to_low = (lows[k] - grow) - from, to_high = (highs[k] + grow) - from;
    if (way.direction[k] == 0.0) {
      in = select((to_low <= zero) & (zero <= to_high), in, infinity);
      continue;
    }
    const Four inverse = set(way.inverse[k]);
    const Four t0 = to_low * inverse, t1 = to_high * inverse;
    in = max(in, min(t0, t1));
    out = min(out, max(t0, t1));
  }
  return select(in <= out, in, infinity);
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_WALK_INL_H
