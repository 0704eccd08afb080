// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/multirate/private/local_force.h"
#include "palpate/sim/multirate/private/stiffness_scale.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// What hands and tissue tell each other at an exchange. Has its full size from the start: nothing
/// of it is allocated while it is told.
struct Exchange {
  explicit Exchange(const World& world);

  // of the hands
  std::vector<HapticSample> hands;  ///< per instrument
  double time = 0.0;                ///< [s]
  bool wants_hash = false;

  // of the tissue, an interval on
  std::vector<LocalModel> models;       ///< per instrument
  std::vector<int> held;                ///< per instrument: triangles that it is fastened to
  std::vector<Vec3Array> surfaces;      ///< [m] per body, the vertices of its surface
  std::vector<int> substeps;            ///< per body, of the last tick
  std::vector<Safeguard> safeguards;    ///< likewise
  std::vector<Alarm> averted;           ///< per body, the last
  std::array<std::uint64_t, 2> hash{};  ///< where it was asked for
  Alarm alarm;
  int alarm_body = -1;
  double cost = 0.0;  ///< [s] that the tissue took
};

/// The tissue's side: it moves in ticks of its own from exchange to exchange.
class SlowSide {
 public:
  /// `ticks` in an interval. The scene must outlive this.
  SlowSide(const Scene& scene, int ticks);

  /// Goes an interval on, from the hands told before to these, and tells where that has led to. In
  /// no haptic thread: it allocates.
  void follow(Exchange& exchange);
  const World& world() const noexcept { return world_; }

 private:
  void move(std::span<const HapticSample> hands) noexcept;
  void tell(Exchange& exchange);

  const Scene& scene_;
  World world_;
  int ticks_;
  bool has_hands_ = false;
  std::vector<HapticSample> told_;       // per instrument
  std::vector<HapticCommand> commands_;  // per instrument, of the last tick
  std::vector<StiffnessScale> scales_;   // per instrument
  std::vector<Candidates> scratch_;      // per body
};

/// The hands' side, in the haptic thread: does not allocate, lock or throw.
class FastSide {
 public:
  /// Hands are read every `step` [s], and tell the tissue every `ticks` of theirs.
  FastSide(const Scene& scene, LocalForceMode mode, double step, int ticks);

  /// Begins a tick with a sample of each instrument. Hands are followed at up to 3 m/s.
  void follow(std::span<const HapticSample> samples) noexcept;
  /// Ticks since the tissue was last told; whether it is to be told again in this one.
  long age() const noexcept { return tick_ - told_at_; }
  bool is_due() const noexcept { return told_at_ < 0 || age() >= ticks_; }
  /// From now on by what the tissue tells.
  void take(const Exchange& exchange) noexcept;
  /// What the tissue is to follow from now on.
  void tell(Exchange& exchange) noexcept;
  /// Ends a tick: the forces that the hands must feel.
  void render(std::span<HapticCommand> commands) noexcept;

  /// [N/m] That the device of an instrument keeps passive; before the first tick.
  void set_passive_stiffness(std::size_t instrument, double passive) noexcept {
    forces_[instrument].set_passive_stiffness(passive);
  }
  bool has_told() const noexcept { return told_at_ >= 0; }
  int ticks() const noexcept { return ticks_; }
  double step() const noexcept { return step_; }
  std::span<const HapticSample> hands() const noexcept { return hands_; }
  const std::vector<LocalForce>& forces() const noexcept { return forces_; }

 private:
  double now() const noexcept { return static_cast<double>(tick_) * step_; }  // [s]

  double step_;  // [s]
  int ticks_;
  long tick_ = 0, told_at_ = -1;
  std::vector<LocalForce> forces_;   // per instrument
  std::vector<HapticSample> hands_;  // per instrument
};

/// What an instrument's state says of a tick of the hands' side, for records and readers: where the
/// tool is, whether it touches, what was felt.
void show_tick(const FastSide& fast, const Scene& scene, std::span<const HapticCommand> commands,
               World& world) noexcept;

/// What a world that does not tick shows of the tissue's side: surfaces, which trade places with
/// those it had, holds, substeps and alarm.
void show_exchange(Exchange& exchange, World& world) noexcept;

/// Ticks of the hands in an interval: Scene::rate / Scene::exchange_rate, 0 without one.
int count_exchange_ticks(const Scene& scene) noexcept;

}  // namespace palpate
