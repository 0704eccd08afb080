// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/pack_solid.h"

#include "palpate/sim/dynamics/private/volume_law.h"
#include "palpate/sim/packed/private/packed_order.h"

namespace palpate {
namespace {

// tetrahedra to choose from for each lane of a pack: each meets more others than a triangle does
constexpr int kLookaheadPerLane = 24;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Packs of tetrahedra by the rows of their corners, and what of each stands in its lane.
void pack_tetrahedra(const TissueModel& model, PackedModel& packed) {
  const Volumes& volumes = model.volumes;
  const int width = packed.width;
  const auto rows = map_rows(packed, volumes.corners);
  const std::vector<int> order = find_pack_order<4>(rows, width, kLookaheadPerLane * width);
  PackedVolumes& packs = packed.volumes;
  packs.pack_count = static_cast<int>(order.size()) / width;
  packs.corner.assign(4 * order.size(), 0);
  packs.inverse_rest.assign(order.size(), 0.0f);
  if (volumes.nodal_share < 1.0) packs.stiffness.assign(order.size(), 0.0f);
  for (int lane = 0; lane < static_cast<int>(order.size()); ++lane) {
    if (order[at(lane)] < 0) continue;
    const std::size_t t = at(order[at(lane)]);
    for (int c = 0; c < 4; ++c) {
      packs.corner[at(4 * (lane - lane % width) + lane % width + c * width)] = rows[t][at(c)];
    }
    packs.inverse_rest[at(lane)] = static_cast<float>(1.0 / (6.0 * volumes.rest_volume[t]));
    if (packs.stiffness.empty()) continue;
    packs.stiffness[at(lane)] =
        static_cast<float>((1.0 - volumes.nodal_share) * volumes.bulk[t] / 6.0);
  }
}

void pack_around(const TissueModel& model, PackedModel& packed) {
  const Volumes& volumes = model.volumes;
  if (!(volumes.nodal_share > 0.0)) return;
  packed.volumes.inverse_rest_around.assign(packed.particle.size(), 0.0f);
  packed.volumes.stiffness_around.assign(packed.particle.size(), 0.0f);
  for (std::size_t i = 0; i < packed.row.size(); ++i) {
    const VolumeAround around = measure_around(volumes, i, model.rest_position);
    if (!(around.rest > 0.0)) continue;
    const std::size_t row = at(packed.row[i]);
    packed.volumes.inverse_rest_around[row] = static_cast<float>(1.0 / (6.0 * around.rest));
    packed.volumes.stiffness_around[row] =
        static_cast<float>(0.25 * volumes.nodal_share * around.bulk / 6.0);
  }
}

}  // namespace

void pack_solid(const TissueModel& model, PackedModel& packed) {
  packed.riding.corners = map_rows(packed, model.skin.corners);
  packed.riding.weights = model.skin.weights;
  if (model.volumes.corners.empty()) return;
  pack_tetrahedra(model, packed);
  pack_around(model, packed);
}

}  // namespace palpate
