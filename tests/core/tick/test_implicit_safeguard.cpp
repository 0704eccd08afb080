// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "core/tick/safeguard_scenes.h"
#include "palpate/sim/packed/simd_targets.h"

// Implicit Euler on what is too stiff for the steps that a body may have [motion: ladder].

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A press of 2 mm in a second, and what came of it.
struct Pressed {
  double peak = 0.0;  // [N]
  Safeguard highest = Safeguard::none;
  Alarm alarm;
};

Pressed press(const Scene& scene, bool recovers = true) {
  World world(scene);
  world.recovers = recovers;
  ScriptedDevice script = press_script(0.002, 1.0);
  Pressed pressed;
  for (int i = 0; i < 1000; ++i) {
    const double force = tick(scene, script.read(1e-3 * i), 1e-3, world).force.norm();
    pressed.peak = std::max(pressed.peak, force);
    pressed.highest = std::max(pressed.highest, world.bodies[0].safeguard);
  }
  pressed.alarm = world.alarm;
  return pressed;
}

}  // namespace

TEST_CASE("a small tissue whose steps are far too long is stepped implicitly as a whole") {
  const Scene scene = make_coarse(8.0, 2, Kernel::reference);
  World world = make_struck(scene);

  const Course course = run(scene, world, 0.5);

  CHECK_FALSE(course.alarm);
  CHECK(course.highest() == Safeguard::implicit_euler);
  for (const Vec3& v : world.bodies[0].tissue.velocity) CHECK(v.norm() < 0.02);
}

TEST_CASE("where a link is too stiff for any step, it is stepped implicitly, in vector code too") {
  for (const Kernel kernel : {Kernel::reference, Kernel::packed}) {
    if (kernel == Kernel::packed && simd_targets().empty()) continue;
    CAPTURE(static_cast<int>(kernel));
    const auto [scene, needed] = make_stiff_link(kernel);
    // a quarter of the step, and implicit damping, are far from enough
    REQUIRE(needed > 4 * scene.bodies[0].substeps_max);
    Scene fine = scene;
    fine.bodies[0].substeps = needed;
    fine.bodies[0].substeps_max = 2 * needed;

    const Pressed held = press(scene), exact = press(fine);

    CHECK(press(scene, false).alarm);
    CHECK_FALSE(held.alarm);
    CHECK_FALSE(exact.alarm);
    CHECK(held.highest == Safeguard::implicit_euler);
    CHECK(held.peak == doctest::Approx(exact.peak).epsilon(0.05));
  }
}

TEST_CASE("a contact that is too hard for any step is stepped implicitly") {
  Scene scene = press_scene();
  scene.bodies[0].kernel = Kernel::reference;
  scene.instruments[0].tool.stiffness *= 200.0;
  scene.bodies[0].substeps_max = scene.bodies[0].substeps;

  const Pressed alone = press(scene, false), held = press(scene);

  CHECK(alone.alarm);
  CHECK_FALSE(held.alarm);
  CHECK(held.highest == Safeguard::implicit_euler);
  CHECK(held.peak < 1.1 * alone.peak);
}
