// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstdint>
#include <thread>

#include "palpate/sim/base/lock_free.h"

using namespace palpate;

TEST_CASE("a mailbox nobody wrote to shows its initial value and nothing new") {
  Latest<int> mailbox(7);

  CHECK_FALSE(mailbox.take());
  CHECK(mailbox.front() == 7);
}

TEST_CASE("what is written but not published is not seen") {
  Latest<int> mailbox(7);
  mailbox.back() = 8;

  CHECK_FALSE(mailbox.take());
  CHECK(mailbox.front() == 7);
}

TEST_CASE("the reader takes the newest value once, and what came before it is dropped") {
  Latest<int> mailbox;
  for (const int value : {1, 2, 3}) {
    mailbox.back() = value;
    mailbox.publish();
  }

  CHECK(mailbox.take());
  CHECK(mailbox.front() == 3);
  CHECK_FALSE(mailbox.take());
  CHECK(mailbox.front() == 3);
}

TEST_CASE("the reader's value stays as it is while the writer publishes more") {
  Latest<int> mailbox;
  mailbox.back() = 1;
  mailbox.publish();
  REQUIRE(mailbox.take());
  const int* held = &mailbox.front();

  for (const int value : {2, 3, 4, 5}) {
    CHECK(&mailbox.back() != held);
    mailbox.back() = value;
    mailbox.publish();
  }

  CHECK(*held == 1);
  CHECK(mailbox.take());
  CHECK(mailbox.front() == 5);
}

TEST_CASE("between two threads no value is torn, none comes back, and the last one arrives") {
  // wide enough that a torn copy would show: every word must tell the same number
  struct Block {
    std::array<std::uint32_t, 64> words{};
  };
  constexpr std::uint32_t kLast = 50'000;
  Latest<Block> mailbox;

  std::thread writer([&] {
    for (std::uint32_t n = 1; n <= kLast; ++n) {
      mailbox.back().words.fill(n);
      mailbox.publish();
    }
  });
  std::uint32_t newest = 0, torn = 0, late = 0;
  while (newest < kLast) {
    if (!mailbox.take()) {
      std::this_thread::yield();
      continue;
    }
    const auto& words = mailbox.front().words;
    for (const std::uint32_t word : words) torn += word != words[0];
    late += words[0] <= newest;
    newest = words[0];
  }
  writer.join();

  CHECK(torn == 0);
  CHECK(late == 0);
  CHECK(newest == kLast);
  CHECK_FALSE(mailbox.take());
}
