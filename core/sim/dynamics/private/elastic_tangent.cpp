// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/private/elastic_law.h"
#include "palpate/sim/dynamics/private/law_tangents.h"

namespace palpate {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

std::vector<bool> mark_free(const TissueModel& model) {
  std::vector<bool> free(model.rest_position.size(), true);
  for (const int i : model.fixed) free[static_cast<std::size_t>(i)] = false;
  return free;
}

/// The block of corners p and q of a tetrahedron [Zienkiewicz13]:
///
///     K_pq = V ((1 - s) lambda g_p g_qᵀ + mu g_q g_pᵀ + mu (g_p·g_q) I)
Mat3 compute_block(const Elastic& elastic, std::size_t t, const RestTetrahedron& tetrahedron, int p,
                   int q) {
  const Vec3 one = tetrahedron.slopes.col(p), two = tetrahedron.slopes.col(q);
  const double lame = (1.0 - elastic.nodal_share) * elastic.lame[t], mu = elastic.shear[t];
  return (lame * one * two.transpose() + mu * two * one.transpose() +
          mu * one.dot(two) * Mat3::Identity()) /
         tetrahedron.volume;
}

void add_tetrahedra(const TissueModel& model, const std::vector<bool>& free, Entries& entries) {
  const Elastic& elastic = model.elastic;
  for (std::size_t t = 0; t < elastic.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(elastic, t, model.rest_position);
    for (int p = 0; p < 4; ++p) {
      for (int q = 0; q < 4; ++q) {
        const int i = tetrahedron.corners[p], j = tetrahedron.corners[q];
        if (!free[static_cast<std::size_t>(i)] || !free[static_cast<std::size_t>(j)]) continue;
        const Mat3 block = compute_block(elastic, t, tetrahedron, p, q);
        for (int row = 0; row < 3; ++row) {
          for (int column = 0; column < 3; ++column) {
            entries.emplace_back(3 * i + row, 3 * j + column, block(row, column));
          }
        }
      }
    }
  }
}

/// s/4 lambda_a V_a r rᵀ over all particles, r = d theta_a/du.
SparseMatrix compute_means(const TissueModel& model, const std::vector<bool>& free) {
  const Elastic& elastic = model.elastic;
  const std::size_t count = model.rest_position.size();
  Entries slopes;
  Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  const auto still = [](int) { return Vec3(Vec3::Zero()); };
  for (std::size_t i = 0; i < count; ++i) {
    const DilatationAround around = measure_dilatation(elastic, i, model.rest_position, still);
    const auto row = static_cast<Eigen::Index>(i);
    stiffness[row] = 0.25 * elastic.nodal_share * around.lame * around.volume;
    for (const int t : list_around(elastic, i)) {
      const RestTetrahedron tetrahedron(elastic, static_cast<std::size_t>(t), model.rest_position);
      for (int k = 0; k < 4; ++k) {
        const int j = tetrahedron.corners[k];
        if (!free[static_cast<std::size_t>(j)]) continue;
        for (int axis = 0; axis < 3; ++axis) {
          slopes.emplace_back(row, 3 * j + axis, tetrahedron.slopes(axis, k) / around.volume);
        }
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(count);
  SparseMatrix matrix(size, 3 * size);
  matrix.setFromTriplets(slopes.begin(), slopes.end());
  return SparseMatrix(matrix.transpose()) * (stiffness.asDiagonal() * matrix);
}

}  // namespace

SparseMatrix compute_elastic_stiffness(const TissueModel& model) {
  const std::vector<bool> free = mark_free(model);
  Entries entries;
  entries.reserve(144 * model.elastic.corners.size());
  add_tetrahedra(model, free, entries);
  const Eigen::Index size = 3 * particle_count(model);
  SparseMatrix stiffness(size, size);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  if (model.elastic.nodal_share > 0.0) stiffness += compute_means(model, free);
  return stiffness;
}

}  // namespace palpate
