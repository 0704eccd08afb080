// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "palpate/sim/tick/tick.h"
#include "scenes/layers.h"

/// Bodies on what never moves.
namespace palpate::scenes {

/// A square of `cells` x `cells`, seen from above, its middle at `middle` [m].
inline SurfaceMesh make_table(double side, int cells, const Vec3& middle = Vec3::Zero()) {
  SurfaceMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      mesh.vertices.push_back(middle +
                              side * Vec3(double(i) / cells - 0.5, double(j) / cells - 0.5, 0.0));
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

/// A layer of Layers on a table that it touches at rest, under a ball.
inline Scene make_layer_on_table(const Layers& layers, double tool_radius, int table_cells = 4) {
  Scene scene;
  scene.bodies[0].kernel = kernel_under_test();
  scene.bodies[0].tissue = make_soft_block({layers.side, layers.side, layers.thickness},
                                           layers.cells, layers.lower_modulus, Vec3::Zero(), true);
  scene.instruments[0].tool.radius = tool_radius;
  scene.scenery = {
      {make_table(1.2 * layers.side, table_cells, {0.0, 0.0, -0.5 * layers.thickness}), {0}, 0.0}};
  return scene;
}

/// [m] How deep the lowest vertex of a body is under a plane of height z [m].
inline double find_depth_under(const SoftState& body, double z) {
  double least = 1.0;
  for (const Vec3& x : surface_position(body)) least = std::min(least, x.z() - z);
  return -least;
}

}  // namespace palpate::scenes
