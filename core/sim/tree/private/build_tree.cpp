// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tree/private/build_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/tree/private/box.h"

namespace palpate {
namespace {

constexpr int kBins = 16;

// below this depth triangles are halved by count, which ends after at most 29 more levels for
// any number an int can hold: the sum stays under AabbTree::kMaxDepth
constexpr int kMedianDepth = 32;

struct Item {
  Box box;
  Vec3 centre;
  int triangle;
};

struct Split {
  int axis = -1;
  double start = 0.0, scale = 0.0;
  int last_bin = 0;  // the last one that goes left
  double cost = std::numeric_limits<double>::infinity();

  int bin(const Item& item) const {
    return std::min(kBins - 1, static_cast<int>((item.centre[axis] - start) * scale));
  }
};

Box bound_centres(std::span<const Item> items) {
  Box box;
  for (const Item& item : items) box.add(item.centre);
  return box;
}

/// How many vectors a run of triangles fills: one takes as long as it is full or not.
double count_vectors(int triangles) {
  return static_cast<double>((triangles + AabbTree::kLeafSize - 1) / AabbTree::kLeafSize);
}

/// The cheapest of the 15 planes between the bins along one axis by the surface area heuristic:
/// cost = A_left n_left + A_right n_right [MacDonald90], binned [Wald07], with n in vectors.
Split find_split_along(int axis, std::span<const Item> items, const Box& centres) {
  Split split;
  const double extent = centres.high[axis] - centres.low[axis];
  if (!(extent > kBins * std::numeric_limits<double>::min())) return split;
  split = {.axis = axis, .start = centres.low[axis], .scale = kBins / extent};

  std::array<Box, kBins> boxes;
  std::array<int, kBins> counts{};
  for (const Item& item : items) {
    const auto bin = static_cast<std::size_t>(split.bin(item));
    boxes[bin].add(item.box);
    ++counts[bin];
  }
  std::array<double, kBins> right_cost{};
  Box right;
  int count = 0;
  for (std::size_t b = kBins - 1; b > 0; --b) {
    right.add(boxes[b]);
    count += counts[b];
    right_cost[b] = count == 0 ? 0.0 : right.half_area() * count_vectors(count);
  }
  Box left;
  count = 0;
  for (std::size_t b = 0; b + 1 < kBins; ++b) {
    left.add(boxes[b]);
    count += counts[b];
    if (count == 0 || count == static_cast<int>(items.size())) continue;
    const double cost = left.half_area() * count_vectors(count) + right_cost[b + 1];
    if (cost < split.cost) {
      split.cost = cost;
      split.last_bin = static_cast<int>(b);
    }
  }
  return split;
}

/// Moves the items of the left child to the front; how many they are, 0 where the centres
/// coincide and no plane parts them.
int part_by_area(std::span<Item> items, const Box& centres) {
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const Split split = find_split_along(axis, items, centres);
    if (split.cost < best.cost) best = split;
  }
  if (best.axis < 0) return 0;
  const auto middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
    return best.bin(item) <= best.last_bin;
  });
  return static_cast<int>(middle - items.begin());
}

int part_by_count(std::span<Item> items, const Box& centres) {
  int axis = 0;
  (centres.high - centres.low).maxCoeff(&axis);
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), middle, items.end(), [axis](const Item& a, const Item& b) {
    if (a.centre[axis] != b.centre[axis]) return a.centre[axis] < b.centre[axis];
    return a.triangle < b.triangle;
  });
  return static_cast<int>(middle - items.begin());
}

/// A run of items that becomes one child.
struct Part {
  int first = 0, count = 0;
  double half_area = 0.0;
};

class Builder {
 public:
  Builder(std::vector<Item>& items, TreeShape& shape) : items_(items), shape_(shape) {}

  /// Appends a node over `whole`, all nodes below it, and their triangles. Boxes come later.
  void build(const Part& whole, int depth) {
    std::array<Part, AabbTree::kWidth> parts;
    const int count = open(whole, depth, parts);
    const std::size_t me = shape_.nodes.size();
    shape_.nodes.emplace_back();
    shape_.nodes[me].count.fill(-1);
    for (int k = 0; k < count; ++k) {
      const auto slot = static_cast<std::size_t>(k);
      const Part& part = parts[slot];
      const bool leaf = part.count <= AabbTree::kLeafSize;
      shape_.nodes[me].first[slot] =
          static_cast<int>(leaf ? shape_.order.size() : shape_.nodes.size());
      shape_.nodes[me].count[slot] = leaf ? part.count : 0;
      if (leaf) {
        for (const Item& item : items_of(part)) shape_.order.push_back(item.triangle);
      } else {
        build(part, depth + 1);
      }
    }
  }

  Part make_part(int first, int count) const {
    Part part{first, count, 0.0};
    Box box;
    for (const Item& item : items_of(part)) box.add(item.box);
    part.half_area = box.half_area();
    return part;
  }

 private:
  std::span<Item> items_of(const Part& part) const {
    return std::span(items_).subspan(static_cast<std::size_t>(part.first),
                                     static_cast<std::size_t>(part.count));
  }

  /// Halves the largest part until there are eight or none is larger than a leaf.
  int open(const Part& whole, int depth, std::array<Part, AabbTree::kWidth>& parts) {
    parts[0] = whole;
    int count = 1;
    while (count < AabbTree::kWidth) {
      Part* largest = nullptr;
      for (int k = 0; k < count; ++k) {
        Part& part = parts[static_cast<std::size_t>(k)];
        if (part.count <= AabbTree::kLeafSize) continue;
        if (largest == nullptr || part.half_area > largest->half_area ||
            (part.half_area == largest->half_area && part.count > largest->count)) {
          largest = &part;
        }
      }
      if (largest == nullptr) break;
      const Part part = *largest;
      const int left = halve(items_of(part), depth);
      *largest = make_part(part.first, left);
      parts[static_cast<std::size_t>(count++)] = make_part(part.first + left, part.count - left);
    }
    return count;
  }

  static int halve(std::span<Item> items, int depth) {
    const Box centres = bound_centres(items);
    const int left = depth < kMedianDepth ? part_by_area(items, centres) : 0;
    return left > 0 ? left : part_by_count(items, centres);
  }

  std::vector<Item>& items_;
  TreeShape& shape_;
};

}  // namespace

TreeShape build_tree(std::span<const Vec3> x, std::span<const Triangle> triangles) {
  std::vector<Item> items(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Box box = bound_triangle(x, triangles[t]);
    // halves first: the sum of two large coordinates may overflow
    items[t] = {box, 0.5 * box.low + 0.5 * box.high, static_cast<int>(t)};
  }
  TreeShape shape;
  shape.order.reserve(triangles.size());
  Builder builder(items, shape);
  builder.build(builder.make_part(0, static_cast<int>(items.size())), 0);
  shape.nodes.shrink_to_fit();
  return shape;
}

}  // namespace palpate
