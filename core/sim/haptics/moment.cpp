// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/moment.h"

#include <algorithm>
#include <utility>

#include "palpate/sim/dynamics/packed.h"
#include "palpate/sim/haptics/follow_tissue.h"
#include "palpate/sim/model/volumes.h"

namespace palpate {

Moment::Moment(const World& world) : displacement(world.packed.displacement.size()) {
  const std::span<const Vec3> surface = surface_position(world);
  seen.position.assign(surface.begin(), surface.end());
  seen.substeps = world.substeps;
}

void note_world(const World& world, const HapticSample& sample, Moment& moment) noexcept {
  moment.seen.tick = world.tick_count - 1;
  moment.seen.time = sample.time;
  moment.seen.sample = sample;
  moment.seen.tool_position = world.tool.position;
  moment.seen.touching = world.tool.touching;
  moment.seen.substeps = world.substeps;
  // after an alarm the packed tissue is not where the world stands still
  moment.packed = lags(world) && world.lag.behind;
  if (moment.packed) {
    std::ranges::copy(world.packed.displacement, moment.displacement.begin());
  } else {
    std::ranges::copy(surface_position(world), moment.seen.position.begin());
  }
}

SnapshotReader::SnapshotReader(const World& world)
    : model_(world.packed_model),
      slices_(model_ ? model_->slice_count : 0),
      particles_(world.skin.empty() ? 0 : world.tissue.position.size()),
      snapshot_(Moment(world).seen) {}

void SnapshotReader::read(const Scene& scene, const Moment& moment) {
  if (!moment.packed) {
    snapshot_ = moment.seen;
    return;
  }
  Vec3Array position = std::move(snapshot_.position);
  Vec3Array& to = particles_.empty() ? position : particles_;
  unpack_positions(*model_, scene.tissue, moment.displacement, slices_.span(), to);
  if (!particles_.empty()) move_skin(scene.tissue.skin, particles_, position);
  snapshot_ = moment.seen;
  snapshot_.position = std::move(position);
}

}  // namespace palpate
