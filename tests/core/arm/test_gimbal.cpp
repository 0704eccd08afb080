// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/kinematics.h"
#include "palpate/sim/arm/private/gimbal.h"

using namespace palpate;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMost = 2.3;  // [rad] of the design's sensors

/// [rad] between how the stylus is held and how it should be.
double find_rest(const Vec3& joints, const Quaternion& stylus, double most = kMost) {
  return compute_stylus(joints, compute_gimbal(joints, stylus, most)).angularDistance(stylus);
}

Quaternion draw_turn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
}

}  // namespace

TEST_CASE("the gimbal's angles are found for how the stylus is held, all over their range") {
  double worst_angle = 0.0, worst_turn = 0.0;
  for (const Vec3& joints : {Vec3(0.0, 0.5, 0.5), Vec3(-0.9, 0.1, -0.3), Vec3(0.7, 1.2, 1.3)}) {
    for (double yaw = -2.25; yaw < 2.3; yaw += 0.25) {
      for (double pitch = -1.5; pitch < 1.55; pitch += 0.25) {
        for (double roll = -2.25; roll < 2.3; roll += 0.25) {
          const Vec3 gimbal(yaw, pitch, roll);
          const Quaternion stylus = compute_stylus(joints, gimbal);
          const Vec3 found = compute_gimbal(joints, stylus, kMost);
          worst_angle = std::max(worst_angle, (found - gimbal).cwiseAbs().maxCoeff());
          worst_turn = std::max(worst_turn, compute_stylus(joints, found).angularDistance(stylus));
        }
      }
    }
  }
  CHECK(worst_angle < 1e-12);
  CHECK(worst_turn < 1e-12);
}

TEST_CASE("a stylus in line with the forearm needs no turn of the gimbal, an upright one some") {
  const Vec3 joints(0.4, 0.3, 0.7);

  CHECK(compute_gimbal(joints, compute_stylus(joints, Vec3::Zero()), kMost).norm() < 1e-12);
  CHECK(compute_gimbal({0.4, 0.3, 0.0}, Quaternion::Identity(), kMost)
            .isApprox(Vec3(-0.4, 0.0, 0.0), 1e-12));
  CHECK(compute_gimbal({0.0, 0.3, 0.7}, Quaternion::Identity(), kMost)
            .isApprox(Vec3(0.0, 0.7, 0.0), 1e-12));
}

TEST_CASE("an upright stylus is in reach all over the workspace, turned or leaned by 75") {
  const Arm arm;
  const Workspace box;
  const double most = 75.0 * kDegree;
  double worst = 0.0;
  for (int i = 0; i < 125; ++i) {
    const Vec3 part(i % 5 / 4.0 - 0.5, i / 5 % 5 / 4.0 - 0.5, i / 25 / 4.0 - 0.5);
    const Vec3 joints = *find_joints(arm, box.center + part.cwiseProduct(box.size));
    for (double turn : {-most, 0.0, most}) {
      const Quaternion stylus(Eigen::AngleAxisd(turn, Vec3::UnitZ()));
      worst = std::max(worst, find_rest(joints, stylus));
    }
    for (int k = 0; k < 12; ++k) {
      const Vec3 across(std::cos(30.0 * kDegree * k), std::sin(30.0 * kDegree * k), 0.0);
      worst = std::max(worst, find_rest(joints, Quaternion(Eigen::AngleAxisd(most, across))));
      const Eigen::AngleAxisd lean(45.0 * kDegree, across), turn(45.0 * kDegree, Vec3::UnitZ());
      worst = std::max(worst, find_rest(joints, Quaternion(lean * turn)));
      worst = std::max(worst, find_rest(joints, Quaternion(lean * turn.inverse())));
    }
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("where yaw and roll have one axis each takes half of the turn") {
  const Vec3 joints(0.2, 0.4, 0.6);
  for (double pitch : {-0.5 * std::numbers::pi, 0.5 * std::numbers::pi}) {
    for (double turn = -3.1; turn < 3.2; turn += 0.2) {
      const Quaternion stylus = compute_stylus(joints, {turn, pitch, 0.0});

      const Vec3 found = compute_gimbal(joints, stylus, kMost);

      CHECK(compute_stylus(joints, found).angularDistance(stylus) < 1e-7);
      CHECK(std::abs(found[0]) <= 0.5 * std::numbers::pi + 1e-6);
    }
  }
}

TEST_CASE("where an angle would have to go beyond its stop the gimbal stops there") {
  const Vec3 joints(0.0, 0.5, 0.0);
  const auto yawed = [&](double angle) { return compute_stylus(joints, {angle, 0.0, 0.0}); };

  CHECK(compute_gimbal(joints, yawed(2.5), kMost).isApprox(Vec3(kMost, 0.0, 0.0)));
  CHECK(find_rest(joints, yawed(2.5)) == doctest::Approx(0.2));
  CHECK(compute_gimbal(joints, yawed(-2.5), kMost).isApprox(Vec3(-kMost, 0.0, 0.0)));
  // a yaw beyond its stop is in reach the other way round
  const Quaternion both = compute_stylus(joints, {2.5, 1.0, 2.0});
  const Vec3 round = compute_gimbal(joints, both, kMost);
  CHECK(compute_stylus(joints, round).angularDistance(both) < 1e-12);
  CHECK(round.isApprox(Vec3(2.5, -1.0, 2.0) - std::numbers::pi * Vec3(1.0, -1.0, 1.0), 1e-12));

  std::mt19937 random(5);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Quaternion stylus = draw_turn(random);
    const Vec3 found = compute_gimbal(joints, stylus, kMost);
    CHECK(found.cwiseAbs().maxCoeff() <= kMost);
    worst = std::max(worst, compute_stylus(joints, found).angularDistance(stylus));
  }
  MESSAGE("left of any turn at most: ", worst / kDegree, " degrees");
  CHECK(worst <= std::numbers::pi - kMost + 1e-9);
}

TEST_CASE("a gimbal's stops are where its calibration has the ends of its range") {
  const Calibration calibration = find_calibration({});
  for (std::size_t j = 3; j < 6; ++j) {
    CHECK(calibration.joints[j].max - calibration.joints[j].zero == kGimbalReach);
    CHECK(calibration.joints[j].zero - calibration.joints[j].min == kGimbalReach);
  }
}
