// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "palpate/sim/packed/private/packed_checkpoint.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "scenes/layers.h"

/// A soft body that is thrown at another.
namespace palpate::scenes {

/// A small body over a block that is held at its rim.
inline Scene make_thrown(double gap, double friction = 0.0) {
  Scene scene;
  scene.bodies.resize(2);
  for (SoftBody& body : scene.bodies) body.kernel = kernel_under_test();
  scene.bodies[0].tissue =
      make_soft_block({0.008, 0.008, 0.002}, {4, 4, 1}, 2e4, {0.0005, 0.001, gap + 0.006}, false);
  scene.bodies[1].tissue = make_soft_block({0.04, 0.04, 0.01}, {8, 8, 2}, 2e4, Vec3::Zero(), true);
  scene.bodies[0].tissue.drag = 0.0;
  scene.instruments[0].tool.radius = 0.003;
  scene.body_pairs = {{.friction = friction}};
  return scene;
}

/// All of a body [m/s], from now on.
inline void set_velocity(const Scene& scene, std::size_t b, const Vec3& velocity, World& world) {
  SoftState& state = world.bodies[b];
  std::ranges::fill(state.tissue.velocity, velocity);
  if (PackedKernel* packed = find_packed(state)) {
    take_over(*packed->model, scene.bodies[b].tissue, state.tissue, packed->state);
  }
  state.guard = Guard(scene.bodies[b].tissue, scene.gravity, state.tissue);
}

}  // namespace palpate::scenes
