// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/model/refusal.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kDt = 1e-3;
constexpr Integrator kEvery[] = {Integrator::explicit_euler,
                                 Integrator::symplectic_euler,
                                 Integrator::midpoint,
                                 Integrator::runge_kutta_4,
                                 Integrator::symplectic_euler_implicit_damping,
                                 Integrator::implicit_euler_linear,
                                 Integrator::implicit_euler,
                                 Integrator::implicit_midpoint,
                                 Integrator::xpbd,
                                 Integrator::projective_dynamics};

/// press_scene(), all of it damped, so that every integrator has a step.
Scene make_unbuilt(Integrator integrator) {
  Scene scene;
  scene.bodies[0].tissue = press_scene().bodies[0].tissue;
  scene.bodies[0].tissue.drag = 200.0;
  scene.bodies[0].integrator = integrator;
  return scene;
}

Scene make_scene_of(Integrator integrator) { return build_scene(make_unbuilt(integrator)); }

/// [N] on a hand that has pressed 4 mm deep and stays.
double press(const Scene& scene, World& world) {
  ScriptedDevice hand = press_script(0.004, 1.0);
  HapticCommand command;
  for (int i = 0; i < 450 && !world.alarm; ++i) {
    command = tick(scene, hand.read(kDt * i), kDt, world);
  }
  return command.force.norm();
}

std::string refusal(const Scene& scene) {
  return find_refusal([&] { build_scene(scene); });
}

}  // namespace

TEST_CASE("every integrator runs in the tick and holds a press with the force of the others" *
          doctest::test_suite("landing")) {
  const Scene usual = make_scene_of(Integrator::symplectic_euler);
  World reference(usual);
  const double expected = press(usual, reference);
  REQUIRE(expected > 0.1);
  for (const Integrator integrator : kEvery) {
    CAPTURE(std::string(integrator_name(integrator)));
    const Scene scene = make_scene_of(integrator);
    World world(scene);

    const double force = press(scene, world);

    CHECK_FALSE(world.alarm);
    CHECK(force == doctest::Approx(expected).epsilon(0.02));
  }
}

TEST_CASE("a body has the substeps that its integrator needs, and implicit ones need one") {
  for (const Integrator integrator : kEvery) {
    CAPTURE(std::string(integrator_name(integrator)));
    const Scene scene = make_scene_of(integrator);
    if (integrator == Integrator::xpbd) {  // stable at any, too soft in long ones
      CHECK(scene.bodies[0].substeps ==
            make_scene_of(Integrator::symplectic_euler).bodies[0].substeps);
      continue;
    }
    const double needed = kDt / stable_step(scene.bodies[0].tissue, integrator);

    CHECK(scene.bodies[0].substeps == std::max(1, static_cast<int>(std::ceil(needed))));
    if (is_implicit(integrator)) CHECK(scene.bodies[0].substeps == 1);
  }
}

TEST_CASE("with steps far beyond its limit an explicit integrator ends in an alarm") {
  for (const Integrator integrator :
       {Integrator::explicit_euler, Integrator::midpoint, Integrator::runge_kutta_4}) {
    CAPTURE(std::string(integrator_name(integrator)));
    Scene scene = make_unbuilt(integrator);
    for (double& stiffness : scene.bodies[0].tissue.springs.stiffness) stiffness *= 400.0;
    const int needed = build_scene(scene).bodies[0].substeps;
    REQUIRE(needed > 6);
    Scene coarse = build_scene(scene);
    coarse.bodies[0].substeps = coarse.bodies[0].substeps_max = needed / 6;
    World world(coarse);
    world.recovers = false;

    press(coarse, world);

    CHECK(world.alarm);
    CHECK(world.alarm.kind != AlarmKind::not_solved);
  }
}

TEST_CASE("vector code has symplectic Euler alone, and automatic chooses the reference") {
  Scene scene = make_unbuilt(Integrator::midpoint);
  CHECK(build_scene(scene).bodies[0].kernel == Kernel::reference);

  scene.bodies[0].kernel = Kernel::packed;
  CHECK(refusal(scene) ==
        "scene: kernel: got packed, expected automatic or reference with the integrator midpoint: "
        "the others step by symplectic_euler");

  scene.bodies[0].kernel = Kernel::reference;
  scene.bodies[0].force_error = 0.01;
  CHECK(refusal(scene).find("force_error [N]: got 0.01, expected 0 for an integrator other") !=
        std::string::npos);

  Scene usual = make_unbuilt(Integrator::symplectic_euler);
  CHECK(build_scene(usual).bodies[0].kernel == Kernel::packed);
}

