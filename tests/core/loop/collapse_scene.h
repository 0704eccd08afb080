// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tick/press_scene.h"

namespace palpate::testing {

/// A tall bag of 162 vertices, held at its bottom, whose weight is far too much for its wall:
/// within a tenth of a second it lies crumpled, and the tree it had at rest suits it no longer.
inline Scene collapse_scene() {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.045}, 2);
  SurfaceOptions options;
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i) {
    if (mesh.vertices[static_cast<std::size_t>(i)].z() < -0.0225) options.fixed.push_back(i);
  }
  options.home_stiffness = 1e3;
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.gravity = Vec3(0.0, 0.0, -30.0);
  scene.bodies[0].tissue = build_mass_spring(mesh, {.wall_thickness = 0.003}, 100.0, options);
  return build_scene(std::move(scene));
}

/// Waits beside the bag while it falls, and is then drawn through where it lies.
inline ScriptedDevice sweep_script(double duration) {
  return ScriptedDevice({{0.0, Vec3(0.08, 0.0, -0.02), 0},
                         {0.3 * duration, Vec3(0.08, 0.0, -0.02), 0},
                         {0.9 * duration, Vec3(-0.02, 0.0, -0.02), 0},
                         {duration, Vec3(0.05, 0.0, -0.02), 0}});
}

}  // namespace palpate::testing
