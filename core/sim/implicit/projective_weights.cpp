// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/implicit/private/projective_weights.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/private/elastic_law.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/prism_law.h"
#include "palpate/sim/dynamics/private/side_hessian.h"

namespace palpate {
namespace {

/// Collects w |difference|² between free particles.
class Weights {
 public:
  explicit Weights(const TissueModel& model) : free_(model.rest_position.size(), true) {
    for (const int i : model.fixed) free_[static_cast<std::size_t>(i)] = false;
  }

  void add(int i, int j, double weight) {
    if (free_[static_cast<std::size_t>(i)] && free_[static_cast<std::size_t>(j)]) {
      entries_.emplace_back(i, j, weight);
    }
  }

  void add_pair(int i, int j, double weight) {
    add(i, i, weight);
    add(j, j, weight);
    add(i, j, -weight);
    add(j, i, -weight);
  }

  /// w V |dF|² of a tetrahedron, w [Pa].
  void add_gradient(const RestTetrahedron& tetrahedron, double weight) {
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) {
        const double product = tetrahedron.slopes.col(k).dot(tetrahedron.slopes.col(l));
        add(tetrahedron.corners[k], tetrahedron.corners[l], weight * product / tetrahedron.volume);
      }
    }
  }

  Eigen::SparseMatrix<double> build() const {
    const auto size = static_cast<Eigen::Index>(free_.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }

  void add_diagonal(int i, double weight) { entries_.emplace_back(i, i, weight); }
  bool is_free(int i) const { return free_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<bool> free_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// k (|d| - L)²/2 is k/2 times the squared distance of d from a sphere: k bounds it everywhere.
void add_links(const Links& links, const std::vector<double>& stiffness, double stiffer, double dt,
               Weights& weights) {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    const auto [i, j] = links.ends[l];
    weights.add_pair(i, j, stiffer * std::max(stiffness[l], 0.0) + links.damping[l] / dt);
  }
}

/// Of the Hessian H in the sides of a triangle at rest, sum of |H_cd| over d bounds side c
/// (Gershgorin).
void add_angles(const TissueModel& model, const SharedBonds& shared, double stiffer,
                Weights& weights) {
  const Angles& angles = model.angles;
  for (std::size_t t = 0; t < angles.corners.size(); ++t) {
    PerSide<Dual> length;
    for (int c = 0; c < 3; ++c) length[c] = Dual(angles.rest_length[t][c], Vec3::Unit(c));
    const PerSide<Dual> tension = compute_angle_tensions(
        AngleRow(angles, t), length, invert_lengths(angles.rest_length[t], length));
    for (int c = 0; c < 3; ++c) {
      Vec3 row = tension[c].slope;
      row[c] += shared.share[t][static_cast<std::size_t>(c)];
      weights.add_pair(angles.corners[t][(c + 1) % 3], angles.corners[t][(c + 2) % 3],
                       stiffer * row.cwiseAbs().sum());
    }
  }
}

/// (|d1| - |d2|)² <= 2 |d1|² + 2 |d2|²
void add_prisms(const Prisms& prisms, double dt, Weights& weights) {
  for (std::size_t p = 0; p < prisms.corners.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      const PrismSide side(prisms.corners[p], c);
      const double weight = 2.0 * (prisms.shear_stiffness[p][c] + prisms.shear_damping[p][c] / dt);
      weights.add_pair(side.ends[0], side.ends[1], weight);
      weights.add_pair(side.ends[2], side.ends[3], weight);
    }
  }
}

/// [Pa] What resists the volume of each tetrahedron: its own part, and of the nodal share the mean
/// of the means around its corners, which by Jensen bounds theirs.
template <class Table>
std::vector<double> find_bulk(const Table& table, const std::vector<double>& bulk,
                              std::span<const Vec3> rest) {
  std::vector<double> volume(rest.size(), 0.0), total(rest.size(), 0.0), found;
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const double part = RestTetrahedron(table, t, rest).volume;
    for (const int corner : table.corners[t]) {
      volume[static_cast<std::size_t>(corner)] += part;
      total[static_cast<std::size_t>(corner)] += part * bulk[t];
    }
  }
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    double mean = 0.0;
    for (const int corner : table.corners[t]) {
      const auto i = static_cast<std::size_t>(corner);
      mean += 0.25 * total[i] / volume[i];
    }
    found.push_back((1.0 - table.nodal_share) * bulk[t] + table.nodal_share * mean);
  }
  return found;
}

/// lambda (dJ)² <= 3 lambda |dF|² at rest, where dJ = tr dF; 2 mu |dF|² for the rest of Hooke's
/// law.
void add_solids(const TissueModel& model, double dt, Weights& weights) {
  const Vec3Array& rest = model.rest_position;
  const Volumes& volumes = model.volumes;
  const std::vector<double> bulk = find_bulk(volumes, volumes.bulk, rest);
  for (std::size_t t = 0; t < volumes.corners.size(); ++t) {
    weights.add_gradient(RestTetrahedron(volumes, t, rest), 3.0 * bulk[t]);
  }
  const Elastic& elastic = model.elastic;
  const std::vector<double> linear = find_bulk(elastic, elastic.lame, rest);
  const double stiffer = 1.0 + elastic.damping_time / dt;
  for (std::size_t t = 0; t < elastic.corners.size(); ++t) {
    weights.add_gradient(RestTetrahedron(elastic, t, rest),
                         stiffer * (2.0 * elastic.shear[t] + 3.0 * linear[t]));
  }
  for (const Hyperelastic* table : {&model.corotated, &model.neo_hookean}) {
    const std::vector<double> lame = find_bulk(*table, table->lame, rest);
    for (std::size_t t = 0; t < table->corners.size(); ++t) {
      weights.add_gradient(RestTetrahedron(*table, t, rest),
                           2.0 * table->shear[t] + 3.0 * lame[t] + 2.0 * table->viscosity[t] / dt);
    }
  }
}

}  // namespace

Eigen::SparseMatrix<double> compute_projective_matrix(const TissueModel& model, double dt) {
  Weights weights(model);
  const double stiffer = 1.0 + model.maxwell.ratio;
  const SharedBonds shared(model.bonds, model.angles);
  add_links(model.springs, model.springs.stiffness, stiffer, dt, weights);
  add_links(model.bonds, shared.remainder, stiffer, dt, weights);
  add_angles(model, shared, stiffer, weights);
  add_prisms(model.prisms, dt, weights);
  add_solids(model, dt, weights);
  for (int i = 0; i < particle_count(model); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double inertia = (1.0 + dt * model.drag) * model.mass[at] / (dt * dt);
    const double home = model.home.empty() ? 0.0 : model.home[at];
    weights.add_diagonal(i, weights.is_free(i) ? inertia + home : 1.0);
  }
  return weights.build();
}

}  // namespace palpate
