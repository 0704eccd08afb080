// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/move_tissue.h"

#include "palpate/sim/dynamics/measure_stretch.h"
#include "palpate/sim/dynamics/packed.h"
#include "palpate/sim/dynamics/step.h"

namespace palpate {
namespace {

/// [W] what the pushes do to the tissue at velocities v; times the substep it is their work to the
/// last bit, because symplectic Euler moves particles with the new velocity.
double compute_push_power(std::span<const Push> pushes, std::span<const Triangle> triangles,
                          std::span<const Vec3> v) noexcept {
  double power = 0.0;
  for (const Push& push : pushes) {
    const auto& [i, j, k] = triangles[static_cast<std::size_t>(push.triangle)];
    const Vec3 patch = push.weights[0] * v[i] + push.weights[1] * v[j] + push.weights[2] * v[k];
    power += push.force.dot(patch);
  }
  return power;
}

void add_near(const Scene& scene, int triangle, World& world) noexcept {
  if (triangle < 0) return;
  for (const int i : scene.tissue.triangles[static_cast<std::size_t>(triangle)]) {
    long& last = world.last_near_at[static_cast<std::size_t>(i)];
    if (last == world.tick_count) continue;
    last = world.tick_count;
    world.near[static_cast<std::size_t>(world.near_count++)] = i;
  }
}

}  // namespace

void begin_moving(const Scene& scene, World& world) noexcept {
  if (!world.packed_model) return;
  world.near_count = 0;
  for (int c = 0; c < world.candidates.count; ++c) {
    add_near(scene, world.candidates.triangles[static_cast<std::size_t>(c)], world);
  }
  for (int h = 0; h < world.tool.hold_count; ++h) {
    add_near(scene, world.tool.holds[static_cast<std::size_t>(h)].triangle, world);
  }
  add_near(scene, world.tool.carrier.triangle, world);
}

double move_tissue(const Scene& scene, double dt, bool last, World& world) noexcept {
  if (world.packed_model) {
    step(*world.packed_model, world.load, dt, world.packed, last ? &world.measure : nullptr);
    for (int n = 0; n < world.near_count; ++n) {
      unpack_particle(*world.packed_model, scene.tissue, world.packed,
                      static_cast<std::size_t>(world.near[static_cast<std::size_t>(n)]),
                      world.tissue);
    }
  } else {
    step(scene.tissue, world.load, dt, world.tissue);
  }
  return dt *
         compute_push_power(world.load.pushes(), scene.tissue.triangles, world.tissue.velocity);
}

Alarm end_moving(const Scene& scene, double work, World& world) noexcept {
  if (!world.packed_model) {
    world.stretch = measure_stretch(scene.tissue, world.tissue.position);
    return check(scene.tissue, scene.gravity, world.tissue, work, world.guard, world.substeps);
  }
  world.stretch = world.measure.stretch;
  unpack(*world.packed_model, scene.tissue, world.packed, world.tissue);
  return check(*world.packed_model, scene.tissue, scene.gravity, world.tissue, world.measure, work,
               world.packed, world.guard, world.substeps);
}

}  // namespace palpate
