// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/tangent.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using scenes::FiniteLaw;
using scenes::kFiniteLaws;

namespace {

constexpr double kShares[] = {0.0, 0.4, 1.0};

/// -df/dx or -df/dv by central differences.
Eigen::MatrixXd measure_tangent(const TissueModel& model, Vec3Array x, Vec3Array v, bool in_speed,
                                double shift) {
  const auto size = static_cast<Eigen::Index>(3 * x.size());
  Eigen::MatrixXd tangent(size, size);
  Vec3Array above(x.size()), below(x.size());
  for (Eigen::Index column = 0; column < size; ++column) {
    double& coordinate = (in_speed ? v : x)[static_cast<std::size_t>(column / 3)][column % 3];
    const double middle = coordinate;
    coordinate = middle + shift;
    compute_forces(model, Load(), x, v, above);
    coordinate = middle - shift;
    compute_forces(model, Load(), x, v, below);
    coordinate = middle;
    const Eigen::Map<Eigen::VectorXd> a(above[0].data(), size), b(below[0].data(), size);
    tangent.col(column) = -(a - b) / (2.0 * shift);
  }
  return tangent;
}

TissueModel make_free_organ(const FiniteLaw& law, double share, double damping_ratio = 0.0) {
  TissueModel model = scenes::make_finite_organ(law, 2, share, {.damping_ratio = damping_ratio});
  model.fixed.clear();
  return model;
}

}  // namespace

TEST_CASE("the tangent of either law is that of finite differences, inside out too") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    for (const double share : kShares) {
      for (const double offset : {0.0, 4e-3, 4e-2}) {
        CAPTURE(share);
        CAPTURE(offset);
        const TissueModel model = make_free_organ(law, share);
        const Vec3Array x = scenes::strained(model, offset);
        const Vec3Array still(x.size(), Vec3::Zero());

        const Eigen::MatrixXd k = compute_stiffness(model, x, Projection::none);

        const Eigen::MatrixXd expected = measure_tangent(model, x, still, false, 1e-7);
        CHECK((k - expected).norm() < 1e-5 * k.norm());
        CHECK((k - k.transpose()).norm() < 1e-13 * k.norm());
      }
    }
  }
}

TEST_CASE("the damping of either law is that of finite differences, and takes energy alone") {
  for (const FiniteLaw& law : kFiniteLaws) {
    const TissueModel model = make_free_organ(law, 0.4, 0.3);
    const Vec3Array x = scenes::strained(model, 4e-3);
    const Vec3Array v = scenes::scatter_vectors(x.size(), 0.1, 3);

    const Eigen::MatrixXd c = compute_damping(model, x);

    CHECK((c - measure_tangent(model, x, v, true, 1e-2)).norm() < 1e-8 * c.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(c, Eigen::EigenvaluesOnly);
    CHECK(solver.eigenvalues().minCoeff() > -1e-12 * solver.eigenvalues().maxCoeff());
  }
}

TEST_CASE("projected, the tangent of either law is semidefinite; at rest it is the exact one") {
  for (const FiniteLaw& law : kFiniteLaws) {
    CAPTURE(std::string(law.name));
    for (const double share : kShares) {
      const TissueModel model = make_free_organ(law, share);
      const auto compute = [&](double squeeze, Projection projection) -> Eigen::MatrixXd {
        Vec3Array x = scenes::strained(model, 0.5e-3);
        for (Vec3& p : x) p *= squeeze;
        return compute_stiffness(model, squeeze == 1.0 ? model.rest_position : x, projection);
      };
      const auto find_least = [](const Eigen::MatrixXd& k) {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, Eigen::EigenvaluesOnly);
        return solver.eigenvalues().minCoeff() / solver.eigenvalues().maxCoeff();
      };
      CHECK(find_least(compute(0.6, Projection::none)) < -1e-3);
      CHECK(find_least(compute(0.6, Projection::positive_semidefinite)) > -1e-12);
      const Eigen::MatrixXd exact = compute(1.0, Projection::none);
      CHECK((compute(1.0, Projection::positive_semidefinite) - exact).norm() <
            1e-12 * exact.norm());
    }
  }
}

TEST_CASE("the pattern of a projected tangent is that of the exact one, at all positions") {
  for (const FiniteLaw& law : kFiniteLaws) {
    const TissueModel model = make_free_organ(law, 0.9);
    const auto exact = compute_stiffness(model, model.rest_position, Projection::none);
    const auto projected =
        compute_stiffness(model, scenes::strained(model, 1e-2), Projection::positive_semidefinite);
    CHECK(exact.nonZeros() == projected.nonZeros());
  }
}

TEST_CASE("for small strains either law is the linear solid of the same tetrahedra") {
  for (const FiniteLaw& law : kFiniteLaws) {
    for (const double share : kShares) {
      const TissueModel model = scenes::make_finite_organ(law, 3, share);
      const TissueModel linear = scenes::make_linear_organ(3, share);
      const auto k = compute_stiffness(model, model.rest_position, Projection::none);
      const auto expected = compute_stiffness(linear, linear.rest_position, Projection::none);
      CHECK((k - expected).norm() < 1e-12 * expected.norm());
    }
  }
}
