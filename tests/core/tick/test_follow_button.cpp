// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/tick/press_scene.h"
#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/tick/private/follow_button.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "scenes/grasped.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using namespace palpate::testing;
using doctest::Approx;

namespace {

/// How a pull straight up ended.
struct Pull {
  bool held_to_the_end = false;
  double largest_force = 0.0;  ///< [N]
  double longest = 1.0;        ///< [-] of a link's rest length
  double slip = 0.0;           ///< [m] of the hand beyond its spring's reach, when let go
  double largest_drop = 0.0;   ///< [N] of the force in one tick, from when it was let go
  AlarmKind alarm = AlarmKind::none;
};

/// Takes hold `depth` [m] deep at the top of the tissue, goes up to `height` [m] above it at
/// `speed` [m/s] and stays there for half a second.
Pull pull_up(const Scene& scene, double depth, double height, double speed) {
  double top = -1.0;
  Vec3 place = Vec3::Zero();
  for (const Vec3& x :
       compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)) {
    if (x.z() > top) place = x, top = x.z();
  }
  World world(scene);
  Pull pull;
  HapticSample sample;
  double last = 0.0;
  const auto go = [&](double from, double to, int ticks, std::uint8_t buttons) {
    for (int i = 1; i <= ticks; ++i) {
      const double above = from + (to - from) * i / ticks;
      sample.position = place + (scene.instruments[0].tool.radius + above) * Vec3::UnitZ();
      sample.buttons = buttons;
      const bool held =
          world.instruments[0].tool.hold_count > 0 && world.instruments[0].release_ticks == 0;
      const double force = tick(scene, sample, 1e-3, world).force.norm();
      if (held && world.instruments[0].release_ticks > 0) {
        pull.slip =
            (world.instruments[0].hand - world.instruments[0].tool.position).norm() -
            scene.instruments[0].coupling.force_max / scene.instruments[0].coupling.stiffness;
      }
      if (world.instruments[0].release_ticks > 0)
        pull.largest_drop = std::max(pull.largest_drop, last - force);
      pull.largest_force = std::max(pull.largest_force, force);
      pull.longest = std::max(pull.longest, world.bodies[0].stretch.longest);
      last = force;
    }
  };
  go(0.002, -depth, 100, 0);
  go(-depth, -depth, 200, 0);
  pull.largest_force = 0.0;
  go(-depth, height, static_cast<int>(1e3 * (depth + height) / speed), kAttachButton);
  go(height, height, 500, kAttachButton);
  pull.held_to_the_end = world.instruments[0].tool.hold_count > 0;
  pull.alarm = world.alarm.kind;
  return pull;
}

Scene molecular_scene(AngleLaw law) {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.020}, 2);
  SurfaceOptions options;
  options.home_stiffness = 4e5;
  options.drag = 8.0;
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].tissue =
      build_molecular(mesh, {.damping_ratio = 0.3, .wall_thickness = 0.003},
                      {.bond_stiffness = 20.0, .bend_stiffness = 1e-5, .angle_law = law}, options);
  return build_scene(std::move(scene));
}

}  // namespace

TEST_CASE("a hand that pulls as hard as it can slips off once it has gone on by a tip's radius") {
  Scene scene = press_scene();
  scene.instruments[0].coupling.force_max = 1.0;  // long before the tissue gives any reason

  const Pull on_and_on = pull_up(scene, 0.003, 0.060, 0.05);

  CHECK(on_and_on.alarm == AlarmKind::none);
  CHECK_FALSE(on_and_on.held_to_the_end);
  CHECK(on_and_on.largest_force == Approx(scene.instruments[0].coupling.force_max));
  CHECK(on_and_on.slip == Approx(scene.instruments[0].tool.radius).epsilon(0.02));
  CHECK(on_and_on.longest < 1.0 + 0.75 * find_strain_limit(scene.bodies[0].tissue));
  CHECK(on_and_on.largest_drop < 0.08 * scene.instruments[0].coupling.force_max);
}

TEST_CASE("a pull at the largest force of the hand that goes no farther is held") {
  Scene scene = press_scene();
  scene.instruments[0].coupling.force_max = 1.0;
  const double where_it_slips = [&] {
    double height = 0.005;
    while (pull_up(scene, 0.003, height, 0.05).held_to_the_end) height += 0.001;
    return height;
  }();

  const Pull held = pull_up(scene, 0.003, where_it_slips - 0.001, 0.05);

  CHECK(held.held_to_the_end);
  CHECK(held.largest_force == Approx(scene.instruments[0].coupling.force_max));
}

TEST_CASE("a grip bears links three times as long where energy tells a pull from a blow-up") {
  const Scene scene = molecular_scene(AngleLaw::gradient);

  const Pull held = pull_up(scene, 0.003, 0.045, 0.05);

  CHECK(held.alarm == AlarmKind::none);
  CHECK(held.held_to_the_end);
  CHECK(held.longest > 3.0);
}

