// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "palpate/sim/tick/private/rigid_motion.h"

/// Rigid bodies.
namespace palpate::scenes {

/// Four triangles of each, the new vertices on the unit sphere: of 42 vertices 162, of those 642.
inline SurfaceMesh refine_sphere(const SurfaceMesh& coarse) {
  SurfaceMesh mesh = divide_triangles(coarse);
  for (Vec3& v : mesh.vertices) v.normalize();
  return mesh;
}

/// A stone of `length` [m], its other sides 9/11 and 8/11 of that, of 2000 kg/m³: an ellipsoid as
/// a mesh of 42 vertices, or more where it is refined, and by fourteen spheres that lie in it and
/// touch its surface.
inline RigidBody make_stone(double length, int refined = 0) {
  const Vec3 half = 0.5 * length * Vec3(1.0, 9.0 / 11.0, 8.0 / 11.0);
  RigidBody stone;
  const double r = 0.45 * half.z();
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int sides = std::abs(x) + std::abs(y) + std::abs(z);
        if (sides != 1 && sides != 3) continue;
        const Vec3 direction = Vec3(x, y, z).normalized();
        stone.sphere_centres.push_back(direction.cwiseProduct(half - Vec3::Constant(r)));
        stone.sphere_radii.push_back(r);
      }
    }
  }
  const double ball[] = {1.0};
  stone.mesh = build_sphere_mesh(Vec3Array{Vec3::Zero()}, ball);
  for (int i = 0; i < refined; ++i) stone.mesh = refine_sphere(stone.mesh);
  for (Vec3& v : stone.mesh.vertices) v = v.cwiseProduct(half);
  stone.mass = 2000.0 * compute_rigid_volume(stone);
  const Vec3 square = half.cwiseProduct(half);
  stone.inertia =
      stone.mass / 5.0 * Vec3(square[1] + square[2], square[0] + square[2], square[0] + square[1]);
  return stone;
}

/// [m] Of its centre over what its lowest sphere lies on.
inline double find_resting_height(const RigidBody& stone) {
  double most = 0.0;
  for (std::size_t s = 0; s < stone.sphere_radii.size(); ++s) {
    most = std::max(most, stone.sphere_radii[s] - stone.sphere_centres[s].z());
  }
  return most;
}

}  // namespace palpate::scenes
