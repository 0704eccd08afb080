// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <thread>

#include "palpate/sim/base/private/duration_histogram.h"
#include "palpate/sim/multirate/private/exchange.h"
#include "palpate/sim/tick/tick_log.h"

namespace palpate {

/// Moves the tissue of a scene with an exchange_rate in a thread of its own, and gives the haptic
/// thread its forces between two exchanges [stability: slow tissue].
///
/// Both share one Exchange in turns, as a TreeBuilder and its user do: nobody ever waits for the
/// other, and the haptic thread neither allocates nor frees. An exchange is taken up when it is due
/// and not before, so a run in which the tissue is never late is the same to the bit in whatever
/// time it was done; one that is late is taken up in the first tick in which it is there. The tick
/// log is told of each, so that a replay takes it up there.
class TissueWorker {
 public:
  explicit TissueWorker(const Scene& scene);
  ~TissueWorker();  ///< waits for an exchange that is being computed

  /// Haptic thread: tick `number`, in the place of tick(). `world` is what is told of it: it shows
  /// the tissue as it was told last.
  void tick(std::span<const HapticSample> samples, World& world, std::span<HapticCommand> commands,
            TickLog* log) noexcept;
  /// [N/m] That the device of an instrument keeps passive; before the first tick.
  void set_passive_stiffness(std::size_t instrument, double passive) noexcept {
    fast_.set_passive_stiffness(instrument, passive);
  }
  /// Haptic thread: the next exchange tells the log the hash of the tissue's world.
  void ask_for_hash() noexcept { wants_hash_ = true; }

  // any thread
  long exchanges() const noexcept { return exchanges_.load(std::memory_order_relaxed); }
  long late_exchanges() const noexcept { return late_.load(std::memory_order_relaxed); }
  const DurationHistogram& costs() const noexcept { return costs_; }

 private:
  enum class Turn { hands, tissue };

  void take(World& world, TickLog* log) noexcept;
  void work() noexcept;
  void fail() noexcept;

  const Scene& scene_;
  SlowSide slow_;      // the worker's own
  Exchange exchange_;  // of whose turn it is
  FastSide fast_;      // the haptic thread's own, as is what follows
  bool wants_hash_ = false;

  std::atomic<Turn> turn_{Turn::hands};
  std::atomic<bool> over_{false};
  std::atomic<unsigned> calls_{0};  // what the worker sleeps on
  std::atomic<long> exchanges_{0}, late_{0};
  DurationHistogram costs_;
  std::thread thread_;
};

}  // namespace palpate
