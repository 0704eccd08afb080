// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "palpate/sim/dynamics/private/hyperelastic_law.h"
#include "palpate/sim/dynamics/private/law_tangents.h"

namespace palpate {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;
using Vec9 = Eigen::Matrix<double, 9, 1>;

// matrices of F in columns: entry 3 c + r of nine is F(r, c)

Vec9 stack(const Mat3& matrix) { return Eigen::Map<const Vec9>(matrix.data()); }

Mat3 cross_matrix(const Vec3& v) {
  Mat3 matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// d²J/dF²: the derivative of f_1 × f_2 and its like in the columns f of F.
Mat9 compute_turning(const Mat3& f) {
  Mat9 turning = Mat9::Zero();
  for (int c = 0; c < 3; ++c) {
    const int one = (c + 1) % 3, two = (c + 2) % 3;
    turning.block<3, 3>(3 * c, 3 * one) = -cross_matrix(f.col(two));
    turning.block<3, 3>(3 * c, 3 * two) = cross_matrix(f.col(one));
  }
  return turning;
}

/// dR/dF = T G⁻¹ Tᵀ, G = tr(S) - S, whose eigenvalues are the sums of two stretches, and column k
/// of T the turn R [e_k]×. Where such a sum is 0 there is no derivative; it is kept from 0.
Mat9 compute_rotation_slope(const Mat3& f, const Polar& polar) {
  constexpr double kLeast = 1e-6;
  const Mat3 s = polar.rotation.transpose() * f;
  const Mat3 sums = polar.trace * Mat3::Identity() - 0.5 * (s + s.transpose());
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(sums);
  const Vec3 inverse = solver.eigenvalues().cwiseMax(kLeast).cwiseInverse();
  Eigen::Matrix<double, 9, 3> turns;
  for (int k = 0; k < 3; ++k) {
    turns.col(k) = stack(polar.rotation * cross_matrix(Mat3::Identity().col(k)));
  }
  const Eigen::Matrix<double, 9, 3> along = turns * solver.eigenvectors();
  return along * inverse.asDiagonal() * along.transpose();
}

Mat9 clamp_eigenvalues(const Mat9& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat9> solver(symmetric);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

std::vector<bool> mark_free(const TissueModel& model) {
  std::vector<bool> free(model.rest_position.size(), true);
  for (const int i : model.fixed) free[static_cast<std::size_t>(i)] = false;
  return free;
}

/// Sums V Bᵀ H B over tetrahedra, with H = `compute(t, F)` and B the nine slopes of F in the
/// corners: block (p, q) is the sum of g_p(b) g_q(d) H_bd over pairs of columns of F.
template <class Compute>
SparseMatrix assemble(const TissueModel& model, const Hyperelastic& table, std::span<const Vec3> x,
                      Compute compute) {
  const std::vector<bool> free = mark_free(model);
  const auto at = [x](int i) noexcept -> const Vec3& { return x[i]; };
  Entries entries;
  entries.reserve(144 * table.corners.size());
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(table, t, model.rest_position);
    const Mat9 h = compute(t, compute_deformation(tetrahedron, model.rest_position, at));
    Eigen::Matrix<double, 9, 12> b = Eigen::Matrix<double, 9, 12>::Zero();
    for (int k = 0; k < 12; ++k) {
      for (int c = 0; c < 3; ++c) b(3 * c + k % 3, k) = tetrahedron.slopes(c, k / 3);
    }
    const Eigen::Matrix<double, 12, 12> k = b.transpose() * h * b / tetrahedron.volume;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j) {
        const int one = tetrahedron.corners[i / 3], two = tetrahedron.corners[j / 3];
        if (free[one] && free[two]) entries.emplace_back(3 * one + i % 3, 3 * two + j % 3, k(i, j));
      }
    }
  }
  const Eigen::Index size = 3 * particle_count(model);
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Of the means: the rows dJ_a/dx, with s/4 lambda_a V_a along each, and in every tetrahedron the
/// pressure s/4 lambda_a (J_a - 1) of all its particles, which turns with its faces.
struct Means {
  Means(const TissueModel& model, const Hyperelastic& table, std::span<const Vec3> x);

