// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/device/device.h"

namespace palpate {

// bits of Felt::touched
inline constexpr std::uint8_t kTouching = 1;
inline constexpr std::uint8_t kAttached = 2;
/// The device's motors were not on: nobody felt the force of this tick.
inline constexpr std::uint8_t kNotRendered = 4;

/// What was felt in one tick, of one instrument.
struct Felt {
  Eigen::Vector3f force = Eigen::Vector3f::Zero();  ///< [N] from tick(), before the safety wrapper
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< [m] the tool
  std::uint8_t touched = 0;                            ///< kTouching, kAttached, kNotRendered
  std::uint16_t lateness_us = 0;                       ///< [us] saturates
};
static_assert(sizeof(Felt) == 28 && alignof(Felt) == 4);

enum class EventKind : std::int32_t {
  missed_ticks = 1,  ///< index: how many were skipped before this tick
  record_gap = 2,    ///< index: how many ticks the log had no room for
  alarm = 3,         ///< index: AlarmKind
  fault = 4,         ///< index: DeviceFault; value: what it found, see describe_fault
  attached = 5,
  released = 6,
  paused = 7,          ///< value: how long [s] the loop rested before this tick
  tree_exchanged = 8,  ///< index: ticks since its positions were taken; value: what the cost of
                       ///< queries had grown by (TreeCost)
  motors_off = 9,      ///< index: MotorState
  motors_on = 10,
  safeguard = 11,  ///< index: Safeguard from this tick on; value: the AlarmKind that it averts,
                   ///< 0 where one was taken back
  passivity = 12,  ///< the passivity controller began to damp; value: [J] the hand was given
  tissue_exchanged = 13,  ///< from this tick on a slow tissue is felt as it was told; index: ticks
                          ///< since its hands were told; value: [s] that it took
  coupling_limited = 14,  ///< from this tick on the hand's spring is bounded by what its device
                          ///< keeps passive; value: [N/m] that; index: [us] T/2 + d
  coupling_follows = 15,  ///< index 1: from this tick on it is stiffer, as the tissue asks; 0: no
                          ///< more; value: [N/m] of the tissue
};

/// Something that happened at a tick.
struct Event {
  std::int64_t tick = 0;
  EventKind kind = EventKind::missed_ticks;
  std::int32_t index = 0;
  double value = 0.0;
  /// Which body it is of: alarm (0 also for one of no body), tree_exchanged, safeguard; or which
  /// instrument: fault, attached, released, motors_off, motors_on, passivity, coupling_limited,
  /// coupling_follows. 0 for the other kinds.
  std::int32_t source = 0;
};
static_assert(sizeof(Event) == 32 && alignof(Event) == 8);

/// The world's hash after a tick (compute_hash in tick.h).
struct StateHash {
  std::int64_t tick = 0;
  std::array<std::uint64_t, 2> hash{};
};

/// More hands than any table has room for; what a record asks of memory grows with them.
inline constexpr int kMostLoggedInstruments = 16;

/// Where the haptic thread leaves what it did: rings with room for 4 s, one writer and one
/// reader, without lock or allocation. A full ring is a counted gap, never a blocked tick.
class TickLog {
 public:
  /// Of one instrument.
  struct Tick {
    std::int64_t tick = 0;
    HapticSample sample;
    Felt felt;
  };

  /// Throws std::invalid_argument for less than one tick, or not 1 to kMostLoggedInstruments.
  explicit TickLog(int tick_capacity = 4000, int instruments = 1);

  // haptic thread; false, and counted, when there is no room (of anything)
  bool push(const Tick& tick) noexcept;  ///< of a log of one instrument
  /// A tick of all instruments in order; false also for another number of them.
  bool push(std::span<const Tick> ticks) noexcept;
  bool push(const Event& event) noexcept;
  bool push(const StateHash& hash) noexcept;

  // reader thread; append what has arrived since the last call, whole ticks with as many rows as
  // there are instruments
  void take(std::vector<Tick>& ticks, std::vector<Event>& events, std::vector<StateHash>& hashes);
  long gap_count() const noexcept { return gaps_.load(std::memory_order_relaxed); }
  int instruments() const noexcept { return instruments_; }

 private:
  const int instruments_;
  Ring<Tick> ticks_;
  Ring<Event> events_;
  Ring<StateHash> hashes_;
  std::atomic<long> gaps_{0};
};

}  // namespace palpate
