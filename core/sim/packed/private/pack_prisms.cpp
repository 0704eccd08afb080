// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/pack_prisms.h"

#include <algorithm>
#include <limits>

#include "palpate/sim/dynamics/private/prism_law.h"
#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/packed/private/pack_solid.h"
#include "palpate/sim/packed/private/packed_order.h"

namespace palpate {
namespace {

// prisms to choose from for each lane of a pack: each meets about a dozen others
constexpr int kLookaheadPerLane = 24;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// [m²] of a diagonal that has lost its direction.
float find_least_square(const TissueModel& model) {
  double shortest = std::numeric_limits<double>::infinity();
  const auto where = [&](int i) -> const Vec3& { return model.rest_position[at(i)]; };
  for (const auto& corners : model.prisms.corners) {
    for (int side = 0; side < 3; ++side) {
      const Diagonals rest(PrismSide(corners, side), where);
      shortest = std::min({shortest, rest.length[0], rest.length[1]});
    }
  }
  const double least = kNoDirection * shortest;
  return static_cast<float>(least * least);
}

/// Where lane `lane` of all packs finds the first of `columns` numbers, `width` apart.
std::size_t find_block(int lane, int width, int columns) {
  return at(columns * (lane - lane % width) + lane % width);
}

CacheAligned<float> pack_sides(const std::vector<int>& order, int width,
                               const std::vector<std::array<double, 3>>& table) {
  CacheAligned<float> values(3 * order.size(), 0.0f);
  for (int lane = 0; lane < static_cast<int>(order.size()); ++lane) {
    if (order[at(lane)] < 0) continue;
    for (int c = 0; c < 3; ++c) {
      values[find_block(lane, width, 3) + at(c * width)] =
          static_cast<float>(table[at(order[at(lane)])][at(c)]);
    }
  }
  return values;
}

}  // namespace

void pack_prisms(const TissueModel& model, PackedModel& packed) {
  const Prisms& prisms = model.prisms;
  if (prisms.corners.empty()) return;
  const int width = packed.width;
  const auto rows = map_rows(packed, prisms.corners);
  const std::vector<int> order = find_pack_order<6>(rows, width, kLookaheadPerLane * width);
  PackedPrisms& packs = packed.prisms;
  packs.pack_count = static_cast<int>(order.size()) / width;
  packs.corner.assign(6 * order.size(), 0);
  for (int lane = 0; lane < static_cast<int>(order.size()); ++lane) {
    if (order[at(lane)] < 0) continue;
    for (int c = 0; c < 6; ++c) {
      packs.corner[find_block(lane, width, 6) + at(c * width)] = rows[at(order[at(lane)])][at(c)];
    }
  }
  packs.rest_difference = pack_sides(order, width, prisms.rest_difference);
  packs.stiffness = pack_sides(order, width, prisms.shear_stiffness);
  packs.damping = pack_sides(order, width, prisms.shear_damping);
  const auto is_zero = [](float value) { return value == 0.0f; };
  if (std::ranges::all_of(packs.damping, is_zero)) packs.damping.clear();
  packs.least_square = find_least_square(model);
}

}  // namespace palpate
