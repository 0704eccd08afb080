// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/build_surface.h"
#include "scenes/scenes.h"

/// Tissues built from the small scenes, one of each kind, for the laws of motion.
namespace palpate::scenes {

/// What takes energy out of a tissue; nothing unless told.
struct Losses {
  double damping_ratio = 0.0;  ///< [-] of each link
  double drag = 0.0;           ///< [1/s]
  DampingLaw law = DampingLaw::axis;
};

inline SurfaceMesh make_organ_mesh(int subdivisions) {
  return make_ellipsoid({0.05, 0.035, 0.03}, subdivisions);
}

/// The vertices of a mesh in the lowest fifth of its height.
inline std::vector<int> find_base(const SurfaceMesh& mesh) {
  double low = mesh.vertices[0].z(), high = low;
  for (const Vec3& x : mesh.vertices) low = std::min(low, x.z()), high = std::max(high, x.z());
  std::vector<int> base;
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i) {
    if (mesh.vertices[i].z() < low + 0.2 * (high - low)) base.push_back(i);
  }
  return base;
}

inline Material make_material(const Losses& losses) {
  Material material;
  material.damping_ratio = losses.damping_ratio;
  return material;
}

inline SurfaceOptions make_options(const Losses& losses, std::vector<int> fixed) {
  SurfaceOptions options;
  options.fixed = std::move(fixed);
  options.drag = losses.drag;
  options.damping_law = losses.law;
  return options;
}

/// A mass-spring ellipsoid, 100 x 70 x 60 mm, held at its base.
inline TissueModel make_spring_organ(int subdivisions, const Losses& losses = {}) {
  const SurfaceMesh mesh = make_organ_mesh(subdivisions);
  return build_mass_spring(mesh, make_material(losses), 60.0,
                           make_options(losses, find_base(mesh)));
}

/// The same as a molecular model with angles and stretch-bend.
inline TissueModel make_molecular_organ(int subdivisions, const Losses& losses = {},
                                        AngleLaw law = AngleLaw::gradient) {
  const SurfaceMesh mesh = make_organ_mesh(subdivisions);
  MolecularConstants constants;
  constants.bond_stiffness = 60.0;
  constants.bend_stiffness = law == AngleLaw::gradient ? 1e-3 : 0.1;
  constants.stretch_coupling = law == AngleLaw::gradient ? 0.02 : 0.0;
  constants.angle_law = law;
  return build_molecular(mesh, make_material(losses), constants,
                         make_options(losses, find_base(mesh)));
}

/// A flat sheet of 60 mm with home springs, its four corners held: the first two by index.
inline TissueModel make_sheet_tissue(const Losses& losses = {}) {
  const SurfaceMesh mesh = make_sheet(6, 6, 0.06);
  Material material = make_material(losses);
  material.wall_thickness = 2e-3;
  return build_mass_spring(mesh, material, 20.0, make_options(losses, {0, 5, 30, 35}));
}

/// A hollow ellipsoid under an inner pressure of 500 Pa, nothing held but by home springs.
inline TissueModel make_hollow_tissue(const Losses& losses = {}) {
  Material material = make_material(losses);
  material.wall_thickness = 3e-3;
  SurfaceOptions options = make_options(losses, {});
  options.pressure = 500.0;
  return build_mass_spring(make_organ_mesh(1), material, 15.0, options);
}

/// A triangle model without bonds: one row of Angles with rest lengths from `rest`.
inline Angles make_angles(const std::vector<Triangle>& corners, const Vec3Array& rest,
                          double bend_stiffness, double stretch_coupling) {
  Angles angles;
  angles.corners = corners;
  for (const Triangle& t : corners) {
    std::array<double, 3> length{}, cosine{};
    for (int c = 0; c < 3; ++c) {
      length[c] = (rest[t[(c + 1) % 3]] - rest[t[(c + 2) % 3]]).norm();
      const Vec3 u = rest[t[(c + 1) % 3]] - rest[t[c]], v = rest[t[(c + 2) % 3]] - rest[t[c]];
      cosine[c] = u.normalized().dot(v.normalized());
    }
    angles.rest_length.push_back(length);
    angles.rest_cosine.push_back(cosine);
    angles.bend_stiffness.push_back({bend_stiffness, 1.3 * bend_stiffness, 0.7 * bend_stiffness});
    angles.stretch_coupling.push_back(
        {stretch_coupling, -0.4 * stretch_coupling, 1.6 * stretch_coupling});
    angles.bond_share.push_back({0.0, 0.0, 0.0});
  }
  return angles;
}

/// `count` vectors with components in [-size, size).
inline Vec3Array scatter_vectors(std::size_t count, double size, std::uint32_t seed) {
  Vec3Array vectors;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t at = seed * 100003u + 3 * i;
    vectors.emplace_back(size * scatter(at), size * scatter(at + 1), size * scatter(at + 2));
  }
  return vectors;
}

/// Adds scattered offsets and velocities to everything that is free.
inline void shake(const TissueModel& model, double offset, double speed, State& state) {
  const Vec3Array dx = scatter_vectors(model.mass.size(), offset, 1);
  const Vec3Array dv = scatter_vectors(model.mass.size(), speed, 2);
  auto held = model.fixed.begin();
  for (int i = 0; i < particle_count(model); ++i) {
    if (held != model.fixed.end() && *held == i) {
      ++held;
      continue;
    }
    state.position[i] += dx[i];
    state.velocity[i] += dv[i];
  }
}

/// Where everything is after a shake, at rest.
inline Vec3Array strained(const TissueModel& model, double offset) {
  State state(model);
  shake(model, offset, 0.0, state);
  return state.position;
}

inline double max_difference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

inline Vec3 sum(std::span<const Vec3> a) {
  Vec3 all = Vec3::Zero();
  for (const Vec3& v : a) all += v;
  return all;
}

/// About the origin.
inline Vec3 compute_torque(std::span<const Vec3> x, std::span<const Vec3> f) {
  Vec3 all = Vec3::Zero();
  for (std::size_t i = 0; i < f.size(); ++i) all += x[i].cross(f[i]);
  return all;
}

inline double max_norm(std::span<const Vec3> a) {
  double most = 0.0;
  for (const Vec3& v : a) most = std::max(most, v.norm());
  return most;
}

}  // namespace palpate::scenes
