// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

#include "core/model/refusal.h"
#include "palpate/sim/model/definiteness.h"

using namespace palpate;
using doctest::Approx;

namespace {

const double kRoot2 = std::numbers::sqrt2, kRoot3 = std::numbers::sqrt3;
constexpr std::array<double, 3> kOnes = {1.0, 1.0, 1.0};

std::array<double, 3> compute_cosines(const Vec3& l) {
  std::array<double, 3> cosine;
  for (int c = 0; c < 3; ++c) {
    const double a = l[c], b = l[(c + 1) % 3], d = l[(c + 2) % 3];
    cosine[c] = (b * b + d * d - a * a) / (2.0 * b * d);
  }
  return cosine;
}

/// One triangle with sides `length`, K_b shares and K_theta the same everywhere, no K_btheta.
Angles make_triangle(const Vec3& length, double share, double bend) {
  Angles angles;
  angles.corners = {{0, 1, 2}};
  angles.rest_length = {{length[0], length[1], length[2]}};
  angles.rest_cosine = {compute_cosines(length)};
  angles.bend_stiffness = {{bend, bend, bend}};
  angles.stretch_coupling = {{0.0, 0.0, 0.0}};
  angles.bond_share = {{share, share, share}};
  return angles;
}

Angles make_scattered_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Vec3 x[3];
  for (Vec3& p : x) p = Vec3(unit(random), unit(random), unit(random));
  Angles angles =
      make_triangle({(x[1] - x[2]).norm(), (x[2] - x[0]).norm(), (x[0] - x[1]).norm()}, 1.0, 0.0);
  for (int c = 0; c < 3; ++c) {
    angles.bond_share[0][c] = 1.0 + 0.5 * unit(random);
    angles.bend_stiffness[0][c] = 0.1 + 0.1 * unit(random);
    angles.stretch_coupling[0][c] = 0.1 * unit(random);
  }
  return angles;
}

/// [J] Eq 8, 9 and 11 of the triangle at side lengths `l`.
double compute_triangle_energy(const Angles& angles, const Vec3& l) {
  const std::array<double, 3> cosine = compute_cosines(l);
  double energy = 0.0;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const double bent = cosine[c] - angles.rest_cosine[0][c];
    const double arms = l[i] - angles.rest_length[0][i] + l[j] - angles.rest_length[0][j];
    const double stretch = l[c] - angles.rest_length[0][c];
    energy += 0.5 * angles.bond_share[0][c] * stretch * stretch +
              0.5 * angles.bend_stiffness[0][c] * bent * bent +
              angles.stretch_coupling[0][c] * bent * arms;
  }
  return energy;
}

/// Second central differences of the energy at rest.
Mat3 differentiate_energy_twice(const Angles& angles, double h) {
  const Vec3 rest(angles.rest_length[0].data());
  Mat3 second;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 di = h * Vec3::Unit(i), dj = h * Vec3::Unit(j);
      second(i, j) = (compute_triangle_energy(angles, rest + di + dj) -
                      compute_triangle_energy(angles, rest + di - dj) -
                      compute_triangle_energy(angles, rest - di + dj) +
                      compute_triangle_energy(angles, rest - di - dj)) /
                     (4.0 * h * h);
    }
  }
  return second;
}

Mat3 compute_stiffness_with(Angles angles, const std::array<double, 3>& coupling) {
  angles.stretch_coupling[0] = coupling;
  return compute_rest_stiffness(angles, 0);
}

}  // namespace

TEST_CASE("the stiffness at rest is the second derivative of the energy in the side lengths") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Angles angles = make_scattered_triangle(random);
    const double shortest =
        *std::min_element(angles.rest_length[0].begin(), angles.rest_length[0].end());
    // a needle would need smaller steps than its energy has digits for
    if (shortest < 0.2) continue;

    const Mat3 exact = compute_rest_stiffness(angles, 0);
    const double h = 1e-4 * shortest;
    CHECK((differentiate_energy_twice(angles, h) - exact).norm() < 1e-5 * exact.norm());
  }
}

