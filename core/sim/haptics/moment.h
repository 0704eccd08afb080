// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/haptics/snapshot.h"
#include "palpate/sim/haptics/world.h"

namespace palpate {

/// What the haptic thread leaves for a snapshot. Where a world lags (follow_tissue.h) that is how
/// the packed tissue lies in memory: whoever reads it unpacks it, in a thread that has time for
/// that.
struct Moment {
  Moment() = default;
  explicit Moment(const World& world);  ///< with room for all of its surface

  Snapshot seen;                     ///< its positions left as they were where displacements tell
  CacheAligned<float> displacement;  ///< [m] as PackedState::displacement
  bool packed = false;               ///< the displacements tell
};

/// Haptic thread: notes the world after a tick with this sample. Does not allocate.
void note_world(const World& world, const HapticSample& sample, Moment& moment) noexcept;

/// What readers see, in their own memory.
class SnapshotReader {
 public:
  explicit SnapshotReader(const World& world);
  void read(const Scene& scene, const Moment& moment);
  const Snapshot& snapshot() const noexcept { return snapshot_; }

 private:
  std::shared_ptr<const PackedModel> model_;
  PackedList slices_;
  Vec3Array particles_;  // [m] under a skin
  Snapshot snapshot_;
};

}  // namespace palpate
