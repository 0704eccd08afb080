// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "calls.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/solids.h"

using namespace palpate;
using namespace palpate::testing;
using doctest::Approx;

namespace {

/// A solid of 100 x 70 x 60 mm held at its base, under an ellipsoid of 54 mm height or bare.
Scene solid_scene(bool covered, Kernel kernel = scenes::kernel_under_test()) {
  const scenes::Losses losses{.damping_ratio = 0.2, .drag = 3.0};
  Scene scene;
  scene.bodies[0].kernel = kernel;
  scene.bodies[0].tissue = covered ? scenes::make_covered_organ(5, 0.9, losses)
                                   : scenes::make_solid_organ(5, 0.9, losses);
  return build_scene(std::move(scene));
}

HapticSample hand_at(double z) {
  HapticSample sample;
  sample.position = {0.001, 0.002, z};
  return sample;
}

/// Goes from `from` to `to` [m] in as many ticks.
HapticCommand move(const Scene& scene, double from, double to, int ticks, World& world) {
  HapticCommand command;
  for (int i = 1; i <= ticks; ++i) {
    command = tick(scene, hand_at(from + (to - from) * i / ticks), 1e-3, world);
  }
  return command;
}

double top_of(const Scene& scene) {
  double top = 0.0;
  for (const Vec3& x :
       compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)) {
    top = std::max(top, x.z());
  }
  return top;
}

}  // namespace

TEST_CASE("a solid is pressed in, pushes back, and comes back, with its skin or without") {
  for (const bool covered : {true, false}) {
    const Scene scene = solid_scene(covered);
    World world(scene);
    const double touch = top_of(scene) + scene.instruments[0].tool.radius;

    const double shallow = move(scene, touch + 0.005, touch - 0.003, 200, world).force.z();
    const double deep = move(scene, touch - 0.003, touch - 0.006, 200, world).force.z();
    const double tip = world.instruments[0].tool.position.z();
    move(scene, touch - 0.006, touch + 0.01, 200, world);
    const HapticCommand away = move(scene, touch + 0.01, touch + 0.01, 1000, world);

    CHECK(!world.alarm);
    CHECK(shallow > 0.02);
    CHECK(deep > 1.5 * shallow);
    CHECK(tip < touch - 0.004);
    CHECK(away.force == Vec3::Zero());
    CHECK(scenes::max_difference(world.bodies[0].tissue.position,
                                 scene.bodies[0].tissue.rest_position) < 1e-4);
  }
}

TEST_CASE("the skin is where the tetrahedra carry it after every tick") {
  const Scene scene = solid_scene(true);
  World world(scene);
  const double touch = top_of(scene) + scene.instruments[0].tool.radius;

  move(scene, touch + 0.002, touch - 0.004, 100, world);

  CHECK(scenes::max_difference(
            world.bodies[0].skin,
            compute_surface(scene.bodies[0].tissue, world.bodies[0].tissue.position)) == 0.0);
  CHECK(surface_position(world.bodies[0]).data() == world.bodies[0].skin.data());
}

TEST_CASE("what the hand feels from a skin is what the tetrahedra carry, force and moment") {
  const Scene scene = solid_scene(true);
  World world(scene);
  const double touch = top_of(scene) + scene.instruments[0].tool.radius;
  const HapticCommand felt = move(scene, touch, touch - 0.004, 400, world);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const Push& push : world.bodies[0].load.pushes()) {
    const auto& [a, b, c] = scene.bodies[0].tissue.triangles[push.triangle];
    force += push.force;
    torque +=
        (push.weights[0] * world.bodies[0].skin[a] + push.weights[1] * world.bodies[0].skin[b] +
         push.weights[2] * world.bodies[0].skin[c])
            .cross(push.force);
  }
  Vec3Array f(scene.bodies[0].tissue.mass.size(), Vec3::Zero());

  accumulate_push_forces(scene.bodies[0].tissue.triangles, scene.bodies[0].tissue.skin,
                         world.bodies[0].load.pushes(), f);

  CHECK(world.bodies[0].load.push_count > 0);
  CHECK((scenes::sum(f) - force).norm() < 1e-13 * force.norm());
  CHECK((scenes::compute_torque(world.bodies[0].tissue.position, f) - torque).norm() <
        1e-12 * torque.norm());
  CHECK((force + felt.force).norm() < 0.01 * felt.force.norm());
}

TEST_CASE("both kernels make the same of a press on a skin") {
  const Scene packed = solid_scene(true, Kernel::packed);
  const Scene reference = solid_scene(true, Kernel::reference);
  World one(packed), other(reference);
  const double touch = top_of(packed) + packed.instruments[0].tool.radius;

  const HapticCommand a = move(packed, touch + 0.001, touch - 0.004, 200, one);
  const HapticCommand b = move(reference, touch + 0.001, touch - 0.004, 200, other);

  CHECK((a.force - b.force).norm() < 1e-4 * b.force.norm());
  CHECK(scenes::max_difference(one.bodies[0].skin, other.bodies[0].skin) < 1e-6);
}

TEST_CASE("a fast and deep press into a skin neither tears it nor passes it") {
  const Scene scene = solid_scene(true);
  World world(scene);
  const double touch = top_of(scene) + scene.instruments[0].tool.radius;

  move(scene, touch + 0.02, touch - 0.015, 35, world);
  const HapticCommand held = move(scene, touch - 0.015, touch - 0.015, 300, world);

  CHECK(!world.alarm);
  CHECK(held.force.z() > 0.3);
  CHECK(world.instruments[0].tool.touching);
}

TEST_CASE("ticks of a covered solid allocate nothing and take no lock") {
  const Scene scene = solid_scene(true);
  World world(scene);
  const double touch = top_of(scene) + scene.instruments[0].tool.radius;

  const Calls before = count_calls_of_this_thread();
  move(scene, touch + 0.002, touch - 0.005, 100, world);
  move(scene, touch - 0.005, touch + 0.002, 100, world);
  const Calls after = count_calls_of_this_thread();

  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
}

TEST_CASE("surface masses bound what contacts add to the spectrum of a covered solid") {
  const TissueModel model = scenes::make_covered_organ(3, 0.9);
  const std::vector<double> mass = compute_surface_mass(model);
  const auto n = static_cast<Eigen::Index>(mass.size());
  // A = P M^-1 P^T in one coordinate, K_s = I: the largest eigenvalue against 1 / the least mass
  Eigen::MatrixXd carried = Eigen::MatrixXd::Zero(n, particle_count(model));
  for (Eigen::Index v = 0; v < n; ++v) {
    for (int k = 0; k < 4; ++k) {
      const int i = model.skin.corners[v][k];
      carried(v, i) += model.skin.weights[v][k] / std::sqrt(model.mass[i]);
    }
  }
  const Eigen::MatrixXd compliance = carried * carried.transpose();
  Eigen::VectorXd x = Eigen::VectorXd::Ones(n);
  for (int i = 0; i < 200; ++i) x = (compliance * x).normalized();

  CHECK(x.dot(compliance * x) < 1.0 / *std::min_element(mass.begin(), mass.end()));
  CHECK(compute_surface_mass(scenes::make_solid_organ(2, 0.0)).size() == 27);
}
