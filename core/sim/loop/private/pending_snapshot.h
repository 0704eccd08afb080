// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/loop/loop.h"
#include "palpate/sim/packed/private/packed_model.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// What the haptic thread leaves for a snapshot. Where a body lags (follow_tissue.h) that is how
/// the packed tissue lies in memory: its reader unpacks it, in a thread that has time for that.
struct PendingSnapshot {
  /// The displacements of a body that is packed.
  struct Packed {
    CacheAligned<float> displacement;  ///< [m] as PackedState::displacement
    bool in_use = false;               ///< they tell, and the positions do not
  };

  PendingSnapshot() = default;
  /// With room for all of its surfaces, and the steps and limits of a task.
  explicit PendingSnapshot(const World& world, const TaskState& task = {});

  /// positions left as they were where displacements tell; what has torn is of particles
  Snapshot seen;
  std::vector<Packed> packed;  ///< per body
};

/// Haptic thread: notes the world after a tick with these samples, one for each instrument. Does
/// not allocate.
void note_world(const World& world, std::span<const HapticSample> samples,
                PendingSnapshot& pending) noexcept;

/// What readers see, in their own memory.
class SnapshotReader {
 public:
  explicit SnapshotReader(const World& world);
  void read(const Scene& scene, const PendingSnapshot& pending);
  const Snapshot& snapshot() const noexcept { return snapshot_; }

 private:
  /// What it takes to unpack a body.
  struct Unpacked {
    explicit Unpacked(const SoftState& body);
    std::shared_ptr<const PackedModel> model;
    PackedList slices;
    Vec3Array particles;  // [m] under a skin
  };

  std::vector<Unpacked> unpacked_;  // per body
  Snapshot snapshot_;
};

}  // namespace palpate
