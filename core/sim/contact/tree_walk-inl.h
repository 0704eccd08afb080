// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: the way through a
// tree.
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

/// A leaf or a node still to visit.
struct Child {
  std::int64_t key;  ///< the least that a triangle in its box can offer, in a form that sorts
  int first, count;
};

/// Numbers that are not negative sort as the integers of the same bits, and of those the last two
/// are free to say which child it is: rounded down, the least stays a least.
inline constexpr std::int64_t kChildBits = 3;
inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
PALPATE_TREE_INLINE std::int64_t make_key(double least, std::size_t child) {
  return (std::bit_cast<std::int64_t>(least) & ~kChildBits) | static_cast<std::int64_t>(child);
}
PALPATE_TREE_INLINE double least_of(std::int64_t key) {
  return std::bit_cast<double>(key & ~kChildBits);
}

/// At most three of every level above, and the next.
class Stack {
 public:
  void push(const Child& child) noexcept { entries_[size_++] = child; }
  /// The next that can offer no more than `most`; false when there is none.
  bool pop(double most, Child& child) noexcept {
    while (size_ > 0) {
      child = entries_[--size_];
      if (least_of(child.key) <= most) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kSize = (AabbTree::kWidth - 1) * AabbTree::kMaxDepth + 1;
  Child entries_[kSize];  // not set to zero: that would cost more than a query
  std::size_t size_ = 0;
};

/// Bits of the children that a node has; the first has always one.
PALPATE_TREE_INLINE unsigned list_present(const AabbTree::Node& node) {
  // without a branch, which would often be guessed wrongly: -1 >> 31 is -1, all else 0
  return 0xfu >> -((node.count[1] >> 31) + (node.count[2] >> 31) + (node.count[3] >> 31));
}

PALPATE_TREE_INLINE void put_in_order(std::int64_t& a, std::int64_t& b) {
  const std::int64_t lower = a < b ? a : b, upper = a < b ? b : a;
  a = lower;
  b = upper;
}

/// The four keys in ascending order, again without a branch.
PALPATE_TREE_INLINE void sort(std::int64_t (&keys)[4]) {
  put_in_order(keys[0], keys[1]);
  put_in_order(keys[2], keys[3]);
  put_in_order(keys[0], keys[2]);
  put_in_order(keys[1], keys[3]);
  put_in_order(keys[1], keys[2]);
}

/// Where a walk goes on from a node: to its only child that can offer no more than `most`, or to
/// the nearest of them, the others on the stack. False where there is none.
PALPATE_TREE_INLINE bool descend(const AabbTree::Node& node, Four least, double most, Stack& stack,
                                 Child& child) {
  unsigned wanted = bits(least <= set(most)) & list_present(node);
  if (wanted == 0) return false;
  const int others = std::popcount(wanted) - 1;
  if (others == 0) {
    const std::size_t k = take_lowest(wanted);
    child = {0, node.first[k], node.count[k]};
    return true;
  }
  alignas(32) double leasts[4];
  store(least, leasts);
  std::int64_t keys[4];
  for (std::size_t k = 0; k < 4; ++k) {
    keys[k] = (wanted >> k & 1) != 0 ? make_key(leasts[k], k) : kNever;
  }
  sort(keys);
  for (int i = others; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(keys[i] & kChildBits);
    child = {keys[i], node.first[k], node.count[k]};
    if (i > 0) stack.push(child);
  }
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
template <class Measure, class Visit>
PALPATE_TREE_INLINE void walk(const AabbTree& tree, Measure measure, double most, Visit visit) {
  const AabbTree::Node* nodes = tree.nodes().data();
  if (nodes == nullptr) return;
  int stack[(AabbTree::kWidth - 1) * AabbTree::kMaxDepth + 1];
  std::size_t size = 1;
  stack[0] = 0;
  while (size > 0) {
    const AabbTree::Node& node = nodes[stack[--size]];
    unsigned wanted = bits(measure(node) <= set(most)) & list_present(node);
    while (wanted != 0) {
      const std::size_t k = take_lowest(wanted);
      if (node.count[k] > 0) {
        visit(node.first[k], node.count[k]);
      } else {
        stack[size++] = node.first[k];
      }
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
