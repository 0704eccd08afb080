// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/solids.h"

/// Soft bodies that touch each other.
namespace palpate::scenes {

/// How two layers are made.
struct Layers {
  double side = 0.1;         ///< [m]
  double thickness = 0.005;  ///< [m] of each
  std::array<int, 3> cells = {20, 20, 2};
  double lower_modulus = 5e3, upper_modulus = 5e3;  ///< [Pa]
  double gap = 5e-4;                                ///< [m] between them at rest
};

/// A solid of springs and volumes, a block moved by `offset` [m], with the particles at the rim of
/// its sides held, or none.
inline TissueModel make_soft_block(const Vec3& sides, const std::array<int, 3>& cells,
                                   double modulus, const Vec3& offset, bool held) {
  SolidMesh solid = make_block(sides, cells);
  for (Vec3& x : solid.vertices) x += offset;
  SolidOptions options;
  for (int i = 0; held && i < static_cast<int>(solid.vertices.size()); ++i) {
    const Vec3 x = (solid.vertices[static_cast<std::size_t>(i)] - offset).cwiseAbs();
    if (x.x() > 0.499 * sides.x() || x.y() > 0.499 * sides.y()) options.fixed.push_back(i);
  }
  Material material;
  material.young_modulus = modulus;
  material.poisson_ratio = 0.45;
  material.damping_ratio = 0.2;
  return build_solid(solid, material, options);
}

/// One layer over another, the upper one pushed down by a ball.
inline Scene make_layers(const Layers& layers, double tool_radius, const BodyPair& pair = {}) {
  const Vec3 sides(layers.side, layers.side, layers.thickness);
  Scene scene;
  scene.bodies.resize(2);
  for (SoftBody& body : scene.bodies) body.kernel = kernel_under_test();
  const Vec3 above(0.0, 0.0, layers.thickness + layers.gap);
  scene.bodies[0].tissue =
      make_soft_block(sides, layers.cells, layers.lower_modulus, Vec3::Zero(), true);
  scene.bodies[1].tissue = make_soft_block(sides, layers.cells, layers.upper_modulus, above, true);
  scene.instruments[0].tool.radius = tool_radius;
  scene.body_pairs = {pair};
  return scene;
}

/// [m] The least gap that a pair of bodies had in a run; the alarm ends it.
struct Pushed {
  double least_gap = 1.0;
  int most_touching = 0;
  double force = 0.0;  ///< [N] up on the upper body, at the end
  int inside = 0;      ///< vertices inside of the other body, at the end
  Alarm alarm;
};

/// Pushes the upper of two layers down by `depth` [m] at `speed` [m/s], from just above it, and
/// holds it there for `rest` [s].
inline Pushed push_layers(const Scene& scene, const Layers& layers, double depth, double speed,
                          double rest, World& world) {
  const double radius = scene.instruments[0].tool.radius;
  const double top = 1.5 * layers.thickness + layers.gap + radius + 1e-4;
  const double dt = 1.0 / scene.rate;
  const int ticks = static_cast<int>(std::lround((depth / speed + rest) / dt));
  Pushed pushed;
  HapticSample sample;
  for (int i = 0; i < ticks && !world.alarm; ++i) {
    sample.time = i * dt;
    sample.position = {0.001, 0.002, top - std::min(depth, speed * sample.time)};
    tick(scene, sample, dt, world);
    pushed.least_gap = std::min(pushed.least_gap, world.body_pairs[0].least_gap);
    pushed.most_touching = std::max(pushed.most_touching, world.body_pairs[0].touching);
  }
  pushed.force = world.body_pairs[0].force.z();
  pushed.alarm = world.alarm;
  return pushed;
}

/// How many vertices of a body are inside of another, closed one, by how often it goes round them.
inline int count_inside(const Scene& scene, const World& world, std::size_t body,
                        std::size_t other) {
  int inside = 0;
  const SoftState& around = world.bodies[other];
  for (const Vec3& x : surface_position(world.bodies[body])) {
    const Vec3 low = around.tree.low() - x, high = x - around.tree.high();
    if (low.maxCoeff() > 0.0 || high.maxCoeff() > 0.0) continue;
    inside += compute_winding_number(scene.bodies[other].tissue.triangles, surface_position(around),
                                     x) > 0.5;
  }
  return inside;
}

}  // namespace palpate::scenes
