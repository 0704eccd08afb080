// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "palpate/sim/base/types.h"

namespace palpate {

/// The largest eigenvalue of a symmetric matrix as Lanczos found it.
struct Largest {
  double value = 0.0;      ///< a Rayleigh quotient, so never above the true one
  double residual = 0.0;   ///< some eigenvalue lies within this of `value`
  Eigen::VectorXd vector;  ///< unit length
};

/// A vector of `size` numbers in [-1, 1) that is always the same (xorshift, Marsaglia 2003).
inline Eigen::VectorXd scatter(Eigen::Index size) {
  std::uint64_t seed = 0x9e3779b97f4a7c15ull;
  Eigen::VectorXd vector(size);
  for (double& number : vector) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    number = static_cast<double>(seed >> 11) / 4503599627370496.0 - 1.0;
  }
  return vector;
}

/// Lanczos with full reorthogonalisation [Lanczos50] on the symmetric matrix that
/// `apply(v) -> A v` stands for. From a scattered start in n dimensions, k steps miss the largest
/// eigenvalue by a part e with a probability below 1.65 sqrt(n) exp(-sqrt(e) (2k - 1))
/// [KuczynskiWozniakowski92]: for n = 1e5 and the least number of steps, by a tenth in one of 1e8
/// meshes. It goes on until the residual is a thousandth.
template <class Apply>
Largest find_largest_eigenvalue(Eigen::Index size, Apply apply) {
  constexpr Eigen::Index kFewest = 40, kMost = 120, kBetweenLooks = 10;
  constexpr double kSmallResidual = 1e-3, kExhausted = 1e-12;
  const Eigen::Index most = std::min(size, kMost);
  Eigen::MatrixXd basis(size, most);
  Eigen::VectorXd diagonal(most), beside(most);
  Eigen::VectorXd next = scatter(size).normalized();
  Largest largest;
  for (Eigen::Index k = 0; k < most; ++k) {
    basis.col(k) = next;
    next = apply(basis.col(k));
    diagonal[k] = basis.col(k).dot(next);
    // twice is enough [Parlett80]
    for (int pass = 0; pass < 2; ++pass) {
      next -= basis.leftCols(k + 1) * (basis.leftCols(k + 1).transpose() * next).eval();
    }
    beside[k] = next.norm();
    const bool exhausted =
        k + 1 == most || beside[k] <= kExhausted * diagonal.head(k + 1).cwiseAbs().maxCoeff();
    if (exhausted || (k + 1 >= kFewest && (k + 1) % kBetweenLooks == 0)) {
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
      solver.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k));
      const Eigen::VectorXd top = solver.eigenvectors().col(k);
      largest.value = solver.eigenvalues()[k];
      largest.residual = beside[k] * std::abs(top[k]);
      largest.vector = basis.leftCols(k + 1) * top;
      if (exhausted || largest.residual <= kSmallResidual * largest.value) break;
    }
    next /= beside[k];
  }
  return largest;
}

}  // namespace palpate
