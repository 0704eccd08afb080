// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstdlib>
#include <mutex>
#include <shared_mutex>
#include <vector>

#include "calls.h"
#include "core/tick/press_scene.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

TEST_CASE("the count of allocations and locks counts") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  std::mutex mutex;
  std::shared_mutex shared;
  const Calls before = count_calls_of_this_thread();

  const std::vector<int> grows(10);
  const void* volatile seen = grows.data();  // else a compiler may leave the allocation out
  (void)seen;
  void* volatile plain = std::malloc(8);
  std::free(plain);
  const std::lock_guard guard(mutex);
  const std::shared_lock other(shared);

  const Calls after = count_calls_of_this_thread();
  CHECK(after.allocations - before.allocations == 2);
  CHECK(after.locks - before.locks == 2);
}

TEST_CASE("ten thousand ticks with contact, pulling and jumps allocate nothing and take no lock") {
  const Scene scene = press_scene();
  World world(scene);
  ScriptedDevice hand = press_script(0.006, 0.5, true);
  long touched = 0, attached = 0;

  const Calls before = count_calls_of_this_thread();
  for (int i = 0; i < 10000; ++i) {
    HapticSample sample = hand.read(1e-3 * (i % 500));
    if (i % 1237 == 0) sample.position.x() += 0.02;
    tick(scene, sample, 1e-3, world);
    compute_felt({}, world);
    if (i % 1000 == 0) compute_hash(world);
    touched += world.instruments[0].tool.touching;
    attached += world.instruments[0].tool.hold_count > 0;
  }
  const Calls after = count_calls_of_this_thread();

  CHECK_FALSE(world.alarm);
  CHECK(touched > 2000);
  CHECK(attached > 2000);
  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}
