// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// K of a model's free particles alone.
struct FreeStiffness {
  /// At rest.
  explicit FreeStiffness(const TissueModel& model)
      : FreeStiffness(model, model.rest_position, Projection::none) {}
  /// At positions x [m].
  FreeStiffness(const TissueModel& model, std::span<const Vec3> x, Projection projection);

  /// Of a coordinate of the model, among those of the free; -1 where it is held.
  Eigen::Index place(Eigen::Index coordinate) const {
    const int n = number[static_cast<std::size_t>(coordinate / 3)];
    return n < 0 ? -1 : 3 * Eigen::Index{n} + coordinate % 3;
  }

  std::vector<int> number;  ///< per particle, -1 where it is held
  int count = 0;
  SparseMatrix matrix;
};

using Factors = Eigen::SimplicialLDLT<SparseMatrix>;

/// False for a body that can move without being strained.
bool factor(const FreeStiffness& stiffness, Factors& factors);

/// So many right sides are solved for in one pass over the factors, which is what such a pass
/// costs.
inline constexpr Eigen::Index kAtOnce = 16;
using Sides = Eigen::Matrix<double, Eigen::Dynamic, kAtOnce, Eigen::RowMajor>;

/// K u = f by its factors, P K Pᵀ = L D Lᵀ.
Sides solve(const Factors& factors, const Sides& f);

}  // namespace palpate