TEST_CASE("an equilateral triangle has the eigenvalues k' and twice k' + 9 K/(4 l²) + 3 K_bt/l") {
  const double l = 0.009, share = 25.0, bend = 1e-4, coupling = -0.01;
  const Angles angles = make_triangle({l, l, l}, share, bend);

  const Mat3 stiffness = compute_stiffness_with(angles, {coupling, coupling, coupling});

  const Vec3 values = Eigen::SelfAdjointEigenSolver<Mat3>(stiffness).eigenvalues();
  const double shear = share + 9.0 * bend / (4.0 * l * l) + 3.0 * coupling / l;
  CHECK(values[0] == Approx(shear));
  CHECK(values[1] == Approx(shear));
  CHECK(values[2] == Approx(share));
}

TEST_CASE("angles and stretch-bend terms never resist a change of size") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    Angles angles = make_scattered_triangle(random);
    angles.bond_share[0] = {0.0, 0.0, 0.0};
    const Vec3 length(angles.rest_length[0].data());

    const Mat3 stiffness = compute_rest_stiffness(angles, 0);

    CHECK(std::abs(length.dot(stiffness * length)) < 1e-12 * stiffness.norm());
    CHECK_FALSE(is_positive_definite(stiffness));
  }
}

TEST_CASE(
    "five triangles have their known ranges of admissible K_btheta, with K_theta and without") {
  // shares of 1 N/m, shortest equal sides of 1 m, K_theta = 0 and 0.1 J [laws: definite]
  struct Shape {
    Vec3 length;
    double bend, low, high;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Shape> shapes = {
      {{1.0, 1.0, 1.0}, 0.0, -0.3333, infinity},   {{1.0, 1.0, 1.0}, 0.1, -0.4083, infinity},
      {{kRoot2, 1.0, 1.0}, 0.0, -0.2172, 53.6730}, {{kRoot2, 1.0, 1.0}, 0.1, -0.3251, 53.7810},
      {{1.0, 2.0, kRoot3}, 0.0, -0.2506, 33.7782}, {{1.0, 2.0, kRoot3}, 0.1, -0.3475, 33.8162},
      {{kRoot3, 1.0, 1.0}, 0.0, -0.1585, 23.5508}, {{kRoot3, 1.0, 1.0}, 0.1, -0.2954, 23.6877},
      {{0.2, 1.0, 1.0}, 0.0, -0.0505, 6.3659},     {{0.2, 1.0, 1.0}, 0.1, -0.5159, 6.3909},
  };

  for (const Shape& shape : shapes) {
    const auto range = find_coupling_range(make_triangle(shape.length, 1.0, shape.bend), 0, kOnes);

    REQUIRE(range.has_value());
    CHECK(range->low == Approx(shape.low).epsilon(1e-3));
    if (std::isinf(shape.high)) {
      CHECK(std::isinf(range->high));
    } else {
      CHECK(range->high == Approx(shape.high).epsilon(1e-3));
    }
  }
}

TEST_CASE("the admissible range is tight: definite just inside its ends, indefinite just outside") {
  std::mt19937 random(3);
  int finite_ends = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Angles angles = make_scattered_triangle(random);
    const std::array<double, 3> proportion = {1.0, trial % 2 ? 1.0 : -0.5, trial % 3 ? 1.0 : 0.2};
    const auto range = find_coupling_range(angles, 0, proportion);
    REQUIRE(range.has_value());
    for (const double end : {range->low, range->high}) {
      if (std::isinf(end)) continue;
      ++finite_ends;
      for (const double factor : {0.999, 1.001}) {
        const double k = end * factor;
        const Mat3 stiffness = compute_stiffness_with(
            angles, {k * proportion[0], k * proportion[1], k * proportion[2]});
        CHECK(is_positive_definite(stiffness) == (factor < 1.0));
      }
    }
  }
  CHECK(finite_ends > 400);
}

