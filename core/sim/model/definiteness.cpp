// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/definiteness.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

/// Eigenvalues below this part of the largest are rounding: sixteen digits, less those that the
/// cosines of a needle lose.
constexpr double kRounding = 1e-9;

/// The same where every side is measured in units of its own stiffness. A nearly flat triangle of
/// plane stress, with two angles of a, is definite by a part of a⁴ only: 6e-13 at 0.05 degrees.
constexpr double kScaledRounding = 1e-13;

/// Row c is the gradient of the cosine at corner c in the three side lengths at rest [1/m]; with
/// i and j the two other corners, and l_c the side opposite c:
///
///     G_cc = -l_c / (l_i l_j),   G_ci = l_c cos_j / (l_i l_j)
Mat3 compute_cosine_gradients(const Angles& angles, int row) noexcept {
  const auto& length = angles.rest_length[row];
  const auto& cosine = angles.rest_cosine[row];
  Mat3 g;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const double scale = length[c] / (length[i] * length[j]);
    g(c, c) = -scale;
    g(c, i) = scale * cosine[j];
    g(c, j) = scale * cosine[i];
  }
  return g;
}

/// What one newton of stretch coupling, `share` of it at each corner, adds to the stiffness [1/m]:
///
///     sum over c of share_c (G_c s_cᵀ + s_c G_cᵀ),   s_c = 1 for the two arms of corner c, else 0
Mat3 compute_coupling_part(const Mat3& g, const std::array<double, 3>& share) noexcept {
  Mat3 half;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int c1 = (j + 1) % 3, c2 = (j + 2) % 3;
      half(i, j) = share[c1] * g(c1, i) + share[c2] * g(c2, i);
    }
  }
  return half + half.transpose();
}

/// The bonds and the angles alone [N/m]: k'_i on the diagonal and the sum of K_theta_c G_c G_cᵀ.
Mat3 compute_plain_part(const Angles& angles, int row, const Mat3& g) noexcept {
  Mat3 plain = Mat3::Zero();
  for (int c = 0; c < 3; ++c) {
    plain(c, c) += angles.bond_share[row][c];
    plain += angles.bend_stiffness[row][c] * g.row(c).transpose() * g.row(c);
  }
  return plain;
}

double find_smallest_eigenvalue(const Mat3& matrix) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// Where the smallest eigenvalue of plain + K coupling is largest. It is a concave function of K,
/// so golden sections close in on the top.
double find_stiffest(const Mat3& plain, const Mat3& coupling) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSections = 120;
  // beyond this the coupling outweighs all else, and alone it is never definite
  double high = 1e3 * plain.norm() / coupling.norm(), low = -high;
  for (int section = 0; section < kSections; ++section) {
    const double one = high - kGolden * (high - low), two = low + kGolden * (high - low);
    const bool left = find_smallest_eigenvalue(plain + one * coupling) >
                      find_smallest_eigenvalue(plain + two * coupling);
    (left ? high : low) = left ? two : one;
  }
  return 0.5 * (low + high);
}

/// The determinant of diag(k') - diag(K) G is a sum of products of k' and of principal minors of
/// -diag(K) G, which are K_i l_i/(l_j l_k), K_i K_j sin²_k/l_k² and, since G l = 0, zero. None is
/// negative for K >= 0, so with k' > 0 it is never zero. Where a constant is negative, a positive
/// definite symmetric part rules a zero out as well: v·S v > 0 for every v.
void check_eq10(const Angles& angles, int row) {
  const auto name = [row](const char* column) {
    return write_text("model: angles.", column, ": row ", row);
  };
  for (const double coupling : angles.stretch_coupling[row]) {
    if (coupling == 0.0) continue;
    refuse(name("stretch_coupling"), write_text(coupling, " N"),
           "0 under AngleLaw::eq10, which has no stretch-bend force");
  }
  const auto& share = angles.bond_share[row];
  const auto& bend = angles.bend_stiffness[row];
  if (std::ranges::all_of(share, [](double k) { return k > 0.0; }) &&
      std::ranges::all_of(bend, [](double k) { return k >= 0.0; })) {
    return;
  }
  const Mat3 slopes = compute_rest_slopes(angles, row, AngleLaw::eq10);
  if (is_positive_definite(0.5 * (slopes + slopes.transpose()))) return;
  for (const double k : share) {
    if (!(k > 0.0)) refuse(name("bond_share"), write_text(k, " N/m"), "a positive number");
  }
  refuse(name("bend_stiffness"), write_text(*std::ranges::min_element(bend), " N"),
         "0 or a positive number, or larger bond shares beside it");
}

