// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"

/// Small scenes shared by the tests of every room. Everything here is deterministic.
namespace palpate::scenes {

/// A number in [-1, 1) that depends on `index` and nothing else.
inline double scatter(std::uint32_t index) {
  std::uint32_t h = index * 2654435761u + 0x9e3779b9u;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  h ^= h >> 16;
  return static_cast<double>(h) / 2147483648.0 - 1.0;
}

/// A closed ellipsoid around the origin with half axes `radii` [m]: an icosahedron divided
/// `subdivisions` times, 10 * 4^s + 2 vertices and 20 * 4^s triangles.
inline SurfaceMesh make_ellipsoid(const Vec3& radii, int subdivisions) {
  const double g = std::numbers::phi;
  SurfaceMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Vec3& x : mesh.vertices) x.normalize();
  for (int s = 0; s < subdivisions; ++s) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int i, int j) {
      const auto [at, fresh] =
          middles.try_emplace({std::min(i, j), std::max(i, j)}, int(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]).normalized());
      return at->second;
    };
    std::vector<Triangle> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& x : mesh.vertices) x = x.cwiseProduct(radii);
  return mesh;
}

/// The side of a tube around +z, open at both ends (z = 0 and z = length), outside away from the
/// axis: `around` vertices on each of `rings` rings.
inline SurfaceMesh make_tube(double radius, double length, int around, int rings) {
  SurfaceMesh mesh;
  for (int r = 0; r < rings; ++r) {
    for (int a = 0; a < around; ++a) {
      // every second ring is turned by half a step, so the triangles come out even
      const double angle = 2.0 * std::numbers::pi * (a + 0.5 * (r % 2)) / around;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                 length * r / (rings - 1));
    }
  }
  for (int r = 0; r + 1 < rings; ++r) {
    for (int a = 0; a < around; ++a) {
      const int b = (a + 1) % around;
      const int low_a = r * around + a, low_b = r * around + b;
      const int high_a = low_a + around, high_b = low_b + around;
      if (r % 2 == 0) {
        mesh.triangles.insert(mesh.triangles.end(),
                              {{low_a, low_b, high_a}, {low_b, high_b, high_a}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(),
                              {{low_a, low_b, high_b}, {low_a, high_b, high_a}});
      }
    }
  }
  return mesh;
}

/// A flat open sheet in the plane z = 0, outside +z, from the origin to (size, size) [m]:
/// nx * ny vertices whose inner ones are moved by up to a fifth of a cell, diagonals alternating.
/// Vertex (i, j) has index j * nx + i.
inline SurfaceMesh make_sheet(int nx, int ny, double size) {
  const double dx = size / (nx - 1), dy = size / (ny - 1);
  SurfaceMesh mesh;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const bool inner = i > 0 && j > 0 && i < nx - 1 && j < ny - 1;
      const auto seed = static_cast<std::uint32_t>(2 * (j * nx + i));
      const double shift_x = inner ? 0.2 * scatter(seed) : 0.0;
      const double shift_y = inner ? 0.2 * scatter(seed + 1) : 0.0;
      mesh.vertices.emplace_back((i + shift_x) * dx, (j + shift_y) * dy, 0.0);
    }
  }
  for (int j = 0; j + 1 < ny; ++j) {
    for (int i = 0; i + 1 < nx; ++i) {
      const int a = j * nx + i, b = a + 1, c = a + nx, d = c + 1;
      if ((i + j) % 2 == 0) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {a, d, c}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {b, d, c}});
      }
    }
  }
  return mesh;
}

/// `n` particles `spacing` [m] apart along +x, the first held, joined by n - 1 springs.
/// The modes of motion along x are w_j = 2 sqrt(k/m) sin((2j - 1) pi / (4n - 2)), j = 1 .. n - 1.
inline TissueModel make_chain_model(int n, double mass = 1e-3, double stiffness = 100.0,
                                    double damping = 0.0, double spacing = 0.01) {
  TissueModel model;
  for (int i = 0; i < n; ++i) {
    model.rest_position.emplace_back(i * spacing, 0.0, 0.0);
    model.mass.push_back(mass);
  }
  model.fixed = {0};
  for (int i = 0; i + 1 < n; ++i) {
    model.springs.ends.push_back({i, i + 1});
    model.springs.rest_length.push_back(spacing);
    model.springs.stiffness.push_back(stiffness);
    model.springs.damping.push_back(damping);
  }
  return model;
}

/// One particle on a spring along +x whose other end, particle 0, is held: w = sqrt(k/m) along x.
inline TissueModel make_oscillator_model(double mass = 1e-3, double stiffness = 100.0,
                                         double damping = 0.0) {
  return make_chain_model(2, mass, stiffness, damping);
}

}  // namespace palpate::scenes
