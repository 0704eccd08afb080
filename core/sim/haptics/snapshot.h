// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/haptics/device.h"
#include "palpate/sim/haptics/world.h"

namespace palpate {

/// What a reader outside the haptic thread sees: the world as it was at most 8 ms ago.
struct Snapshot {
  long tick = 0;
  double time = 0.0;   ///< [s]
  Vec3Array position;  ///< [m] of the vertices of the surface
  HapticSample sample;
  Vec3 tool_position = Vec3::Zero();
  Vec3 force = Vec3::Zero();  ///< [N] on the hand
  bool touching = false;
  double cost = 0.0;      ///< [s] of the last tick
  double lateness = 0.0;  ///< [s] of the last tick
  int substeps = 0;
  long missed_ticks = 0;
};

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
