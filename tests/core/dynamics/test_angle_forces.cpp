// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>

#include "palpate/sim/dynamics/forces.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

Vec3Array angle_forces(const Angles& angles, const Vec3Array& x) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_angle_forces(angles, x, f);
  return f;
}

Vec3Array eq10_forces(const Angles& angles, const Vec3Array& x) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_eq10_forces(angles, x, f);
  return f;
}

/// Only corner 0 has a constant.
Angles one_corner(const Vec3Array& rest, double bend_stiffness, double stretch_coupling) {
  Angles angles = scenes::make_angles({{0, 1, 2}}, rest, 0.0, 0.0);
  angles.bend_stiffness[0] = {bend_stiffness, 0.0, 0.0};
  angles.stretch_coupling[0] = {stretch_coupling, 0.0, 0.0};
  return angles;
}

}  // namespace

TEST_CASE("a right angle with 1 m arms that opens to 120 degrees is pulled shut by K/2 sin") {
  // at corner 0, q = cos 120° - cos 90° = -1/2; |grad cos| = sin 120° / 1 m on either arm's end
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double sine = std::sqrt(3.0) / 2.0;
  const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {-0.5, sine, 0}};

  const auto f = angle_forces(one_corner(rest, 2.0, 0.0), x);

  CHECK(f[1].x() == Approx(0.0).epsilon(1e-12));
  CHECK(f[1].y() == Approx(2.0 * 0.5 * sine));  // towards the other arm
  CHECK(scenes::sum(f).norm() < 1e-15);
}

TEST_CASE("stretch-bend at a right angle pulls across its arms by K S / r") {
  // arms 1.1 m and 1 m, so S = 0.1 m, q = 0: only the part K S grad cos is left
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3Array x = {{0, 0, 0}, {1.1, 0, 0}, {0, 1, 0}};

  const auto f = angle_forces(one_corner(rest, 0.0, 3.0), x);

  CHECK(f[1].y() == Approx(-3.0 * 0.1 / 1.1));
  CHECK(f[2].x() == Approx(-3.0 * 0.1 / 1.0));
  CHECK(f[1].x() == Approx(0.0).epsilon(1e-12));
  CHECK(scenes::sum(f).norm() < 1e-15);
}

TEST_CASE("Eq 10 pushes the arms' ends apart along the opposite edge and spares the corner") {
  // corner closed from 90 to 60 degrees: q = 1/2, opposite edge 1 m along (1/2, -sqrt(3)/2)
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double sine = std::sqrt(3.0) / 2.0;
  const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {0.5, sine, 0}};

  const auto f = eq10_forces(one_corner(rest, 4.0, 0.0), x);

  CHECK(f[0] == Vec3::Zero());
  CHECK(f[1].x() == Approx(4.0 * 0.5 * 0.5));
  CHECK(f[1].y() == Approx(-4.0 * 0.5 * sine));
  CHECK((f[1] + f[2]).norm() == 0.0);
}

TEST_CASE("in an equilateral triangle Eq 10 equals the angle law to first order for 1.5 K / l") {
  const double l = 0.01, bend = 3e-5;
  const Vec3Array rest = {{0, 0, 0}, {l, 0, 0}, {0.5 * l, 0.5 * std::sqrt(3.0) * l, 0}};
  Angles law = scenes::make_angles({{0, 1, 2}}, rest, 0.0, 0.0);
  law.bend_stiffness[0] = {bend, bend, bend};
  Angles eq10 = law;
  eq10.bend_stiffness[0].fill(1.5 * bend / l);
  const Vec3Array offset = scenes::scatter_vectors(3, 1.0, 3);

  const auto difference_at = [&](double size) {
    Vec3Array x = rest;
    for (int i = 0; i < 3; ++i) x[i] += size * l * offset[i];
    const auto f = angle_forces(law, x);
    return scenes::max_difference(f, eq10_forces(eq10, x)) / scenes::max_norm(f);
  };

  CHECK(difference_at(1e-2) < 2e-1);
  CHECK(difference_at(1e-4) < 2e-3);  // shrinks with the strain
  CHECK(difference_at(1e-6) < 2e-5);
}

TEST_CASE("round a closed loop Eq 10 does work and the gradient of Eq 9 does none") {
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0.3, 1.1, 0}};
  const Angles angles = one_corner(rest, 1.0, 0.0);
  using Law = std::function<Vec3Array(const Vec3Array&)>;
  const auto work_round_loop = [&](const Law& forces) {
    const int count = 4000;
    const double amplitude = 0.2;
    const auto place = [&](double t) {
      Vec3Array x = rest;
      x[1].x() += amplitude * (std::cos(t) - 1.0);
      x[2].y() += amplitude * std::sin(t);
      return x;
    };
    double work = 0.0;
    for (int s = 0; s < count; ++s) {
      const double t = 2.0 * std::numbers::pi * s / count, dt = 2.0 * std::numbers::pi / count;
      const Vec3Array from = place(t), to = place(t + dt), f = forces(place(t + 0.5 * dt));
      for (int i = 0; i < 3; ++i) work += f[i].dot(to[i] - from[i]);
    }
    return work;
  };

  const double eq10 = work_round_loop([&](const Vec3Array& x) { return eq10_forces(angles, x); });
  const double law = work_round_loop([&](const Vec3Array& x) { return angle_forces(angles, x); });

  CHECK(std::abs(eq10) == Approx(0.0119).epsilon(0.01));
  CHECK(std::abs(law) < 1e-15);
}

TEST_CASE("angle and Eq 10 forces sum to zero, exert no torque and turn with the body") {
  const Mat3 turn = Eigen::AngleAxisd(1.234, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Vec3Array rest = scenes::scatter_vectors(3, 0.02, seed);
    const Vec3Array x = scenes::scatter_vectors(3, 0.02, seed + 1000);
    const Angles angles = scenes::make_angles({{0, 1, 2}}, rest, 1e-3, 0.05);
    Vec3Array turned;
    for (const Vec3& each : x) turned.push_back(turn * each + Vec3(0.3, -0.1, 0.2));
    for (const auto forces : {angle_forces, eq10_forces}) {
      const auto f = forces(angles, x), f_turned = forces(angles, turned);

      const double size = scenes::max_norm(f);
      CHECK(scenes::sum(f).norm() <= 1e-15 * size);
      CHECK(scenes::compute_torque(x, f).norm() <= 1e-15 * size);
      for (int i = 0; i < 3; ++i) CHECK((f_turned[i] - turn * f[i]).norm() < 1e-11 * size);
    }
  }
}
