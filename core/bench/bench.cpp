// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/bench.h"

#include <algorithm>
#include <stdexcept>

#include "palpate/bench/naive.h"
#include "palpate/bench/time_queries.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/timing.h"
#include "palpate/sim/dynamics/packed.h"
#include "palpate/sim/haptics/tick.h"

namespace palpate::bench {
namespace {

/// A tip 3 mm inside the highest vertex, as in the middle of a press.
HapticSample press_sample(const Scene& scene) {
  const auto& x = scene.tissue.rest_position;
  const auto highest = std::max_element(x.begin(), x.end(),
                                        [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  HapticSample sample;
  sample.position = *highest + Vec3(0.0, 0.0, scene.tool.radius - 3e-3);
  return sample;
}

/// The tick of a first program: every triangle a candidate, plain steps, nothing guarded.
void tick_naively(const Scene& scene, const HapticSample& sample, double dt, World& world) {
  world.candidates.count = find_in_sphere_naively(
      scene.tissue.triangles, world.tissue.position, world.tool.position,
      scene.tool.radius + kCandidateMargin + (sample.position - world.tool.position).norm(),
      world.candidates.triangles);
  for (int i = 0; i < world.candidates.count; ++i) {
    const auto slot = static_cast<std::size_t>(i);
    world.candidates.areas[slot] =
        scene.rest_areas[static_cast<std::size_t>(world.candidates.triangles[slot])];
  }
  for (int s = 0; s < world.substeps; ++s) {
    balance_tool(scene.tool, scene.coupling, sample.position, world.candidates,
                 scene.tissue.triangles, world.tissue.position, world.tool, world.load);
    step_naively(scene.tissue, world.load, dt / world.substeps, world.tissue);
  }
}

/// [m] How far tissue and tool of both forms are apart after some ticks from the same world.
double compare_ticks(const Scene& scene, const HapticSample& sample, double dt, World ours,
                     World naive) {
  constexpr int kTicks = 5;
  for (int i = 0; i < kTicks; ++i) {
    tick(scene, sample, dt, ours);
    tick_naively(scene, sample, dt, naive);
  }
  return std::max(largest_difference(ours.tissue.position, naive.tissue.position),
                  (ours.tool.position - naive.tool.position).norm());
}

/// The same world for the naive form, which knows no vectors.
World make_naive(const World& world) {
  World naive = world;
  naive.tool.lanes = {};
  return naive;
}

BenchRow time_world(const Scene& scene, const HapticSample& sample, World world,
                    const BenchOptions& options) {
  // both forms feel the same contacts; a float and a double drift apart by rounding
  constexpr double kTickAgreement = 1e-6;
  const double dt = 1.0 / scene.rate;
  World naive = make_naive(world);
  require_agreement("tick", compare_ticks(scene, sample, dt, world, naive), kTickAgreement);
  BenchRow row = time_against(
      options, 1, [&] { tick(scene, sample, dt, world); },
      [&] { tick_naively(scene, sample, dt, naive); });
  row.substeps = world.substeps;
  row.share_of_bound = world.substeps * bound_step(scene.tissue) / row.median;
  if (world.packed_model) row.simd_target = simd_target(*world.packed_model);
  row.physics = std::to_string(world.load.push_count) + " contacts, alarm, " +
                (world.packed_model ? "packed" : "reference") +
                " kernel; naive searches every triangle, steps naively and has no alarm";
  return row;
}

/// Come from above and settled, a press held.
BenchRow time_press(const std::string& work, const Scene& scene, const BenchOptions& options) {
  const double dt = 1.0 / scene.rate;
  HapticSample sample = press_sample(scene);
  World world(scene);
  const Vec3 inside = sample.position;
  for (int i = 0; i <= 300; ++i) {
    sample.time = i * dt;
    sample.position = inside + Vec3(0.0, 0.0, std::max(0.0, 6e-3 * (1.0 - i / 200.0)));
    tick(scene, sample, dt, world);
  }
  if (world.alarm) throw std::logic_error("bench: " + work + ": the held press blew up");
  BenchRow row = time_world(scene, sample, std::move(world), options);
  row.work = work;
  row.physics = "3 mm press held, " + row.physics;
  return row;
}

/// The hand in the air, 5 mm above, and a tick as short as one substep of the press.
BenchRow time_hover(const std::string& work, Scene scene, const BenchOptions& options) {
  scene.rate *= scene.substeps;
  scene.substeps = 1;
  HapticSample sample = press_sample(scene);
  sample.position.z() += 8e-3;
  World world(scene);
  for (int i = 0; i < 50; ++i) tick(scene, sample, 1.0 / scene.rate, world);
  BenchRow row = time_world(scene, sample, std::move(world), options);
  row.work = work;
  row.physics = "hand in the air, " + row.physics;
  return row;
}

std::vector<BenchRow> time_ticks(const std::string& work, const Scene& scene,
                                 const BenchOptions& options) {
  Scene plain = scene;
  plain.tissue = without_dashpots(scene.tissue);
  // without damping fewer substeps are needed, but the same are taken, so that rows compare
  plain.spectrum_damping = 0.0;
  return {time_hover(work + "_tick", plain, options),
          time_hover(work + "_dashpot_tick", scene, options),
          time_press(work + "_tick", plain, options),
          time_press(work + "_dashpot_tick", scene, options)};
}

}  // namespace

std::vector<BenchRow> run_bench(const Scene& mass_spring, const Scene& molecular,
                                const BenchOptions& options) {
  if (mass_spring.tissue.springs.ends.empty() || molecular.tissue.bonds.ends.empty() ||
      mass_spring.tissue.triangles != molecular.tissue.triangles) {
    throw std::invalid_argument(
        "run_bench: expected a mass-spring and a molecular scene on the same surface");
  }
  std::vector<BenchRow> rows = time_steps(mass_spring, molecular, options);
  rows.push_back(time_refit(mass_spring.tissue, options));
  for (BenchRow& row : time_queries(mass_spring.tissue, options)) rows.push_back(std::move(row));
  for (BenchRow& row : time_ticks("mss", mass_spring, options)) rows.push_back(std::move(row));
  for (BenchRow& row : time_ticks("mms", molecular, options)) rows.push_back(std::move(row));
  for (BenchRow& row : rows) row.vertices = particle_count(mass_spring.tissue);
  return rows;
}

}  // namespace palpate::bench
