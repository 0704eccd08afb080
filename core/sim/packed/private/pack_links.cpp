// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/pack_links.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/private/tensions.h"

namespace palpate {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// One end of a link, as the particle at its other end sees it.
struct LinkEnd {
  int neighbour;
  float stiffness, rest_tension, damping;
};

std::vector<std::vector<LinkEnd>> list_ends(const PackedModel& packed,
                                            std::span<const ChosenLinks> tables) {
  std::vector<std::vector<LinkEnd>> ends(packed.particle.size());
  for (const auto& [links, chosen] : tables) {
    for (std::size_t l = 0; l < links->ends.size(); ++l) {
      if (!chosen[l]) continue;
      const int a = packed.row[at(links->ends[l][0])], b = packed.row[at(links->ends[l][1])];
      const auto k = static_cast<float>(links->stiffness[l]);
      const auto tension = static_cast<float>(links->stiffness[l] * links->rest_length[l]);
      const auto c = static_cast<float>(links->damping[l]);
      ends[at(a)].push_back({b, k, tension, c});
      ends[at(b)].push_back({a, k, tension, c});
    }
  }
  for (auto& row : ends) {
    std::stable_sort(row.begin(), row.end(),
                     [](const LinkEnd& a, const LinkEnd& b) { return a.neighbour < b.neighbour; });
  }
  return ends;
}

/// How many of them, from the first on, have a stiffness and a length.
std::size_t count_plain(const std::vector<LinkEnd>& ends) {
  const auto end = std::find_if(ends.begin(), ends.end(), [](const LinkEnd& link) {
    return !(link.stiffness > 0.0f && link.rest_tension > 0.0f);
  });
  return static_cast<std::size_t>(end - ends.begin());
}

}  // namespace

PackedColumn make_column(std::vector<float> values, std::size_t block, float filler) {
  const auto first = std::find_if(values.begin(), values.end(), [](float v) { return v == v; });
  const bool same =
      std::all_of(first, values.end(), [&](float v) { return v != v || v == *first; });
  PackedColumn column;
  if (same) {
    column.values.assign(block, first == values.end() ? filler : *first);
    return column;
  }
  std::replace_if(
      values.begin(), values.end(), [](float v) { return v != v; }, filler);
  column.values.assign(values.begin(), values.end());
  column.stride = block;
  return column;
}

void pack_links(std::span<const ChosenLinks> tables, PackedModel& packed) {
  const auto ends = list_ends(packed, tables);
  const std::size_t width = at(packed.width);
  std::vector<float> stiffness, tension, damping;
  PackedLinks& links = packed.links;
  links.first_slot.push_back(0);
  for (std::size_t first = 0; first < ends.size(); first += width) {
    std::size_t most = 0, plain = ends[first].size();
    for (std::size_t r = first; r < first + width; ++r) {
      most = std::max(most, ends[r].size());
      plain = std::min(plain, count_plain(ends[r]));
    }
    links.plain_end.push_back(links.first_slot.back() + static_cast<int>(plain));
    for (std::size_t slot = 0; slot < most; ++slot) {
      for (std::size_t r = first; r < first + width; ++r) {
        const bool used = slot < ends[r].size();
        const LinkEnd end =
            used ? ends[r][slot] : LinkEnd{static_cast<int>(r), kNoNumber, kNoNumber, kNoNumber};
        links.neighbour.push_back(end.neighbour);
        stiffness.push_back(end.stiffness);
        tension.push_back(end.rest_tension);
        damping.push_back(end.damping);
      }
    }
    links.first_slot.push_back(links.first_slot.back() + static_cast<int>(most));
  }
  links.stiffness = make_column(std::move(stiffness), width, 0.0f);
  links.rest_tension = make_column(std::move(tension), width, 0.0f);
  links.damping = make_column(std::move(damping), width, 0.0f);

  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [table, chosen] : tables) {
    for (const double length : table->rest_length) shortest = std::min(shortest, length);
  }
  const double least = std::isfinite(shortest) ? kNoDirection * shortest : 1e-9;
  links.least_square = static_cast<float>(least * least);
}

}  // namespace palpate
