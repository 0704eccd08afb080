// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/dynamics/private/law_tangents.h"
#include "palpate/sim/dynamics/private/prism_law.h"

namespace palpate {
namespace {

using Mat12 = Eigen::Matrix<double, 12, 12>;
using Vec12 = Eigen::Matrix<double, 12, 1>;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// ds/dx of the four ends of the two diagonals.
Vec12 compute_gradient(const Diagonals& now) {
  Vec12 gradient;
  gradient << -now.unit[0], now.unit[0], now.unit[1], -now.unit[1];
  return gradient;
}

/// Adds `weight` times the second derivative of a diagonal's length, (I - n nᵀ)/L.
void add_curvature(const Diagonals& now, int d, double weight, Mat12& k) {
  if (!(now.length[d] > 0.0)) return;
  const Mat3 across =
      (weight / now.length[d]) * (Mat3::Identity() - now.unit[d] * now.unit[d].transpose());
  const int p = 6 * d, q = 6 * d + 3;
  k.block<3, 3>(p, p) += across;
  k.block<3, 3>(q, q) += across;
  k.block<3, 3>(p, q) -= across;
  k.block<3, 3>(q, p) -= across;
}

/// Sums `compute(p, c, diagonals)`, a matrix for the four ends of side c of prism p, over all
/// sides.
template <class Compute>
SparseMatrix assemble(const TissueModel& model, std::span<const Vec3> x, Compute compute) {
  std::vector<bool> free(model.rest_position.size(), true);
  for (const int i : model.fixed) free[static_cast<std::size_t>(i)] = false;
  const auto at = [x](int i) -> const Vec3& { return x[static_cast<std::size_t>(i)]; };
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * 144 * model.prisms.corners.size());
  for (std::size_t p = 0; p < model.prisms.corners.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      const PrismSide side(model.prisms.corners[p], c);
      const Mat12 k = compute(p, c, Diagonals(side, at));
      for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
          const int one = side.ends[i / 3], two = side.ends[j / 3];
          if (!free[one] || !free[two]) continue;
          entries.emplace_back(3 * one + i % 3, 3 * two + j % 3, k(i, j));
        }
      }
    }
  }
  const Eigen::Index size = 3 * particle_count(model);
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

/// K = k g gᵀ + T (H1 - H2), g = ds/dx, T = k s, H the second derivatives of the two lengths.
/// Projected, of the last two only the one that T stretches counts.
SparseMatrix compute_prism_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                     Projection projection) {
  const Prisms& prisms = model.prisms;
  return assemble(model, x, [&](std::size_t p, int c, const Diagonals& now) {
    const double stiffness = prisms.shear_stiffness[p][c];
    const double tension =
        stiffness * (now.length[0] - now.length[1] - prisms.rest_difference[p][c]);
    const bool exact = projection == Projection::none;
    const Vec12 gradient = compute_gradient(now);
    Mat12 k = stiffness * gradient * gradient.transpose();
    add_curvature(now, 0, exact ? tension : std::max(tension, 0.0), k);
    add_curvature(now, 1, exact ? -tension : std::max(-tension, 0.0), k);
    return k;
  });
}

SparseMatrix compute_prism_damping(const TissueModel& model, std::span<const Vec3> x) {
  return assemble(model, x, [&](std::size_t p, int c, const Diagonals& now) -> Mat12 {
    const Vec12 gradient = compute_gradient(now);
    return model.prisms.shear_damping[p][c] * gradient * gradient.transpose();
  });
}

}  // namespace palpate
