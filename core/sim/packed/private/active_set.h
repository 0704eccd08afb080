// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/load.h"
#include "palpate/sim/packed/private/packed_model.h"

namespace palpate {

/// What decides which particles move.
struct ActiveRule {
  double threshold = 0.0;  ///< [m] who has moved less is at rest, wherever the tool is
  double reach = 0.0;      ///< [m] at rest; nothing so near to what the tool may touch sleeps
  double decay = 0.0;      ///< [m] the distance on which a pull along the surface falls to 1/e
  /// [m] times the depth of the tool, at most a decay length: who has moved less than that over
  /// how far it has moved in all is at rest too
  double product_limit_per_depth = 0.0;
};

/// The active set: which slices of a packed tissue move. The others sleep, that is, they stand
/// still where they fell asleep, until a neighbour has moved by the threshold or the tool comes
/// near; they fall asleep when for some time they have moved by less.
struct ActiveSet {
  /// Rows of numbers, one after the other.
  struct Table {
    std::vector<int> first;  ///< of each row, and the end
    std::vector<int> numbers;
    std::span<const int> row(int index) const noexcept {
      const auto at = static_cast<std::size_t>(index);
      return std::span(numbers).subspan(static_cast<std::size_t>(first[at]),
                                        static_cast<std::size_t>(first[at + 1] - first[at]));
    }
  };

  ActiveSet() = default;
  /// `patience` is after how many checks without motion a slice falls asleep. What the forces at
  /// the state leave where it is sleeps from the start.
  ActiveSet(const PackedModel& model, const TissueModel& tissue, const Load& load,
            const State& state, const ActiveRule& rule, int patience, PackedState& packed);

  bool on = false;
  float threshold = 0.0f;                ///< [m]
  double reach = 0.0;                    ///< [m]
  double decay = 0.0;                    ///< [m]
  double product_limit_per_depth = 0.0;  ///< [m] of the rule, for slices of this width
  double depth = 0.0;          ///< [m] of the tool, as the tissue has had time to follow it
  float product_limit = 0.0f;  ///< [m²] of the tool as it stands: zero where it touches nothing
  int patience = 0;            ///< checks

  Table neighbours, packs, skin;  ///< of each slice
  Vec3Array centre;               ///< [m] of each slice, at rest
  std::vector<double> radius;     ///< [m] likewise

  std::vector<unsigned char> awake, kept, moved, stirred;  ///< per slice
  std::vector<unsigned char> settled;      ///< per slice: has slept with the tool away
  std::vector<int> quiet;                  ///< checks since it last moved
  CacheAligned<float> anchor;              ///< [m] displacements then
  CacheAligned<float> still;               ///< [m] where it last slept so
  std::vector<int> pulling, pulling_skin;  ///< per pack: how many of its slices are awake
  Vec3 kept_about = Vec3::Zero();          ///< [m] at rest
  bool keeps = false;                      ///< some are kept
};
static_assert(alignof(ActiveSet) == 8);

}  // namespace palpate
