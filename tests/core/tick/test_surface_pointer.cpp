// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <atomic>
#include <limits>
#include <thread>

#include "calls.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/tick/surface_pointer.h"
#include "scenes/stones.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kPole = 0.020;  // [m] height of the organ's highest point

PointerTarget over_pole(double time, double depth, bool pressing) {
  return {.time = time, .goal = {0.0, 0.0, kPole}, .depth = depth, .pressing = pressing};
}

constexpr double kBeside = 0.070;  // [m] along x to the other organ, 10 mm from the first
constexpr double kTable = -0.030;  // [m] height of a table, 10 mm below the organs

/// Two organs beside each other over a table, and a stone of 9 mm on that.
Scene crowded_scene() {
  Scene scene = press_scene();
  SoftBody other = scene.bodies[0];
  for (Vec3& p : other.tissue.rest_position) p.x() += kBeside;
  scene.bodies.push_back(std::move(other));
  Scenery table;
  table.mesh.vertices = {
      {-0.2, -0.2, kTable}, {0.2, -0.2, kTable}, {0.2, 0.2, kTable}, {-0.2, 0.2, kTable}};
  table.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.scenery.push_back(std::move(table));
  scene.rigid.push_back(scenes::make_stone(0.009));
  scene.rigid[0].position = {0.035, -0.060, kTable + 0.010};
  return build_scene(std::move(scene));
}

/// [m] Where the hand rests after two seconds over a target.
Vec3 rest_at(SurfacePointer& hand, const PointerTarget& target) {
  hand.post(target);
  HapticSample last = hand.read(0.0);
  for (int i = 1; i <= 2000; ++i) last = hand.read(1e-3 * i);
  return last.position;
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

TEST_CASE("of several organs the hand presses the one under the pointer") {
  const Scene scene = crowded_scene();
  const double radius = scene.instruments[0].tool.radius;
  SurfacePointer hand(scene);
  const Vec3 pole(kBeside, 0.0, kPole);

  const Vec3 at = rest_at(hand, {.goal = pole, .depth = 0.004, .pressing = true});

  CHECK((at - pole - Vec3(0.0, 0.0, radius - 0.004)).norm() < 1e-6);
}

TEST_CASE("from one organ to the other the hand goes over both and into neither") {
  const Scene scene = crowded_scene();
  const double radius = scene.instruments[0].tool.radius;
  SurfacePointer hand(scene);
  hand.post({.goal = {0.0, 0.0, kPole}, .depth = -0.004});
  hand.read(0.0);
  hand.post({.time = 0.1, .goal = {kBeside, 0.024, 0.0}, .depth = -0.004});
  const SceneSurfaces surfaces(scene);

  double nearest = 1.0;
  HapticSample last;
  for (int i = 1; i <= 3000; ++i) {
    last = hand.read(1e-3 * i);
    const auto found = surfaces.find_closest_point(last.position);
    const double above = (last.position - found->point).dot(found->normal);
    nearest = std::min(nearest, std::copysign(found->distance, above));
  }
  CHECK(nearest > radius);
  CHECK(last.position.x() == doctest::Approx(kBeside).epsilon(0.1));
}

TEST_CASE("the hand presses scenery, and a stone where the window sees it") {
  const Scene scene = crowded_scene();
  const double radius = scene.instruments[0].tool.radius;
  SurfacePointer on_table(scene), on_stone(scene);
  const Vec3 place(0.0, -0.1, kTable), moved(-0.05, -0.06, 0.0);

  const Vec3 there = rest_at(on_table, {.goal = place, .depth = 0.002, .pressing = true});
  const Vec3 top = moved + Vec3(0.0, 0.0, 0.009 * 8.0 / 22.0);
  const Vec3 held =
      rest_at(on_stone,
              {.goal = top, .depth = 0.001, .pressing = true, .rigid = 0, .rigid_position = moved});

  CHECK((there - place - Vec3(0.0, 0.0, radius - 0.002)).norm() < 1e-6);
  CHECK((held - top - Vec3(0.0, 0.0, radius - 0.001)).norm() < 1e-4);
}

TEST_CASE("a hand of the mouse allocates nothing and takes no lock in the haptic thread") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  const Scene scene = crowded_scene();
  SurfacePointer hand(scene);
  PointerTarget target = over_pole(0.0, 0.003, true);
  target.rigid = 0;
  hand.post(target);

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
  CHECK_THROWS_AS(hand.post({.rigid_position = {nan, 0.0, 0.0}}), std::invalid_argument);
  CHECK_THROWS_AS(hand.post({.rigid_orientation = {1.0, 1.0, 0.0, 0.0}}), std::invalid_argument);
  CHECK_THROWS_AS(hand.post({.rigid = 0}), std::invalid_argument);  // the scene has none
}
