// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/model/refusal.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/definiteness.h"
#include "palpate/sim/model/membrane.h"
#include "scenes/scenes.h"

using namespace palpate;
using doctest::Approx;

namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;

const double kRoot3 = std::numbers::sqrt3;
const SurfaceMesh kSheet = scenes::make_sheet(6, 5, 0.1);

Material make_wall(double poisson_ratio = 0.45) {
  return {.young_modulus = 2e5, .poisson_ratio = poisson_ratio, .wall_thickness = 1e-3};
}

SurfaceMesh make_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

SurfaceMesh make_equilateral(double length) {
  return make_triangle(Vec3::Zero(), {length, 0.0, 0.0}, {0.5 * length, 0.5 * kRoot3 * length, 0});
}

/// The constant-strain triangle under plane stress as textbooks have it: h A Bᵀ C B with strains
/// (xx, yy, 2 xy) in an orthonormal frame of the triangle's plane, turned into space.
Mat9 compute_finite_element(const SurfaceMesh& mesh, const Material& material) {
  const Vec3 one = mesh.vertices[1] - mesh.vertices[0], two = mesh.vertices[2] - mesh.vertices[0];
  const Vec3 normal = one.cross(two).normalized();
  const Vec3 ex = one.normalized(), ey = normal.cross(ex);
  Eigen::Matrix2d sides;
  sides << one.dot(ex), two.dot(ex), one.dot(ey), two.dot(ey);
  const Eigen::Matrix2d inverse = sides.inverse();
  Eigen::Matrix<double, 3, 9> b = Eigen::Matrix<double, 3, 9>::Zero();
  for (int corner = 0; corner < 3; ++corner) {
    const Eigen::RowVector2d slope = corner == 0
                                         ? Eigen::RowVector2d(-inverse.row(0) - inverse.row(1))
                                         : Eigen::RowVector2d(inverse.row(corner - 1));
    b.block<1, 3>(0, 3 * corner) = slope[0] * ex.transpose();
    b.block<1, 3>(1, 3 * corner) = slope[1] * ey.transpose();
    b.block<1, 3>(2, 3 * corner) = slope[1] * ex.transpose() + slope[0] * ey.transpose();
  }
  const double e = material.young_modulus, nu = material.poisson_ratio;
  Mat3 c;
  c << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
  c *= e / (1.0 - nu * nu);
  return *material.wall_thickness * 0.5 * sides.determinant() * b.transpose() * c * b;
}

/// The 9x9 stiffness of a model of one triangle.
Mat9 compute_tangent(const TissueModel& model) {
  return Eigen::MatrixXd(compute_stiffness(model, model.rest_position, Projection::none));
}

double compute_smallest_degrees(const SurfaceMesh& mesh) {
  return compute_smallest_angle(mesh) * 180.0 / std::numbers::pi;
}

/// A triangle anywhere in space, every third of them a needle or nearly flat.
SurfaceMesh make_random_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0), exponent(-4.0, 0.0);
  std::array<Vec3, 3> x;
  for (Vec3& p : x) p = 0.01 * Vec3(unit(random), unit(random), unit(random));
  const double near = std::pow(10.0, exponent(random));
  const double share = 0.5 + 0.5 * unit(random);
  switch (random() % 6) {
    case 0:
      x[2] = x[1] + near * (x[2] - x[1]);
      break;
    case 1:
      x[2] = x[0] + share * (x[1] - x[0]) + near * (x[2] - x[0]);
      break;
    default:
      break;
  }
  return make_triangle(x[0], x[1], x[2]);
}

SurfaceOptions make_bare() {
  SurfaceOptions options;
  options.home_stiffness = 0.0;
  return options;
}

}  // namespace

