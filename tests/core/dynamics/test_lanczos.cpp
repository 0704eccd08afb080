// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/private/lanczos.h"

using namespace palpate;
using doctest::Approx;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Largest find_of(const MatrixXd& matrix) {
  return find_largest_eigenvalue(matrix.rows(),
                                 [&](const auto& v) -> VectorXd { return matrix * v; });
}

}  // namespace

TEST_CASE("of a diagonal matrix the largest entry is found, with its axis") {
  const Largest largest = find_of(Eigen::Vector4d(3.0, -7.0, 5.0, 1.0).asDiagonal());

  CHECK(largest.value == Approx(5.0).epsilon(1e-12));
  CHECK(std::abs(largest.vector[2]) == Approx(1.0));
}

TEST_CASE("a matrix of zeros and an empty one have nothing above zero") {
  CHECK(find_of(MatrixXd::Zero(5, 5)).value == 0.0);
  CHECK(find_of(MatrixXd(0, 0)).value == 0.0);
}

TEST_CASE("a largest eigenvalue that many axes share is found as fast as a single one") {
  VectorXd diagonal = VectorXd::Ones(200);
  diagonal.tail(150).setConstant(9.0);

  CHECK(find_of(diagonal.asDiagonal()).value == Approx(9.0).epsilon(1e-12));
}

TEST_CASE("eigenvalues that crowd at the top are found to a thousandth, from below") {
  const VectorXd diagonal = VectorXd::LinSpaced(5000, 0.0, 1.0);

  const Largest largest = find_largest_eigenvalue(
      5000, [&](const auto& v) -> VectorXd { return diagonal.cwiseProduct(v); });

  CHECK(largest.value <= 1.0);
  CHECK(largest.value > 1.0 - 2e-3);
  CHECK(largest.value + largest.residual > 1.0 - 1e-3);
}

TEST_CASE("the residual says how far the vector is from an eigenvector") {
  const VectorXd start = scatter(3600);
  MatrixXd matrix = Eigen::Map<const MatrixXd>(start.data(), 60, 60);
  matrix = (matrix + matrix.transpose()).eval();

  const Largest largest = find_of(matrix);

  CHECK((matrix * largest.vector - largest.value * largest.vector).norm() <
        1.01 * largest.residual + 1e-10);
}

TEST_CASE("the start vector is always the same and looks like nothing") {
  const VectorXd one = scatter(1000), two = scatter(1000);

  CHECK(one == two);
  CHECK(std::abs(one.mean()) < 0.1);
  CHECK(one.cwiseAbs().maxCoeff() < 1.0);
  CHECK(one.squaredNorm() / 1000.0 == Approx(1.0 / 3.0).epsilon(0.1));
}
