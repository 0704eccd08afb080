// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/tangent.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/private/dual.h"
#include "palpate/sim/dynamics/private/law_tangents.h"
#include "palpate/sim/dynamics/private/laws.h"
#include "palpate/sim/dynamics/private/side_hessian.h"
#include "palpate/sim/dynamics/private/tensions.h"

namespace palpate {
namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;
using Mat93 = Eigen::Matrix<double, 9, 3>;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Collects 3x3 blocks between free particles.
class Assembly {
 public:
  Assembly(const TissueModel& model, std::size_t block_count)
      : size_(3 * particle_count(model)), free_(model.rest_position.size(), true) {
    for (const int i : model.fixed) free_[static_cast<std::size_t>(i)] = false;
    entries_.reserve(9 * block_count);
  }

  void add(int i, int j, const Mat3& block) {
    if (!free_[static_cast<std::size_t>(i)] || !free_[static_cast<std::size_t>(j)]) return;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        entries_.emplace_back(3 * i + row, 3 * j + column, block(row, column));
      }
    }
  }

  void add_link(const std::array<int, 2>& ends, const Mat3& block) {
    add(ends[0], ends[0], block);
    add(ends[1], ends[1], block);
    add(ends[0], ends[1], -block);
    add(ends[1], ends[0], -block);
  }

  SparseMatrix build() const {
    SparseMatrix matrix(size_, size_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }

 private:
  int size_;
  std::vector<bool> free_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// The direction of a link, zero where it is too short to have one.
Vec3 find_direction(const Vec3& d, double length, double rest_length) {
  return length <= kNoDirection * rest_length ? Vec3(Vec3::Zero()) : Vec3(d / length);
}

/// K_ii = k n nᵀ + (k (l - L)/l) (I - n nᵀ), K_ij = -K_ii: exact, or with both parts clamped at 0,
/// which needs no eigenvalues [laws: link]. `stiffness` stands in for that of the links.
void add_links(const Links& links, const std::vector<double>& stiffness, std::span<const Vec3> x,
               Projection projection, Assembly& assembly) {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto [i, j] = links.ends[l];
    const Vec3 d = x[j] - x[i];
    const double length = d.norm(), rest = links.rest_length[l];
    // no direction, no force; the entries stay, so that every tangent has the same pattern
    const bool directed = length > kNoDirection * rest;
    const Vec3 n = find_direction(d, length, rest);
    double along = stiffness[l], across = directed ? stiffness[l] * (length - rest) / length : 0.0;
    if (projection == Projection::positive_semidefinite) {
      along = std::max(along, 0.0);
      across = std::max(across, 0.0);
    }
    const Mat3 nn = n * n.transpose();
    assembly.add_link(links.ends[l], along * nn + across * (Mat3::Identity() - nn));
  }
}

/// A triangle's sides in space: lengths, and the directions x_p - x_q that a side pulls along.
struct Sides {
  Sides(const Triangle& corners, std::span<const Vec3> x) {
    for (int c = 0; c < 3; ++c) {
      const int p = (c + 1) % 3, q = (c + 2) % 3;
      vector[c] = x[corners[p]] - x[corners[q]];
      length[c] = vector[c].norm();
      unit[c] = length[c] > 0.0 ? Vec3(vector[c] / length[c]) : Vec3(Vec3::Zero());
    }
  }

  /// The lengths, each a variable to be differentiated by.
  PerSide<Dual> variables() const {
    return {Dual(length[0], Vec3::UnitX()), Dual(length[1], Vec3::UnitY()),
            Dual(length[2], Vec3::UnitZ())};
  }

  PerSide<Vec3> vector, unit;
  PerSide<double> length;
};

/// Adds `block` to the 3x3 blocks that a force along side c, +1 at one end, -1 at the other, has.
void add_side(int c, const Mat3& block, Mat9& k) {
  const int p = 3 * ((c + 1) % 3), q = 3 * ((c + 2) % 3);
  k.block<3, 3>(p, p) += block;
  k.block<3, 3>(q, q) += block;
  k.block<3, 3>(p, q) -= block;
  k.block<3, 3>(q, p) -= block;
}

