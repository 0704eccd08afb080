// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/move_tissue.h"

#include "palpate/sim/dynamics/follow_motion.h"
#include "palpate/sim/dynamics/measure_stretch.h"
#include "palpate/sim/dynamics/packed.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/haptics/follow_tissue.h"
#include "palpate/sim/haptics/linear_tick.h"
#include "palpate/sim/model/volumes.h"

namespace palpate {
namespace {

/// Makes a way measured in float no shorter than it was.
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

void add_near(const Scene& scene, int triangle, World& world) noexcept {
  if (triangle < 0) return;
  const Skin& skin = scene.tissue.skin;
  for (const int i : scene.tissue.triangles[static_cast<std::size_t>(triangle)]) {
    if (skin.corners.empty()) {
      add_once(i, world.tick_count, world.last_near_at, world.near, world.near_count);
      continue;
    }
    add_once(i, world.tick_count, world.last_skin_near_at, world.near_skin, world.near_skin_count);
    for (const int p : skin.corners[static_cast<std::size_t>(i)]) {
      add_once(p, world.tick_count, world.last_near_at, world.near, world.near_count);
    }
  }
}

/// Brings particles up to date where the tool may touch.
void unpack_near(const TissueModel& tissue, World& world) noexcept {
  for (int n = 0; n < world.near_count; ++n) {
    unpack_particle(*world.packed_model, tissue, world.packed,
                    static_cast<std::size_t>(world.near[static_cast<std::size_t>(n)]),
                    world.tissue);
  }
}

/// And the skin on them.
void move_near_skin(const TissueModel& tissue, World& world) noexcept {
  for (int n = 0; n < world.near_skin_count; ++n) {
    const auto v = static_cast<std::size_t>(world.near_skin[static_cast<std::size_t>(n)]);
    world.skin[v] = place_on_skin(tissue.skin, v, world.tissue.position);
  }
}

/// The tree follows what moves in this tick, and nothing else.
void choose_in_tree(World& world) noexcept {
  const PackedModel& model = *world.packed_model;
  const auto width = static_cast<std::size_t>(model.width);
  for (std::size_t s = 0; s < world.in_tree.size(); ++s) {
    if (world.in_tree[s] == world.active.awake[s]) continue;
    world.in_tree[s] = world.active.awake[s];
    std::span<const int> particles = std::span(model.particle).subspan(width * s, width);
    while (particles.back() < 0) particles = particles.first(particles.size() - 1);
    world.tree.set_moving(particles, world.in_tree[s] != 0);
  }
}

}  // namespace

void refit_tree(World& world) noexcept {
  if (world.active.on) {
    world.tree.refit_moving(world.tissue.position);
  } else {
    world.tree.refit(surface_position(world));
  }
  world.tree_cost.follow(world.tree);
}

void begin_moving(const Scene& scene, World& world) noexcept {
  if (!world.packed_model && !world.response) return;
  world.near_count = world.near_skin_count = 0;
  for (int c = 0; c < world.candidates.count; ++c) {
    add_near(scene, world.candidates.triangles[static_cast<std::size_t>(c)], world);
  }
  for (int h = 0; h < world.tool.hold_count; ++h) {
    add_near(scene, world.tool.holds[static_cast<std::size_t>(h)].triangle, world);
  }
  add_near(scene, world.tool.carrier.triangle, world);
  if (!world.active.on) return;
  const auto near = std::span(world.near).first(static_cast<std::size_t>(world.near_count));
  wake_near(*world.packed_model, scene.tissue, near, world.active, world.packed);
  choose_in_tree(world);
}

double move_tissue(const Scene& scene, double dt, bool last, World& world) noexcept {
  if (world.response) {
    move_linear(scene, dt, world);
    move_near_skin(scene.tissue, world);
    return 0.0;  // nothing swings, so that there is no energy to account for
  }
  if (world.packed_model) {
    step(*world.packed_model, world.load, dt, world.packed, last ? &world.measure : nullptr);
    unpack_near(scene.tissue, world);
    move_near_skin(scene.tissue, world);
  } else {
    step(scene.tissue, world.load, dt, world.tissue);
    move_skin(scene.tissue.skin, world.tissue.position, world.skin);
  }
  return dt * compute_push_power(world.load.pushes(), scene.tissue, world.tissue.velocity);
}

Alarm end_moving(const Scene& scene, double work, World& world) noexcept {
  if (world.response) return end_linear(scene, world);
  if (!world.packed_model) {
    world.stretch = measure_stretch(scene.tissue, world.tissue.position);
    return check(scene.tissue, scene.gravity, world.tissue, work, world.guard, world.substeps);
  }
  world.stretch = world.measure.stretch;
  world.tissue.time = world.packed.time;
  world.lag.behind = true;
  world.lag.moved += kWiden * world.skin_gain * world.measure.largest_move;
  if (!lags(world) || looks_wrong(world.measure, world.guard, world.substeps)) {
    catch_up(scene, world);
  }
  const Alarm alarm = check(*world.packed_model, scene.tissue, world.tissue, world.measure, work,
                            world.packed, world.guard, world.substeps);
  if (world.active.on && !alarm) {
    follow_motion(*world.packed_model, world.active, world.packed, world.tissue);
  }
  return alarm;
}

}  // namespace palpate
