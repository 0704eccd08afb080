// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/tangent.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;
using Eigen::MatrixXd;

namespace {

enum class By { position, velocity };

/// -df/dx or -df/dv by central differences, rows and columns of fixed particles zero.
MatrixXd difference(const TissueModel& model, Vec3Array x, Vec3Array v, By by, double shift) {
  const int n = particle_count(model);
  MatrixXd slopes = MatrixXd::Zero(3 * n, 3 * n);
  Vec3Array above(n), below(n);
  Vec3Array& changed = by == By::position ? x : v;
  for (int j = 0; j < n; ++j) {
    for (int c = 0; c < 3; ++c) {
      const double middle = changed[j][c];
      changed[j][c] = middle + shift;
      compute_forces(model, Load(), x, v, above);
      changed[j][c] = middle - shift;
      compute_forces(model, Load(), x, v, below);
      changed[j][c] = middle;
      for (int i = 0; i < n; ++i) {
        slopes.block<3, 1>(3 * i, 3 * j + c) = -(above[i] - below[i]) / (2.0 * shift);
      }
    }
  }
  for (const int i : model.fixed) {
    slopes.middleRows(3 * i, 3).setZero();
    slopes.middleCols(3 * i, 3).setZero();
  }
  return slopes;
}

double smallest_eigenvalue_part(const MatrixXd& symmetric) {
  const Eigen::VectorXd all =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  return all[0] / all[all.size() - 1];
}

}  // namespace

TEST_CASE("the stiffness of a spring at rest is k along it and nothing across") {
  TissueModel model = scenes::make_oscillator_model(1e-3, 200.0);
  model.fixed = {};

  const MatrixXd k = compute_stiffness(model, model.rest_position, Projection::none);

  CHECK(k(0, 0) == Approx(200.0));
  CHECK(k(0, 3) == Approx(-200.0));
  CHECK(k(1, 1) == 0.0);
  CHECK(k(2, 5) == 0.0);
}

TEST_CASE("a spring stretched to twice its length has half its stiffness across") {
  const TissueModel model = scenes::make_oscillator_model(1e-3, 200.0);
  Vec3Array x = model.rest_position;
  x[1].x() *= 2.0;

  const MatrixXd k = compute_stiffness(model, x, Projection::none);

  CHECK(k(3, 3) == Approx(200.0));
  CHECK(k(4, 4) == Approx(100.0));
}

TEST_CASE("a spring pressed to half its length is unstable across, and projected it is not") {
  const TissueModel model = scenes::make_oscillator_model(1e-3, 200.0);
  Vec3Array x = model.rest_position;
  x[1].x() *= 0.5;

  CHECK(MatrixXd(compute_stiffness(model, x, Projection::none))(4, 4) == Approx(-200.0));
  CHECK(MatrixXd(compute_stiffness(model, x, Projection::positive_semidefinite))(4, 4) == 0.0);
}

