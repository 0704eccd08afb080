// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "palpate/sim/tick/private/rigid_motion.h"

/// Rigid bodies.
namespace palpate::scenes {

/// Four triangles of each, the new vertices on the unit sphere: of 42 vertices 162, of those 642.
inline SurfaceMesh refine_sphere(const SurfaceMesh& coarse) {
  SurfaceMesh mesh;
  mesh.vertices = coarse.vertices;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
    const auto at = [&](int v) { return coarse.vertices[static_cast<std::size_t>(v)]; };
    if (is_new) mesh.vertices.push_back((at(a) + at(b)).normalized());
    return found->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& t :
         {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}}) {
      mesh.triangles.push_back(t);
    }
  }
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
