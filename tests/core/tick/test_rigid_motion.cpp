// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tick/private/rigid_contacts.h"

using namespace palpate;

namespace {

/// A stone of 0.8 g, 11 x 9 x 8 mm.
RigidBody make_stone() {
  RigidBody stone;
  stone.sphere_centres = {Vec3::Zero()};
  stone.sphere_radii = {0.004};
  stone.mass = 8e-4;
  const Vec3 half(5.5e-3, 4.5e-3, 4e-3), square = half.cwiseProduct(half);
  stone.inertia =
      stone.mass / 5.0 * Vec3(square[1] + square[2], square[0] + square[2], square[0] + square[1]);
  stone.mesh = build_sphere_mesh(stone.sphere_centres, stone.sphere_radii);
  return stone;
}

}  // namespace

TEST_CASE("R1: a free body keeps energy and angular momentum to 1e-6 over 10 s") {
  const RigidBody stone = make_stone();
  const MovedMass own{stone.mass, stone.inertia};
  RigidState state;
  state.velocity = {0.1, -0.2, 0.05};
  // about the axis between the others, where turning is not stable
  state.angular_velocity = {0.3, 20.0, 0.2};
  const double energy = compute_kinetic_energy(own, state);
  const Vec3 momentum = compute_angular_momentum(stone.inertia, state);
  constexpr double kDt = 1e-3 / 12.0;
  double worst_energy = 0.0, worst_momentum = 0.0, turned = 0.0;
  for (int i = 0; i < 120000; ++i) {
    advance_rigid(own, {}, kDt, state);
    worst_energy =
        std::max(worst_energy, std::abs(compute_kinetic_energy(own, state) / energy - 1.0));
    worst_momentum = std::max(
        worst_momentum,
        (compute_angular_momentum(stone.inertia, state) - momentum).norm() / momentum.norm());
    turned = std::max(turned, (state.orientation * Vec3::UnitY()).dot(-Vec3::UnitY()));
  }
  CHECK(worst_energy < 1e-6);
  CHECK(worst_momentum < 1e-6);
  CHECK(turned > 0.9);  // it has turned over on the way
  CHECK(state.orientation.norm() == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(state.position.isApprox(10.0 * Vec3(0.1, -0.2, 0.05), 1e-9));
}

TEST_CASE("a push off the centre moves and turns a body as worked out by hand") {
  const MovedMass moved{0.002, {1e-7, 2e-7, 4e-7}};
  RigidState state;
  state.position = {0.1, 0.0, 0.0};
  Wrench wrench;
  wrench.add({0.1, 0.01, 0.0}, {0.0, 0.0, 0.4}, state.position);
  CHECK(wrench.torque.isApprox(Vec3(0.004, 0.0, 0.0)));
  advance_rigid(moved, wrench, 1e-4, state);
  CHECK(state.velocity.isApprox(Vec3(0.0, 0.0, 0.02)));         // 1e-4 0.4 / 0.002
  CHECK(state.angular_velocity.isApprox(Vec3(4.0, 0.0, 0.0)));  // 1e-4 0.004 / 1e-7
  CHECK(state.position.isApprox(Vec3(0.1, 0.0, 2e-6)));
}

TEST_CASE("a sphere falls in water at the speed where drag and buoyancy bear its weight") {
  RigidBody ball = make_stone();
  const double volume = compute_rigid_volume(ball);
  CHECK(volume == doctest::Approx(4.0 / 3.0 * std::numbers::pi * std::pow(0.004, 3)).epsilon(0.15));
  const Fluid water{1000.0, 7e-4};
  const Vec3 gravity(0.0, 0.0, -9.81);
  RigidState state;
  for (int i = 0; i < 20000; ++i) {
    Wrench wrench;
    add_fluid(ball, water, gravity, volume, state, wrench);
    advance_rigid({ball.mass, ball.inertia}, wrench, 1e-4, state);
  }
  const double r = std::cbrt(0.75 * volume / std::numbers::pi), v = -state.velocity.z();
  const double drag = 6.0 * std::numbers::pi * 7e-4 * r * v +
                      0.5 * 1000.0 * 0.44 * std::numbers::pi * r * r * v * v;
  CHECK(drag == doctest::Approx((ball.mass - 1000.0 * volume) * 9.81).epsilon(1e-6));
  ball.mass = 500.0 * volume;
  Wrench wrench;
  add_fluid(ball, water, gravity, volume, RigidState(), wrench);
  CHECK(wrench.force.z() == doctest::Approx(500.0 * volume * 9.81));  // what is light rises
}

TEST_CASE("mass and inertia are raised where contacts are too stiff for a step, and only there") {
  const RigidBody stone = make_stone();
  const MovedMass own = raise_mass(stone, 1000.0, 1000.0 * 2.5e-5, 1e-4);
  CHECK(own.mass == stone.mass);  // 2 1e-8 1000 = 2e-5
  const MovedMass raised = raise_mass(stone, 1e5, 1e5 * 2.5e-5, 1e-4);
  CHECK(raised.mass == doctest::Approx(2e-3));
  CHECK(raised.inertia.minCoeff() == doctest::Approx(5e-8));
}

TEST_CASE("a bristle pulls along the surface up to mu N, then its point follows") {
  const BristleLaw law{100.0, 0.0, 0.3};
  Vec3 slip;
  const Vec3 stretch(1e-3, 0.0, 5e-3);
  CHECK(pull_bristle(law, stretch, Vec3::Zero(), Vec3::UnitZ(), 1.0, slip)
            .isApprox(Vec3(0.1, 0.0, 0.0)));
  CHECK(slip.isZero(0.0));
  CHECK(pull_bristle(law, stretch, Vec3::Zero(), Vec3::UnitZ(), 0.1, slip)
            .isApprox(Vec3(0.03, 0.0, 0.0)));
  CHECK(slip.isApprox(Vec3(7e-4, 0.0, 0.0)));
  // damping is within the same limit
  const BristleLaw damped{100.0, 10.0, 0.3};
  CHECK(pull_bristle(damped, stretch, {1.0, 0.0, 0.0}, Vec3::UnitZ(), 1.0, slip).norm() ==
        doctest::Approx(0.3));
}

TEST_CASE("the mesh of spheres is closed about each, and turned outwards") {
  const Vec3Array centres = {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}};
  const std::vector<double> radii = {0.004, 0.002};
  const SurfaceMesh mesh = build_sphere_mesh(centres, radii);
  CHECK_NOTHROW(validate(mesh));
  CHECK(is_closed(mesh.triangles));
  CHECK(mesh.triangles.size() == 160);
  RigidBody body;
  body.mesh = mesh;
  CHECK(compute_rigid_volume(body) > 0.0);
}