TEST_CASE("the tangent of an exact membrane at rest is the finite element of plane stress") {
  // rounding grows with the element's condition, which goes with the square of 1 / angle
  constexpr double kGoodAngle = 0.5, kError = 1e-9;
  std::mt19937 random(1);
  int built = 0, needles = 0, with_negative_bond = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const SurfaceMesh mesh = make_random_triangle(random);
    const double angle = compute_smallest_degrees(mesh);
    if (angle < kSmallestAngle) continue;
    const double nu = std::array{0.0, 0.3, 0.45, 0.5}[trial % 4];
    CAPTURE(trial);
    CAPTURE(nu);
    CAPTURE(angle);

    const TissueModel model =
        build_membrane_molecular(mesh, make_wall(nu), 0.0, AngleLaw::gradient, make_bare());

    const Mat9 expected = compute_finite_element(mesh, make_wall(nu));
    const double allowed =
        angle >= kGoodAngle ? kError : kError * std::pow(kGoodAngle / angle, 2.0);
    CHECK((compute_tangent(model) - expected).norm() <= allowed * expected.norm());
    ++built;
    needles += angle < 1.0;
    const auto& share = model.angles.bond_share[0];
    with_negative_bond += *std::min_element(share.begin(), share.end()) < 0.0;
  }
  CHECK(built > 5000);
  CHECK(needles > 500);
  CHECK(with_negative_bond > built / 4);
}

TEST_CASE("any bend stiffness gives the same tangent at rest") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const SurfaceMesh mesh = make_random_triangle(random);
    if (compute_smallest_degrees(mesh) < 5.0) continue;
    const Material wall = make_wall();
    const double bend = 0.1 * wall.young_modulus * *wall.wall_thickness * compute_area(mesh);

    const TissueModel model =
        build_membrane_molecular(mesh, wall, bend, AngleLaw::gradient, make_bare());

    CHECK(model.angles.bend_stiffness[0][1] == bend);
    const Mat9 expected = compute_finite_element(mesh, wall);
    CHECK((compute_tangent(model) - expected).norm() <= 1e-9 * expected.norm());
  }
}

TEST_CASE("a triangle with an angle below 0.05 degrees is refused by name") {
  SurfaceMesh mesh = kSheet;
  mesh.vertices.push_back({0.2, 0.0, 0.0});
  mesh.vertices.push_back({0.3, 0.0, 0.0});
  mesh.vertices.push_back({0.25, 3e-5, 0.0});
  const int n = static_cast<int>(mesh.vertices.size());
  mesh.triangles.push_back({n - 3, n - 2, n - 1});
  const std::string number = std::to_string(mesh.triangles.size() - 1);

  for (const std::string& refusal :
       {find_refusal([&] { build_membrane_molecular(mesh, make_wall()); }),
        find_refusal([&] { build_membrane_springs(mesh, make_wall()); }), find_refusal([&] {
          compare_with_membrane(build_mass_spring(mesh, make_wall(), 50.0), make_wall());
        })}) {
    CAPTURE(refusal);
    CHECK(refusal.find("mesh: triangle " + number) == 0);
    CHECK(refusal.find("a smallest angle of 0.0343775 degrees") != std::string::npos);
    CHECK(refusal.find("expected at least 0.05 degrees") != std::string::npos);
  }
}

TEST_CASE("a membrane without a wall thickness is refused") {
  const SurfaceMesh solid = scenes::make_ellipsoid({0.05, 0.035, 0.03}, 1);
  const std::string expected =
      "material: wall_thickness: got none, expected the thickness of the wall [m]";

  CHECK(find_refusal([&] { build_membrane_molecular(solid, {}); }) == expected);
  CHECK(find_refusal([&] { build_membrane_springs(solid, {}); }) == expected);
  CHECK(find_refusal([&] { compare_with_membrane(build_mass_spring(solid, {}, 50.0), {}); }) ==
        expected);
}

