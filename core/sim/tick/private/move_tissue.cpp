// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/move_tissue.h"

#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/volumes.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Makes a displacement measured in float no shorter than it was.
constexpr double kWiden = 1.0 + 1e-6;

/// [W] what the pushes do to the tissue at velocities v; times the substep it is their work to the
/// last bit, because symplectic Euler moves particles with the new velocity.
double compute_push_power(std::span<const Push> pushes, const TissueModel& tissue,
                          std::span<const Vec3> v) noexcept {
  const auto velocity_of = [&](int vertex) noexcept -> Vec3 {
    if (tissue.skin.corners.empty()) return v[static_cast<std::size_t>(vertex)];
    const auto& corners = tissue.skin.corners[static_cast<std::size_t>(vertex)];
    const auto& weights = tissue.skin.weights[static_cast<std::size_t>(vertex)];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) sum += weights[k] * v[corners[k]];
    return sum;
  };
  double power = 0.0;
  for (const Push& push : pushes) {
    const auto& [i, j, k] = tissue.triangles[static_cast<std::size_t>(push.triangle)];
    const Vec3 patch = push.weights[0] * velocity_of(i) + push.weights[1] * velocity_of(j) +
                       push.weights[2] * velocity_of(k);
    power += push.force.dot(patch);
  }
  return power;
}

/// Adds `what` to `list` unless it is there in this tick already.
void add_once(int what, long tick, std::vector<long>& last_at, std::vector<int>& list,
              int& count) noexcept {
  long& last = last_at[static_cast<std::size_t>(what)];
  if (last == tick) return;
  last = tick;
  list[static_cast<std::size_t>(count++)] = what;
}

void add_near(const TissueModel& tissue, int triangle, long tick, NearList& near) noexcept {
  if (triangle < 0) return;
  for (const int i : tissue.triangles[static_cast<std::size_t>(triangle)]) {
    if (tissue.skin.corners.empty()) {
      add_once(i, tick, near.particle_last_at, near.particles, near.particle_count);
      continue;
    }
    add_once(i, tick, near.skin_last_at, near.skin, near.skin_count);
    for (const int p : tissue.skin.corners[static_cast<std::size_t>(i)]) {
      add_once(p, tick, near.particle_last_at, near.particles, near.particle_count);
    }
  }
}

/// Lists what the tool may touch or holds.
void list_near(const TissueModel& tissue, const World& world, NearList& near) noexcept {
  near.clear();
  for (int c = 0; c < world.candidates.count; ++c) {
    add_near(tissue, world.candidates.triangles[static_cast<std::size_t>(c)], world.tick_count,
             near);
  }
  for (int h = 0; h < world.tool.hold_count; ++h) {
    add_near(tissue, world.tool.holds[static_cast<std::size_t>(h)].triangle, world.tick_count,
             near);
  }
  add_near(tissue, world.tool.carrier.triangle, world.tick_count, near);
}

/// Brings particles up to date where the tool may touch.
void unpack_near(const TissueModel& tissue, const PackedKernel& kernel, World& world) noexcept {
  for (const int particle : kernel.near.particles_in_use()) {
    unpack_particle(*kernel.model, tissue, kernel.state, static_cast<std::size_t>(particle),
                    world.tissue);
  }
}

/// And the skin on them.
void move_near_skin(const TissueModel& tissue, const NearList& near, World& world) noexcept {
  for (const int vertex : near.skin_in_use()) {
    const auto v = static_cast<std::size_t>(vertex);
    world.skin[v] = place_on_skin(tissue.skin, v, world.tissue.position);
  }
}

