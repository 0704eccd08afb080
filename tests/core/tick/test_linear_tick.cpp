// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "calls.h"
#include "core/model/refusal.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using namespace palpate::testing;
using doctest::Approx;

namespace {

constexpr double kDamping = 0.2;

/// A linear solid of 54 or 60 mm height held at its base, bare or under an ellipsoid.
Scene linear_scene(bool covered, Kernel kernel = Kernel::packed, const Vec3& gravity = {0, 0, 0},
                   double damping = kDamping) {
  Scene scene;
  scene.bodies[0].kernel = kernel;
  scene.gravity = gravity;
  scene.bodies[0].tissue = covered ? scenes::make_covered_linear_organ(5, 0.9, damping)
                                   : scenes::make_linear_organ(5, 0.9, damping);
  return build_scene(std::move(scene));
}

HapticSample hand_at(double z, bool attach = false) {
  HapticSample sample;
  sample.position = {0.001, 0.002, z};
  sample.buttons = attach ? kAttachButton : 0;
  return sample;
}

/// Goes from `from` to `to` [m] in as many ticks.
HapticCommand move(const Scene& scene, double from, double to, int ticks, World& world,
                   bool attach = false) {
  HapticCommand command;
  for (int i = 1; i <= ticks; ++i) {
    command = tick(scene, hand_at(from + (to - from) * i / ticks, attach), 1e-3, world);
  }
  return command;
}

/// [m] The height at which the tool touches.
double find_touch(const Scene& scene) {
  double top = 0.0;
  for (const Vec3& x :
       compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)) {
    top = std::max(top, x.z());
  }
  return top + scene.instruments[0].tool.radius;
}

}  // namespace

TEST_CASE("a linear solid runs from its response, unless the reference is asked for") {
  const Scene scene = linear_scene(true), reference = linear_scene(true, Kernel::reference);

  CHECK(scene.bodies[0].kernel == Kernel::response);
  CHECK(scene.bodies[0].response->size.bytes > 0);
  CHECK(reference.bodies[0].kernel == Kernel::reference);
  CHECK(reference.bodies[0].response == nullptr);
  CHECK(!has_packed_form(scene.bodies[0].tissue));
  CHECK(find_refusal([&] { pack(scene.bodies[0].tissue); }) ==
        "elastic: got 750 rows, expected none: linear solids have no packed form");
  Scene springs;
  springs.bodies[0].kernel = Kernel::response;
  springs.bodies[0].tissue = scenes::make_solid_organ(2, 0.0);
  CHECK(find_refusal([&] { build_scene(springs); }).find("that is no linear solid") !=
        std::string::npos);
  Scene stripped = scene;
  stripped.bodies[0].response.reset();
  CHECK(find_refusal([&] { World world(stripped); }) ==
        "world: got a linear solid without its response, expected a scene from build_scene");
}

TEST_CASE("a linear solid is pressed in, pushes back, and comes back, with its skin or without") {
  for (const bool covered : {true, false}) {
    const Scene scene = linear_scene(covered);
    World world(scene);
    const double touch = find_touch(scene);

    const double shallow = move(scene, touch + 0.005, touch - 0.003, 200, world).force.z();
    const double deep = move(scene, touch - 0.003, touch - 0.006, 200, world).force.z();
    const double tip = world.instruments[0].tool.position.z();
    move(scene, touch - 0.006, touch + 0.01, 200, world);
    const HapticCommand away = move(scene, touch + 0.01, touch + 0.01, 100, world);

    CHECK(!world.alarm);
    CHECK(shallow > 0.02);
    CHECK(deep > 1.5 * shallow);
    CHECK(tip < touch - 0.004);
    CHECK(away.force == Vec3::Zero());
    CHECK(world.bodies[0].substeps == 1);
    CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                                 scene.bodies[0].tissue.rest_position) < 1e-9);
  }
}

// both kernels run in it
TEST_CASE("a press held still is what the swinging reference comes to rest in" *
          doctest::skip(scenes::kernel_under_test() == Kernel::reference)) {
  const Vec3 gravity(0, 2, -9.81);
  const Scene quick = linear_scene(true, Kernel::packed, gravity);
  // damped so that its slow swinging has died away; where it comes to rest does not depend on it
  const Scene reference = linear_scene(true, Kernel::reference, gravity, 4.0 * kDamping);
  World one(quick), other(reference);
  const double touch = find_touch(quick);

  move(quick, touch + 0.001, touch - 0.004, 200, one);
  move(reference, touch + 0.001, touch - 0.004, 200, other);
  const HapticCommand a = move(quick, touch - 0.004, touch - 0.004, 200, one);
  const HapticCommand b = move(reference, touch - 0.004, touch - 0.004, 300, other);

  CHECK(!one.alarm);
  CHECK(b.force.z() > 0.03);
  CHECK((a.force - b.force).norm() < 2e-3 * b.force.norm());
  CHECK(scenes::max_difference(one.bodies[0].skin, other.bodies[0].skin) < 2e-5);
}

