// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/scenes.h"

namespace palpate::scenes {

/// An ellipsoid of 10 n² + 2 vertices: every side of an icosahedron divided into n.
inline SurfaceMesh make_geodesic(const Vec3& radii, int n) {
  const SurfaceMesh coarse = make_ellipsoid(Vec3::Ones(), 0);
  SurfaceMesh mesh;
  std::map<std::array<int, 6>, int> found;
  for (const Triangle& face : coarse.triangles) {
    std::vector<int> index;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n - i; ++j) {
        // vertices are named by whose corner they share and how much, in order of corners
        std::array<std::pair<int, int>, 3> shares = {
            {{face[0], n - i - j}, {face[1], i}, {face[2], j}}};
        std::sort(shares.begin(), shares.end());
        std::array<int, 6> name{};
        Vec3 x = Vec3::Zero();
        for (std::size_t k = 0, at = 0; k < 3; ++k) {
          const auto& [corner, share] = shares[k];
          x += share * coarse.vertices[static_cast<std::size_t>(corner)];
          if (share == 0) continue;
          name[at++] = corner + 1;
          name[at++] = share;
        }
        const auto [at, fresh] = found.try_emplace(name, static_cast<int>(mesh.vertices.size()));
        if (fresh) mesh.vertices.push_back(x.normalized().cwiseProduct(radii));
        index.push_back(at->second);
      }
    }
    for (int i = 0, row = 0; i < n; row += n - i + 1, ++i) {
      const int below = row + n - i + 1;
      for (int j = 0; j < n - i; ++j) {
        const auto v = [&](int k) { return index[static_cast<std::size_t>(k)]; };
        mesh.triangles.push_back({v(row + j), v(below + j), v(row + j + 1)});
        if (j + 1 < n - i) {
          mesh.triangles.push_back({v(row + j + 1), v(below + j), v(below + j + 1)});
        }
      }
    }
  }
  return mesh;
}

/// The wall of [contact: law] under a tool: E h = 60 N/m in the wall, so 0.866 E h along every edge
/// of a mesh of even triangles, 3e5 N/m³ home, 2 kg/m², light damping on purpose.
inline Scene make_law_wall(const SurfaceMesh& mesh, const Tool& tool) {
  SurfaceOptions options;
  options.home_stiffness = 3e5;
  options.drag = 30.0;
  const Material wall{.density = 1000.0, .damping_ratio = 0.03, .wall_thickness = 0.002};
  Scene scene;
  scene.bodies[0].kernel = kernel_under_test();
  scene.bodies[0].tissue = build_mass_spring(mesh, wall, 0.866 * 60.0, options);
  scene.instruments[0].tool = tool;
  scene.instruments[0].coupling = {.stiffness = 400.0, .force_max = 5.0};
  return build_scene(std::move(scene));
}

}  // namespace palpate::scenes
