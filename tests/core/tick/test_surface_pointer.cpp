// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <atomic>
#include <limits>
#include <thread>

#include "calls.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/tick/surface_pointer.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kPole = 0.020;  // [m] height of the organ's highest point

PointerTarget over_pole(double time, double depth, bool pressing) {
  return {.time = time, .goal = {0.0, 0.0, kPole}, .depth = depth, .pressing = pressing};
}

/// [m] of the tip's lowest point below the pole, at rest over it.
double depth_of(const HapticSample& hand, const Scene& scene) {
  return kPole + scene.instruments[0].tool.radius - hand.position.z();
}

}  // namespace

TEST_CASE("a pointer's hand presses at 50 mm/s and goes over the surface at 250 mm/s at most") {
  const Scene scene = press_scene();
  SurfacePointer hand(scene);
  hand.post(over_pole(0.0, -0.004, false));
  HapticSample last = hand.read(0.0);
  CHECK(depth_of(last, scene) == doctest::Approx(-0.004));

  hand.post(over_pole(0.0, 0.005, true));
  double fastest = 0.0;
  for (int i = 1; i <= 400; ++i) {
    last = hand.read(1e-3 * i);
    fastest = std::max(fastest, last.velocity.norm());
  }
  CHECK(depth_of(last, scene) == doctest::Approx(0.005));
  CHECK(fastest == doctest::Approx(0.05).epsilon(0.02));

  hand.post({.time = 0.4, .goal = {0.030, 0.0, 0.0}, .depth = 0.005, .pressing = true});
  fastest = 0.0;
  for (int i = 401; i <= 1200; ++i) {
    last = hand.read(1e-3 * i);
    fastest = std::max(fastest, last.velocity.norm());
  }
  CHECK(fastest < 0.26);
  CHECK(last.position.x() ==
        doctest::Approx(0.030 + scene.instruments[0].tool.radius - 0.005).epsilon(0.01));
}

TEST_CASE("a press that was over before it was heard of lasts as long as the window says") {
  const Scene scene = press_scene();
  SurfacePointer hand(scene);
  hand.post(over_pole(10.0, -0.004, false));
  hand.read(0.0);
  hand.post(over_pole(12.0, 0.005, true));
  hand.post(over_pole(13.0, -0.004, false));

  int pressed = 0;
  for (int i = 1; i <= 2000; ++i) pressed += depth_of(hand.read(1e-3 * i), scene) > 0.0049;
  CHECK(pressed > 700);
  CHECK(pressed < 1000);
  CHECK(depth_of(hand.read(2.001), scene) == doctest::Approx(-0.004));
}

TEST_CASE("what is held is taken hold of before it is pulled, however late the window is") {
  const Scene scene = press_scene();
  SurfacePointer hand(scene);
  hand.post(over_pole(0.0, -0.004, false));
  hand.read(0.0);
  PointerTarget held = over_pole(0.0, 0.002, true);
  held.buttons = kAttachButton;
  hand.post(held);
  held.goal.z() += 0.02;
  held.path = PointerPath::straight;
  hand.post(held);

  double closed_at = 0.0;
  HapticSample last;
  for (int i = 1; i <= 2000; ++i) {
    last = hand.read(1e-3 * i);
    if (last.buttons != 0 && closed_at == 0.0) closed_at = depth_of(last, scene);
  }
  CHECK(closed_at == doctest::Approx(0.002).epsilon(0.2));
  CHECK(depth_of(last, scene) == doctest::Approx(0.002 - 0.02));
}

TEST_CASE("a hand of the mouse allocates nothing and takes no lock in the haptic thread") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  const Scene scene = press_scene();
  SurfacePointer hand(scene);
  hand.post(over_pole(0.0, 0.003, true));

  const Calls before = count_calls_of_this_thread();
  double sum = 0.0;
  for (int i = 0; i < 2000; ++i) sum += hand.read(1e-3 * i).position.z();
  const Calls after = count_calls_of_this_thread();

  CHECK(sum != 0.0);
  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("targets reach the haptic thread whole, whatever it does meanwhile") {
  const Scene scene = press_scene();
  SurfacePointer hand(scene);
  std::atomic<bool> stop{false};
  std::thread window([&] {
    for (int i = 0; !stop; ++i) {
      const double depth = i % 2 == 0 ? 0.001 : -0.001;
      hand.post(
          {.time = 1e-3 * i, .goal = {0.0, 0.0, kPole}, .depth = depth, .pressing = i % 3 == 0});
    }
  });
  bool sane = true;
  for (int i = 0; i < 20000; ++i) {
    const HapticSample sample = hand.read(1e-3 * i);
    sane = sane && sample.position.allFinite() && sample.position.head<2>().norm() < 1e-2;
  }
  stop = true;
  window.join();
  CHECK(sane);
}

TEST_CASE("a target that is not finite is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SurfacePointer hand(press_scene());

  CHECK_THROWS_AS(hand.post({.goal = {nan, 0.0, 0.0}}), std::invalid_argument);
  CHECK_THROWS_AS(hand.post({.depth = nan}), std::invalid_argument);
  CHECK_THROWS_AS(hand.post({.time = nan}), std::invalid_argument);
}
