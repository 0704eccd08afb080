// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "calls.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/shells.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A wall of prisms around a hollow of 100 x 70 x 60 mm, held at its base.
Scene shell_scene(Kernel kernel = scenes::kernel_under_test()) {
  Scene scene;
  scene.bodies[0].kernel = kernel;
  scene.bodies[0].tissue = scenes::make_shell_organ(2, {.damping_ratio = 0.2, .drag = 3.0});
  return build_scene(std::move(scene));
}

/// [m] Where the tip touches the top.
double find_touch(const Scene& scene) {
  double top = 0.0;
  for (const Vec3& x : scene.bodies[0].tissue.rest_position) top = std::max(top, x.z());
  return top + scene.instruments[0].tool.radius;
}

/// Goes from `from` to `to` [m] above where the tip first touches, in as many ticks.
HapticCommand move(const Scene& scene, double from, double to, int ticks, World& world) {
  const double touch = find_touch(scene);
  HapticCommand command;
  for (int i = 1; i <= ticks; ++i) {
    HapticSample sample;
    sample.position = {0.001, 0.002, touch + from + (to - from) * i / ticks};
    command = tick(scene, sample, 1e-3, world);
  }
  return command;
}

}  // namespace

TEST_CASE("a scene with a shell keeps the packed kernel, and its ticks run on it") {
  const Scene scene = shell_scene(Kernel::packed);
  const World world(scene);

  CHECK(scene.bodies[0].kernel == Kernel::packed);
  CHECK((find_packed(world.bodies[0]) != nullptr) == !simd_targets().empty());
}

TEST_CASE("a shell is pressed in, pushes back, and comes back") {
  const Scene scene = shell_scene();
  World world(scene);

  const double shallow = move(scene, 0.005, -0.003, 200, world).force.z();
  const double deep = move(scene, -0.003, -0.006, 200, world).force.z();
  move(scene, -0.006, 0.01, 200, world);
  const HapticCommand away = move(scene, 0.01, 0.01, 1000, world);

  CHECK(!world.alarm);
  CHECK(shallow > 0.03);
  CHECK(deep > 1.5 * shallow);
  CHECK(away.force == Vec3::Zero());
  CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                               scene.bodies[0].tissue.rest_position) < 1e-4);
}

TEST_CASE("both kernels make the same of a press on a shell") {
  const Scene packed = shell_scene(Kernel::packed);
  const Scene reference = shell_scene(Kernel::reference);
  World one(packed), other(reference);

  const HapticCommand a = move(packed, 0.001, -0.004, 200, one);
  const HapticCommand b = move(reference, 0.001, -0.004, 200, other);

  CHECK(b.force.z() > 0.05);
  CHECK((a.force - b.force).norm() < 1e-4 * b.force.norm());
  CHECK(scenes::max_difference(one.bodies[0].tissue.position, other.bodies[0].tissue.position) <
        1e-6);
}

TEST_CASE("ticks of a shell allocate nothing and take no lock") {
  const Scene scene = shell_scene();
  World world(scene);

  const Calls before = count_calls_of_this_thread();
  move(scene, 0.002, -0.005, 100, world);
  move(scene, -0.005, 0.002, 100, world);
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("no part of a shell may sleep: a force error is refused by name") {
  Scene scene = shell_scene();
  scene.bodies[0].tissue.home.assign(scene.bodies[0].tissue.mass.size(), 10.0);
  scene.bodies[0].force_error = 1e-3;

  CHECK_THROWS_WITH_AS(build_scene(scene), doctest::Contains("walls of prisms are moved whole"),
                       std::invalid_argument);
}
