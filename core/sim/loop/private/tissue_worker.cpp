// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/tissue_worker.h"

#include <cmath>
#include <exception>
#include <utility>

namespace palpate {

TissueWorker::TissueWorker(const Scene& scene)
    : scene_(scene),
      slow_(scene, count_exchange_ticks(scene)),
      exchange_(slow_.world()),
      fast_(scene, LocalForceMode::local_stiffness, 1.0 / scene.rate, count_exchange_ticks(scene)),
      thread_([this] { work(); }) {}

TissueWorker::~TissueWorker() {
  over_.store(true, std::memory_order_release);
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_one();
  thread_.join();
}

void TissueWorker::tick(std::span<const HapticSample> samples, World& world,
                        std::span<HapticCommand> commands, TickLog* log) noexcept {
  fast_.follow(samples);
  if (fast_.is_due() && turn_.load(std::memory_order_acquire) == Turn::hands) {
    if (fast_.has_told()) take(world, log);
    fast_.tell(exchange_);
    exchange_.wants_hash = std::exchange(wants_hash_, false);
    turn_.store(Turn::tissue, std::memory_order_release);
    calls_.fetch_add(1, std::memory_order_release);
    calls_.notify_one();
  }
  fast_.render(commands);
  show_tick(fast_, scene_, commands, world);
}

void TissueWorker::take(World& world, TickLog* log) noexcept {
  const long number = world.tick_count, age = fast_.age();
  fast_.take(exchange_);
  show_exchange(exchange_, world);
  exchanges_.fetch_add(1, std::memory_order_relaxed);
  if (age > fast_.ticks()) late_.fetch_add(1, std::memory_order_relaxed);
  costs_.add(std::llround(1e9 * exchange_.cost));
  if (!log) return;
  log->push(Event{number, EventKind::tissue_exchanged, static_cast<std::int32_t>(age),
                  exchange_.cost, 0});
  if (exchange_.wants_hash) log->push(StateHash{number, exchange_.hash});
}

/// No memory: of the tissue nothing more is known, so its force fades as after any alarm.
void TissueWorker::fail() noexcept {
  for (LocalModel& model : exchange_.models) model = {.held = true};
  exchange_.wants_hash = false;
  exchange_.alarm = {AlarmKind::not_solved, -1, 1.0 / scene_.exchange_rate, 0.0, exchange_.time};
}

void TissueWorker::work() noexcept {
  unsigned seen = 0;
  while (!over_.load(std::memory_order_acquire)) {
    if (turn_.load(std::memory_order_acquire) == Turn::tissue) {
      try {
        slow_.follow(exchange_);
      } catch (const std::exception&) {
        fail();
      }
      turn_.store(Turn::hands, std::memory_order_release);
    }
    calls_.wait(seen, std::memory_order_acquire);
    seen = calls_.load(std::memory_order_acquire);
  }
}

}  // namespace palpate