TEST_CASE("a held press does not tremble") {
  for (const double depth : {0.001, 0.004, 0.007}) {
    const Scene scene = linear_scene(true);
    World world(scene);
    const double touch = find_touch(scene);
    move(scene, touch + 0.001, touch - depth, 100, world);
    const Vec3 first = move(scene, touch - depth, touch - depth, 300, world).force;

    double least = first.z(), most = first.z();
    for (int i = 0; i < 200; ++i) {
      const double force = tick(scene, hand_at(touch - depth), 1e-3, world).force.z();
      least = std::min(least, force), most = std::max(most, force);
    }

    CHECK(most - least < 1e-4 * first.z());
  }
}

TEST_CASE("the force does not depend on how stiff the contact is, within its own yielding") {
  Scene soft = linear_scene(true), hard = soft;
  hard.instruments[0].tool.stiffness *= 30.0;
  World one(soft), other(hard);
  const double touch = find_touch(soft);

  move(soft, touch + 0.001, touch - 0.004, 200, one);
  move(hard, touch + 0.001, touch - 0.004, 200, other);
  const double a = move(soft, touch - 0.004, touch - 0.004, 300, one).force.z();
  const double b = move(hard, touch - 0.004, touch - 0.004, 300, other).force.z();

  CHECK(!other.alarm);
  CHECK(b > a);
  CHECK(b < 1.3 * a);
}

TEST_CASE("a tissue that is held is pulled, and let go without a kick") {
  const Scene scene = linear_scene(true);
  World world(scene);
  const double touch = find_touch(scene);
  move(scene, touch + 0.001, touch - 0.002, 100, world);

  const double pull = move(scene, touch - 0.002, touch + 0.004, 200, world, true).force.z();
  const double kick = move(scene, touch + 0.004, touch + 0.004, 1, world).force.z();

  CHECK(pull < -0.02);
  CHECK(std::abs(kick - pull) < 0.1 * std::abs(pull));
  move(scene, touch + 0.004, touch + 0.004, 200, world);
  CHECK(!world.alarm);
  CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                               scene.bodies[0].tissue.rest_position) < 1e-9);
}

TEST_CASE("a press beyond 15 % of the thickness raises the alarm, one short of it does not") {
  const Scene scene = linear_scene(true);
  const double touch = find_touch(scene);
  World shallow(scene), deep(scene);
  // over 54 mm: 8.1 mm of tissue, to which the contact adds its own yielding
  move(scene, touch + 0.001, touch - 0.0075, 200, shallow);
  move(scene, touch - 0.0075, touch - 0.0075, 200, shallow);

  move(scene, touch + 0.001, touch - 0.013, 200, deep);
  const HapticCommand after = move(scene, touch - 0.013, touch - 0.013, 200, deep);

  CHECK(!shallow.alarm);
  CHECK(deep.alarm.kind == AlarmKind::pressed_deep);
  CHECK(deep.alarm.limit == Approx(0.15 * 0.054).epsilon(0.02));
  CHECK(deep.alarm.value > deep.alarm.limit);
  CHECK(after.force == Vec3::Zero());
}

TEST_CASE("a flick does not pass a linear solid") {
  const Scene scene = linear_scene(true);
  World world(scene);
  const double touch = find_touch(scene);

  move(scene, touch + 0.01, touch - 0.012, 8, world);  // 2.75 m/s
  const HapticCommand held = move(scene, touch - 0.012, touch - 0.012, 5, world);

  CHECK(world.instruments[0].tool.touching);
  CHECK(held.force.z() > 0.3);
  CHECK(held.force.z() < 5.01);
}

TEST_CASE("out of reach a linear solid is felt and does not give") {
  Scene scene;
  scene.bodies[0].tissue = scenes::make_covered_linear_organ(5, 0.9, kDamping);
  int bottom = 0;
  const Vec3Array rest =
      compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position);
  for (int v = 0; v < static_cast<int>(rest.size()); ++v) {
    if (rest[v].x() > rest[bottom].x()) bottom = v;
  }
  scene.bodies[0].tissue = limit_reach(std::move(scene.bodies[0].tissue), {bottom});
  scene = build_scene(std::move(scene));
  World world(scene);
  const double touch = find_touch(scene);

  const HapticCommand felt = move(scene, touch + 0.001, touch - 0.003, 200, world);

  CHECK(felt.force.z() > 0.3);
  CHECK(scenes::max_difference(world.bodies[0].skin, rest) == 0.0);
}

TEST_CASE("ticks of a linear solid allocate nothing and take no lock") {
  const Scene scene = linear_scene(true);
  World world(scene);
  const double touch = find_touch(scene);

  const Calls before = count_calls_of_this_thread();
  move(scene, touch + 0.002, touch - 0.005, 100, world);
  move(scene, touch - 0.005, touch + 0.002, 100, world, true);
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("the same hand gives the same bits") {
  const Scene scene = linear_scene(true);
  World one(scene), other(scene);
  const double touch = find_touch(scene);

  const HapticCommand a = move(scene, touch + 0.002, touch - 0.005, 150, one);
  const HapticCommand b = move(scene, touch + 0.002, touch - 0.005, 150, other);

  CHECK(a.force == b.force);
  CHECK(compute_hash(one) == compute_hash(other));
}