/// Column c holds the given vector of side c at its one end and the opposite at the other.
Mat93 spread(const PerSide<Vec3>& vectors) {
  Mat93 columns = Mat93::Zero();
  for (int c = 0; c < 3; ++c) {
    columns.block<3, 1>(3 * ((c + 1) % 3), c) = vectors[c];
    columns.block<3, 1>(3 * ((c + 2) % 3), c) = -vectors[c];
  }
  return columns;
}

/// The sides pull with s_c (x_p - x_q), s = tau/l a function of the three lengths, so
///
///     K = sum of s_c g_c g_cᵀ  +  sum over c, j of (ds_c/dl_j) g_c (x_p - x_q) (g_j n_j)ᵀ
///
/// where g_c is +I at p and -I at q: exact for every law and guard that the kernels have.
template <class Tensions>
Mat9 compute_exact(const Angles& angles, std::size_t row, const Sides& sides,
                   Tensions compute_tensions) {
  const PerSide<Dual> length = sides.variables();
  const Divisors<Dual> by = invert_lengths(angles.rest_length[row], length);
  const PerSide<Dual> tension = compute_tensions(AngleRow(angles, row), length, by);
  Mat3 slopes;
  Mat9 k = Mat9::Zero();
  for (int c = 0; c < 3; ++c) {
    const Dual pull = tension[c] * by.direction[c];
    slopes.row(c) = pull.slope.transpose();
    add_side(c, pull.value * Mat3::Identity(), k);
  }
  k += spread(sides.vector) * slopes * spread(sides.unit).transpose();
  return k;
}

/// K = Bᵀ H B + sum of tau/l (I - n nᵀ) with the eigenvalues of the 3x3 Hessian H in the lengths
/// and the tensions clamped at 0 [laws: tension]: no 9x9 eigenvalues. `energetic` are the angles
/// that H is taken of, `tension` what the sides pull with.
Mat9 compute_projected(const Angles& energetic, std::size_t row, const Sides& sides,
                       const PerSide<double>& share, PerSide<double> tension) {
  const PerSide<Dual> length = sides.variables();
  const PerSide<double>& rest = energetic.rest_length[row];
  const PerSide<Dual> slopes =
      compute_angle_tensions(AngleRow(energetic, row), length, invert_lengths(rest, length));
  const PerSide<double> inverse = invert_lengths(rest, sides.length).direction;
  Mat3 hessian;
  Mat9 k = Mat9::Zero();
  for (int c = 0; c < 3; ++c) {
    hessian.row(c) = slopes[c].slope.transpose();
    tension[c] += share[c] * (sides.length[c] - rest[c]);
    const Mat3 across = Mat3::Identity() - sides.unit[c] * sides.unit[c].transpose();
    add_side(c, std::max(tension[c], 0.0) * inverse[c] * across, k);
  }
  hessian = (0.5 * (hessian + hessian.transpose())).eval();
  hessian.diagonal() += Vec3(share[0], share[1], share[2]);
  const Mat93 b = spread(sides.unit);
  k += b * clamp_eigenvalues(hessian) * b.transpose();
  return k;
}

void add_triangle(const Triangle& corners, const Mat9& k, Assembly& assembly) {
  for (int p = 0; p < 3; ++p) {
    for (int q = 0; q < 3; ++q) assembly.add(corners[p], corners[q], k.block<3, 3>(3 * p, 3 * q));
  }
}

/// Eq 10 has no Hessian to project. Its stand-in is the angle energy that equals it to first order
/// in an equilateral triangle, K_theta = K10 l / 1.5 with l the mean side [laws: eq10].
Angles build_energetic(const TissueModel& model) {
  Angles angles = model.angles;
  if (model.angle_law == AngleLaw::gradient) return angles;
  for (std::size_t t = 0; t < angles.corners.size(); ++t) {
    const PerSide<double>& rest = angles.rest_length[t];
    const double mean = (rest[0] + rest[1] + rest[2]) / 3.0;
    for (double& stiffness : angles.bend_stiffness[t]) stiffness *= mean / 1.5;
  }
  return angles;
}

