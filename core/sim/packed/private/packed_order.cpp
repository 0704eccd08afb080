// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/packed_order.h"

#include <algorithm>
#include <numeric>

#include "palpate/sim/model/private/law_tables.h"

namespace palpate {
namespace {

// slices may only be as even as their neighbourhood: a wider window costs more in memory than it
// saves in padding, sooner on a large mesh [motion: packing]
constexpr int kWindow = 256, kWindowOfLarge = 64;
constexpr std::size_t kLarge = 100000;
/// particles of a patch: few slices, for all of them wake where one particle does
constexpr int kPatch = 16;

using Neighbours = std::vector<std::vector<int>>;

/// Who moves with whom: within each row of a law, and within triangles of the surface; ascending.
Neighbours find_neighbours(const TissueModel& model) {
  Neighbours neighbours(model.rest_position.size());
  const auto join = [&](int i, int j) {
    neighbours[static_cast<std::size_t>(i)].push_back(j);
    neighbours[static_cast<std::size_t>(j)].push_back(i);
  };
  const auto join_all = [&](const auto& rows) {
    for (const auto& corners : rows) {
      for (std::size_t p = 0; p < corners.size(); ++p) {
        for (std::size_t q = 0; q < p; ++q) join(corners[p], corners[q]);
      }
    }
  };
  laws::for_each_law([&]<class Law>(const Law& law) {
    using T = typename Law::Rows;
    laws::for_each_column(law, laws::Overloaded{[&]<std::size_t N>(const laws::Corners<T, N>& its) {
                                                  join_all((model.*law.of).*its.rows);
                                                },
                                                [](const auto&) {}});
  });
  if (model.skin.corners.empty()) join_all(model.triangles);
  for (std::vector<int>& row : neighbours) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
  return neighbours;
}

/// Appends everything that hangs together with `start`, ring by ring, in each ring those with few
/// neighbours first.
void append_rings(const Neighbours& neighbours, int start, std::vector<bool>& seen,
                  std::vector<int>& order) {
  const auto degree = [&](int i) { return neighbours[static_cast<std::size_t>(i)].size(); };
  seen[static_cast<std::size_t>(start)] = true;
  order.push_back(start);
  for (std::size_t next = order.size() - 1; next < order.size(); ++next) {
    const auto ring = static_cast<std::ptrdiff_t>(order.size());
    for (const int j : neighbours[static_cast<std::size_t>(order[next])]) {
      if (seen[static_cast<std::size_t>(j)]) continue;
      seen[static_cast<std::size_t>(j)] = true;
      order.push_back(j);
    }
    std::stable_sort(order.begin() + ring, order.end(),
                     [&](int a, int b) { return degree(a) < degree(b); });
  }
}

/// The reverse Cuthill-McKee order [CuthillMcKee69]: each part begins at an end of it, found as
/// the last particle of a first sweep.
std::vector<int> find_banded_order(const Neighbours& neighbours) {
  std::vector<bool> tried(neighbours.size(), false), seen(neighbours.size(), false);
  std::vector<int> order, sweep;
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    if (seen[i]) continue;
    sweep.clear();
    append_rings(neighbours, static_cast<int>(i), tried, sweep);
    append_rings(neighbours, sweep.back(), seen, order);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<int> count_links(const TissueModel& model) {
  std::vector<int> count(model.rest_position.size(), 0);
  for (const auto& [i, j] : model.springs.ends) {
    ++count[static_cast<std::size_t>(i)];
    ++count[static_cast<std::size_t>(j)];
  }
  return count;
}

/// Halves what lies between two places of `order` across its longest side, again and again, until
/// no part is larger than a window. Every part but the last is as large as some windows.
void part_by_place(const Vec3Array& x, std::span<int> order, int window) {
  if (static_cast<int>(order.size()) <= window) return;
  Vec3 low = x[static_cast<std::size_t>(order[0])], high = low;
  for (const int i : order) {
    low = low.cwiseMin(x[static_cast<std::size_t>(i)]);
    high = high.cwiseMax(x[static_cast<std::size_t>(i)]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int windows = (static_cast<int>(order.size()) + window - 1) / window;
  const auto middle = static_cast<std::size_t>(windows / 2 * window);
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(middle), order.end(),
                   [&](int a, int b) {
                     const double at_a = x[static_cast<std::size_t>(a)][axis];
                     const double at_b = x[static_cast<std::size_t>(b)][axis];
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  part_by_place(x, order.first(middle), window);
  part_by_place(x, order.subspan(middle), window);
}

/// Within each window those with many links first, so that the lanes of a slice need as many.
void even_out(const TissueModel& model, int window, std::vector<int>& order) {
  const std::vector<int> links = count_links(model);
  const auto more_links = [&](int a, int b) {
    return links[static_cast<std::size_t>(a)] > links[static_cast<std::size_t>(b)];
  };
  for (std::size_t first = 0; first < order.size(); first += static_cast<std::size_t>(window)) {
    const std::size_t last = std::min(order.size(), first + static_cast<std::size_t>(window));
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(first),
                     order.begin() + static_cast<std::ptrdiff_t>(last), more_links);
  }
}

}  // namespace

std::vector<int> find_bands(const TissueModel& model) {
  std::vector<int> order = find_banded_order(find_neighbours(model));
  even_out(model, order.size() < kLarge ? kWindow : kWindowOfLarge, order);
  return order;
}

std::vector<int> find_patches(const TissueModel& model) {
  std::vector<int> order(model.rest_position.size());
  std::iota(order.begin(), order.end(), 0);
  part_by_place(model.rest_position, order, kPatch);
  even_out(model, kPatch, order);
  return order;
}

template <std::size_t N>
std::vector<int> find_pack_order(std::span<const std::array<int, N>> elements, int width,
                                 int lookahead) {
  int rows = 0;
  for (const auto& corners : elements) {
    rows = std::max(rows, *std::max_element(corners.begin(), corners.end()) + 1);
  }
  std::vector<int> near(elements.size());
  std::iota(near.begin(), near.end(), 0);
  const auto lowest = [&](int t) {
    const auto& corners = elements[static_cast<std::size_t>(t)];
    return *std::min_element(corners.begin(), corners.end());
  };
  std::stable_sort(near.begin(), near.end(), [&](int a, int b) { return lowest(a) < lowest(b); });

  std::vector<int> order, waiting, left, pack_of_row(static_cast<std::size_t>(rows), -1);
  std::size_t next = 0;
  for (int pack = 0; next < near.size() || !waiting.empty(); ++pack) {
    while (static_cast<int>(waiting.size()) < lookahead && next < near.size()) {
      waiting.push_back(near[next++]);
    }
    const std::size_t full = order.size() + static_cast<std::size_t>(width);
    left.clear();
    for (const int t : waiting) {
      const auto& corners = elements[static_cast<std::size_t>(t)];
      const auto taken = [&](int row) {
        return pack_of_row[static_cast<std::size_t>(row)] == pack;
      };
      if (order.size() == full || std::any_of(corners.begin(), corners.end(), taken)) {
        left.push_back(t);
        continue;
      }
      for (const int row : corners) pack_of_row[static_cast<std::size_t>(row)] = pack;
      order.push_back(t);
    }
    order.resize(full, -1);
    waiting.swap(left);
  }
  return order;
}

template std::vector<int> find_pack_order<3>(std::span<const Triangle>, int, int);
template std::vector<int> find_pack_order<4>(std::span<const std::array<int, 4>>, int, int);
template std::vector<int> find_pack_order<6>(std::span<const std::array<int, 6>>, int, int);

}  // namespace palpate
