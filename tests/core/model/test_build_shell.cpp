// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/model/refusal.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/membrane.h"
#include "scenes/scenes.h"

using namespace palpate;
using doctest::Approx;

namespace {

Material make_wall(double thickness = 2e-3, double poisson_ratio = 0.45) {
  return {.young_modulus = 1e5, .poisson_ratio = poisson_ratio, .wall_thickness = thickness};
}

/// A plate `side` [m] square whose border is clamped: held in both faces.
TissueModel make_clamped_plate(int cells, double side, const Material& wall) {
  const SurfaceMesh mesh = scenes::make_sheet(cells + 1, cells + 1, side);
  SurfaceOptions options;
  for (const auto& loop : find_border_loops(mesh.triangles)) {
    options.fixed.insert(options.fixed.end(), loop.begin(), loop.end());
  }
  return build_shell(mesh, wall, options);
}

/// [m] the farthest that any particle moves under `load` [N] per particle, to first order.
double compute_deflection(const TissueModel& model, const std::function<Vec3(int)>& load) {
  Eigen::SparseMatrix<double> k = compute_stiffness(model, model.rest_position, Projection::none);
  Eigen::VectorXd f = Eigen::VectorXd::Zero(k.rows());
  for (int i = 0; i < particle_count(model); ++i) f.segment<3>(3 * i) = load(i);
  for (const int i : model.fixed) {
    f.segment<3>(3 * i).setZero();
    for (int axis = 0; axis < 3; ++axis) k.coeffRef(3 * i + axis, 3 * i + axis) = 1.0;
  }
  const Eigen::VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(k).solve(f);
  double farthest = 0.0;
  for (int i = 0; i < particle_count(model); ++i) {
    farthest = std::max(farthest, u.segment<3>(3 * i).norm());
  }
  return farthest;
}

double compute_bending_stiffness(const Material& wall) {
  const double h = *wall.wall_thickness, nu = wall.poisson_ratio;
  return wall.young_modulus * h * h * h / (12.0 * (1.0 - nu * nu));
}

}  // namespace

TEST_CASE("particle i of a shell is vertex i, and particle n + i lies below it") {
  const SurfaceMesh mesh = scenes::make_sheet(6, 5, 0.1);
  SurfaceOptions options;
  options.fixed = {3, 1};
  const TissueModel model = build_shell(mesh, make_wall(), options);
  const auto n = static_cast<int>(mesh.vertices.size());

  REQUIRE(particle_count(model) == 2 * n);
  CHECK(model.triangles == mesh.triangles);
  CHECK(model.fixed == std::vector<int>{1, 3, n + 1, n + 3});
  CHECK(model.home.empty());
  CHECK(model.springs.ends.size() == mesh.vertices.size());
  CHECK(model.prisms.corners.size() == mesh.triangles.size());
  for (int i = 0; i < n; ++i) {
    CHECK(model.rest_position[i] == mesh.vertices[i]);
    const Vec3 down = model.rest_position[n + i] - model.rest_position[i];
    CHECK(down.norm() == Approx(2e-3 / std::sqrt(3.0)));
  }
  CHECK(compute_total_mass(model) == Approx(1060.0 * 2e-3 * compute_area(mesh)));
}

TEST_CASE("each face of a shell is an exact membrane of half the wall") {
  const SurfaceMesh mesh = scenes::make_sheet(6, 5, 0.1);
  const TissueModel model = build_shell(mesh, make_wall());

  CHECK(compare_with_membrane(model, make_wall(1e-3)).error < 1e-10);
}

TEST_CASE("a clamped square plate under its own load sinks as Kirchhoff says, thin or thick") {
  // 0.00126532 q a⁴/D in the middle [Timoshenko59]; what shear adds to the thicker one is real
  constexpr double kSide = 0.1, kLoad = 2.0;
  for (const double thickness : {0.5e-3, 1e-3, 2e-3}) {
    const Material wall = make_wall(thickness);
    const TissueModel model = make_clamped_plate(24, kSide, wall);
    const double area_load = kLoad / (1060.0 * thickness);
    const double sunk =
        compute_deflection(model, [&](int i) { return Vec3(0, 0, area_load * model.mass[i]); });

    const double expected =
        0.00126532 * kLoad * std::pow(kSide, 4.0) / compute_bending_stiffness(wall);
    CAPTURE(thickness);
    CHECK(sunk / expected == Approx(1.0).epsilon(0.03));
  }
}

