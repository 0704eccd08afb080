// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/loop/snapshot.h"
#include "palpate/sim/packed/private/packed_model.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// What the haptic thread leaves for a snapshot. Where a world lags (follow_tissue.h) that is how
/// the packed tissue lies in memory: its reader unpacks it, in a thread that has time for
/// that.
struct PendingSnapshot {
  PendingSnapshot() = default;
  explicit PendingSnapshot(const World& world);  ///< with room for all of its surface

  Snapshot seen;                     ///< its positions left as they were where displacements tell
  CacheAligned<float> displacement;  ///< [m] as PackedState::displacement
  bool packed = false;               ///< the displacements tell
};

/// Haptic thread: notes the world after a tick with this sample. Does not allocate.
void note_world(const World& world, const HapticSample& sample, PendingSnapshot& pending) noexcept;

/// What readers see, in their own memory.
class SnapshotReader {
 public:
  explicit SnapshotReader(const World& world);
  void read(const Scene& scene, const PendingSnapshot& pending);
  const Snapshot& snapshot() const noexcept { return snapshot_; }

 private:
  std::shared_ptr<const PackedModel> model_;
  PackedList slices_;
  Vec3Array particles_;  // [m] under a skin
  Snapshot snapshot_;
};

}  // namespace palpate
