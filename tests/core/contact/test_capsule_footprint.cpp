// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/tree/soups.h"
#include "palpate/sim/contact/private/capsule_slices.h"
#include "palpate/sim/contact/private/footprint.h"
#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/packed/simd_targets.h"
#include "skip.h"

using namespace palpate;

namespace {

constexpr double kModulus = 6270.0;  ///< [Pa]
constexpr double kRadius = 0.002;    ///< [m]

NearPressure make_law() { return {kModulus, kRadius, 3e7}; }

/// [N] Of a plane of right triangles whose legs are `edge` [m], turned by an angle.
Vec3 press_plane(double edge, const Vec3& from, const Vec3& to, double* stiffness = nullptr) {
  const int n = static_cast<int>(std::ceil(0.06 / edge));
  const Eigen::AngleAxisd turn(0.4, Vec3::UnitZ());
  const auto corner = [&](int i, int j) -> Vec3 {
    return turn * Vec3((i - 0.43 * n) * edge, (j - 0.57 * n) * edge, 0.0);
  };
  Vec3 force = Vec3::Zero();
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    Footprint part;
    if (!integrate_capsule_footprint(make_law(), from, to, a, b, c, part)) return;
    force += part.force;
    if (stiffness) *stiffness += part.stiffness;
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      add(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
      add(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
  return force;
}

}  // namespace

TEST_CASE("the footprint of a capsule of no length is that of a ball") {
  Dice dice(91);
  int touched = 0;
  for (int k = 0; k < 400; ++k) {
    const Vec3 p = dice.vector(0.001), a = dice.vector(0.004), b = dice.vector(0.004),
               c = dice.vector(0.004);
    Footprint ball, capsule;
    const bool found = integrate_footprint(make_law(), p, a, b, c, ball);
    if (!found || ball.normal_force < 0.02 * ball.whole_force) continue;
    REQUIRE(integrate_capsule_footprint(make_law(), p, p, a, b, c, capsule));
    ++touched;
    // both are sums over few points, of a part of the circle, and a slice knows no corner of it
    // where an edge leaves the circle
    CHECK((capsule.force - ball.force).norm() < 0.03 * ball.whole_force);
    CHECK(capsule.whole_force == doctest::Approx(ball.whole_force).epsilon(0.01));
    CHECK((capsule.weights - ball.weights).norm() < 0.1);
    CHECK(capsule.depth == doctest::Approx(ball.depth).epsilon(1e-9));
    CHECK(capsule.spread == 0.0);
  }
  CHECK(touched > 50);
}

TEST_CASE("on a rigid plane a capsule's footprint is the same whatever its triangles") {
  for (const double tilt : {0.0, 0.1, 0.6, 1.5}) {
    const Vec3 axis(0.010 * std::cos(tilt), 0.0, 0.010 * std::sin(tilt));
    for (const double depth : {0.1, 0.4, 0.8}) {
      CAPTURE(tilt);
      CAPTURE(depth);
      const Vec3 from(0.0003, -0.0002, kRadius * (1.0 - depth));
      const Vec3 whole = press_plane(0.05, from, from + axis);
      for (const double edge : {0.001, 0.0025, 0.007}) {
        CAPTURE(edge);
        const Vec3 parts = press_plane(edge, from, from + axis);
        CHECK((parts - whole).norm() < 0.02 * whole.norm());
      }
    }
  }
}

TEST_CASE("the stiffness of a capsule's footprint is the slope of its force") {
  const Vec3 axis(0.009, 0.002, 0.001), from(0.0003, -0.0002, 0.6 * kRadius);
  const Vec3 step = 1e-7 * Vec3::UnitZ();
  double stiffness = 0.0;
  press_plane(0.004, from, from + axis, &stiffness);
  const double deeper = press_plane(0.004, from - step, from + axis - step).z();
  const double higher = press_plane(0.004, from + step, from + axis + step).z();
  CHECK(stiffness == doctest::Approx((deeper - higher) / 2e-7).epsilon(0.03));
}

/// A long capsule's middle: with o = d - y²/2R the pressures E*/pi sqrt(o/R) sum to E* d/sqrt(2) a
/// length.
TEST_CASE("a capsule that is pressed a little is pressed evenly along: E* d / sqrt(2)") {
  constexpr double kDepth = 2e-5;
  const Vec3 from(-0.02, 0.0, kRadius - kDepth), to(0.02, 0.0, kRadius - kDepth);
  Footprint part;
  REQUIRE(integrate_capsule_footprint(make_law(), from, to, {0.0, -0.01, 0.0}, {0.004, -0.01, 0.0},
                                      {0.004, 0.01, 0.0}, part));
  Footprint other;
  REQUIRE(integrate_capsule_footprint(make_law(), from, to, {0.0, -0.01, 0.0}, {0.004, 0.01, 0.0},
                                      {0.0, 0.01, 0.0}, other));
  const double a_length = (part.normal_force + other.normal_force) / 0.004;
  CHECK(a_length == doctest::Approx(kModulus * kDepth / std::numbers::sqrt2).epsilon(0.02));
  CHECK(part.axis.x() + other.axis.x() == doctest::Approx(0.004).epsilon(1e-3));
}

TEST_CASE("vector code sums the slices of a capsule's footprint as the plain code does") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const std::string& target : simd_targets()) {
    CAPTURE(target);
    const SumSlices sum = find_slice_sums(ContactLanes(8, target, 1));
    REQUIRE((sum != nullptr));
    Dice dice(97);
    int touched = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vec3 from = dice.vector(0.002), to = k % 9 == 0 ? from : Vec3(dice.vector(0.008));
      const Vec3 a = dice.vector(0.004), b = dice.vector(0.004), c = dice.vector(0.004);
      Footprint plain, vector;
      const bool found = integrate_capsule_footprint(make_law(), from, to, a, b, c, plain);
      if (plain.normal_force < 1e-9) continue;
      REQUIRE(found ==
              integrate_capsule_footprint(make_law(), from, to, a, b, c, vector, true, sum));
      ++touched;
      const double scale = plain.normal_force;
      CHECK((vector.force - plain.force).norm() < 1e-9 * scale);
      CHECK(vector.normal_force == doctest::Approx(scale).epsilon(1e-9));
      CHECK(vector.whole_force == doctest::Approx(plain.whole_force).epsilon(1e-9));
      CHECK(vector.stiffness == doctest::Approx(plain.stiffness).epsilon(1e-9));
      CHECK(vector.area == doctest::Approx(plain.area).epsilon(1e-9));
      CHECK((vector.weights - plain.weights).norm() < 1e-7);
      CHECK((vector.axis - plain.axis).norm() < 1e-9);
      CHECK(vector.spread == doctest::Approx(plain.spread).epsilon(1e-6));
    }
    CHECK(touched > 200);
  }
  CHECK((find_slice_sums(ContactLanes()) == nullptr));
}

