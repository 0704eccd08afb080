// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/aabb_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "palpate/sim/contact/box.h"
#include "palpate/sim/contact/refit_boxes.h"

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

/// The cheapest of the 15 planes between the bins along one axis by the surface area heuristic:
/// cost = A_left n_left + A_right n_right [MacDonald90], binned [Wald07].
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
  for (std::size_t b = kBins - 1, count = 0; b > 0; --b) {
    right.add(boxes[b]);
    count += static_cast<std::size_t>(counts[b]);
    right_cost[b] = count == 0 ? 0.0 : right.half_area() * static_cast<double>(count);
  }
  Box left;
  int count = 0;
  for (std::size_t b = 0; b + 1 < kBins; ++b) {
    left.add(boxes[b]);
    count += counts[b];
    if (count == 0 || count == static_cast<int>(items.size())) continue;
    const double cost = left.half_area() * count + right_cost[b + 1];
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

/// Appends the nodes of `items`, and their triangles to `order`, depth first. Boxes come later.
void build(std::span<Item> items, int depth, std::vector<AabbTree::Node>& nodes,
           std::vector<int>& order) {
  const std::size_t me = nodes.size();
  nodes.emplace_back();
  if (items.size() <= AabbTree::kLeafSize) {
    nodes[me].first = static_cast<int>(order.size());
    nodes[me].count = static_cast<int>(items.size());
    for (const Item& item : items) order.push_back(item.triangle);
    return;
  }
  const Box centres = bound_centres(items);
  int left = depth < kMedianDepth ? part_by_area(items, centres) : 0;
  if (left == 0) left = part_by_count(items, centres);

  build(items.first(static_cast<std::size_t>(left)), depth + 1, nodes, order);
  nodes[me].first = static_cast<int>(nodes.size());
  build(items.subspan(static_cast<std::size_t>(left)), depth + 1, nodes, order);
}

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
  std::vector<Item> items(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Box box = bound_triangle(x, triangles[t]);
    // halves first: the sum of two large coordinates may overflow
    items[t] = {box, 0.5 * box.low + 0.5 * box.high, static_cast<int>(t)};
  }
  nodes_.reserve(triangles.size());
  order_.reserve(triangles.size());
  build(items, 0, nodes_, order_);
  nodes_.shrink_to_fit();

  std::vector<int> particles;
  for (int i = static_cast<int>(nodes_.size()); i-- > 0;) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    if (node.count == 0) {
      inner_.push_back(i);
      continue;
    }
    particles.clear();
    for (int k = node.first; k < node.first + node.count; ++k) {
      const auto t = static_cast<std::size_t>(order_[static_cast<std::size_t>(k)]);
      particles.insert(particles.end(), triangles_[t].begin(), triangles_[t].end());
    }
    std::sort(particles.begin(), particles.end());
    particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
    while (particles.size() % kBlock != 0) particles.push_back(particles.back());
    leaves_.push_back(
        {i, static_cast<int>(leaf_particles_.size()), static_cast<int>(particles.size())});
    leaf_particles_.insert(leaf_particles_.end(), particles.begin(), particles.end());
  }
  refit(x);
}

void AabbTree::refit(std::span<const Vec3> x) noexcept {
  refit_boxes({x, leaves_, leaf_particles_, inner_, nodes_});
}

}  // namespace palpate
