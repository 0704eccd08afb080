// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SVD>
#include <cmath>

#include "palpate/sim/dynamics/private/hyperelastic_law.h"

namespace palpate {
namespace {

/// Below this part of |F|³ the product of the sums of two stretches no longer divides.
constexpr double kLeastProduct = 1e-2;

/// By singular values, the smallest with the sign of det F.
Polar compute_by_values(const Mat3& f) noexcept {
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  Vec3 stretch = svd.singularValues();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) {
    u.col(2) = -u.col(2);
    stretch[2] = -stretch[2];
  }
  return {u * svd.matrixV().transpose(), stretch.sum()};
}

/// The largest root of x⁴ - 2 I x² - 8 J x + I² - 4 II, from above, where Newton only falls.
double find_trace(double one, double two, double j) noexcept {
  constexpr int kMostRounds = 30;
  constexpr double kSettled = 1e-15;
  double x = std::sqrt(3.0 * one);
  for (int round = 0; round < kMostRounds; ++round) {
    const double square = x * x;
    const double value = square * (square - 2.0 * one) - 8.0 * j * x + one * one - 4.0 * two;
    const double slope = 4.0 * x * (square - one) - 8.0 * j;
    if (!(slope > 0.0)) break;
    const double step = value / slope;
    x -= step;
    if (!(step > kSettled * x)) break;
  }
  return x;
}

}  // namespace

/// With I = |F|², II the second invariant of FᵀF and J = det F, x = tr S is the largest root of
/// x⁴ - 2 I x² - 8 J x + I² - 4 II, and R = dx/dF follows from the derivative of that [Lin22]:
///
///     R = ((x² + I) F - 2 F FᵀF + 2 x cof F) / (x³ - I x - 2 J)
///
/// where the denominator is twice the product of the sums of two stretches: what is nearly 0 there
/// is left to singular values.
Polar compute_polar(const Mat3& f) noexcept {
  const Mat3 c = f.transpose() * f;
  const double one = c.trace(), two = 0.5 * (one * one - c.squaredNorm());
  const Mat3 cofactor = compute_cofactor(f);
  const double j = f.col(0).dot(cofactor.col(0));
  const double x = find_trace(one, two, j);
  const double product = x * (x * x - one) - 2.0 * j;
  if (!(product > kLeastProduct * one * std::sqrt(one))) return compute_by_values(f);
  return {((x * x + one) * f - 2.0 * f * c + 2.0 * x * cofactor) / product, x};
}

}  // namespace palpate
