// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/flicks.h"
#include "scenes/held_block.h"
#include "scenes/kernels.h"
#include "scenes/solids.h"

// What is felt of tissue that a ball has taken hold of and pulls, through the tick
// [contact: hold].

using namespace palpate;

namespace {

constexpr double kModulus = scenes::kBlockModulus;  ///< [Pa]
constexpr double kTick = 1e-3, kRadius = 0.004, kGrip = 0.0005;
constexpr double kHand = 500.0, kHold = 500.0;  ///< [N/m]

/// A block of cells of `edge` [m] that is held below, of which all springs and volumes, or the
/// linear solid, are felt under the near field.
Scene make_block_scene(double edge, const std::array<int, 3>& cells, bool linear, double far) {
  const Vec3 size = edge * Vec3(cells[0], cells[1], cells[2]);
  const SolidMesh solid = scenes::make_block(size, cells);
  SolidOptions options;
  options.nodal_share = 0.9;
  options.drag = 60.0;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (solid.vertices[i].z() < -0.499 * size.z()) options.fixed.push_back(static_cast<int>(i));
  }
  Material material = scenes::make_material({.damping_ratio = 0.3});
  material.young_modulus = scenes::kBlockYoung;
  material.poisson_ratio = scenes::kBlockPoisson;
  Scene scene;
  SoftBody& body = scene.bodies[0];
  body.tissue =
      linear ? build_linear_solid(solid, material, options) : build_solid(solid, material, options);
  if (!linear) body.kernel = scenes::kernel_under_test();
  body.contact_modulus = kModulus;
  body.tied_holds = true;
  if (!std::isnan(far)) {
    body.far_compliance.assign(solid.vertices.size(), {far, far, far, 0.0, 0.0, 0.0});
  }
  scene.instruments[0].tool.radius = kRadius;
  scene.instruments[0].coupling.stiffness = kHand;
  scene.instruments[0].hold_stiffness = kHold;
  return build_scene(std::move(scene));
}

struct Pull {
  double grip = 0.0;       ///< [N] when it takes hold
  double jump = 0.0;       ///< [N] in the tick in which it does
  double stiffness = 0.0;  ///< [N/m] of the pull against how far the tool goes up
  double slack = 0.0;      ///< [N] when it is let go, the largest from tick to tick
  double left = 0.0;       ///< [N] at the end, in the air
  double sideways = 0.0;   ///< [N/m]
};

/// Presses kGrip deep, takes hold, pulls `up` [m] and `aside`, comes back and lets go.
Pull pull(const Scene& scene, const Vec3& at, double top, const Vec3& way) {
  World world(scene);
  Pull found;
  Vec3 last = Vec3::Zero();
  const auto go = [&](const Vec3& from, const Vec3& to, int ticks, bool held) {
    double most = 0.0;
    for (int i = 0; i < ticks; ++i) {
      const double part = std::min(1.0, 2.0 * (i + 1) / ticks);
      HapticSample sample = scenes::hand_at(from + part * (to - from));
      sample.buttons = held ? kAttachButton : std::uint8_t{0};
      const Vec3 force = tick(scene, sample, kTick, world).force;
      most = std::max(most, (force - last).norm());
      last = force;
    }
    REQUIRE_FALSE(world.alarm);
    return most;
  };
  const Vec3 over = at + Vec3(0.0, 0.0, top + kRadius + 0.001);
  const Vec3 low = at + Vec3(0.0, 0.0, top + kRadius - kGrip);
  go(over, over, 10, false);
  go(over, low, 600, false);
  found.grip = last.z();
  found.jump = go(low, low, 1, true);
  go(low, low, 400, true);
  const Vec3 force = last, place = world.instruments[0].tool.position;
  go(low, low + way, 800, true);
  const Vec3 gone = world.instruments[0].tool.position - place;
  found.stiffness = (force - last).dot(gone) / gone.squaredNorm();
  found.slack = go(low + way, low + way, 100, false);
  go(low + way, over, 400, false);
  found.left = last.norm();
  return found;
}

double top_of(const Scene& scene) {
  double top = 0.0;
  for (const Vec3& x : scene.bodies[0].tissue.rest_position) top = std::max(top, x.z());
  return top;
}

/// [N/m] 2 E* a of the dent of the force F [N] on a half space.
double find_disc(double force) {
  const double s = std::pow(force / (4.0 / 3.0 * kModulus * std::sqrt(kRadius)), 2.0 / 3.0);
  return 2.0 * kModulus * std::sqrt(kRadius * s);
}

}  // namespace

TEST_CASE("a pull is that of a tied disc on a layer, whatever the mesh") {
  // alpha_0 of [Dimitriadis02], of a layer of 50 mm that is bonded below
  constexpr double kNu = scenes::kBlockPoisson;
  const double alpha = -(1.2876 - 1.4678 * kNu + 1.3442 * kNu * kNu) / (1.0 - kNu);
  const double far = alpha / (std::numbers::pi * kModulus * scenes::kBlockThickness);
  for (const int n : {3, 5}) {
    const Scene scene = make_block_scene(scenes::kBlockThickness / n, {2 * n, 2 * n, n}, true, NAN);
    const Pull found = pull(scene, {0.0011, 0.0023, 0.0}, top_of(scene), {0, 0, 0.002});
    const double known = 1.0 / (1.0 / kHold + 1.05 / find_disc(found.grip) + far);
    CAPTURE(n);
    CHECK(found.stiffness == doctest::Approx(known).epsilon(0.10));
    CHECK(found.jump < 0.1 * found.grip);
    CHECK(found.left < 1e-6);
  }
}

TEST_CASE("under a far field that is given a pull is alike on tetrahedra of 2 to 10 mm") {
  constexpr double kFar = 0.01;  // [m/N], beside 0.06 of the disc
  for (const bool linear : {true, false}) {
    for (const double edge : {0.002, 0.005, 0.010}) {
      const Scene scene = make_block_scene(edge, {8, 8, 4}, linear, kFar);
      const Pull found = pull(scene, {0.13 * edge, 0.21 * edge, 0.0}, top_of(scene), {0, 0, 0.001});
      const double known = 1.0 / (1.0 / kHold + 1.05 / find_disc(found.grip) + kFar);
      CAPTURE(linear);
      CAPTURE(edge);
      CHECK(found.stiffness == doctest::Approx(known).epsilon(0.12));
      CHECK(found.slack < 0.25 * known * 0.001);
    }
  }
}

TEST_CASE("a hold that is fastened to vertices feels the mesh: files of before") {
  Scene scene = make_block_scene(0.010, {8, 8, 4}, true, 0.01);
  scene.bodies[0].tied_holds = false;
  scene = build_scene(std::move(scene));
  const Pull found = pull(scene, {0.0013, 0.0021, 0.0}, top_of(scene), {0, 0, 0.001});
  CHECK(found.stiffness > 2.0 / (1.0 / kHold + 1.05 / find_disc(found.grip) + 0.01));
}

TEST_CASE("a scene refuses holds that are tied to tissue without a near field") {
  Scene scene = make_block_scene(0.010, {4, 4, 2}, true, NAN);
  scene.bodies[0].contact_modulus = 0.0;
  CHECK_THROWS_WITH(build_scene(scene),
                    doctest::Contains("tied_holds: got true without a contact_modulus"));
}
