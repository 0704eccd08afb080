// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/lanczos.h"
#include "palpate/sim/dynamics/private/laws.h"
#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/dynamics/private/volume_law.h"
#include "palpate/sim/dynamics/step.h"

namespace palpate {
namespace {

void add_part(double length, double rest, Stretch& stretch) noexcept {
  const double part = length / rest;
  stretch.longest = std::max(stretch.longest, part);
  stretch.shortest = std::min(stretch.shortest, part);
}

/// How many times as stiff links are as they are alone.
double scale_links(const TissueModel& model) {
  double scale = 1.0;
  laws::for_each([&]<class Law>(Law) {
    if constexpr (requires { Law::scale_links(model); }) scale *= Law::scale_links(model);
  });
  return scale;
}

/// Links that hold in every direction as they do along: their K is the same for x, y and z.
double find_largest_of_taut_links(const TissueModel& model) {
  const int n = particle_count(model);
  std::vector<double> scale(static_cast<std::size_t>(n), 0.0);  // [1/sqrt(kg)] 0 for what is held
  for_each_free(model, [&](int i) {
    scale[static_cast<std::size_t>(i)] = 1.0 / std::sqrt(model.mass[static_cast<std::size_t>(i)]);
  });
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int i, int j, double k) {
    const double scaled =
        k * scale[static_cast<std::size_t>(i)] * scale[static_cast<std::size_t>(j)];
    if (scaled != 0.0) entries.emplace_back(i, j, scaled);
  };
  const double times = scale_links(model);
  for (const Links* links : {&model.springs, &model.bonds}) {
    for (std::size_t l = 0; l < links->ends.size(); ++l) {
      const auto [i, j] = links->ends[l];
      const double k = times * std::abs(links->stiffness[l]);
      add(i, i, k), add(j, j, k), add(i, j, -k), add(j, i, -k);
    }
  }
  for (int i = 0; i < static_cast<int>(model.home.size()); ++i) {
    add(i, i, model.home[static_cast<std::size_t>(i)]);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Largest largest =
      find_largest_eigenvalue(n, [&](const auto& v) -> Eigen::VectorXd { return matrix * v; });
  return largest.value + largest.residual;
}

/// The laws of a model that stiffen in one way, alone: no home springs, pressure or drag.
TissueModel keep_laws(const TissueModel& model, laws::Stiffens stiffens) {
  TissueModel kept = model;
  laws::for_each([&]<class Law>(Law) {
    if (Law::kStiffens == stiffens || Law::kStiffens == laws::Stiffens::as_the_others) return;
    kept.*Law::table.of = {};
  });
  kept.home.clear();
  kept.pressure = kept.drag = 0.0;
  return kept;
}

bool has_laws(const TissueModel& model, laws::Stiffens stiffens) {
  bool any = false;
  laws::for_each([&]<class Law>(Law) {
    any = any || (Law::kStiffens == stiffens && laws::is_present(model, Law::table));
  });
  return any;
}

/// Of Eq 9 and Eq 11, or Eq 10, and the shear of prisms, alone.
double find_largest_of_angles(const TissueModel& model) {
  if (!has_laws(model, laws::Stiffens::as_sides)) return 0.0;
  return estimate_spectrum(keep_laws(model, laws::Stiffens::as_sides)).stiffness;
}

/// The part of volumes that has `share` of the bulk, by tetrahedra (nodal_share 0) or means (1).
double find_largest_of_volumes(const TissueModel& model, double share, double nodal_share) {
  if (model.volumes.corners.empty() || share == 0.0) return 0.0;
  TissueModel alone = keep_laws(model, laws::Stiffens::as_volumes);
  for (double& bulk : alone.volumes.bulk) bulk *= share;
  alone.volumes.nodal_share = nodal_share;
  return estimate_spectrum(alone).stiffness;
}

/// How many times as stiff as at rest volumes are that are down to `part`, where lengths are up to
/// `longest`: the curvature of their law, and slopes that go with the area of faces.
double stiffen_volumes(double part, double longest) noexcept {
  return compute_volume_law(std::min(part, 1.0)).curvature * longest * longest;
}

/// visit(law) for those of tetrahedra at finite strain.
template <class Visit>
void for_each_strain(Visit visit) {
  laws::for_each([&]<class Law>(Law law) {
    if constexpr (Law::kStiffens == laws::Stiffens::as_strains) visit(law);
  });
}

/// Largest eigenvalue of M⁻¹ sum of V mu g_p·g_q over the tetrahedra of a table: mu |F|²/2 of any
/// F, which no less resists than shear does, the same for x, y and z.
double find_largest_of_shear(const TissueModel& model, const Hyperelastic& table) {
  if (table.corners.empty()) return 0.0;
  const int n = particle_count(model);
  std::vector<double> scale(static_cast<std::size_t>(n), 0.0);  // [1/sqrt(kg)]
  for_each_free(model, [&](int i) { scale[i] = 1.0 / std::sqrt(model.mass[i]); });
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(table, t, model.rest_position);
    for (int p = 0; p < 4; ++p) {
      for (int q = 0; q < 4; ++q) {
        const int i = tetrahedron.corners[p], j = tetrahedron.corners[q];
        const double k = table.shear[t] / tetrahedron.volume *
                         tetrahedron.slopes.col(p).dot(tetrahedron.slopes.col(q));
        entries.emplace_back(i, j, k * scale[i] * scale[j]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Largest largest =
      find_largest_eigenvalue(n, [&](const auto& v) -> Eigen::VectorXd { return matrix * v; });
  return largest.value + largest.residual;
}

/// Of what goes with areas: the means, and what the law itself has of J.
template <class Law>
double find_largest_of_faces(const TissueModel& model, double shear) {
  using Density = typename Law::Density;
  Hyperelastic table = model.*Law::table.of;
  if (table.corners.empty()) return 0.0;
  if (!Density::kAreaLame) {
    for (double& lame : table.lame) lame *= table.nodal_share;
    table.nodal_share = 1.0;
  }
  for (double& mu : table.shear) mu = 0.0;
  for (double& eta : table.viscosity) eta = 0.0;
  TissueModel alone;
  alone.rest_position = model.rest_position;
  alone.mass = model.mass;
  alone.fixed = model.fixed;
  alone.*Law::table.of = std::move(table);
  return estimate_spectrum(alone).stiffness + Density::kAreaShear * shear;
}

/// No eigenvalue of M⁻¹K exceeds the largest sum of the blocks in a row of K, over the mass: a
/// triangle has p/6 times its sides in each.
double bound_pressure(const TissueModel& model) {
  if (model.pressure == 0.0) return 0.0;
  const Vec3Array& x = model.rest_position;
  std::vector<double> rows(x.size(), 0.0);  // [N/m]
  for (const auto& [i, j, k] : model.triangles) {
    const double sides =
        measure_distance(x, i, j) + measure_distance(x, j, k) + measure_distance(x, k, i);
    for (const int corner : {i, j, k}) {
      rows[static_cast<std::size_t>(corner)] += std::abs(model.pressure) / 6.0 * sides;
    }
  }
  double largest = 0.0;
  for_each_free(model, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    largest = std::max(largest, rows[at] / model.mass[at]);
  });
  return largest;
}

/// Adds the principal stretches of every tetrahedron of a table, each under as much pressure of the
/// means around its particles as there is anywhere.
template <class Law>
void add_strains(const TissueModel& model, std::span<const Vec3> x, Stretch& stretch) noexcept {
  const Hyperelastic& table = model.*Law::table.of;
  const auto at = [x](int i) noexcept -> const Vec3& { return x[i]; };
  double swell = 0.0;
  for_each_mean(table, model.rest_position, at, [&](std::size_t, const MeanVolume& mean) noexcept {
    swell = std::max(swell, std::abs(mean.swell));
  });
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const RestTetrahedron tetrahedron(table, t, model.rest_position);
    const Mat3 f = compute_deformation(tetrahedron, model.rest_position, at);
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(f.transpose() * f, Eigen::EigenvaluesOnly);
    const Vec3 stretches = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    const double least = f.determinant() < 0.0 ? -stretches[0] : stretches[0];
    stretch.largest_face = std::max(stretch.largest_face, stretches[2] * stretches[1]);
    const double own = Law::Density::compute_stiffening({stretches[2], stretches[1], least},
                                                        find_moduli(table, t));
    const double of_means = table.nodal_share * table.lame[t] / table.shear[t] * swell;
    stretch.stiffening = std::max(stretch.stiffening, own + of_means * stretches[2]);
  }
}

}  // namespace

Stretch measure_stretch(const TissueModel& model, std::span<const Vec3> x,
                        const TornMask& torn) noexcept {
  const auto is_torn = [](std::span<const unsigned char> mask, std::size_t i) noexcept {
    return !mask.empty() && mask[i] != 0;
  };
  Stretch stretch;
  std::size_t link = 0;
  for (const Links* links : {&model.springs, &model.bonds}) {
    for (std::size_t l = 0; l < links->ends.size(); ++l) {
      if (is_torn(torn.links, link++)) continue;
      const auto [i, j] = links->ends[l];
      add_part(measure_distance(x, i, j), links->rest_length[l], stretch);
    }
  }
  for (std::size_t row = 0; row < model.angles.corners.size(); ++row) {
    if (is_torn(torn.triangles, row)) continue;
    const auto [i, j, k] = model.angles.corners[row];
    const auto& rest = model.angles.rest_length[row];
    add_part(measure_distance(x, j, k), rest[0], stretch);
    add_part(measure_distance(x, k, i), rest[1], stretch);
    add_part(measure_distance(x, i, j), rest[2], stretch);
  }
  for_each_strain([&]<class Law>(Law) { add_strains<Law>(model, x, stretch); });
  const Volumes& volumes = model.volumes;
  for (std::size_t t = 0; t < volumes.corners.size(); ++t) {
    const double part = measure_volume(volumes, t, x) / volumes.rest_volume[t];
    stretch.smallest_volume = std::min(stretch.smallest_volume, part);
  }
  if (!(volumes.nodal_share > 0.0)) return stretch;
  for (std::size_t i = 0; i + 1 < volumes.first_around.size(); ++i) {
    const VolumeAround around = measure_around(volumes, i, x);
    if (!(around.rest > 0.0)) continue;
    stretch.smallest_mean = std::min(stretch.smallest_mean, around.now / around.rest);
  }
  return stretch;
}

StretchSpectrum::StretchSpectrum(const TissueModel& model, double rest_in)
    : rest(rest_in),
      angles(find_largest_of_angles(model)),
      pressure(bound_pressure(model)),
      volumes(find_largest_of_volumes(model, 1.0 - model.volumes.nodal_share, 0.0)),
      means(find_largest_of_volumes(model, model.volumes.nodal_share, 1.0)) {
  for_each_strain([&]<class Law>(Law) {
    const double of_mu = find_largest_of_shear(model, model.*Law::table.of);
    shear += of_mu;
    faces += find_largest_of_faces<Law>(model, of_mu);
  });
  taut = std::max(rest, find_largest_of_taut_links(model) + angles + pressure + volumes + means);
}

/// A link of stiffness k that is s longer than at rest holds across with the tension over length,
///
///     k n n^T + k s/(1+s) (I - n n^T) = (1-b) k n n^T + b k I,   b = s/(1+s)
///
/// so that a whole tissue lies between rest (b = 0) and `taut` (b = 1); one that is shorter holds
/// less. Volumes stiffen as they are squeezed, tetrahedra at finite strain with the squares of
/// their areas and as their law says of shear. Gradients of angles go with 1/l, their part of K
/// with 1/l²; those of pressure with l. What is left out is how turned links come to lie and what
/// the torque of a bent angle adds; the bound held with both in every shape that was tried
/// (tests/core/dynamics/test_stretch.cpp).
double bound_stiffness(const StretchSpectrum& spectrum, const Stretch& stretch) noexcept {
  const double taut = 1.0 - 1.0 / stretch.longest;
  const double inverse = 1.0 / std::max(stretch.shortest, 0.5 * kBluntSide);
  return spectrum.rest + taut * (spectrum.taut - spectrum.rest) +
         (inverse * inverse - 1.0) * spectrum.angles + (stretch.longest - 1.0) * spectrum.pressure +
         (stiffen_volumes(stretch.smallest_volume, stretch.longest) - 1.0) * spectrum.volumes +
         (stiffen_volumes(stretch.smallest_mean, stretch.longest) - 1.0) * spectrum.means +
         stretch.stiffening * spectrum.shear +
         (stretch.largest_face * stretch.largest_face - 1.0) * spectrum.faces;
}

}  // namespace palpate
