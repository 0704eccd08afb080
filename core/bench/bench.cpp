// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/bench.h"

#include <algorithm>
#include <stdexcept>

#include "palpate/bench/naive.h"
#include "palpate/bench/time_queries.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/timing.h"
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

BenchRow time_tick(const std::string& work, const Scene& scene, const BenchOptions& options) {
  const double dt = 1.0 / scene.rate;
  HapticSample sample = press_sample(scene);
  World world(scene);
  // come from above and settle, then time the held press
  const Vec3 inside = sample.position;
  for (int i = 0; i <= 300; ++i) {
    sample.time = i * dt;
    sample.position = inside + Vec3(0.0, 0.0, std::max(0.0, 6e-3 * (1.0 - i / 200.0)));
    tick(scene, sample, dt, world);
  }
  if (world.alarm) throw std::logic_error("bench: " + work + ": the held press blew up");
  World naive_world = world;
  BenchRow row = time_against(
      options, 1, [&] { tick(scene, sample, dt, world); },
      [&] { tick_naively(scene, sample, dt, naive_world); });
  row.work = work;
  row.physics = "3 mm press held, " + std::to_string(world.substeps) + " substeps, " +
                std::to_string(world.load.push_count) +
                " contacts; naive searches every triangle and steps naively";
  return row;
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
  rows.push_back(time_tick("mss_tick", mass_spring, options));
  rows.push_back(time_tick("mms_tick", molecular, options));
  for (BenchRow& row : rows) row.vertices = particle_count(mass_spring.tissue);
  return rows;
}

}  // namespace palpate::bench
