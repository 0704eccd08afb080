// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/build_surface.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

constexpr double kRadius = 0.03, kPressure = 50.0;  // [m], [Pa]: a strain of 1e-3
constexpr int k642 = 3;                             // subdivisions

Material make_wall(double poisson_ratio) {
  return {.young_modulus = 2e5, .poisson_ratio = poisson_ratio, .wall_thickness = 1e-3};
}

SurfaceMesh make_sphere(int subdivisions) {
  return scenes::make_ellipsoid({kRadius, kRadius, kRadius}, subdivisions);
}

SurfaceOptions make_bare() {
  SurfaceOptions options;
  options.home_stiffness = 0.0;
  return options;
}

/// [m] p R² (1 - nu)/(2 E h): how far the wall of a thin sphere moves out.
double compute_exact_growth(const Material& wall) {
  return kPressure * kRadius * kRadius * (1.0 - wall.poisson_ratio) /
         (2.0 * wall.young_modulus * *wall.wall_thickness);
}

/// [m] how far the vertices move out under the pressure, to first order, on average.
double compute_growth(const TissueModel& model) {
  const Vec3Array& x = model.rest_position;
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_pressure_forces(model.triangles, kPressure, x, f);
  const Eigen::Map<const Eigen::VectorXd> push(f.front().data(), 3 * f.size());

  Eigen::SparseMatrix<double> k = compute_stiffness(model, x, Projection::none);
  // a hair of stiffness holds the sphere in its place, where no force moves it
  Eigen::SparseMatrix<double> hair(k.rows(), k.cols());
  hair.setIdentity();
  k += 1e-7 * k.diagonal().mean() * hair;
  const Eigen::VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(k).solve(push);
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += u.segment<3>(3 * i).dot(x[i].normalized());
  return sum / static_cast<double>(x.size());
}

}  // namespace

TEST_CASE(
    "a sphere of exact membrane grows under pressure as theory says, to 1 % at 642 vertices") {
  for (const double nu : {0.0, 0.3, 0.45, 0.5}) {
    const Material wall = make_wall(nu);
    const auto compute_error = [&](int subdivisions) {
      const TissueModel model = build_membrane_molecular(make_sphere(subdivisions), wall, 0.0,
                                                         AngleLaw::gradient, make_bare());
      return std::abs(compute_growth(model) / compute_exact_growth(wall) - 1.0);
    };
    CAPTURE(nu);
    CHECK(compute_error(k642) < 0.01);
    CHECK(compute_error(k642) < 0.5 * compute_error(k642 - 1));
  }
}

TEST_CASE("so does a sphere of prisms, whose wall bends as well") {
  for (const double nu : {0.0, 0.3, 0.45}) {
    const Material wall = make_wall(nu);
    const auto compute_error = [&](int subdivisions) {
      const TissueModel model = build_shell(make_sphere(subdivisions), wall, make_bare());
      return std::abs(compute_growth(model) / compute_exact_growth(wall) - 1.0);
    };
    CAPTURE(nu);
    CHECK(compute_error(k642) < 0.01);
    CHECK(compute_error(k642) < 0.5 * compute_error(k642 - 1));
  }
}

TEST_CASE("so does a sphere of springs, as a wall of nu = 1/3") {
  const Material wall = make_wall(1.0 / 3.0);
  for (const SpringRule rule : {SpringRule::van_gelder, SpringRule::lloyd}) {
    const TissueModel model = build_membrane_springs(make_sphere(k642), wall, rule, make_bare());
    CHECK(std::abs(compute_growth(model) / compute_exact_growth(wall) - 1.0) < 0.01);
  }
}

TEST_CASE("springs cannot be a wall of nu = 0.45: Van Gelder's sphere grows a fifth too far") {
  const Material wall = make_wall(0.45);
  const TissueModel model =
      build_membrane_springs(make_sphere(k642), wall, SpringRule::van_gelder, make_bare());

  // (1 - 1/3) / (1 - 0.45)
  CHECK(compute_growth(model) / compute_exact_growth(wall) == doctest::Approx(1.21).epsilon(0.02));
}

TEST_CASE("an exact membrane with negative bonds comes to rest within its stable step") {
  SurfaceOptions options;
  options.pressure = kPressure;
  options.drag = 100.0;
  SurfaceMesh mesh = scenes::make_sheet(8, 12, 0.05);
  for (Vec3& x : mesh.vertices) x.x() *= 3.0;
  const TissueModel model =
      build_membrane_molecular(mesh, make_wall(0.5), 0.0, AngleLaw::gradient, options);
  REQUIRE(std::ranges::min(model.bonds.stiffness) < 0.0);

  const double dt = stable_step(model);
  REQUIRE(dt > 1e-5);
  State state(model);
  Load load(0);
  for (; state.time < 1.0;) step(model, load, dt, state);

  double fastest = 0.0;
  for (const Vec3& v : state.velocity) fastest = std::max(fastest, v.norm());
  CHECK(fastest < 1e-5);
  CHECK((state.position[0] - model.rest_position[0]).norm() < 1e-3);
}