TEST_CASE("a triangle with a negative bond holds where its stretch-bend terms make up for it") {
  // the plane-stress element of this triangle with nu = 0.3 and E h = 1 N/m, told in constants of
  // the molecular model [laws: membrane]: definite as the element is, though a bond is negative
  const Vec3 length(1.0, 0.35, 1.25);
  const double lambda = 0.3 / (1.0 - 0.09), mu = 0.5 / 1.3;
  const std::array<double, 3> cosine = compute_cosines(length);
  const double area = 0.5 * length[0] * length[1] * std::sqrt(1.0 - cosine[2] * cosine[2]);
  Mat3 element;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto cotangent = [&](int c) {
        return cosine[c] / std::sqrt(1.0 - cosine[c] * cosine[c]);
      };
      element(i, j) = length[i] * length[j] / (4.0 * area) *
                      ((lambda + 2.0 * mu) * cotangent(i) * cotangent(j) + mu * (i == j ? 1 : -1));
    }
  }
  REQUIRE(is_positive_definite(element));

  // the three off-diagonal terms are linear in the three K_btheta, and the bonds take up the rest
  Angles angles = make_triangle(length, 0.0, 0.0);
  Mat3 system;
  for (int c = 0; c < 3; ++c) {
    std::array<double, 3> one = {0.0, 0.0, 0.0};
    one[c] = 1.0;
    const Mat3 part = compute_stiffness_with(angles, one);
    system.col(c) = Vec3(part(1, 2), part(2, 0), part(0, 1));
  }
  const Vec3 coupling =
      system.partialPivLu().solve(Vec3(element(1, 2), element(2, 0), element(0, 1)));
  const std::array<double, 3> couplings = {coupling[0], coupling[1], coupling[2]};
  const Vec3 share = (element - compute_stiffness_with(angles, couplings)).diagonal();
  angles.bond_share[0] = {share[0], share[1], share[2]};
  angles.stretch_coupling[0] = couplings;

  CHECK(share.minCoeff() < 0.0);
  CHECK((compute_rest_stiffness(angles, 0) - element).norm() < 1e-12 * element.norm());
  CHECK_NOTHROW(check_definiteness(angles, AngleLaw::gradient));

  angles.stretch_coupling[0] = {0.0, 0.0, 0.0};
  CHECK_THROWS_AS(check_definiteness(angles, AngleLaw::gradient), std::invalid_argument);
}

TEST_CASE("where only some K_btheta other than 0 makes a triangle definite, it is found") {
  // a bond of -0.05 N/m cannot hold without the coupling
  Angles angles = make_triangle({1.0, 0.35, 1.25}, 1.0, 0.0);
  bool found_one = false;
  for (int c = 0; c < 3; ++c) {
    angles.bond_share[0] = {1.0, 1.0, 1.0};
    angles.bond_share[0][c] = -0.05;
    REQUIRE_FALSE(is_positive_definite(compute_rest_stiffness(angles, 0)));

    const auto range = find_coupling_range(angles, 0, kOnes);

    if (!range) continue;
    found_one = true;
    CHECK(range->low * range->high > 0.0);
    const double middle = 0.5 * (range->low + range->high);
    CHECK(is_positive_definite(compute_stiffness_with(angles, {middle, middle, middle})));
  }
  CHECK(found_one);
}

TEST_CASE("bonds that push at every side are beyond help, and the refusal says so") {
  const Angles angles = make_triangle({1.0, 1.0, 1.0}, -1.0, 0.1);

  CHECK_FALSE(find_coupling_range(angles, 0, kOnes).has_value());
  const std::string refusal = find_refusal([&] { check_definiteness(angles, AngleLaw::gradient); });
  CHECK(refusal.find("model: angles: row 0 (particles 0, 1, 2): got ") == 0);
  CHECK(refusal.find("no K_btheta makes it positive definite") != std::string::npos);
}

