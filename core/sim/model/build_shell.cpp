// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/private/inner_face.h"
#include "palpate/sim/model/private/prism_shear.h"
#include "palpate/sim/model/private/surface_particles.h"

namespace palpate {
namespace {

double wall_of(const Material& material) {
  validate(material);
  if (!material.wall_thickness) {
    refuse("material: wall_thickness", "none", "the thickness of the wall [m]");
  }
  return *material.wall_thickness;
}

Vec3 compute_area_vector(const Vec3Array& x, const Triangle& t) {
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
}

template <class Row>
void append(const std::vector<Row>& more, std::vector<Row>& rows) {
  rows.insert(rows.end(), more.begin(), more.end());
}

/// Adds the rows of the inner face, whose particles follow the first `n`.
void append_face(const TissueModel& inner, int n, TissueModel& model) {
  const auto shift = [n](auto ids) {
    for (int& id : ids) id += n;
    return ids;
  };
  append(inner.rest_position, model.rest_position);
  append(inner.mass, model.mass);
  append(inner.home, model.home);
  for (const int i : inner.fixed) model.fixed.push_back(i + n);
  for (const auto& ends : inner.bonds.ends) model.bonds.ends.push_back(shift(ends));
  append(inner.bonds.rest_length, model.bonds.rest_length);
  append(inner.bonds.stiffness, model.bonds.stiffness);
  append(inner.bonds.damping, model.bonds.damping);
  for (const auto& corners : inner.angles.corners) model.angles.corners.push_back(shift(corners));
  append(inner.angles.rest_cosine, model.angles.rest_cosine);
  append(inner.angles.rest_length, model.angles.rest_length);
  append(inner.angles.bend_stiffness, model.angles.bend_stiffness);
  append(inner.angles.stretch_coupling, model.angles.stretch_coupling);
  append(inner.angles.bond_share, model.angles.bond_share);
}

/// The springs between the faces, E A/h, A the area that a vertex stands for.
void add_pillars(const SurfaceMesh& mesh, const Material& material, const SurfaceOptions& options,
                 TissueModel& model) {
  const auto n = static_cast<int>(mesh.vertices.size());
  const double modulus = material.young_modulus / *material.wall_thickness;
  std::vector<double> stiffness = compute_vertex_areas(mesh);
  std::vector<std::array<int, 2>> ends;
  for (int i = 0; i < n; ++i) {
    stiffness[i] *= modulus * compute_local_scale(options.stiffness_scale, std::array{i});
    ends.push_back({i, n + i});
  }
  model.springs = build_edge_links(model, ends, std::move(stiffness), material.damping_ratio);
}

/// [-] to [m]: how much a unit of shear in a side lengthens one diagonal more than the other.
double compute_lever(const std::array<double, 2>& diagonal, double side, double height) {
  return 2.0 * side * height / (0.5 * (diagonal[0] + diagonal[1]));
}

/// Three sides of equal weight, 2 A/3 of the shear energy each, pass the shear of a prism on:
/// exact in an equilateral one. Each is damped as a link of its own stiffness would be.
void add_prism(const SurfaceMesh& mesh, std::size_t t, const Material& material, double scale,
               const std::vector<double>& depth, TissueModel& model) {
  const auto n = static_cast<int>(mesh.vertices.size());
  const Triangle& outer = mesh.triangles[t];
  const std::array<int, 6> corners = {outer[0] + n, outer[1] + n, outer[2] + n,
                                      outer[0],     outer[1],     outer[2]};
  const Vec3Array& x = model.rest_position;
  const auto distance = [&](int a, int b) { return (x[corners[b]] - x[corners[a]]).norm(); };
  std::array<double, 3> side;
  for (int c = 0; c < 3; ++c) side[c] = distance(3 + (c + 1) % 3, 3 + (c + 2) % 3);
  const double longest = *std::ranges::max_element(side), h = *material.wall_thickness;
  const double shear = material.young_modulus / (2.0 * (1.0 + material.poisson_ratio));
  const double unlocked = find_unlocked_shear(h, longest);
  const double area = compute_area_vector(mesh.vertices, outer).norm();
  const double energy = 2.0 / 3.0 * area * kShearShare * shear * h * unlocked * scale;
  std::array<double, 3> difference, stiffness, damping;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const std::array<double, 2> diagonal = {distance(i, 3 + j), distance(j, 3 + i)};
    const double height = 0.5 * (depth[outer[i]] + depth[outer[j]]);
    const double lever = compute_lever(diagonal, side[c], height);
    const double mass = 0.25 * (model.mass[corners[i]] + model.mass[corners[j]] +
                                model.mass[corners[3 + i]] + model.mass[corners[3 + j]]);
    difference[c] = diagonal[0] - diagonal[1];
    stiffness[c] = energy / (lever * lever);
    damping[c] = 2.0 * material.damping_ratio * std::sqrt(stiffness[c] * 0.5 * mass);
  }
  model.prisms.corners.push_back(corners);
  model.prisms.rest_difference.push_back(difference);
  model.prisms.shear_stiffness.push_back(stiffness);
  model.prisms.shear_damping.push_back(damping);
}

}  // namespace

/// Two faces of thickness h/2 at a distance d stretch like one of h and bend with
/// 2 (E h/2)/(1 - nu²) (d/2)², which is E h³/(12 (1 - nu²)) for d = h/sqrt(3).
TissueModel build_shell(const SurfaceMesh& mesh, const Material& material,
                        const SurfaceOptions& options) {
  const double height = wall_of(material) / std::sqrt(3.0);
  validate(mesh);
  Material half = material;
  half.wall_thickness = 0.5 * *material.wall_thickness;
  SurfaceOptions outer = options;
  outer.home_stiffness = 0.5 * options.home_stiffness.value_or(0.0);
  SurfaceOptions inner = outer;
  inner.pressure = 0.0;
  TissueModel model = build_membrane_molecular(mesh, half, 0.0, AngleLaw::gradient, outer);
  const InnerFace below = make_inner_face(mesh, height);
  const TissueModel under =
      build_membrane_molecular(below.mesh, half, 0.0, AngleLaw::gradient, inner);
  append_face(under, static_cast<int>(mesh.vertices.size()), model);
  add_pillars(mesh, material, options, model);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double scale = compute_local_scale(options.stiffness_scale, mesh.triangles[t]);
    add_prism(mesh, t, material, scale, below.depth, model);
  }
  validate(model);
  return model;
}

}  // namespace palpate
