// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>
#include <vector>

#include "palpate/sim/dynamics/private/tensions.h"

namespace palpate {

/// What each triangle holds of the bonds around it, and what remains to the bonds themselves.
/// Together with its part of the bonds a triangle's length Hessian is closer to definite than
/// alone, so less is clamped away.
struct SharedBonds {
  SharedBonds(const Links& bonds, const Angles& angles) : remainder(bonds.stiffness) {
    std::vector<std::pair<std::array<int, 2>, std::size_t>> by_ends;
    for (std::size_t l = 0; l < bonds.ends.size(); ++l) by_ends.push_back({bonds.ends[l], l});
    std::sort(by_ends.begin(), by_ends.end());
    for (std::size_t t = 0; t < angles.corners.size(); ++t) {
      share.push_back({0.0, 0.0, 0.0});
      for (std::size_t c = 0; c < 3; ++c) {
        const int i = angles.corners[t][(c + 1) % 3], j = angles.corners[t][(c + 2) % 3];
        const std::array<int, 2> ends = {std::min(i, j), std::max(i, j)};
        const auto bond =
            std::lower_bound(by_ends.begin(), by_ends.end(), std::pair{ends, std::size_t{0}});
        if (bond == by_ends.end() || bond->first != ends) continue;
        share.back()[c] = angles.bond_share[t][c];
        remainder[bond->second] -= angles.bond_share[t][c];
      }
    }
  }

  std::vector<PerSide<double>> share;  ///< [N/m] per triangle and side
  std::vector<double> remainder;       ///< [N/m] per bond
};

inline Mat3 clamp_eigenvalues(const Mat3& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

}  // namespace palpate
