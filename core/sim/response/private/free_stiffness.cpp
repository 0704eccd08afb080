// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/response/private/free_stiffness.h"

namespace palpate {

FreeStiffness::FreeStiffness(const TissueModel& model, std::span<const Vec3> x,
                             Projection projection)
    : number(model.rest_position.size(), 0) {
  for (const int i : model.fixed) number[static_cast<std::size_t>(i)] = -1;
  for (int& n : number) {
    if (n == 0) n = count++;
  }
  const SparseMatrix whole = compute_stiffness(model, x, projection);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(whole.nonZeros()));
  for (Eigen::Index column = 0; column < whole.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(whole, column); entry; ++entry) {
      const Eigen::Index i = place(entry.row()), j = place(entry.col());
      if (i >= 0 && j >= 0) entries.emplace_back(i, j, entry.value());
    }
  }
  matrix.resize(3 * count, 3 * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
}

/// A body that is not held has rigid motions without resistance, and rounding makes of these
/// pivots that are tiny or negative.
bool factor(const FreeStiffness& stiffness, Factors& factors) {
  constexpr double kLeastPivot = 1e-9;
  factors.compute(stiffness.matrix);
  const bool solved = factors.info() == Eigen::Success;
  const Eigen::VectorXd pivots = solved ? Eigen::VectorXd(factors.vectorD()) : Eigen::VectorXd();
  return solved && pivots.minCoeff() > kLeastPivot * pivots.maxCoeff();
}

Sides solve(const Factors& factors, const Sides& f) {
  const SparseMatrix& lower = factors.matrixL().nestedExpression();
  const Eigen::VectorXd pivots = factors.vectorD();
  Sides u = factors.permutationP() * f;
  for (Eigen::Index j = 0; j < u.rows(); ++j) {
    if (u.row(j).isZero(0.0)) continue;  // nothing has come down to it from a few unit forces
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      if (entry.row() > j) u.row(entry.row()) -= entry.value() * u.row(j);
    }
  }
  for (Eigen::Index j = u.rows() - 1; j >= 0; --j) {
    u.row(j) /= pivots[j];
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      if (entry.row() > j) u.row(j) -= entry.value() * u.row(entry.row());
    }
  }
  return factors.permutationPinv() * u;
}

}  // namespace palpate