TEST_CASE("under Eq 10, which has no energy, a grip lets go before a link is three times as long") {
  const Scene scene = molecular_scene(AngleLaw::eq10);
  REQUIRE(find_strain_limit(scene.bodies[0].tissue) == kLargestStrain);

  for (const double speed : {0.05, 0.3, 1.0}) {
    const Pull slipped = pull_up(scene, 0.003, 0.060, speed);

    CHECK(slipped.alarm == AlarmKind::none);
    CHECK_FALSE(slipped.held_to_the_end);
    CHECK(slipped.longest > 2.4);
    CHECK(slipped.longest < 1.0 + kLargestStrain);
    // what would bear no more is let go in 5 ms, evenly
    CHECK(slipped.largest_drop < 0.25 * slipped.largest_force);
  }
}

TEST_CASE("a grip of a linear solid lets go before it has been moved too far, however fast") {
  for (const bool covered : {true, false}) {
    Scene scene;
    scene.bodies[0].kernel = scenes::kernel_under_test();
    scene.bodies[0].tissue = covered ? scenes::make_covered_linear_organ(5, 0.9, 0.2)
                                     : scenes::make_linear_organ(5, 0.9, 0.2);
    scene = build_scene(std::move(scene));
    if (!scene.bodies[0].response) continue;  // the reference kernel has the rules of other tissues
    for (const double speed : {0.05, 0.3, 1.0, 3.0}) {
      const Pull slipped = pull_up(scene, 0.003, 0.060, speed);

      CAPTURE(covered);
      CAPTURE(speed);
      CHECK(slipped.alarm == AlarmKind::none);
      CHECK_FALSE(slipped.held_to_the_end);
      CHECK(slipped.largest_force < scene.instruments[0].coupling.force_max);
      CHECK(slipped.largest_drop < 0.08 * slipped.largest_force);
    }
  }
}

namespace {

/// A slab that jaws hold and have drawn out.
struct Held {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(0.5, 1.0), 500.0);
  World world = hold(scene);

  static World hold(const Scene& scene) {
    scenes::GraspingHand hand(scene);
    hand.close();
    hand.go(0.003, 0.3);
    return hand.world();
  }
  /// A tick of a hand that has opened, where the smallest volume is that of what it is at rest.
  void open(double volume) {
    world.bodies[0].stretch.smallest_volume = internals(world.bodies[0]).volume_before = volume;
    HapticSample sample;
    sample.position = world.instruments[0].hand;
    follow_jaws(scene, 0, sample, 1e-3, world);
  }
};

/// [-] What is left of the closing force in each tick from when a hand opens its jaws, where the
/// smallest volume of what they hold is `volume` of that at rest.
std::vector<double> open_jaws(double volume) {
  Held jaws;
  World& world = jaws.world;
  const double held = world.instruments[0].tool.grip_limit;
  std::vector<double> left;
  for (int k = 0; k < 60 && world.instruments[0].attach_pressed; ++k) {
    jaws.open(volume);
    left.push_back(world.instruments[0].tool.grip_limit / held);
  }
  left.pop_back();  // in the last they have let go, and open with little
  return left;
}

}  // namespace

TEST_CASE("jaws let go of tissue near an alarm in 5 ms, as a hold does, and else in 30 and more") {
  const std::vector<double> calm = open_jaws(0.5), near = open_jaws(0.08);

  CHECK(calm.size() >= 30);
  // a fifth of the load a tick, of which what could not be borne was taken first
  REQUIRE(near.size() == 4);
  for (std::size_t k = 0; k < near.size(); ++k) {
    CHECK(near[k] <= 0.2 * (4.0 - static_cast<double>(k)) + 1e-12);
    CHECK(near[k] > 0.0);
  }
}

TEST_CASE("opened jaws come away from what collapses, however much of what is felt goes with it") {
  for (const double volume : {0.5, 0.08, 0.0}) {
    CAPTURE(volume);
    Held jaws;
    InstrumentState& state = jaws.world.instruments[0];
    REQUIRE(state.last_force.norm() > 0.1);
    state.attach_pressed = false;
    state.tool.felt_change = 0.01;
    jaws.open(volume);
    CHECK(state.tool.felt_change == (volume < 0.05 ? state.last_force.norm() : 0.01));
  }
}

// They had closed in a crease, and the hand was pushed by 0.1 to 0.5 N in a tick.
TEST_CASE("jaws that tissue shuts again after they have opened are as even as while they opened") {
  for (const double grip : {0.05, 1.0}) {
    CAPTURE(grip);
    Held jaws;
    InstrumentState& state = jaws.world.instruments[0];
    const double open = jaws.scene.instruments[0].tool.jaws->open;
    state.attach_pressed = true;
    state.tool.jaw_wanted = open;
    state.tool.jaw_angle = 0.5 * open;
    state.tool.touching = true;
    state.tool.grip_limit = grip * jaws.scene.instruments[0].tool.jaws->grip;
    jaws.open(0.5);

    // jaws whose hand has never closed them have all of their force, and press as it goes
    const bool shut = grip < 1.0;
    CHECK(state.tool.felt_change == (shut ? Approx(state.last_force.norm() / 15.0) : Approx(0.0)));
    CHECK(state.attach_pressed != shut);
    jaws.open(0.5);
    CHECK((state.tool.felt_change > 0.0) == shut);
    state.tool.touching = false;
    jaws.open(0.5);
    CHECK((state.tool.felt_change > 0.0) == (shut && state.tool.residual.norm() >= 1e-3));
  }
}
