// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/private/hyperelastic_law.h"
#include "scenes/scenes.h"

using namespace palpate;
using doctest::Approx;

namespace {

Mat3 scatter_matrix(int seed) {
  Mat3 matrix;
  for (int k = 0; k < 9; ++k) matrix(k / 3, k % 3) = scenes::scatter(9 * seed + k);
  return matrix;
}

void check_rotation(const Mat3& r, double error) {
  CHECK((r.transpose() * r - Mat3::Identity()).norm() < error);
  CHECK(r.determinant() == Approx(1.0));
}

}  // namespace

TEST_CASE("what is stretched along three axes and then turned is turned by that very rotation") {
  const Mat3 turn = Eigen::AngleAxisd(2.0, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  const Mat3 axes = Eigen::AngleAxisd(0.7, Vec3(3, 1, 1).normalized()).toRotationMatrix();
  for (const Vec3& stretch : {Vec3(1, 1, 1), Vec3(1.1, 1, 0.9), Vec3(3, 0.2, 0.1), Vec3(1e-3, 1, 2),
                              Vec3(1e4, 2e4, 3e4), Vec3(0.8, 0.9, -0.3)}) {
    const Mat3 s = axes * stretch.asDiagonal() * axes.transpose();

    const Polar polar = compute_polar(turn * s);

    CHECK(polar.trace == Approx(stretch.sum()));
    CHECK((polar.rotation - turn).norm() < 1e-10);
  }
}

TEST_CASE("the rotation is proper, and S is symmetric, of any matrix") {
  for (int seed = 0; seed < 200; ++seed) {
    const Mat3 f = scatter_matrix(seed);

    const Polar polar = compute_polar(f);

    check_rotation(polar.rotation, 1e-10);
    const Mat3 s = polar.rotation.transpose() * f;
    CHECK((s - s.transpose()).norm() < 1e-10);
    CHECK(s.trace() == Approx(polar.trace));
  }
}

TEST_CASE("the rotation is the slope of the trace") {
  for (int seed = 0; seed < 20; ++seed) {
    const Mat3 f = Mat3::Identity() + 0.5 * scatter_matrix(seed);
    const Mat3 along = scatter_matrix(seed + 100);
    constexpr double kShift = 1e-6;
    const double above = compute_polar(f + kShift * along).trace;
    const double below = compute_polar(f - kShift * along).trace;

    CHECK((above - below) / (2.0 * kShift) ==
          Approx(compute_polar(f).rotation.cwiseProduct(along).sum()).epsilon(1e-6));
  }
}

TEST_CASE("flat, drawn to a line, to a point, and mirrored there is a rotation too") {
  for (const Vec3& stretch : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, -1),
                              Vec3(-1, -1, -1), Vec3(1e-200, 0, 0), Vec3(2, 1e-9, -1e-9)}) {
    check_rotation(compute_polar(stretch.asDiagonal()).rotation, 1e-9);
  }
}
