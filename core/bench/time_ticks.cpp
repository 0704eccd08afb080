// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/time_ticks.h"

#include <algorithm>
#include <stdexcept>

#include "palpate/bench/naive.h"
#include "palpate/bench/naive_tree.h"
#include "palpate/bench/press_and_hold.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/timing.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"

namespace palpate::bench {
namespace {

/// The tick of a first program: the textbook tree, plain steps, nothing guarded.
void tick_naively(const Scene& scene, const HapticSample& sample, double dt, NaiveTree& tree,
                  NaiveVolumes& kept, World& world) {
  find_naively(scene, sample, tree, world);
  for (int s = 0; s < world.bodies[0].substeps; ++s) {
    balance_tool(scene.instruments[0].tool, scene.instruments[0].coupling, sample.position,
                 world.pairs[0].candidates, scene.bodies[0].tissue.triangles,
                 world.bodies[0].tissue.position, world.instruments[0].tool, world.bodies[0].load);
    step_naively(scene.bodies[0].tissue, world.bodies[0].load, dt / world.bodies[0].substeps,
                 world.bodies[0].tissue, kept);
  }
}

/// [m] How far tissue and tool of both forms are apart after some ticks from the same world.
double compare_ticks(const Scene& scene, const HapticSample& sample, double dt, World ours,
                     World naive) {
  NaiveTree tree(naive.bodies[0].tissue.position, scene.bodies[0].tissue.triangles);
  NaiveVolumes kept(scene.bodies[0].tissue.volumes);
  const int ticks = afford(5, 1, 10.0 * count_work(scene, ours));
  for (int i = 0; i < ticks; ++i) {
    tick(scene, sample, dt, ours);
    tick_naively(scene, sample, dt, tree, kept, naive);
  }
  catch_up(scene, ours);
  return std::max(
      largest_difference(ours.bodies[0].tissue.position, naive.bodies[0].tissue.position),
      (ours.instruments[0].tool.position - naive.instruments[0].tool.position).norm());
}

/// The same world for the naive form, which knows no vectors.
World make_naive(const World& world) {
  World naive = world;
  naive.pairs[0].candidates.lanes = {};
  return naive;
}

BenchRow time_world(const Scene& scene, const HapticSample& sample, World world,
                    const BenchOptions& options) {
  // both forms feel the same contacts; a float and a double drift apart by rounding
  constexpr double kTickAgreement = 1e-6;
  const double dt = 1.0 / scene.rate;
  World naive = make_naive(world);
  world.follows_all = false;  // as in the live loop
  require_agreement("tick", compare_ticks(scene, sample, dt, world, naive), kTickAgreement);
  NaiveTree tree(naive.bodies[0].tissue.position, scene.bodies[0].tissue.triangles);
  NaiveVolumes kept(scene.bodies[0].tissue.volumes);
  BenchRow row = time_against(
      options, 1, [&] { tick(scene, sample, dt, world); },
      [&] { tick_naively(scene, sample, dt, tree, kept, naive); });
  if (world.alarm) throw std::logic_error("bench: tick: the tissue blew up while it was timed");
  row.substeps = world.bodies[0].substeps;
  row.share_of_bound = world.bodies[0].substeps * bound_step(scene.bodies[0].tissue) / row.median;
  const PackedKernel* packed = find_packed(world.bodies[0]);
  if (packed) row.simd_target = simd_target(*packed->model);
  row.physics = std::to_string(world.bodies[0].load.push_count) +
                " contacts, refit in turn, candidates, alarm, " +
                (packed ? "packed" : "reference") +
                " kernel; naive has a textbook tree, steps naively and has no alarm";
  return row;
}

/// [m] of the tip above it, in the air.
constexpr double kAirHeight = 5e-3;

/// Come from above and settled, a press held.
BenchRow time_press(const std::string& work, const Scene& scene, const Place& place,
                    const BenchOptions& options) {
  const HapticSample pressed = hold_at(scene, place, -kPressDepth);
  World world(scene);
  press_and_hold(work, scene, place, world);
  BenchRow row = time_world(scene, pressed, std::move(world), options);
  row.work = work;
  row.physics = "3 mm press held, " + row.physics;
  return row;
}

/// The hand in the air, and a tick so short that it takes the substeps asked for.
BenchRow time_hover(const std::string& work, int substeps, Scene scene, const Place& place,
                    const BenchOptions& options) {
  scene.rate *= double(scene.bodies[0].substeps) / substeps;
  scene.bodies[0].substeps = substeps;
  World world(scene);
  HapticSample sample = hold_at(scene, place, kAirHeight);
  const int ticks = afford(50, 5, count_work(scene, world));
  for (int i = 0; i < ticks; ++i) {
    tick(scene, sample, 1.0 / scene.rate, world);
    // in a hollow the other side is near
    if (world.pairs[0].candidates.count > 0) sample = hold_at(scene, place, kAirHeight * (i + 2));
  }
  BenchRow row = time_world(scene, sample, std::move(world), options);
  row.work = work;
  row.physics = "hand in the air, " + row.physics;
  return row;
}

}  // namespace

std::vector<BenchRow> time_ticks(const std::string& work, const Scene& scene,
                                 const BenchOptions& options) {
  const Place place = find_press_place(scene.bodies[0].tissue);
  std::vector<BenchRow> rows;
  for (const int substeps : options.air_substeps) {
    rows.push_back(time_hover(work, substeps, scene, place, options));
  }
  if (options.press) rows.push_back(time_press(work, scene, place, options));
  return rows;
}

}  // namespace palpate::bench
