// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/definiteness.h"
#include "palpate/sim/model/membrane.h"
#include "palpate/sim/model/private/surface_particles.h"

namespace palpate {
namespace {

/// H of every triangle [N/m], local scale included.
std::vector<Mat3> compute_targets(const SurfaceMesh& mesh, const Material& material,
                                  const std::vector<double>& scale) {
  std::vector<Mat3> targets = compute_membrane_stiffnesses(mesh, material);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    targets[t] *= compute_local_scale(scale, mesh.triangles[t]);
  }
  return targets;
}

/// Row c is the direction that side c pulls its two ends in, as nine coordinates of the corners.
Eigen::Matrix<double, 3, 9> compute_pulls(const std::array<Vec3, 3>& corners) {
  Eigen::Matrix<double, 3, 9> rows = Eigen::Matrix<double, 3, 9>::Zero();
  for (int c = 0; c < 3; ++c) {
    const int p = (c + 1) % 3, q = (c + 2) % 3;
    const Vec3 n = (corners[p] - corners[q]).normalized();
    rows.block<1, 3>(c, 3 * p) = n.transpose();
    rows.block<1, 3>(c, 3 * q) = -n.transpose();
  }
  return rows;
}

/// The k >= 0 that make |Bᵀ (H - diag k) B| least. With M = B Bᵀ the normal equations are
/// sum_j M_ij² k_j = (M H M)_ii; what comes out negative is left out and the rest solved again.
Vec3 fit_springs(const Mat3& target, const std::array<Vec3, 3>& corners) {
  const Eigen::Matrix<double, 3, 9> b = compute_pulls(corners);
  const Mat3 m = b * b.transpose();
  Mat3 system = m.cwiseProduct(m);
  Vec3 right = (m * target * m).diagonal();
  Vec3 k = system.fullPivLu().solve(right);
  for (int round = 0; round < 3 && k.minCoeff() < 0.0; ++round) {
    for (int c = 0; c < 3; ++c) {
      if (k[c] >= 0.0) continue;
      system.row(c).setZero();
      system.col(c).setZero();
      system(c, c) = 1.0;
      right[c] = 0.0;
    }
    k = system.fullPivLu().solve(right);
  }
  return k.cwiseMax(0.0);
}

/// [N/m] what a triangle gives to the springs along its sides.
Vec3 share_springs(const Mat3& target, const std::array<Vec3, 3>& corners, double modulus,
                   SpringRule rule) {
  if (rule == SpringRule::lloyd) return fit_springs(target, corners);
  const double area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  Vec3 share;
  for (int c = 0; c < 3; ++c) {
    share[c] = modulus * area / (corners[(c + 1) % 3] - corners[(c + 2) % 3]).squaredNorm();
  }
  return share;
}

/// Solves for the K_btheta and the bond shares that give `target` beside the angles of a row: the
/// off-diagonal terms are linear in the three K_btheta, the bonds take up the diagonal
/// [laws: membrane].
void fit_triangle(const Mat3& target, int row, Angles& angles) {
  angles.bond_share[row] = angles.stretch_coupling[row] = {0.0, 0.0, 0.0};
  const Mat3 missing = target - compute_rest_stiffness(angles, row);
  const std::array<double, 3> bend = angles.bend_stiffness[row];
  angles.bend_stiffness[row] = {0.0, 0.0, 0.0};
  Mat3 system;
  for (int c = 0; c < 3; ++c) {
    angles.stretch_coupling[row] = {0.0, 0.0, 0.0};
    angles.stretch_coupling[row][c] = 1.0;
    const Mat3 part = compute_rest_stiffness(angles, row);
    system.col(c) = Vec3(part(1, 2), part(2, 0), part(0, 1));
  }
  const Vec3 coupling = system.fullPivLu().solve(Vec3(missing(1, 2), missing(2, 0), missing(0, 1)));
  angles.stretch_coupling[row] = {coupling[0], coupling[1], coupling[2]};
  angles.bend_stiffness[row] = bend;
  const Vec3 share = (target - compute_rest_stiffness(angles, row)).diagonal();
  angles.bond_share[row] = {share[0], share[1], share[2]};
}

/// One row of Eq 10's slopes: the bond's k' on the diagonal and K10 times `slopes`.
struct Eq10Row {
  double bond, bend;