  SparseMatrix stiffness;
  std::vector<double> pressure;  // [Pa] per tetrahedron
};

Means::Means(const TissueModel& model, const Hyperelastic& table, std::span<const Vec3> x)
    : pressure(table.corners.size(), 0.0) {
  const std::vector<bool> free = mark_free(model);
  const auto count = static_cast<Eigen::Index>(model.rest_position.size());
  const auto at = [x](int i) noexcept -> const Vec3& { return x[i]; };
  Entries entries;
  Eigen::VectorXd along = Eigen::VectorXd::Zero(count);
  for_each_mean(table, model.rest_position, at, [&](std::size_t i, const MeanVolume& mean) {
    const auto row = static_cast<Eigen::Index>(i);
    const double share = 0.25 * table.nodal_share * mean.lame;
    along[row] = share * mean.rest;
    for (const int t : list_around(table, i)) {
      const auto& [a, b, c, d] = table.corners[t];
      const Mat34 slopes = compute_volume_slopes(x[a], x[b], x[c], x[d]);
      pressure[t] += share * mean.swell;
      for (int k = 0; k < 4; ++k) {
        const int j = table.corners[t][k];
        if (!free[j]) continue;
        for (int axis = 0; axis < 3; ++axis) {
          entries.emplace_back(row, 3 * j + axis, slopes(axis, k) / mean.rest);
        }
      }
    }
  });
  SparseMatrix slopes(count, 3 * count);
  slopes.setFromTriplets(entries.begin(), entries.end());
  stiffness = SparseMatrix(slopes.transpose()) * (along.asDiagonal() * slopes);
}

template <class Density>
SparseMatrix compute(const TissueModel& model, const Hyperelastic& table, std::span<const Vec3> x,
                     Projection projection) {
  const Means means(model, table, x);
  SparseMatrix stiffness = assemble(model, table, x, [&](std::size_t t, const Mat3& f) -> Mat9 {
    Mat9 h = Density::compute_tangent(f, find_moduli(table, t));
    if (means.pressure[t] != 0.0) h += means.pressure[t] * compute_turning(f);
    return projection == Projection::none ? h : clamp_eigenvalues(h);
  });
  if (table.nodal_share > 0.0) stiffness += means.stiffness;
  return stiffness;
}

}  // namespace

/// 2 mu + lambda R Rᵀ + (lambda (tr S - 3) - 2 mu) dR/dF, all on nine.
Mat9 Corotated::compute_tangent(const Mat3& f, const Moduli& moduli) {
  const Polar polar = compute_polar(f);
  const Vec9 r = stack(polar.rotation);
  const double turn = moduli.lame * (polar.trace - 3.0) - 2.0 * moduli.shear;
  return 2.0 * moduli.shear * Mat9::Identity() + moduli.lame * r * r.transpose() +
         turn * compute_rotation_slope(f, polar);
}

/// 4/3 mu (I/(I + 1) + 2 F Fᵀ/(I + 1)²) + k cof F cof Fᵀ + (k (J - 1) - mu) d²J/dF², all on nine.
Mat9 NeoHookean::compute_tangent(const Mat3& f, const Moduli& moduli) {
  const double square = f.squaredNorm(), more = square + 1.0, bulk = find_bulk(moduli);
  const Vec9 all = stack(f), cofactor = stack(compute_cofactor(f));
  return 4.0 / 3.0 * moduli.shear *
             (square / more * Mat9::Identity() + 2.0 / (more * more) * all * all.transpose()) +
         bulk * cofactor * cofactor.transpose() +
         (bulk * (f.determinant() - 1.0) - moduli.shear) * compute_turning(f);
}

SparseMatrix compute_corotated_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                         Projection projection) {
  return compute<Corotated>(model, model.corotated, x, projection);
}

SparseMatrix compute_neo_hookean_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                           Projection projection) {
  return compute<NeoHookean>(model, model.neo_hookean, x, projection);
}

/// dP_v/dF' takes F' to eta F (FᵀF' + F'ᵀF), column by column.
SparseMatrix compute_viscous_damping(const TissueModel& model, const Hyperelastic& table,
                                     std::span<const Vec3> x) {
  return assemble(model, table, x, [&](std::size_t t, const Mat3& f) {
    Mat9 h;
    for (int k = 0; k < 9; ++k) {
      Mat3 rate = Mat3::Zero();
      rate(k % 3, k / 3) = 1.0;
      const Mat3 turned = f.transpose() * rate;
      h.col(k) = stack(table.viscosity[t] * f * (turned + turned.transpose()));
    }
    return h;
  });
}

}  // namespace palpate
