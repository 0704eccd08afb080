// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/pending_snapshot.h"

#include <algorithm>
#include <utility>

#include "palpate/sim/model/volumes.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

PendingSnapshot::PendingSnapshot(const World& world) {
  if (const PackedKernel* packed = find_packed(world)) {
    displacement.resize(packed->state.displacement.size());
  }
  const std::span<const Vec3> surface = surface_position(world);
  seen.position.assign(surface.begin(), surface.end());
  seen.substeps = world.substeps;
}

void note_world(const World& world, const HapticSample& sample, PendingSnapshot& pending) noexcept {
  pending.seen.tick = world.tick_count - 1;
  pending.seen.time = sample.time;
  pending.seen.sample = sample;
  pending.seen.tool_position = world.tool.position;
  pending.seen.touching = world.tool.touching;
  pending.seen.substeps = world.substeps;
  // after an alarm the packed tissue is not where the world stands still
  pending.packed = lags(world) && is_behind(world);
  if (pending.packed) {
    std::ranges::copy(find_packed(world)->state.displacement, pending.displacement.begin());
  } else {
    std::ranges::copy(surface_position(world), pending.seen.position.begin());
  }
}

SnapshotReader::SnapshotReader(const World& world)
    : model_(find_packed(world) ? find_packed(world)->model : nullptr),
      slices_(model_ ? model_->slice_count : 0),
      particles_(world.skin.empty() ? 0 : world.tissue.position.size()),
      snapshot_(PendingSnapshot(world).seen) {}

void SnapshotReader::read(const Scene& scene, const PendingSnapshot& pending) {
  if (!pending.packed) {
    snapshot_ = pending.seen;
    return;
  }
  Vec3Array position = std::move(snapshot_.position);
  Vec3Array& to = particles_.empty() ? position : particles_;
  unpack_positions(*model_, scene.tissue, pending.displacement, slices_.span(), to);
  if (!particles_.empty()) move_skin(scene.tissue.skin, particles_, position);
  snapshot_ = pending.seen;
  snapshot_.position = std::move(position);
}

}  // namespace palpate