/// The tree follows what moves in this tick, and nothing else.
void choose_in_tree(PackedKernel& kernel, AabbTree& tree) noexcept {
  const PackedModel& model = *kernel.model;
  const auto width = static_cast<std::size_t>(model.width);
  for (std::size_t s = 0; s < kernel.in_tree.size(); ++s) {
    if (kernel.in_tree[s] == kernel.active.awake[s]) continue;
    kernel.in_tree[s] = kernel.active.awake[s];
    std::span<const int> particles = std::span(model.particle).subspan(width * s, width);
    while (particles.back() < 0) particles = particles.first(particles.size() - 1);
    tree.set_moving(particles, kernel.in_tree[s] != 0);
  }
}

// --- begin, step and end of each kernel ----------------------------------------------------------

void begin(ReferenceKernel&, const Scene&, World&) noexcept {}

double step_kernel(ReferenceKernel&, const Scene& scene, double dt, bool, World& world) noexcept {
  step(scene.tissue, world.load, dt, world.tissue);
  move_skin(scene.tissue.skin, world.tissue.position, world.skin);
  return dt * compute_push_power(world.load.pushes(), scene.tissue, world.tissue.velocity);
}

Alarm end(ReferenceKernel&, const Scene& scene, double work, World& world) noexcept {
  world.stretch = measure_stretch(scene.tissue, world.tissue.position);
  return check(scene.tissue, scene.gravity, world.tissue, work, world.guard, world.substeps);
}

void begin(PackedKernel& kernel, const Scene& scene, World& world) noexcept {
  list_near(scene.tissue, world, kernel.near);
  if (!kernel.active.on) return;
  wake_near(*kernel.model, scene.tissue, kernel.near.particles_in_use(), kernel.active,
            kernel.state);
  choose_in_tree(kernel, world.tree);
}

double step_kernel(PackedKernel& kernel, const Scene& scene, double dt, bool last,
                   World& world) noexcept {
  step(*kernel.model, world.load, dt, kernel.state, last ? &kernel.measure : nullptr);
  unpack_near(scene.tissue, kernel, world);
  move_near_skin(scene.tissue, kernel.near, world);
  return dt * compute_push_power(world.load.pushes(), scene.tissue, world.tissue.velocity);
}

Alarm end(PackedKernel& kernel, const Scene& scene, double work, World& world) noexcept {
  world.stretch = kernel.measure.stretch;
  world.tissue.time = kernel.state.time;
  kernel.lag.behind = true;
  kernel.lag.moved += kWiden * kernel.skin_gain * kernel.measure.largest_move;
  if (!lags(world) || needs_check(kernel.measure, world.guard, world.substeps)) {
    catch_up(scene, world);
  }
  const Alarm alarm = check(*kernel.model, scene.tissue, world.tissue, kernel.measure, work,
                            kernel.state, world.guard, world.substeps);
  if (kernel.active.on && !alarm) {
    follow_motion(*kernel.model, kernel.active, kernel.state, world.tissue);
  }
  return alarm;
}

void begin(ResponseKernel& kernel, const Scene& scene, World& world) noexcept {
  list_near(scene.tissue, world, kernel.near);
}

double step_kernel(ResponseKernel& kernel, const Scene& scene, double dt, bool,
                   World& world) noexcept {
  move_linear(scene, dt, kernel, world);
  move_near_skin(scene.tissue, kernel.near, world);
  return 0.0;  // nothing swings, so that there is no energy to account for
}

Alarm end(ResponseKernel& kernel, const Scene& scene, double, World& world) noexcept {
  return end_linear(scene, kernel, world);
}

}  // namespace

void begin_moving(const Scene& scene, World& world) noexcept {
  std::visit([&](auto& kernel) { begin(kernel, scene, world); }, internals(world).kernel);
}

double move_tissue(const Scene& scene, double dt, bool last, World& world) noexcept {
  return std::visit([&](auto& kernel) { return step_kernel(kernel, scene, dt, last, world); },
                    internals(world).kernel);
}

Alarm end_moving(const Scene& scene, double work, World& world) noexcept {
  return std::visit([&](auto& kernel) { return end(kernel, scene, work, world); },
                    internals(world).kernel);
}

}  // namespace palpate
