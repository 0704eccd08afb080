// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/surface_particles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/private/check_options.h"

namespace palpate {
namespace {

void check_options(const SurfaceOptions& options, std::size_t vertex_count) {
  check_common_options(options, vertex_count);
  const double home = options.home_stiffness.value_or(0.0);
  if (!(std::isfinite(home) && home >= 0.0)) {
    refuse("options: home_stiffness", write_text(home, " N/m³"), "0 or a positive number");
  }
  if (!std::isfinite(options.pressure)) {
    refuse("options: pressure", write_text(options.pressure, " Pa"), "a finite number");
  }
}

/// [N/m] per vertex: home stiffness x local scale x the area the vertex stands for; empty for 0.
std::vector<double> compute_home(const SurfaceMesh& mesh, const Material& material,
                                 const SurfaceOptions& options) {
  const double per_area = options.home_stiffness.value_or(default_home_stiffness(mesh, material));
  if (per_area == 0.0) return {};
  std::vector<double> home = compute_vertex_areas(mesh);
  for (int i = 0; i < static_cast<int>(home.size()); ++i) {
    home[i] *= per_area * compute_local_scale(options.stiffness_scale, std::array{i});
  }
  return home;
}

/// cos_c = (l_i² + l_j² - l_c²) / (2 l_i l_j), i and j the corners beside c.
std::array<double, 3> compute_cosines(const std::array<double, 3>& length) {
  std::array<double, 3> cosine;
  for (int c = 0; c < 3; ++c) {
    const double one = length[(c + 1) % 3], two = length[(c + 2) % 3], far = length[c];
    cosine[c] = (one * one + two * two - far * far) / (2.0 * one * two);
  }
  return cosine;
}

/// A side of a row of Angles.
struct Side {
  std::size_t row;
  std::size_t corner;  ///< opposite
};

}  // namespace

double default_home_stiffness(const SurfaceMesh& mesh, const Material& material) {
  if (!material.wall_thickness) return 0.0;
  const double fading_length = 0.1 * compute_diagonal(mesh.vertices);
  return material.young_modulus * *material.wall_thickness / (fading_length * fading_length);
}

std::vector<double> compute_lumped_mass(const SurfaceMesh& mesh, const Material& material) {
  std::vector<double> mass = compute_vertex_areas(mesh);
  double per_area = 0.0;
  if (material.wall_thickness) {
    per_area = material.density * *material.wall_thickness;
  } else if (!is_closed(mesh.triangles)) {
    refuse("material: wall_thickness", "none for an open surface",
           "the thickness of the wall [m], since what is open encloses no volume");
  } else {
    const double volume = compute_volume(mesh);
    if (!(volume > 0.0)) {
      refuse("mesh: volume", write_text(volume, " m³"),
             "a positive one: triangles counter-clockwise from outside");
    }
    per_area = material.density * volume / compute_area(mesh);
  }
  for (double& m : mass) m *= per_area;
  return mass;
}

TissueModel build_surface_particles(const SurfaceMesh& mesh, const Material& material,
                                    const SurfaceOptions& options) {
  validate(mesh);
  validate(material);
  check_options(options, mesh.vertices.size());

  TissueModel model;
  model.rest_position = mesh.vertices;
  model.mass = compute_lumped_mass(mesh, material);
  model.fixed = options.fixed;
  std::sort(model.fixed.begin(), model.fixed.end());
  model.fixed.erase(std::unique(model.fixed.begin(), model.fixed.end()), model.fixed.end());
  model.home = compute_home(mesh, material, options);
  model.pressure = options.pressure;
  model.triangles = mesh.triangles;
  model.drag = options.drag;
  model.damping_law = options.damping_law;
  return model;
}

Angles build_rest_angles(const SurfaceMesh& mesh) {
  Angles angles;
  angles.corners = mesh.triangles;
  for (const Triangle& corners : mesh.triangles) {
    std::array<double, 3> length;
    for (int c = 0; c < 3; ++c) {
      // in ascending order, as the links' lengths are computed: the same to the last bit
      const auto [i, j] = std::minmax(corners[(c + 1) % 3], corners[(c + 2) % 3]);
      length[c] = (mesh.vertices[j] - mesh.vertices[i]).norm();
    }
    angles.rest_length.push_back(length);
    angles.rest_cosine.push_back(compute_cosines(length));
  }
  return angles;
}

std::vector<double> sum_bond_shares(const Angles& angles, const Topology& topology) {
  std::vector<double> stiffness(topology.edges.size(), 0.0);
  for (std::size_t t = 0; t < angles.corners.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      stiffness[topology.triangle_edges[t][c]] += angles.bond_share[t][c];
    }
  }
  return stiffness;
}

/// One spring between two free masses swings with w² = k / m, m = m_i m_j / (m_i + m_j), so it is
/// damped to the ratio zeta by c = 2 zeta sqrt(k m) [laws: damping].
Links build_edge_links(const TissueModel& model, std::span<const std::array<int, 2>> edges,
                       std::vector<double> stiffness, double damping_ratio,
                       std::span<const double> damped_as) {
  Links links;
  links.ends.assign(edges.begin(), edges.end());
  links.stiffness = std::move(stiffness);
  links.rest_length.reserve(edges.size());
  links.damping.reserve(edges.size());
  for (std::size_t l = 0; l < edges.size(); ++l) {
    const int i = edges[l][0], j = edges[l][1];
    links.rest_length.push_back((model.rest_position[j] - model.rest_position[i]).norm());
    const double reduced = model.mass[i] * model.mass[j] / (model.mass[i] + model.mass[j]);
    const double k = damped_as.empty() ? links.stiffness[l] : damped_as[l];
    links.damping.push_back(2.0 * damping_ratio * std::sqrt(k * reduced));
  }
  return links;
}

BondShares share_bonds(const TissueModel& model) {
  // rest lengths computed twice from the same points may differ by their last bits
  constexpr double kSameLength = 1e-12;
  std::map<std::array<int, 2>, std::vector<Side>> sides;
  const Angles& angles = model.angles;
  for (std::size_t row = 0; row < angles.corners.size(); ++row) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int i = angles.corners[row][(c + 1) % 3], j = angles.corners[row][(c + 2) % 3];
      sides[{std::min(i, j), std::max(i, j)}].push_back({row, c});
    }
  }
  BondShares shares;
  shares.left.assign(model.bonds.ends.size(), true);
  shares.side_count.assign(model.bonds.ends.size(), 0);
  shares.stiffness.assign(angles.corners.size(), {0.0, 0.0, 0.0});
  shares.damping = shares.stiffness;
  shares.bond.assign(angles.corners.size(), {-1, -1, -1});
  for (std::size_t l = 0; l < model.bonds.ends.size(); ++l) {
    const auto found = sides.find(model.bonds.ends[l]);
    const double length = model.bonds.rest_length[l];
    const auto fits = [&](const Side& side) {
      return std::abs(angles.rest_length[side.row][side.corner] - length) <= kSameLength * length;
    };
    if (found == sides.end() || !std::ranges::all_of(found->second, fits)) continue;
    shares.left[l] = false;
    shares.side_count[l] = static_cast<int>(found->second.size());
    for (const auto& [row, c] : found->second) {
      shares.stiffness[row][c] = angles.bond_share[row][c];
      shares.damping[row][c] = model.bonds.damping[l] / shares.side_count[l];
      shares.bond[row][c] = static_cast<int>(l);
    }
  }
  return shares;
}

}  // namespace palpate
