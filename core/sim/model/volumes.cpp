// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

namespace {

/// Fills in a table's `first_around` and `around` from its corners.
template <class Table>
void find_around(int particle_count, Table& table) {
  if (table.corners.empty()) return;
  table.first_around.assign(static_cast<std::size_t>(particle_count) + 1, 0);
  for (const auto& row : table.corners) {
    for (const int i : row) ++table.first_around[static_cast<std::size_t>(i) + 1];
  }
  for (std::size_t i = 1; i < table.first_around.size(); ++i) {
    table.first_around[i] += table.first_around[i - 1];
  }
  table.around.resize(4 * table.corners.size());
  std::vector<int> next = table.first_around;
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    for (const int i : table.corners[t]) {
      table.around[static_cast<std::size_t>(next[static_cast<std::size_t>(i)]++)] =
          static_cast<int>(t);
    }
  }
}

}  // namespace

Volumes build_volumes(int particle_count, std::vector<std::array<int, 4>> corners,
                      std::vector<double> rest_volume, std::vector<double> bulk,
                      double nodal_share) {
  Volumes volumes{std::move(corners), std::move(rest_volume), std::move(bulk), {}, {}, nodal_share};
  find_around(particle_count, volumes);
  return volumes;
}

Elastic build_elastic(int particle_count, std::vector<std::array<int, 4>> corners,
                      std::vector<double> lame, std::vector<double> shear, double nodal_share,
                      double damping_time) {
  Elastic elastic;
  elastic.corners = std::move(corners);
  elastic.lame = std::move(lame);
  elastic.shear = std::move(shear);
  elastic.nodal_share = nodal_share;
  elastic.damping_time = damping_time;
  find_around(particle_count, elastic);
  return elastic;
}

Hyperelastic build_hyperelastic(int particle_count, std::vector<std::array<int, 4>> corners,
                                std::vector<double> lame, std::vector<double> shear,
                                std::vector<double> viscosity, double nodal_share) {
  Hyperelastic table;
  table.corners = std::move(corners);
  table.lame = std::move(lame);
  table.shear = std::move(shear);
  table.viscosity = std::move(viscosity);
  table.nodal_share = nodal_share;
  find_around(particle_count, table);
  return table;
}

void move_skin(const Skin& skin, std::span<const Vec3> x, std::span<Vec3> surface) noexcept {
  for (std::size_t v = 0; v < skin.corners.size(); ++v) {
    const auto& [a, b, c, d] = skin.corners[v];
    const auto& w = skin.weights[v];
    surface[v] = w[0] * x[a] + w[1] * x[b] + w[2] * x[c] + w[3] * x[d];
  }
}

Vec3Array compute_surface(const TissueModel& model, std::span<const Vec3> x) {
  if (model.skin.corners.empty()) return {x.begin(), x.end()};
  Vec3Array surface(model.skin.corners.size());
  move_skin(model.skin, x, surface);
  return surface;
}

/// A is no larger than the diagonal matrix of its row sums of absolute values, by Gershgorin.
std::vector<double> compute_surface_mass(const TissueModel& model) {
  const Skin& skin = model.skin;
  if (skin.corners.empty()) return model.mass;
  std::vector<double> carried(model.mass.size(), 0.0), mass;
  for (std::size_t v = 0; v < skin.corners.size(); ++v) {
    for (std::size_t k = 0; k < 4; ++k) carried[skin.corners[v][k]] += std::abs(skin.weights[v][k]);
  }
  mass.reserve(skin.corners.size());
  for (std::size_t v = 0; v < skin.corners.size(); ++v) {
    double compliance = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const int i = skin.corners[v][k];
      compliance += std::abs(skin.weights[v][k]) * carried[i] / model.mass[i];
    }
    mass.push_back(1.0 / compliance);
  }
  return mass;
}

}  // namespace palpate