/// F/(E* R²) of a rigid, frictionless capsule on a half space, by boundary elements: squares of
/// even pressure [Johnson85, 3.4] an 11th of the footprint's half width wide, and an active set for
/// which of them are pressed. L/R, s/R, force.
TEST_CASE("the half space's force on a capsule is that of boundary elements within 5 %") {
  constexpr std::array<std::array<double, 3>, 12> kForces = {{{1.0, 0.1, 0.0833},
                                                              {1.0, 0.25, 0.2721},
                                                              {2.0, 0.05, 0.0512},
                                                              {2.0, 0.25, 0.3653},
                                                              {5.0, 0.05, 0.0941},
                                                              {5.0, 0.1, 0.2089},
                                                              {5.0, 0.25, 0.6108},
                                                              {8.0, 0.1, 0.2907},
                                                              {8.0, 0.25, 0.8303},
                                                              {12.0, 0.05, 0.1810},
                                                              {12.0, 0.1, 0.3924},
                                                              {12.0, 0.25, 1.1034}}};
  for (const auto& [length, s, force] : kForces) {
    CAPTURE(length);
    CAPTURE(s);
    LocalPress press{kModulus, kRadius, 0.0, 0.0, length * kRadius};
    // the solution is linear: what deep presses of a neo-Hookean half space take off is put back
    const double linear = press.compute_force(s * kRadius) / (1.0 - 0.1327 * s - 0.0104 * s * s);
    CHECK(linear == doctest::Approx(force * kModulus * kRadius * kRadius).epsilon(0.05));
    const double h = 1e-4 * kRadius;
    const double slope =
        (press.compute_force(s * kRadius + h) - press.compute_force(s * kRadius - h)) / (2.0 * h);
    CHECK(press.compute_slope(s * kRadius) == doctest::Approx(slope).epsilon(1e-5));
  }
}