TEST_CASE("a membrane without home springs does not bend at all, a shell does") {
  const SurfaceMesh mesh = scenes::make_sheet(9, 9, 0.1);
  SurfaceOptions options;
  options.home_stiffness = 0.0;
  const TissueModel flat =
      build_membrane_molecular(mesh, make_wall(), 0.0, AngleLaw::gradient, options);
  const TissueModel shell = build_shell(mesh, make_wall());
  const auto resist = [](const TissueModel& model) {
    Eigen::VectorXd bent = Eigen::VectorXd::Zero(3 * particle_count(model));
    for (int i = 0; i < particle_count(model); ++i) {
      bent[3 * i + 2] = 1e-3 * std::cos(60.0 * model.rest_position[i].x());
    }
    return bent.dot(compute_stiffness(model, model.rest_position, Projection::none) * bent);
  };

  CHECK(std::abs(resist(flat)) < 1e-15);
  CHECK(resist(shell) > 1e-6);
}

TEST_CASE("a shell has a stable step, and a stiffer or thinner wall a shorter one") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.05, 0.035, 0.03}, 2);
  Material stiff = make_wall();
  stiff.young_modulus *= 4.0;
  const double dt = stable_step(build_shell(mesh, make_wall()));

  CHECK(dt > 1e-5);
  CHECK(stable_step(build_shell(mesh, stiff)) == Approx(0.5 * dt).epsilon(0.02));
  CHECK(stable_step(build_shell(mesh, make_wall(1e-3))) < dt);
}

TEST_CASE("a wall a thousandth as thick as its triangles are wide is built, in no more memory") {
  const SurfaceMesh sheet = scenes::make_sheet(7, 7, 0.06);
  const std::size_t n = sheet.vertices.size();

  const TissueModel model = build_shell(sheet, make_wall(5e-6));

  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 below = model.rest_position[i] - model.rest_position[n + i];
    CHECK(below.norm() == Approx(5e-6 / std::sqrt(3.0)).epsilon(1e-6));
  }
}

TEST_CASE("a wall too thick for its surface is refused at the triangle that would be lost") {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.01, 0.01, 0.01}, 2);

  CHECK_NOTHROW(build_shell(mesh, make_wall(5e-3)));
  const std::string refusal = find_refusal([&] { build_shell(mesh, make_wall(1.5e-2)); });
  CAPTURE(refusal);
  CHECK(refusal.find("mesh: triangle 0: got an inner face, 8.66025 mm below, of ") == 0);
  CHECK(refusal.find("expected at least 10 %: a thinner wall") != std::string::npos);
  CHECK(find_refusal([&] { build_shell(mesh, Material()); }) ==
        "material: wall_thickness: got none, expected the thickness of the wall [m]");
}

TEST_CASE("prisms that cannot be are refused by column and row") {
  const auto refuse = [](const std::function<void(Prisms&)>& damage) {
    TissueModel model = build_shell(scenes::make_sheet(3, 3, 0.1), make_wall());
    damage(model.prisms);
    return find_refusal([&] { validate(model); });
  };

  CHECK(refuse([](Prisms&) {}) == "");
  CHECK(refuse([](Prisms& p) { p.corners[1][2] = 99; }).find("model: prisms.corners: row 1") == 0);
  CHECK(refuse([](Prisms& p) {
          p.corners[1][2] = p.corners[1][5];
        }).find("expected six different particles, 0 to 17") != std::string::npos);
  CHECK(refuse([](Prisms& p) {
          p.rest_difference[0][1] = NAN;
        }).find("model: prisms.rest_difference: row 0") == 0);
  CHECK(refuse([](Prisms& p) { p.shear_stiffness[2][0] = -1.0; }) ==
        "model: prisms.shear_stiffness: row 2: got -1 N/m, expected 0 or a positive number");
  CHECK(refuse([](Prisms& p) {
          p.shear_damping[2][0] = -1.0;
        }).find("model: prisms.shear_damping: row 2") == 0);
  CHECK(refuse([](Prisms& p) { p.shear_damping.pop_back(); }) ==
        "model: prisms.shear_damping: got 7 rows, expected 8");
}