void add_angles_exactly(const TissueModel& model, std::span<const Vec3> x, Assembly& assembly) {
  const Angles& angles = model.angles;
  for (std::size_t t = 0; t < angles.corners.size(); ++t) {
    const Sides sides(angles.corners[t], x);
    const Mat9 k = model.angle_law == AngleLaw::gradient
                       ? compute_exact(angles, t, sides, compute_angle_tensions<Dual>)
                       : compute_exact(angles, t, sides, compute_eq10_tensions<Dual>);
    add_triangle(angles.corners[t], k, assembly);
  }
}

void add_angles_projected(const TissueModel& model, const SharedBonds& bonds,
                          std::span<const Vec3> x, Assembly& assembly) {
  const Angles& angles = model.angles;
  const Angles energetic = build_energetic(model);
  for (std::size_t t = 0; t < angles.corners.size(); ++t) {
    const Sides sides(angles.corners[t], x);
    const Divisors<double> by = invert_lengths(angles.rest_length[t], sides.length);
    const PerSide<double> tension =
        model.angle_law == AngleLaw::gradient
            ? compute_angle_tensions(AngleRow(angles, t), sides.length, by)
            : compute_eq10_tensions(AngleRow(angles, t), sides.length, by);
    const Mat9 k = compute_projected(energetic, t, sides, bonds.share[t], tension);
    add_triangle(angles.corners[t], k, assembly);
  }
}

}  // namespace

SparseMatrix compute_side_stiffness(const TissueModel& model, std::span<const Vec3> x,
                                    Projection projection, bool home) {
  const std::size_t link_count = model.springs.ends.size() + model.bonds.ends.size();
  Assembly assembly(model, 4 * link_count + 9 * model.angles.corners.size() + model.home.size());
  add_links(model.springs, model.springs.stiffness, x, projection, assembly);
  if (projection == Projection::none) {
    add_links(model.bonds, model.bonds.stiffness, x, projection, assembly);
    add_angles_exactly(model, x, assembly);
  } else {
    const SharedBonds shared(model.bonds, model.angles);
    add_links(model.bonds, shared.remainder, x, projection, assembly);
    add_angles_projected(model, shared, x, assembly);
  }
  for (int i = 0; home && i < static_cast<int>(model.home.size()); ++i) {
    assembly.add(i, i, model.home[static_cast<std::size_t>(i)] * Mat3::Identity());
  }
  return assembly.build();
}

SparseMatrix compute_stiffness(const TissueModel& model, std::span<const Vec3> x,
                               Projection projection) {
  SparseMatrix stiffness = compute_side_stiffness(model, x, projection, true);
  laws::for_each([&]<class Law>(Law) {
    if constexpr (requires { Law::compute_stiffness(model, x, projection); }) {
      if (!laws::is_present(model, Law::table)) return;
      stiffness += Law::compute_stiffness(model, x, projection);
    }
  });
  return stiffness;
}

/// C_ii = c n nᵀ (axis) or c I (isotropic), C_ij = -C_ii, and drag m_i I.
SparseMatrix compute_damping(const TissueModel& model, std::span<const Vec3> x) {
  const std::size_t link_count = model.springs.ends.size() + model.bonds.ends.size();
  Assembly assembly(model, 4 * link_count + model.mass.size());
  for (const Links* links : {&model.springs, &model.bonds}) {
    for (std::size_t l = 0; l < links->ends.size(); ++l) {
      const Vec3 d = x[links->ends[l][1]] - x[links->ends[l][0]];
      const Vec3 n = find_direction(d, d.norm(), links->rest_length[l]);
      const Mat3 shape =
          model.damping_law == DampingLaw::axis ? Mat3(n * n.transpose()) : Mat3(Mat3::Identity());
      assembly.add_link(links->ends[l], links->damping[l] * shape);
    }
  }
  for (int i = 0; i < particle_count(model); ++i) {
    assembly.add(i, i, model.drag * model.mass[static_cast<std::size_t>(i)] * Mat3::Identity());
  }
  SparseMatrix damping = assembly.build();
  laws::for_each([&]<class Law>(Law) {
    if constexpr (requires { Law::compute_damping(model, x); }) {
      if (laws::is_present(model, Law::table)) damping += Law::compute_damping(model, x);
    }
  });
  return damping;
}

}  // namespace palpate