TEST_CASE("the exact tangent is the derivative of the forces, whatever the law and the strain") {
  std::vector<TissueModel> models = {scenes::make_spring_organ(1), scenes::make_molecular_organ(1),
                                     scenes::make_molecular_organ(1, {}, AngleLaw::eq10),
                                     scenes::make_sheet_tissue()};
  for (const TissueModel& model : models) {
    for (const double offset : {0.0, 1e-4, 1e-3, 4e-3}) {
      CAPTURE(offset);
      const Vec3Array x = scenes::strained(model, offset), v(x.size(), Vec3::Zero());

      const MatrixXd exact = compute_stiffness(model, x, Projection::none);
      const MatrixXd measured = difference(model, x, v, By::position, 1e-7);

      CHECK((exact - measured).cwiseAbs().maxCoeff() < 1e-6 * exact.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("the exact tangent is the derivative of the forces inside the guards too") {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {0.01, 0, 0}, {0.004, 0.009, 0}};
  model.mass.assign(3, 1e-3);
  model.angles = scenes::make_angles({{0, 1, 2}}, model.rest_position, 1e-3, 0.02);
  const Vec3Array v(3, Vec3::Zero());
  const std::vector<Vec3Array> shapes = {
      {{0, 0, 0}, {0.01, 0, 0}, {0.0102, 1e-4, 0}},    // a side of 2 % of its rest length
      {{0, 0, 0}, {2e-4, 1e-4, 0}, {1e-4, 3e-4, 0}}};  // three of them
  for (const AngleLaw law : {AngleLaw::gradient, AngleLaw::eq10}) {
    model.angle_law = law;
    for (const Vec3Array& x : shapes) {
      const MatrixXd exact = compute_stiffness(model, x, Projection::none);
      const MatrixXd measured = difference(model, x, v, By::position, 1e-9);

      CHECK((exact - measured).cwiseAbs().maxCoeff() < 1e-5 * exact.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("the exact tangent is symmetric where there is an energy, and not under Eq 10") {
  const auto asymmetry = [](const TissueModel& model) {
    const MatrixXd k = compute_stiffness(model, scenes::strained(model, 1e-3), Projection::none);
    return (k - k.transpose()).cwiseAbs().maxCoeff() / k.cwiseAbs().maxCoeff();
  };

  CHECK(asymmetry(scenes::make_molecular_organ(1)) < 1e-14);
  CHECK(asymmetry(scenes::make_molecular_organ(1, {}, AngleLaw::eq10)) > 1e-4);
}

TEST_CASE("projected, the tangent of no strained state has a negative eigenvalue") {
  TissueModel strong = scenes::make_molecular_organ(1);
  for (auto& constants : strong.angles.stretch_coupling) constants = {0.3, -0.3, 0.3};
  const std::vector<TissueModel> models = {
      scenes::make_spring_organ(1), scenes::make_molecular_organ(1), strong,
      scenes::make_molecular_organ(1, {}, AngleLaw::eq10), scenes::make_sheet_tissue()};
  for (const TissueModel& model : models) {
    for (const double offset : {0.0, 1e-3, 4e-3, 2e-2}) {
      CAPTURE(offset);
      const Vec3Array x = scenes::strained(model, offset);

      const MatrixXd k = compute_stiffness(model, x, Projection::positive_semidefinite);

      CHECK((k - k.transpose()).cwiseAbs().maxCoeff() <= 1e-14 * k.cwiseAbs().maxCoeff());
      CHECK(smallest_eigenvalue_part(k) >= -1e-9);
    }
  }
  // and without projection there are some, so this has something to show
  CHECK(smallest_eigenvalue_part(
            compute_stiffness(strong, scenes::strained(strong, 4e-3), Projection::none)) < -1e-2);
}

TEST_CASE("at rest nothing needs projecting: both tangents are the same") {
  const TissueModel model = scenes::make_molecular_organ(1);

  const MatrixXd exact = compute_stiffness(model, model.rest_position, Projection::none);
  const MatrixXd projected =
      compute_stiffness(model, model.rest_position, Projection::positive_semidefinite);

  CHECK((exact - projected).cwiseAbs().maxCoeff() < 1e-12 * exact.cwiseAbs().maxCoeff());
}

TEST_CASE("a negative bond that its triangles outweigh is kept by the projection at rest") {
  // a flat triangle of bonds 60, 60, -2 N/m is stable through its angles [laws: definite]
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {0.01, 0, 0}, {0.005, 0.008, 0}};
  model.mass.assign(3, 1e-3);
  model.triangles = {{0, 1, 2}};
  model.angles = scenes::make_angles(model.triangles, model.rest_position, 5e-3, 0.0);
  model.angles.bond_share[0] = {60.0, 60.0, -2.0};
  model.bonds.ends = {{0, 1}, {0, 2}, {1, 2}};
  for (const int c : {2, 1, 0}) {
    model.bonds.rest_length.push_back(model.angles.rest_length[0][c]);
    model.bonds.stiffness.push_back(model.angles.bond_share[0][c]);
    model.bonds.damping.push_back(0.0);
  }
  validate(model);

  const MatrixXd exact = compute_stiffness(model, model.rest_position, Projection::none);
  const MatrixXd projected =
      compute_stiffness(model, model.rest_position, Projection::positive_semidefinite);

  CHECK((exact - projected).cwiseAbs().maxCoeff() < 1e-12 * exact.cwiseAbs().maxCoeff());
}

TEST_CASE("the damping matrix is the derivative of the forces in the velocities") {
  for (const DampingLaw law : {DampingLaw::axis, DampingLaw::isotropic}) {
    const TissueModel model =
        scenes::make_spring_organ(1, {.damping_ratio = 0.3, .drag = 5.0, .law = law});
    const Vec3Array x = scenes::strained(model, 2e-3);

    const MatrixXd exact = compute_damping(model, x);
    const MatrixXd measured =
        difference(model, x, Vec3Array(x.size(), Vec3::Zero()), By::velocity, 1e-3);

    CHECK((exact - measured).cwiseAbs().maxCoeff() < 1e-9 * exact.cwiseAbs().maxCoeff());
    CHECK(smallest_eigenvalue_part(exact) >= -1e-12);
  }
}

TEST_CASE("rows and columns of fixed particles are zero in both matrices") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.3, .drag = 5.0});
  REQUIRE_FALSE(model.fixed.empty());

  const MatrixXd k =
      compute_stiffness(model, model.rest_position, Projection::positive_semidefinite);
  const MatrixXd c = compute_damping(model, model.rest_position);

  for (const int i : model.fixed) {
    CHECK(k.middleRows(3 * i, 3).isZero(0.0));
    CHECK(k.middleCols(3 * i, 3).isZero(0.0));
    CHECK(c.middleRows(3 * i, 3).isZero(0.0));
    CHECK(c.middleCols(3 * i, 3).isZero(0.0));
  }
}
