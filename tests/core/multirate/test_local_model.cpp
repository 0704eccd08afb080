// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/tick/press_scene.h"
#include "palpate/sim/multirate/private/measure_local_model.h"
#include "scenes/held_block.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;
using testing::press_scene;

namespace {

/// A hand that stays: what it feels once the tissue has come to rest.
Vec3 stay(SlowTissue& slow, const Vec3& hand, int ticks) {
  HapticSample sample;
  sample.position = hand;
  Vec3 force = Vec3::Zero();
  for (int t = 0; t < ticks; ++t) force = slow.tick(sample).force;
  return force;
}

/// [N/m] What the hand feels of a model: its own spring, the tissue behind it.
Mat3 felt_stiffness(const LocalModel& model, const Coupling& coupling) {
  return (Mat3::Identity() / coupling.stiffness * model.stiffness + Mat3::Identity())
             .transpose()
             .inverse() *
         model.stiffness;
}

Scene solid_scene() {
  const scenes::Held held = scenes::make_held_block(3);
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].tissue = build_solid(held.solid, held.material, held.options);
  scene.bodies[0].tissue.drag = 30.0;
  return build_scene(std::move(scene));
}

}  // namespace

TEST_CASE("one spring before a tissue: K = M (I + C M)^-1") {
  const Vec3 n = Vec3(1.0, 2.0, 2.0) / 3.0;
  Mat3 compliance;
  compliance << 5e-3, 1e-3, 0.0, 1e-3, 4e-3, 5e-4, 0.0, 5e-4, 6e-3;
  const Mat3 m = 200.0 * n * n.transpose();

  const Mat3 stiffness =
      condense({{{n, 200.0}}}, Eigen::MatrixXd::Constant(1, 1, n.dot(compliance * n)));

  const Mat3 expected = m * (Mat3::Identity() + compliance * m).inverse();
  CHECK((stiffness - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("springs side by side add up, and on one soft place give way together") {
  const LocalSpring spring{Vec3::UnitZ(), 100.0};
  const std::vector<LocalSpring> two = {spring, spring};

  CHECK(condense(two, Eigen::MatrixXd::Zero(2, 2))(2, 2) == Approx(200.0));
  // 10 mm/N each of its own: 1/(1/100 + 0.01) twice
  CHECK(condense(two, 0.01 * Eigen::MatrixXd::Identity(2, 2))(2, 2) == Approx(100.0));
  // 10 mm/N under both: 1/(1/200 + 0.01)
  CHECK(condense(two, Eigen::MatrixXd::Constant(2, 2, 0.01))(2, 2) == Approx(1.0 / 0.015));
  CHECK(condense({}, Eigen::MatrixXd()) == Mat3::Zero());
}

TEST_CASE("the local stiffness is that of the whole scene by finite differences, along the press") {
  for (const bool solid : {false, true}) {
    CAPTURE(solid);
    const Scene scene = solid ? solid_scene() : press_scene();
    const Vec3 hand = solid ? Vec3(0.003, 0.002, 0.026) : Vec3(0.001, 0.002, 0.0205);
    SlowTissue slow(scene, 1000.0, 10);
    stay(slow, hand + Vec3(0, 0, 0.003), 20);
    stay(slow, hand, 3000);
    const LocalModel model = slow.model();
    constexpr double kMove = 1e-4;  // [m]

    const Vec3 up = stay(slow, hand + Vec3(0, 0, kMove), 2000);
    const Vec3 down = stay(slow, hand - Vec3(0, 0, kMove), 2000);

    const double measured = (down - up).z() / (2.0 * kMove);
    const double told = felt_stiffness(model, scene.instruments[0].coupling)(2, 2);
    REQUIRE(model.force.z() > 0.02);
    CHECK(told == Approx(measured).epsilon(0.1));
    CHECK((model.stiffness - model.stiffness.transpose()).norm() == 0.0);
    CHECK(Eigen::SelfAdjointEigenSolver<Mat3>(model.stiffness).eigenvalues()[0] >
          -1e-9 * model.stiffness.norm());
  }
}

TEST_CASE("a tool above the tissue is told where it would touch, and how hard") {
  const Scene scene = press_scene();
  SlowTissue slow(scene, 1000.0, 10);

  stay(slow, {0.0, 0.0, 0.0260}, 30);

  const LocalModel& model = slow.model();
  CHECK(model.force == Vec3::Zero());
  CHECK(model.normal.z() > 0.9);
  CHECK(model.position.z() == Approx(0.0230).epsilon(0.01));
  CHECK(model.stiffness(2, 2) > 10.0);
}
