// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "palpate/sim/tick/tick.h"
#include "scenes/flicks.h"
#include "scenes/geodesic.h"
#include "scenes/scenes.h"

// T1 to T3 of an instrument of capsules, through the tick the hand feels [contact: capsules].

using namespace palpate;

namespace {

using scenes::hand_at;

constexpr double kTick = 1e-3;

/// Of 10 n² + 2 vertices, under a capsule of 10 mm across its top.
Scene make_organ(int n, double radius) {
  return scenes::make_law_wall(
      scenes::make_geodesic({0.0165, 0.030, 0.0165}, n),
      {.radius = radius, .stiffness = 3e7, .capsules = {{{0, -0.005, 0}, {0, 0.005, 0}}}});
}

struct Held {
  double force = 0.0;  ///< [N] mean
  double noise = 0.0;  ///< [N] second differences, root mean square
};

/// 5 mm deep at 20 mm/s, held, turned about the normal by `angle` [rad]; the last 0.2 s.
Held press_and_hold(const Scene& scene, double angle) {
  World world(scene);
  const double top = 0.0165 + scene.instruments[0].tool.radius;
  Held held;
  double last = 0.0, before = 0.0;
  for (int i = 0; i < 900; ++i) {
    HapticSample sample = hand_at({0.0011, 0.0007, top + 1e-3 - std::min(0.006, 2e-5 * i)});
    sample.orientation = Quaternion(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    const double force = tick(scene, sample, kTick, world).force.norm();
    if (i >= 700) {
      held.force += force / 200.0;
      held.noise += std::pow(force - 2.0 * last + before, 2) / 200.0;
    }
    before = last;
    last = force;
  }
  CHECK_FALSE(world.alarm);
  held.noise = std::sqrt(held.noise);
  return held;
}

bool is_inside(const Scene& scene, const World& world) {
  const ToolState& tool = world.instruments[0].tool;
  return std::ranges::any_of(std::array{-0.005, 0.0, 0.005}, [&](double y) {
    return compute_winding_number(scene.bodies[0].tissue.triangles, world.bodies[0].tissue.position,
                                  tool.position + tool.orientation * Vec3(0.0, y, 0.0)) > 0.5;
  });
}

/// Straight down at places all over the top, 12 mm past the surface.
void check_flicks(int n, int places) {
  const Scene scene = make_organ(n, 0.0015);
  std::vector<Vec3> starts;
  for (int place = 0; place < places; ++place) {
    const double u = std::fmod(0.618034 * place, 1.0) - 0.5, v = (place + 0.5) / places - 0.5;
    starts.emplace_back(0.014 * u, 0.03 * v, 0.0165 + 0.003);
  }
  for (const double speed : {1.0, 3.0}) {
    CAPTURE(n);
    CAPTURE(speed);
    const scenes::Flicks found = scenes::flick_down(scene, starts, 0.0135, speed, is_inside);
    CHECK(found.crossed == 0);
    CHECK(found.touched == places);
    CHECK(found.alarms == 0);
  }
}

}  // namespace

/// T1 and T2 at an angle to the organ's long axis, on meshes of 10 n² + 2 vertices.
void check_held(double angle, std::initializer_list<int> meshes) {
  std::vector<double> forces;
  for (const int n : meshes) {
    CAPTURE(n);
    CAPTURE(angle);
    const Held held = press_and_hold(make_organ(n, 0.0025), angle);
    CHECK(held.noise < 1e-3);
    CHECK(held.force > 0.05);
    forces.push_back(held.force);
  }
  CHECK(std::abs(forces.back() - forces.front()) < 0.15 * forces.back());
}

TEST_CASE("T1: a held capsule is quiet on 642 and 1962 vertices") {
  CHECK(press_and_hold(make_organ(8, 0.0025), 0.8).noise < 1e-3);
  CHECK(press_and_hold(make_organ(14, 0.0025), 0.0).noise < 1e-3);
}

TEST_CASE("T1 and T2: a held capsule is quiet, and refining the mesh changes its force by < 15 %" *
          doctest::test_suite("landing")) {
  for (const double angle : {0.0, 0.8}) check_held(angle, {14, 23});  // 1962 and 5292 vertices
}

TEST_CASE("T3: no flick of a capsule at 1 and at 3 m/s passes through the wall") {
  check_flicks(8, 5);
}

TEST_CASE("T3: none of 100 flicks of a capsule at 1 and at 3 m/s passes through the wall" *
          doctest::test_suite("landing")) {
  check_flicks(8, 100);
  check_flicks(14, 100);
}

TEST_CASE("a capsule turned against tissue turns no faster than the hand may lever for nothing") {
  const Scene scene = make_organ(8, 0.0025);
  World world(scene);
  const double top = 0.0165 + 0.0025;
  HapticSample sample;
  for (int i = 0; i < 400; ++i) {
    sample = hand_at({0.0, 0.0, top + 1e-3 - std::min(0.006, 3e-5 * i)});
    tick(scene, sample, kTick, world);
  }
  // about an axis across it, into the tissue at one end
  sample.orientation = Quaternion(Eigen::AngleAxisd(1.2, Vec3::UnitX()));
  double most = 0.0;
  for (int i = 0; i < 300; ++i) {
    const Quaternion before = world.instruments[0].tool.orientation;
    const double torque = world.instruments[0].tool.torque.norm();
    tick(scene, sample, kTick, world);
    const double turned = before.angularDistance(world.instruments[0].tool.orientation);
    if (torque > 0.02) most = std::max(most, turned);
  }
  CHECK_FALSE(world.alarm);
  CHECK(most <= 3.0 * kTick * (1.0 + 1e-6));
}