TEST_CASE("in an equilateral triangle Van Gelder, Lloyd at nu = 1/3 and the exact membrane agree") {
  const SurfaceMesh mesh = make_equilateral(0.01);
  const Material wall = make_wall(1.0 / 3.0);
  const double share = 0.25 * kRoot3 * 2e5 * 1e-3;

  for (const SpringRule rule : {SpringRule::van_gelder, SpringRule::lloyd}) {
    const TissueModel springs = build_membrane_springs(mesh, wall, rule);
    for (const double k : springs.springs.stiffness) CHECK(k == Approx(share));
    CHECK(compare_with_membrane(springs, wall).error < 1e-12);
  }
  const TissueModel molecular = build_membrane_molecular(mesh, wall);
  for (int c = 0; c < 3; ++c) {
    CHECK(molecular.angles.bond_share[0][c] == Approx(share));
    CHECK(std::abs(molecular.angles.stretch_coupling[0][c]) < 1e-12);
  }
}

TEST_CASE("springs keep nu = 1/3 in an equilateral lattice whatever the material's is") {
  const SurfaceMesh mesh = make_equilateral(0.01);
  for (const double nu : {0.0, 0.45}) {
    const MembraneFit fit =
        compare_with_membrane(build_membrane_springs(mesh, make_wall(nu)), make_wall(nu));

    CHECK(fit.poisson_ratio == Approx(1.0 / 3.0));
    CHECK(fit.young_modulus == Approx(2e5));
    // area: 3/4 E h against E h/2/(1 - nu); shear: 3/8 E h against E h/2/(1 + nu)
    const double area = 1.5 * (1.0 - nu), shear = 0.75 * (1.0 + nu);
    CHECK(fit.least == Approx(std::min(area, shear)));
    CHECK(fit.most == Approx(std::max(area, shear)));
  }
}

TEST_CASE("no springs come nearer to the element's stiffness than Lloyd's") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> factor(0.8, 1.25);
  for (int trial = 0; trial < 200; ++trial) {
    const SurfaceMesh mesh = make_random_triangle(random);
    if (compute_smallest_degrees(mesh) < 5.0) continue;
    const Mat9 element = compute_finite_element(mesh, make_wall());
    const auto distance = [&](const TissueModel& model) {
      return (compute_tangent(model) - element).norm();
    };
    TissueModel model = build_membrane_springs(mesh, make_wall(), SpringRule::lloyd, make_bare());
    const double least = distance(model);

    CHECK(least <= (1.0 + 1e-12) * distance(build_membrane_springs(
                                       mesh, make_wall(), SpringRule::van_gelder, make_bare())));
    for (double& k : model.springs.stiffness) k *= factor(random);
    CHECK(least <= (1.0 + 1e-12) * distance(model));
  }
}

TEST_CASE("what is painted stiffer has a larger Young's modulus there, still exactly") {
  SurfaceOptions options = make_bare();
  options.stiffness_scale.assign(kSheet.vertices.size(), 1.0);
  options.stiffness_scale[7] = 4.0;

  const TissueModel model =
      build_membrane_molecular(kSheet, make_wall(), 0.0, AngleLaw::gradient, options);

  CHECK(compare_with_membrane(model, make_wall(), options.stiffness_scale).error < 1e-10);
  const MembraneFit against_unpainted = compare_with_membrane(model, make_wall());
  CHECK(against_unpainted.least == Approx(1.0));
  CHECK(against_unpainted.most == Approx(2.0));
}

TEST_CASE("bonds of an exact membrane are damped although some are negative") {
  SurfaceMesh mesh = kSheet;
  for (Vec3& x : mesh.vertices) x.x() *= 3.0;
  const TissueModel model = build_membrane_molecular(mesh, make_wall(0.5));

  CHECK(*std::min_element(model.bonds.stiffness.begin(), model.bonds.stiffness.end()) < 0.0);
  for (const double c : model.bonds.damping) CHECK(c > 0.0);
}

