// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/scenes.h"

namespace palpate::testing {

/// A hollow organ of 162 vertices, 60 x 50 x 40 mm, held at its lower half, with a 3 mm tip above
/// its pole at z = 20 mm.
inline Scene press_scene() {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.020}, 2);
  SurfaceOptions options;
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i) {
    if (mesh.vertices[static_cast<std::size_t>(i)].z() < 0.0) options.fixed.push_back(i);
  }
  options.home_stiffness = 4e5;
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].tissue = build_mass_spring(mesh, {.wall_thickness = 0.003}, 100.0, options);
  return build_scene(std::move(scene));
}

/// Down from 10 mm above the pole to `depth` [m] below where the tip first touches it, a rest,
/// and up again, in `duration` [s]; attached from the middle on, if asked.
inline ScriptedDevice press_script(double depth, double duration, bool attach = false) {
  const Vec3 above(0.001, 0.002, 0.033), below(0.001, 0.002, 0.023 - depth);
  const std::uint8_t button = attach ? kAttachButton : 0;
  return ScriptedDevice({{0.0, above, 0},
                         {0.4 * duration, below, 0},
                         {0.5 * duration, below, button},
                         {0.9 * duration, above, button},
                         {duration, above, 0}});
}

}  // namespace palpate::testing
