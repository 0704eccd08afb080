// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/dynamics/private/law_tangents.h"
#include "palpate/sim/dynamics/private/volume_law.h"

namespace palpate {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// A mean of J over some tetrahedra is a row: its slopes in the coordinates of free particles, and
/// the stiffness [J] along them. Row by row, with r the slopes dJ/dx,
///
///     K = sum over rows of  e''(J) B V r rᵀ  +  sum over tetrahedra of  p d²v/dx²
///
/// where p = dE/dv is what accumulate_volume_forces (forces.cpp) pushes with.
struct Rows {
  explicit Rows(const TissueModel& its_model, std::span<const Vec3> its_x, Projection projection)
      : model(its_model),
        volumes(its_model.volumes),
        x(its_x),
        projected(projection == Projection::positive_semidefinite),
        free(its_model.rest_position.size(), true),
        pressure(its_model.volumes.corners.size(), 0.0) {
    for (const int i : model.fixed) free[static_cast<std::size_t>(i)] = false;
  }

  void add_slopes(std::size_t t, double per_volume) {
    const auto& [a, b, c, d] = volumes.corners[t];
    const Eigen::Matrix<double, 3, 4> slope = compute_volume_slopes(x[a], x[b], x[c], x[d]);
    for (int k = 0; k < 4; ++k) {
      const int i = volumes.corners[t][static_cast<std::size_t>(k)];
      if (!free[static_cast<std::size_t>(i)]) continue;
      for (int axis = 0; axis < 3; ++axis) {
        slopes.emplace_back(static_cast<int>(stiffness.size()), 3 * i + axis,
                            per_volume * slope(axis, k));
      }
    }
  }

  void finish_row(const VolumeLaw& law, double energy_scale) {
    const double curvature = projected ? std::max(law.curvature, 0.0) : law.curvature;
    stiffness.push_back(curvature * energy_scale);
  }

  void add_tetrahedra(double share);
  void add_means(double share);

  const TissueModel& model;
  const Volumes& volumes;
  std::span<const Vec3> x;
  bool projected;
  std::vector<bool> free;
  std::vector<double> pressure;  ///< [Pa] dE/dv per tetrahedron
  Entries slopes;
  std::vector<double> stiffness;  ///< [J] per row
};

void Rows::add_tetrahedra(double share) {
  for (std::size_t t = 0; t < volumes.corners.size(); ++t) {
    const double rest = volumes.rest_volume[t];
    const VolumeLaw law = compute_volume_law(measure_volume(volumes, t, x) / rest);
    pressure[t] += share * volumes.bulk[t] * law.slope;
    add_slopes(t, 1.0 / rest);
    finish_row(law, share * volumes.bulk[t] * rest);
  }
}

void Rows::add_means(double share) {
  for (std::size_t i = 0; i + 1 < volumes.first_around.size(); ++i) {
    const VolumeAround around = measure_around(volumes, i, x);
    if (!(around.rest > 0.0)) continue;
    const VolumeLaw law = compute_volume_law(around.now / around.rest);
    for (const int row : list_around(volumes, i)) {
      const auto t = static_cast<std::size_t>(row);
      pressure[t] += 0.25 * share * around.bulk * law.slope;
      add_slopes(t, 1.0 / around.rest);
    }
    finish_row(law, 0.25 * share * around.bulk * around.rest);
  }
}

Mat3 cross_matrix(const Vec3& v) {
  Mat3 matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// d²v/dx_c dx_p of a tetrahedron: with p, q, r the face opposite c, counter-clockwise from
/// outside, dv/dx_c = -(p × q + q × r + r × p)/6 and so d²v/dx_c dx_p = -[r - q]×/6.
void add_turning(const Rows& rows, std::size_t t, Entries& entries) {
  constexpr std::array<std::array<std::size_t, 3>, 4> kFaces = {
      {{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};
  const auto& corners = rows.volumes.corners[t];
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = corners[c], p = corners[kFaces[c][k]];
      const int q = corners[kFaces[c][(k + 1) % 3]], r = corners[kFaces[c][(k + 2) % 3]];
      if (!rows.free[static_cast<std::size_t>(i)] || !rows.free[static_cast<std::size_t>(p)]) {
        continue;
      }
      const Mat3 block = (-rows.pressure[t] / 6.0) * cross_matrix(rows.x[r] - rows.x[q]);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          if (row != column) entries.emplace_back(3 * i + row, 3 * p + column, block(row, column));
        }
      }
    }
  }
}

}  // namespace

SparseMatrix compute_volume_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                      Projection projection) {
  const Eigen::Index size = 3 * particle_count(model);
  Rows rows(model, x, projection);
  const double share = model.volumes.nodal_share;
  if (share < 1.0) rows.add_tetrahedra(1.0 - share);
  if (share > 0.0) rows.add_means(share);

  const auto count = static_cast<Eigen::Index>(rows.stiffness.size());
  SparseMatrix slopes(count, size), turning(size, size);
  slopes.setFromTriplets(rows.slopes.begin(), rows.slopes.end());
  const Eigen::Map<const Eigen::VectorXd> stiffness(rows.stiffness.data(), count);
  SparseMatrix sum = SparseMatrix(slopes.transpose()) * (stiffness.asDiagonal() * slopes);
  Entries entries;
  for (std::size_t t = 0; !rows.projected && t < model.volumes.corners.size(); ++t) {
    add_turning(rows, t, entries);
  }
  turning.setFromTriplets(entries.begin(), entries.end());
  // its pattern is part of that of the sum, which every tangent therefore shares
  sum += turning;
  return sum;
}

}  // namespace palpate
