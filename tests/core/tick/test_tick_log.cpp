// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "palpate/sim/tick/tick_log.h"

using namespace palpate;

namespace {

struct Taken {
  std::vector<TickLog::Tick> ticks;
  std::vector<Event> events;
  std::vector<StateHash> hashes;
  void from(TickLog& log) { log.take(ticks, events, hashes); }
};

}  // namespace

TEST_CASE("what is pushed into the log comes out once and in order") {
  TickLog log(10);
  Taken taken;

  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 7; ++i) REQUIRE(log.push(TickLog::Tick{7 * round + i, {}, {}}));
    log.push(Event{round, EventKind::attached, 3, 0.5});
    log.push(StateHash{round, {1, 2}});
    taken.from(log);
  }

  REQUIRE(taken.ticks.size() == 35);
  for (int i = 0; i < 35; ++i) CHECK(taken.ticks[static_cast<std::size_t>(i)].tick == i);
  CHECK(taken.events.size() == 5);
  CHECK(taken.events[4].tick == 4);
  CHECK(taken.hashes.size() == 5);
  CHECK(log.gap_count() == 0);
}

TEST_CASE("a full log refuses and counts, and what it holds stays whole") {
  TickLog log(4);
  Taken taken;

  for (int i = 0; i < 6; ++i) CHECK(log.push(TickLog::Tick{i, {}, {}}) == (i < 4));
  taken.from(log);

  CHECK(log.gap_count() == 2);
  REQUIRE(taken.ticks.size() == 4);
  CHECK(taken.ticks.back().tick == 3);
  CHECK(log.push(TickLog::Tick{6, {}, {}}));
  CHECK_THROWS_AS(TickLog(0), std::invalid_argument);
}

TEST_CASE("a tick of several instruments is in the log whole or not at all") {
  TickLog log(2, 3);
  Taken taken;
  const auto rows = [](std::int64_t tick) {
    return std::vector<TickLog::Tick>{{tick, {}, {}}, {tick, {}, {}}, {tick, {}, {}}};
  };

  for (int i = 0; i < 3; ++i) CHECK(log.push(rows(i)) == (i < 2));
  CHECK_FALSE(log.push(TickLog::Tick{3, {}, {}}));
  taken.from(log);

  CHECK(log.instruments() == 3);
  CHECK(log.gap_count() == 2);
  REQUIRE(taken.ticks.size() == 6);
  for (std::size_t row = 0; row < 6; ++row) CHECK(taken.ticks[row].tick == long(row / 3));
  CHECK(log.push(rows(4)));
  CHECK_THROWS_AS(TickLog(10, 0), std::invalid_argument);
  CHECK_THROWS_AS(TickLog(10, kMostLoggedInstruments + 1), std::invalid_argument);
}

TEST_CASE("two threads pass a million ticks through a small log without a torn or a lost one" *
          doctest::test_suite("landing")) {
  TickLog log(64);
  constexpr std::int64_t kCount = 1000000;
  std::thread haptic([&] {
    for (std::int64_t i = 0; i < kCount;) {
      TickLog::Tick tick{i, {}, {}};
      tick.sample.time = static_cast<double>(i);
      tick.felt.lateness_us = static_cast<std::uint16_t>(i);
      if (log.push(tick))
        ++i;
      else
        std::this_thread::yield();
    }
  });

  Taken taken;
  std::int64_t next = 0;
  bool whole = true;
  while (next < kCount) {
    taken.ticks.clear();
    taken.from(log);
    for (const TickLog::Tick& tick : taken.ticks) {
      whole = whole && tick.tick == next && tick.sample.time == static_cast<double>(next) &&
              tick.felt.lateness_us == static_cast<std::uint16_t>(next);
      ++next;
    }
    if (taken.ticks.empty()) std::this_thread::yield();
  }
  haptic.join();

  CHECK(whole);
}
