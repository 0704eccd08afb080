// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "palpate/sim/arm/kinematics.h"

using namespace palpate;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
const Vec3 kHome = {0.0, 30.0 * kDegree, 30.0 * kDegree};

/// A grid of 9 x 9 x 9 points of the box [kinematics: workspace].
std::vector<Vec3> points_of_workspace() {
  const Workspace box;
  std::vector<Vec3> points;
  for (int i = 0; i < 729; ++i) {
    const Vec3 part(i % 9 / 8.0 - 0.5, i / 9 % 9 / 8.0 - 0.5, i / 81 / 8.0 - 0.5);
    points.push_back(box.center + part.cwiseProduct(box.size));
  }
  return points;
}

double condition(const Mat3& m) {
  const Mat3 inverse = m.inverse();
  return m.norm() * inverse.norm();  // Frobenius: at least the ratio of singular values
}

Vec3 random_force(std::mt19937& random, double size) {
  std::normal_distribution<double> normal;
  return size * Vec3(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace

TEST_CASE("at home the tip is 205 mm before and 55 mm below the origin") {
  const Arm arm;

  const Vec3 tip = compute_tip(arm, kHome);

  CHECK(tip.x() == doctest::Approx(0.0));
  CHECK(tip.y() == doctest::Approx(-0.15 * (std::sqrt(3.0) / 2.0 + 0.5)));  // -204.9 mm
  CHECK(tip.z() == doctest::Approx(0.15 * (0.5 - std::sqrt(3.0) / 2.0)));   // -54.9 mm
}

TEST_CASE("a positive yaw moves the tip to the right, a positive forearm towards the user") {
  const Arm arm;
  const Vec3 tip = compute_tip(arm, kHome);

  CHECK(compute_tip(arm, kHome + Vec3(0.1, 0, 0)).x() > tip.x());
  CHECK(compute_tip(arm, kHome + Vec3(0, 0.1, 0)).z() > tip.z());
  CHECK(compute_tip(arm, kHome + Vec3(0, 0, 0.1)).y() < tip.y());
}

TEST_CASE("joints give back the tip they were found for, all over the workspace") {
  const Arm arm;
  double worst = 0.0;

  for (const Vec3& point : points_of_workspace()) {
    const auto joints = find_joints(arm, point);
    REQUIRE(joints);
    CHECK(is_within(arm, *joints));
    worst = std::max(worst, (compute_tip(arm, *joints) - point).norm());
  }

  CHECK(worst < 1e-15);
}

TEST_CASE("tips give back the joints they were computed from, with links of unlike length too") {
  Arm arm;
  arm.upper_length = 0.18;
  arm.forearm_length = 0.13;

  for (double yaw : {-0.9, 0.0, 0.7}) {
    for (double elevation : {0.1, 0.6, 1.2}) {
      for (double forearm : {-0.2, 0.3, 0.9}) {
        const Vec3 joints(yaw, elevation, forearm);
        const auto found = find_joints(arm, compute_tip(arm, joints));
        REQUIRE(found);
        CHECK((*found - joints).norm() < 1e-12);
      }
    }
  }
}

TEST_CASE("what the arm cannot reach has no joints") {
  const Arm arm;

  CHECK_FALSE(find_joints(arm, {0.0, -0.31, 0.0}));          // 0.30 m is all there is
  CHECK_FALSE(find_joints(arm, {0.0, 0.0, -0.1}));           // on the yaw axis
  CHECK_FALSE(find_joints(arm, {std::nan(""), -0.1, 0.0}));  // nowhere
  CHECK_FALSE(is_within(arm, {0.0, 1.4, 0.1}));              // folded
  CHECK_FALSE(is_within(arm, {70.0 * kDegree, 0.5, 0.5}));   // too far to the right
}

TEST_CASE("the Jacobian is the tip's derivative and its determinant r L1 L2 cos(q2 - q3)") {
  const Arm arm;
  constexpr double kStep = 1e-6;

  for (const Vec3& point : points_of_workspace()) {
    const Vec3 q = *find_joints(arm, point);
    const Mat3 jacobian = compute_jacobian(arm, q);

    for (int j = 0; j < 3; ++j) {
      const Vec3 step = kStep * Vec3::Unit(j);
      const Vec3 slope = (compute_tip(arm, q + step) - compute_tip(arm, q - step)) / (2.0 * kStep);
      CHECK((slope - jacobian.col(j)).norm() < 1e-9);
    }
    const double out = std::hypot(point.x(), point.y());
    CHECK(std::abs(jacobian.determinant()) ==
          doctest::Approx(out * 0.15 * 0.15 * std::cos(q[1] - q[2])));
    CHECK(condition(jacobian) < 6.0);
  }
}

TEST_CASE("the weight's torque is the slope of its energy") {
  Arm arm;
  arm.upper_weight = 0.143;
  arm.forearm_weight = 0.088;
  const auto energy = [&arm](const Vec3& q) {  // of weights at the elbow and at the tip
    const double elbow = arm.upper_length * std::sin(q[1]);
    const double tip = compute_tip(arm, q).z();
    const double at_tip = arm.forearm_weight / arm.forearm_length;
    return at_tip * tip + (arm.upper_weight / arm.upper_length - at_tip) * elbow;
  };

  for (const Vec3& point : points_of_workspace()) {
    const Vec3 q = *find_joints(arm, point);
    const Vec3 torque = compute_weight_torque(arm, q);

    for (int j = 0; j < 3; ++j) {
      const Vec3 step = 1e-5 * Vec3::Unit(j);
      const double slope = (energy(q + step) - energy(q - step)) / 2e-5;
      CHECK(torque[j] == doctest::Approx(slope).epsilon(1e-6));
    }
  }
}

TEST_CASE("the force that goes in comes out, all over the workspace") {
  const Arm arm;
  std::mt19937 random(7);

  for (const Vec3& point : points_of_workspace()) {
    const Vec3 q = *find_joints(arm, point);
    const Vec3 force = random_force(random, 1.0);

    const Vec3 torque = compute_torque(arm, q, force, Vec3::Constant(10.0));

    CHECK((compute_tip_force(arm, q, torque) - force).norm() < 1e-12);
  }
}

TEST_CASE("the power the motors give is the power the hand takes") {
  const Arm arm;
  const Vec3 rate(0.3, -0.2, 0.5), force(0.4, -0.7, 1.1);

  const Vec3 torque = compute_jacobian(arm, kHome).transpose() * force;

  CHECK(torque.dot(rate) == doctest::Approx(force.dot(compute_jacobian(arm, kHome) * rate)));
}

TEST_CASE("a force beyond the motors keeps its direction, and the weight is carried first") {
  const Arm arm;
  const Vec3 torque_max = Vec3::Constant(0.235);
  std::mt19937 random(8);

  for (const Vec3& point : points_of_workspace()) {
    const Vec3 q = *find_joints(arm, point);
    const Vec3 force = random_force(random, 50.0);

    const Vec3 torque = compute_torque(arm, q, force, torque_max);

    CHECK((torque.cwiseAbs() - torque_max).maxCoeff() < 1e-12);
    CHECK((torque.cwiseAbs() - torque_max).maxCoeff() > -1e-12);  // all that can be had
    const Vec3 felt = compute_tip_force(arm, q, torque);
    CHECK(felt.dot(force) == doctest::Approx(felt.norm() * force.norm()));
    CHECK(felt.norm() > 0.9);  // [N] 1.09 without weight [kinematics: workspace]
  }
}

TEST_CASE("motors too weak for the arm's weight give no force but all they have against it") {
  const Arm arm;

  const Vec3 torque = compute_torque(arm, kHome, {0, 0, 1}, Vec3::Constant(0.005));

  CHECK(torque == Vec3(0.0, 0.005, 0.005));
}

TEST_CASE("force fades over the last three degrees before the edge of the workspace") {
  const Arm arm;
  const double edge = arm.joint_max[0];

  CHECK(compute_edge_fade(arm, kHome) == 1.0);
  CHECK(compute_edge_fade(arm, {edge - 1.5 * kDegree, 0.5, 0.5}) == doctest::Approx(0.5));
  CHECK(compute_edge_fade(arm, {edge, 0.5, 0.5}) == 0.0);
  CHECK(compute_edge_fade(arm, {edge + 0.1, 0.5, 0.5}) == 0.0);
  CHECK(compute_edge_fade(arm, {0.0, 1.2, 1.2 - arm.bend_max + 1.5 * kDegree}) ==
        doctest::Approx(0.5));
}

TEST_CASE("the stylus follows yaw and forearm and turns by its gimbal") {
  CHECK(compute_stylus(Vec3::Zero(), Vec3::Zero()).isApprox(Quaternion::Identity()));

  // the forearm's own direction, straight down at zero, is where the links say it is
  const Vec3 q(0.4, 0.3, 0.7);
  const Vec3 down = compute_stylus(q, Vec3::Zero()) * -Vec3::UnitZ();
  const Vec3 along(std::sin(0.7) * std::sin(0.4), -std::sin(0.7) * std::cos(0.4), -std::cos(0.7));
  CHECK((down - along).norm() < 1e-15);

  const Quaternion rolled = compute_stylus(Vec3::Zero(), {0.0, 0.0, 0.5});
  CHECK((rolled * Vec3::UnitY() - Vec3::UnitY()).norm() < 1e-15);
  CHECK(rolled.angularDistance(Quaternion::Identity()) == doctest::Approx(0.5));
}

TEST_CASE("an arm that cannot be is refused") {
  const auto refused = [](auto change) {
    Arm arm;
    change(arm);
    CHECK_THROWS_AS(validate(arm), std::invalid_argument);
  };

  CHECK_NOTHROW(validate(Arm{}));
  refused([](Arm& a) { a.upper_length = 0.0; });
  refused([](Arm& a) { a.forearm_length = std::nan(""); });
  refused([](Arm& a) { a.upper_weight = std::nan(""); });
  refused([](Arm& a) { a.joint_min[1] = 2.0; });
  refused([](Arm& a) { a.bend_max = 1.6; });
}