  double square(const Vec3& target, const Vec3& slopes, int c) const {
    return (target - bend * slopes - bond * Vec3::Unit(c)).squaredNorm();
  }
};

/// K10 alone fits the two terms off the diagonal, and the bond takes up what is on it.
Eq10Row fit_eq10_row(const Vec3& target, const Vec3& slopes, int c) {
  const int i = (c + 1) % 3, j = (c + 2) % 3;
  const double square = slopes[i] * slopes[i] + slopes[j] * slopes[j];
  const double bend = (target[i] * slopes[i] + target[j] * slopes[j]) / square;
  return {target[c] - bend * slopes[c], bend};
}

/// The same with a bond that pulls and an angle that does not push the wrong way.
Eq10Row fit_eq10_row_within_bounds(const Vec3& target, const Vec3& slopes, int c) {
  constexpr double kLeastBond = 0.01;  // of what the side must resist
  const double least = kLeastBond * target[c];
  Eq10Row best = fit_eq10_row(target, slopes, c);
  if (best.bond >= least && best.bend >= 0.0) return best;
  best = {target[c], 0.0};
  const double bend = (target - least * Vec3::Unit(c)).dot(slopes) / slopes.squaredNorm();
  const Eq10Row weak_bond = {least, std::max(bend, 0.0)};
  return weak_bond.square(target, slopes, c) < best.square(target, slopes, c) ? weak_bond : best;
}

/// The Eq 10 constants whose slopes, diag(k') - diag(K10) G, come nearest to `target`; where those
/// let the triangle give way, the nearest that keep to bounds under which none does.
void fit_eq10(const Mat3& target, int row, Angles& angles) {
  angles.bond_share[row] = angles.stretch_coupling[row] = {0.0, 0.0, 0.0};
  angles.bend_stiffness[row] = {1.0, 1.0, 1.0};
  const Mat3 slopes = compute_rest_slopes(angles, row, AngleLaw::eq10);
  for (const auto& fit : {fit_eq10_row, fit_eq10_row_within_bounds}) {
    for (int c = 0; c < 3; ++c) {
      const Eq10Row found = fit(target.row(c).transpose(), slopes.row(c).transpose(), c);
      angles.bond_share[row][c] = found.bond;
      angles.bend_stiffness[row][c] = found.bend;
    }
    const Mat3 fitted = compute_rest_slopes(angles, row, AngleLaw::eq10);
    if (is_positive_definite(0.5 * (fitted + fitted.transpose()))) return;
  }
}

void check_bend(double bend_stiffness, AngleLaw law) {
  if (law == AngleLaw::eq10 && bend_stiffness != 0.0) {
    refuse("membrane: bend_stiffness", write_text(bend_stiffness, " J"),
           "0 under AngleLaw::eq10, whose constants follow from the material");
  }
  if (!(std::isfinite(bend_stiffness) && bend_stiffness >= 0.0)) {
    refuse("membrane: bend_stiffness", write_text(bend_stiffness, " J"), "0 or a positive number");
  }
}

}  // namespace

TissueModel build_membrane_springs(const SurfaceMesh& mesh, const Material& material,
                                   SpringRule rule, const SurfaceOptions& options) {
  TissueModel model = build_surface_particles(mesh, material, options);
  const Topology topology = build_topology(mesh.triangles);
  const std::vector<Mat3> targets = compute_targets(mesh, material, options.stiffness_scale);
  std::vector<double> stiffness(topology.edges.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [i, j, k] = mesh.triangles[t];
    const double modulus = material.young_modulus * *material.wall_thickness *
                           compute_local_scale(options.stiffness_scale, mesh.triangles[t]);
    const Vec3 share = share_springs(
        targets[t], {mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]}, modulus, rule);
    for (int c = 0; c < 3; ++c) stiffness[topology.triangle_edges[t][c]] += share[c];
  }
  model.springs =
      build_edge_links(model, topology.edges, std::move(stiffness), material.damping_ratio);
  validate(model);
  return model;
}

TissueModel build_membrane_molecular(const SurfaceMesh& mesh, const Material& material,
                                     double bend_stiffness, AngleLaw angle_law,
                                     const SurfaceOptions& options) {
  check_bend(bend_stiffness, angle_law);
  TissueModel model = build_surface_particles(mesh, material, options);
  const Topology topology = build_topology(mesh.triangles);
  const std::vector<Mat3> targets = compute_targets(mesh, material, options.stiffness_scale);
  model.angle_law = angle_law;
  model.angles = build_rest_angles(mesh);
  const std::array<double, 3> bend = {bend_stiffness, bend_stiffness, bend_stiffness};
  model.angles.bend_stiffness.assign(mesh.triangles.size(), bend);
  model.angles.stretch_coupling.resize(mesh.triangles.size());
  model.angles.bond_share.resize(mesh.triangles.size());
  std::vector<double> damped_as(topology.edges.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto row = static_cast<int>(t);
    angle_law == AngleLaw::gradient ? fit_triangle(targets[t], row, model.angles)
                                    : fit_eq10(targets[t], row, model.angles);
    // a side is damped as what its triangles resist its lengthening with: bonds may be negative
    for (int c = 0; c < 3; ++c) damped_as[topology.triangle_edges[t][c]] += targets[t](c, c);
  }
  model.bonds = build_edge_links(model, topology.edges, sum_bond_shares(model.angles, topology),
                                 material.damping_ratio, damped_as);
  validate(model);
  return model;
}

Angles convert_to_eq10(const Angles& angles) {
  Angles converted = angles;
  for (int row = 0; row < static_cast<int>(angles.corners.size()); ++row) {
    fit_eq10(compute_rest_stiffness(angles, row), row, converted);
  }
  return converted;
}

std::vector<double> compute_eq10_residuals(const Angles& angles) {
  const Angles converted = convert_to_eq10(angles);
  std::vector<double> residuals;
  for (int row = 0; row < static_cast<int>(angles.corners.size()); ++row) {
    const Mat3 wanted = compute_rest_stiffness(angles, row);
    const Mat3 found = compute_rest_slopes(converted, row, AngleLaw::eq10);
    residuals.push_back((found - wanted).norm() / wanted.norm());
  }
  return residuals;
}

}  // namespace palpate