void check_gradient(const Angles& angles, int row) {
  const Mat3 stiffness = compute_rest_stiffness(angles, row);
  if (is_positive_definite(stiffness)) return;

  // the range is told for the largest of the three, the others keeping their proportion to it
  const auto& coupling = angles.stretch_coupling[row];
  double largest = 0.0;
  for (const double k : coupling) largest = std::abs(k) > std::abs(largest) ? k : largest;
  std::array<double, 3> proportion = {1.0, 1.0, 1.0};
  for (int c = 0; c < 3 && largest != 0.0; ++c) proportion[c] = coupling[c] / largest;
  const auto range = find_coupling_range(angles, row, proportion);
  const auto [i, j, k] = angles.corners[row];
  refuse(write_text("model: angles: row ", row, " (particles ", i, ", ", j, ", ", k, ")"),
         write_text("K_btheta ", largest, " N and a tangent at rest with an eigenvalue of ",
                    find_smallest_eigenvalue(stiffness), " N/m"),
         range ? "K_btheta " + describe(*range)
               : "larger bond shares or K_theta, for no K_btheta makes it positive definite");
}

}  // namespace

void check_definiteness(const Angles& angles, AngleLaw law) {
  for (int row = 0; row < static_cast<int>(angles.corners.size()); ++row) {
    law == AngleLaw::eq10 ? check_eq10(angles, row) : check_gradient(angles, row);
  }
}

/// H = diag(k') + sum over corners c of
/// K_theta_c G_c G_cᵀ + K_btheta_c (G_c s_cᵀ + s_c G_cᵀ). At rest no term pulls, so the second
/// derivatives of the cosines do not count [laws: definite].
Mat3 compute_rest_stiffness(const Angles& angles, int row) noexcept {
  const Mat3 g = compute_cosine_gradients(angles, row);
  return compute_plain_part(angles, row, g) +
         compute_coupling_part(g, angles.stretch_coupling[row]);
}

/// Under Eq 10 the side opposite corner c pulls with k'_c (l - L) - K_c (cos_c - cos0_c).
Mat3 compute_rest_slopes(const Angles& angles, int row, AngleLaw law) noexcept {
  if (law == AngleLaw::gradient) return compute_rest_stiffness(angles, row);
  Mat3 slopes = compute_cosine_gradients(angles, row);
  for (int c = 0; c < 3; ++c) {
    slopes.row(c) *= -angles.bend_stiffness[row][c];
    slopes(c, c) += angles.bond_share[row][c];
  }
  return slopes;
}

bool is_positive_definite(const Mat3& stiffness) noexcept {
  if (!stiffness.allFinite() || !(stiffness.diagonal().minCoeff() > 0.0)) return false;
  const Vec3 unit = stiffness.diagonal().cwiseSqrt().cwiseInverse();
  const Mat3 scaled = unit.asDiagonal() * stiffness * unit.asDiagonal();
  return find_smallest_eigenvalue(scaled) > kScaledRounding;
}

/// The matrices P + K D that are positive definite form an interval of K, because those matrices
/// form a convex cone. From a K0 inside, with P + K0 D = L Lᵀ and m the eigenvalues of L⁻¹ D L⁻ᵀ,
/// the form stays positive while 1 + (K - K0) m > 0 for every m.
std::optional<CouplingRange> find_coupling_range(const Angles& angles, int row,
                                                 const std::array<double, 3>& proportion) {
  const Mat3 g = compute_cosine_gradients(angles, row);
  const Mat3 plain = compute_plain_part(angles, row, g);
  const Mat3 coupling = compute_coupling_part(g, proportion);
  if (!plain.allFinite() || !coupling.allFinite()) return std::nullopt;
  const bool coupled = coupling.norm() > 0.0;
  const double inside =
      coupled && !is_positive_definite(plain) ? find_stiffest(plain, coupling) : 0.0;
  const Mat3 start = plain + inside * coupling;
  if (!is_positive_definite(start)) return std::nullopt;

  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> solver(coupling, start,
                                                              Eigen::EigenvaluesOnly);
  const Vec3 m = solver.eigenvalues();
  const double nothing = kRounding * m.cwiseAbs().maxCoeff();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return CouplingRange{m[2] > nothing ? inside - 1.0 / m[2] : -kInfinity,
                       m[0] < -nothing ? inside - 1.0 / m[0] : kInfinity};
}

std::string describe(const CouplingRange& range) {
  // more than the six digits shown can move a bound
  constexpr double kHair = 1e-5;
  const double low = range.low + kHair * std::abs(range.low);
  const double high = range.high - kHair * std::abs(range.high);
  if (std::isinf(range.low) && std::isinf(range.high)) return "any number";
  if (std::isinf(range.high)) return write_text("above ", low, " N");
  if (std::isinf(range.low)) return write_text("below ", high, " N");
  return write_text(low, " to ", high, " N");
}

}  // namespace palpate
