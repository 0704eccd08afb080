// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "palpate/sim/device/device.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/tick/scene.h"

namespace palpate {

/// What a tissue does to a tool that is near some place, to first order: F(p) = f0 - K (p - p0),
/// and nothing where that would pull [stability: slow tissue].
struct LocalModel {
  double time = 0.0;              ///< [s] of the hand that it was taken at
  Vec3 position = Vec3::Zero();   ///< [m] p0 of the tool
  Vec3 force = Vec3::Zero();      ///< [N] f0 on the tool there
  Vec3 normal = Vec3::Zero();     ///< unit, out of the tissue; 0 where none is near
  Mat3 stiffness = Mat3::Zero();  ///< [N/m] K, symmetric
  bool held = false;              ///< the force pulls as well: the tool is attached
};
static_assert(alignof(LocalModel) == 8);

/// What is felt between two exchanges with a slow tissue.
enum class LocalForceMode {
  local_stiffness,  ///< F(p) at the tool's place of this very tick
  hold,             ///< the last force told
  extrapolation,    ///< the line through the last two forces told, over time
};

/// A scene whose tissue moves at a rate of its own beside hands that are read faster.
///
/// Hands are told to the tissue every so many ticks of theirs. In the time until the next exchange
/// it follows from the hand told before to the one told last, in ticks of its own, and is then told
/// as a local model: so a model is one to two intervals old while it is felt. Here all is done in
/// the thread that asks, at the exchange: a run is the same to the bit however long the tissue
/// took.
class SlowTissue {
 public:
  /// Hands are read at `hand_rate` [Hz] and told every `ticks` of theirs; the tissue ticks at
  /// Scene::rate. The scene must outlive this. Throws std::invalid_argument where an interval is
  /// not a whole number of the tissue's ticks, or no time.
  SlowTissue(const Scene& scene, double hand_rate, int ticks,
             LocalForceMode mode = LocalForceMode::local_stiffness);
  SlowTissue(SlowTissue&&) noexcept;
  ~SlowTissue();

  /// One tick of the hands: the forces they must feel, from one sample for each instrument, whose
  /// own times do not count. Hands are followed at up to 3 m/s. After an alarm the forces fade to
  /// zero. Throws std::invalid_argument for another number of samples.
  std::vector<HapticCommand> tick(std::span<const HapticSample> samples);
  /// The same for a scene of one instrument.
  HapticCommand tick(const HapticSample& sample);

  /// What an instrument is rendered from. Throws std::out_of_range for one that there is not.
  const LocalModel& model(std::size_t instrument = 0) const;
  const Alarm& alarm() const noexcept;  ///< the first of the tissue
  double interval() const noexcept;     ///< [s] between exchanges
  int tissue_ticks() const noexcept;    ///< in an interval

 private:
  struct Run;
  std::unique_ptr<Run> run_;
};

}  // namespace palpate