TEST_CASE("a linear solid steps by another integrator under the reference kernel only") {
  Scene scene;
  scene.bodies[0].tissue = scenes::make_linear_organ(5, 0.9, 0.2);
  scene.bodies[0].integrator = Integrator::implicit_midpoint;
  CHECK(build_scene(scene).bodies[0].kernel == Kernel::reference);

  scene.bodies[0].kernel = Kernel::response;
  CHECK(refusal(scene).find("kernel: got response, expected automatic or reference") !=
        std::string::npos);
}

TEST_CASE("an integrator that is never stable on a tissue is refused, whatever the substeps") {
  for (const int substeps : {0, 50}) {
    for (const Integrator integrator : {Integrator::explicit_euler, Integrator::midpoint}) {
      Scene scene = make_unbuilt(integrator);
      scene.bodies[0].tissue.drag = 0.0;
      scene.bodies[0].substeps = substeps;
      for (double& damping : scene.bodies[0].tissue.springs.damping) damping = 0.0;
      CHECK(refusal(scene).find("integrator: got " + std::string(integrator_name(integrator)) +
                                ", expected one that is stable where next to nothing is damped") !=
            std::string::npos);
    }
  }
}

TEST_CASE("an implicit step without a solution is an alarm, and the tissue stands where it was") {
  for (const Integrator integrator :
       {Integrator::implicit_euler_linear, Integrator::implicit_euler,
        Integrator::implicit_midpoint, Integrator::xpbd, Integrator::projective_dynamics}) {
    CAPTURE(std::string(integrator_name(integrator)));
    const Scene scene = make_scene_of(integrator);
    World world(scene);
    world.recovers = false;  // the velocity of the tick before was a number
    HapticSample away;
    away.position = {0.0, 0.0, 0.2};
    tick(scene, away, kDt, world);
    const Vec3Array before = world.bodies[0].tissue.position;
    world.bodies[0].asleep = false;
    world.bodies[0].tissue.velocity.back().x() = std::numeric_limits<double>::quiet_NaN();

    const HapticCommand command = tick(scene, away, kDt, world);

    CHECK(world.alarm.kind == AlarmKind::not_solved);
    CHECK(world.alarm.value == kDt / world.bodies[0].substeps);
    CHECK(world.alarm_body == 0);
    CHECK(world.bodies[0].tissue.position == before);
    CHECK(command.force.isZero(0.0));
  }
}

TEST_CASE("a copy of a world goes on with an implicit integrator to the same bits") {
  for (const Integrator integrator :
       {Integrator::implicit_euler, Integrator::xpbd, Integrator::projective_dynamics}) {
    const Scene scene = make_scene_of(integrator);
    World world(scene);
    ScriptedDevice hand = press_script(0.004, 0.2);
    for (int i = 0; i < 60; ++i) tick(scene, hand.read(kDt * i), kDt, world);
    const Scene same = scene;
    World copy = world;
    for (int i = 60; i < 120; ++i) {
      REQUIRE(tick(scene, hand.read(kDt * i), kDt, world).force ==
              tick(same, hand.read(kDt * i), kDt, copy).force);
    }
    CHECK(compute_hash(copy) == compute_hash(world));
  }
}

TEST_CASE("XPBD and projective dynamics press a solid by its near field as symplectic Euler does" *
          doctest::test_suite("landing")) {
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    Scene scene;
    SoftBody& body = scene.bodies[0];
    body.tissue = scenes::make_finite_organ(law, 4, 0.9, {.damping_ratio = 0.2, .drag = 20.0});
    body.contact_modulus = 5000.0 / (1.0 - 0.45 * 0.45);
    const Scene usual = build_scene(scene);
    World reference(usual);
    const double expected = press(usual, reference);
    REQUIRE(expected > 0.1);
    for (const Integrator integrator : {Integrator::xpbd, Integrator::projective_dynamics}) {
      CAPTURE(std::string(integrator_name(integrator)));
      body.integrator = integrator;
      const Scene built = build_scene(scene);
      World world(built);

      const double force = press(built, world);

      CHECK_FALSE(world.alarm);
      CHECK(force == doctest::Approx(expected).epsilon(0.02));
    }
  }
}

TEST_CASE("iterations are chosen where there are some to choose, and refused elsewhere") {
  for (const Integrator integrator : kEvery) {
    const int iterations = make_scene_of(integrator).bodies[0].iterations;
    CHECK(iterations == (integrator == Integrator::xpbd                  ? 5
                         : integrator == Integrator::projective_dynamics ? 10
                                                                         : 0));
  }
  Scene scene = make_unbuilt(Integrator::xpbd);
  scene.bodies[0].iterations = 7;
  CHECK(build_scene(scene).bodies[0].iterations == 7);
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].integrator = Integrator::midpoint;
  CHECK(refusal(scene) ==
        "scene: bodies[1].iterations: got 7, expected 0 with midpoint: only xpbd and "
        "projective_dynamics have a number of them");
}
