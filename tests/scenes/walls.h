// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "palpate/sim/model/build_surface.h"
#include "scenes/scenes.h"
#include "scenes/tissues.h"

/// Walls of prisms whose deflection is known by hand.
namespace palpate::scenes {

inline Material make_wall(double thickness, double young, double poisson, double damping = 0.0) {
  Material wall = make_material({.damping_ratio = damping});
  wall.young_modulus = young;
  wall.poisson_ratio = poisson;
  wall.wall_thickness = thickness;
  return wall;
}

/// Rings of 6, 12, 18 ... vertices around the origin, to `radius` [m] and one beyond.
inline SurfaceMesh make_disc(double radius, double edge) {
  const int rings = std::max(2, static_cast<int>(std::lround(radius / edge)));
  SurfaceMesh mesh;
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  for (int i = 1; i <= rings + 1; ++i) {
    for (int j = 0; j < 6 * i; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / (6 * i), r = radius * i / rings;
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    }
  }
  const auto at = [](int i, int j) { return i == 0 ? 0 : 1 + 3 * i * (i - 1) + j % (6 * i); };
  for (int i = 1; i <= rings + 1; ++i) {
    for (int s = 0; s < 6; ++s) {
      for (int k = 0; k < i; ++k) {
        const int in = at(i - 1, s * (i - 1) + k), next = at(i - 1, s * (i - 1) + k + 1);
        const int out = at(i, s * i + k), ahead = at(i, s * i + k + 1);
        mesh.triangles.push_back({in, out, ahead});
        if (k + 1 < i) mesh.triangles.push_back({in, ahead, next});
      }
    }
  }
  return mesh;
}

/// The disc as a wall, clamped from `radius` on; vertex 0 is its middle.
inline TissueModel make_round_plate(double radius, double edge, double thickness, double young,
                                    double poisson, double damping = 0.0) {
  const SurfaceMesh mesh = make_disc(radius, edge);
  SurfaceOptions options;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (mesh.vertices[i].norm() > 0.999 * radius) options.fixed.push_back(static_cast<int>(i));
  }
  return build_shell(mesh, make_wall(thickness, young, poisson, damping), options);
}

/// A sphere that nothing holds.
inline TissueModel make_sphere_wall(double radius, int subdivisions, double thickness, double young,
                                    double poisson) {
  return build_shell(make_ellipsoid(Vec3::Constant(radius), subdivisions),
                     make_wall(thickness, young, poisson), {});
}

}  // namespace palpate::scenes