TEST_CASE("a refusal tells the range for the largest coupling in its present proportion") {
  Angles angles = make_triangle({kRoot2, 1.0, 1.0}, 1.0, 0.0);
  angles.stretch_coupling[0] = {-0.5, -0.5, -0.5};
  CHECK(find_refusal([&] {
          check_definiteness(angles, AngleLaw::gradient);
        }).find("expected K_btheta -0.217181 to 53.6725 N") != std::string::npos);

  angles.stretch_coupling[0] = {0.0, -3.0, 0.0};
  const auto range = find_coupling_range(angles, 0, {0.0, 1.0, 0.0});
  REQUIRE(range.has_value());
  CHECK(find_refusal([&] {
          check_definiteness(angles, AngleLaw::gradient);
        }).find("expected K_btheta " + describe(*range)) != std::string::npos);
}

TEST_CASE("a range is told in numbers that are themselves admissible") {
  const double infinity = std::numeric_limits<double>::infinity();

  CHECK(describe({-1.0, 2.0}) == "-0.99999 to 1.99998 N");
  CHECK(describe({-1.0, infinity}) == "above -0.99999 N");
  CHECK(describe({-infinity, 2.0}) == "below 1.99998 N");
  CHECK(describe({-infinity, infinity}) == "any number");
}

TEST_CASE("under Eq 10 positive bonds and no negative K never give way, whatever the triangle") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  for (int trial = 0; trial < 500; ++trial) {
    Angles angles = make_scattered_triangle(random);
    angles.stretch_coupling[0] = {0.0, 0.0, 0.0};
    const auto& l = angles.rest_length[0];
    const auto& cosine = angles.rest_cosine[0];
    Mat3 stiffness = Mat3::Zero();
    for (int c = 0; c < 3; ++c) {
      const int i = (c + 1) % 3, j = (c + 2) % 3;
      const double bend = std::pow(10.0, exponent(random)), scale = l[c] / (l[i] * l[j]);
      angles.bond_share[0][c] = std::pow(10.0, exponent(random));
      angles.bend_stiffness[0][c] = bend;
      // the tension -K q_c of Eq 10 in the side opposite the corner, by its side lengths
      stiffness(c, c) = angles.bond_share[0][c] + bend * scale;
      stiffness(c, i) = -bend * scale * cosine[j];
      stiffness(c, j) = -bend * scale * cosine[i];
    }

    CHECK_NOTHROW(check_definiteness(angles, AngleLaw::eq10));
    CHECK(stiffness.determinant() > 0.0);
  }
}

TEST_CASE("under Eq 10 bonds and angles that give way are refused, and so are stretch-bend terms") {
  const auto find_eq10_refusal = [](auto damage) {
    Angles angles = make_triangle({1.0, 1.0, 1.0}, 1.0, 0.1);
    damage(angles);
    return find_refusal([&] { check_definiteness(angles, AngleLaw::eq10); });
  };

  CHECK(find_eq10_refusal([](Angles&) {}) == "");
  CHECK(find_eq10_refusal([](Angles& a) { a.bond_share[0][1] = -0.5; }) ==
        "model: angles.bond_share: row 0: got -0.5 N/m, expected a positive number");
  CHECK(find_eq10_refusal([](Angles& a) { a.bend_stiffness[0][1] = -3.0; }) ==
        "model: angles.bend_stiffness: row 0: got -3 N, expected 0 or a positive number, or "
        "larger bond shares beside it");
  CHECK(find_eq10_refusal([](Angles& a) { a.stretch_coupling[0][2] = 0.1; }) ==
        "model: angles.stretch_coupling: row 0: got 0.1 N, expected 0 under AngleLaw::eq10, "
        "which has no stretch-bend force");
}

TEST_CASE(
    "under Eq 10 a negative constant is taken where the rest of the triangle makes up for it") {
  Angles angles = make_triangle({1.0, 1.0, 1.0}, 1.0, 0.0);
  // eigenvalues k' and k' + 1.5 K10/l, so K10 may go down to -2/3 N
  for (const double bend : {-0.6, -0.7}) {
    angles.bend_stiffness[0] = {bend, bend, bend};
    const bool refused = !find_refusal([&] { check_definiteness(angles, AngleLaw::eq10); }).empty();
    CHECK(refused == (bend < -2.0 / 3.0));
  }
}
