// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/build_surface.h"
#include "scenes/tissues.h"

/// Walls of prisms.
namespace palpate::scenes {

/// The hollow organ of make_organ_mesh, a wall of 3 mm and 50 kPa held at its base.
inline TissueModel make_shell_organ(int subdivisions, const Losses& losses = {}) {
  const SurfaceMesh mesh = make_organ_mesh(subdivisions);
  Material wall = make_material(losses);
  wall.young_modulus = 5e4;
  wall.wall_thickness = 3e-3;
  return build_shell(mesh, wall, make_options(losses, find_base(mesh)));
}

/// One crooked prism, some 10 mm wide and 4 mm high with its outside above, of nothing but shear
/// stiffness, its damping, and home springs.
inline TissueModel make_damped_prism() {
  TissueModel model;
  for (const double z : {0.0, 0.004}) {
    model.rest_position.insert(model.rest_position.end(),
                               {{0.1 * z, 0.0, z}, {0.01, 0.2 * z, z}, {0.005, 0.008, 1.1 * z}});
  }
  model.mass.assign(6, 0.1);
  model.home.assign(6, 50.0);
  model.triangles = {{3, 4, 5}};
  model.prisms.corners = {{0, 1, 2, 3, 4, 5}};
  const auto distance = [&](int a, int b) {
    return (model.rest_position[a] - model.rest_position[b]).norm();
  };
  model.prisms.rest_difference = {{distance(1, 5) - distance(2, 4), distance(2, 3) - distance(0, 5),
                                   distance(0, 4) - distance(1, 3)}};
  model.prisms.shear_stiffness = {{100.0, 200.0, 300.0}};
  model.prisms.shear_damping = {{1.0, 0.0, 2.0}};
  return model;
}

}  // namespace palpate::scenes