TEST_CASE("Eq 10 is exactly the membrane in equilateral triangles, whatever nu is") {
  for (const double nu : {0.0, 0.3, 0.45, 0.5}) {
    const SurfaceMesh mesh = make_equilateral(0.01);
    const TissueModel model =
        build_membrane_molecular(mesh, make_wall(nu), 0.0, AngleLaw::eq10, make_bare());

    const Mat9 expected = compute_finite_element(mesh, make_wall(nu));
    CHECK((compute_tangent(model) - expected).norm() <= 1e-9 * expected.norm());
    // s = 1.5 K10 / (l k') = (1 - 3 nu)/(1 + nu)
    const double s = (1.0 - 3.0 * nu) / (1.0 + nu);
    const double share = 2e5 * 1e-3 * (3.0 + s) / (4.0 * kRoot3 * (1.0 + s));
    CHECK(model.angles.bend_stiffness[0][0] == Approx(s * 0.01 * share / 1.5).epsilon(1e-9));
  }
}

TEST_CASE("Eq 10 holds every triangle that has a membrane at all, and says how badly") {
  std::mt19937 random(4);
  double worst = 0.0;
  int built = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const SurfaceMesh mesh = make_random_triangle(random);
    if (compute_smallest_degrees(mesh) < 0.5) continue;
    const Material wall = make_wall(std::array{0.0, 0.3, 0.45, 0.5}[trial % 4]);
    REQUIRE_NOTHROW(build_membrane_molecular(mesh, wall, 0.0, AngleLaw::eq10));
    const Angles exact = build_membrane_molecular(mesh, wall).angles;
    worst = std::max(worst, compute_eq10_residuals(exact).front());
    ++built;
  }
  CHECK(built > 2000);
  CHECK(worst > 0.1);
  CHECK(worst < 1.0);
}

TEST_CASE("elsewhere Eq 10 is as near as it can be, and says how far off") {
  const SurfaceMesh mesh = make_triangle(Vec3::Zero(), {0.01, 0, 0}, {0.004, 0.008, 0});
  const Angles angles = build_membrane_molecular(mesh, make_wall()).angles;
  const Angles converted = convert_to_eq10(angles);
  const double residual = compute_eq10_residuals(angles).front();
  const Mat3 wanted = compute_rest_stiffness(angles, 0);

  CHECK(residual > 0.01);
  CHECK(residual < 1.0);
  for (int c = 0; c < 3; ++c) {
    for (const double factor : {0.99, 1.01}) {
      Angles other = converted;
      other.bend_stiffness[0][c] *= factor;
      const Mat3 slopes = compute_rest_slopes(other, 0, AngleLaw::eq10);
      CHECK((slopes - wanted).norm() > residual * wanted.norm());
    }
  }
}

TEST_CASE("angles of an equilateral triangle convert to K10 = 1.5 K_theta / l without loss") {
  Angles angles = build_membrane_molecular(make_equilateral(0.01), make_wall()).angles;
  angles.bend_stiffness[0] = {2e-4, 2e-4, 2e-4};
  angles.stretch_coupling[0] = {0.0, 0.0, 0.0};
  angles.bond_share[0] = {50.0, 50.0, 50.0};

  const Angles converted = convert_to_eq10(angles);

  CHECK(compute_eq10_residuals(angles).front() < 1e-12);
  for (int c = 0; c < 3; ++c) {
    CHECK(converted.bend_stiffness[0][c] == Approx(1.5 * 2e-4 / 0.01));
    CHECK(converted.bond_share[0][c] == Approx(50.0));
  }
}

TEST_CASE("a bend stiffness that a law cannot take is refused") {
  CHECK(find_refusal([] {
          build_membrane_molecular(kSheet, make_wall(), 1e-4, AngleLaw::eq10);
        }).find("membrane: bend_stiffness: got 0.0001 J, expected 0 under AngleLaw::eq10") == 0);
  CHECK(find_refusal([] {
          build_membrane_molecular(kSheet, make_wall(), -1e-4);
        }).find("membrane: bend_stiffness: got -0.0001 J") == 0);
}
