// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/tick_log.h"

#include <stdexcept>
#include <string>

namespace palpate {
namespace {

// rare beside the ticks: a second of nothing but missed ticks, and minutes of hashes
constexpr std::size_t kEventCapacity = 1000;
constexpr std::size_t kHashCapacity = 240;

int validated(int instruments) {
  if (instruments < 1 || instruments > kMostLoggedInstruments) {
    throw std::invalid_argument("tick log: instruments: got " + std::to_string(instruments) +
                                ", expected 1 to " + std::to_string(kMostLoggedInstruments));
  }
  return instruments;
}

std::size_t count_rows(int tick_capacity, int instruments) {
  if (tick_capacity < 1) {
    throw std::invalid_argument("tick log: tick_capacity: got " + std::to_string(tick_capacity) +
                                ", expected at least 1");
  }
  return static_cast<std::size_t>(tick_capacity) * static_cast<std::size_t>(instruments);
}

}  // namespace

TickLog::TickLog(int tick_capacity, int instruments)
    : instruments_(validated(instruments)),
      ticks_(count_rows(tick_capacity, instruments)),
      events_(kEventCapacity),
      hashes_(kHashCapacity) {}

bool TickLog::push(const Tick& tick) noexcept { return push(std::span(&tick, 1)); }

bool TickLog::push(std::span<const Tick> ticks) noexcept {
  if (ticks.size() == static_cast<std::size_t>(instruments_) && ticks_.push(ticks)) return true;
  gaps_.fetch_add(1, std::memory_order_relaxed);
  return false;
}

bool TickLog::push(const Event& event) noexcept {
  if (events_.push(event)) return true;
  gaps_.fetch_add(1, std::memory_order_relaxed);
  return false;
}

bool TickLog::push(const StateHash& hash) noexcept {
  if (hashes_.push(hash)) return true;
  gaps_.fetch_add(1, std::memory_order_relaxed);
  return false;
}

void TickLog::take(std::vector<Tick>& ticks, std::vector<Event>& events,
                   std::vector<StateHash>& hashes) {
  // later things first: a reader that sees an event or a hash will also see the tick it belongs to
  hashes_.take(hashes);
  events_.take(events);
  ticks_.take(ticks);
}

}  // namespace palpate
