// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <numbers>

#include "palpate/sim/base/types.h"

namespace palpate {

// Symmetric matrices as columns of six: the diagonal, then sqrt(2) times what stands beside it, so
// that products of columns are those of matrices.

using Six = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat63 = Eigen::Matrix<double, 6, 3>;

inline Six write_column(const Mat3& m) noexcept {
  constexpr double h = 0.5 * std::numbers::sqrt2;
  Six column;
  column << m(0, 0), m(1, 1), m(2, 2), h * (m(1, 2) + m(2, 1)), h * (m(2, 0) + m(0, 2)),
      h * (m(0, 1) + m(1, 0));
  return column;
}

/// The symmetric matrix whose column has 1 at `k` and 0 elsewhere.
inline Mat3 write_unit(int k) noexcept {
  Mat3 unit = Mat3::Zero();
  if (k < 3) {
    unit(k, k) = 1.0;
  } else {
    const int i = (k - 2) % 3, j = (k - 1) % 3;
    unit(i, j) = unit(j, i) = 0.5 * std::numbers::sqrt2;
  }
  return unit;
}

/// The columns of the symmetric part of Aᵀ dx gᵀ, for dx along each axis.
inline Mat63 differentiate_strain(const Mat3& a, const Vec3& g) noexcept {
  constexpr double h = 0.5 * std::numbers::sqrt2;
  Mat63 rows;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    rows.row(k) = g[k] * a.col(k).transpose();
    rows.row(3 + k) = h * (g[j] * a.col(i) + g[i] * a.col(j)).transpose();
  }
  return rows;
}

}  // namespace palpate
