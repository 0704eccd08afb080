// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/time_linear.h"

#include <algorithm>

#include "palpate/bench/limits.h"
#include "palpate/bench/naive_linear.h"
#include "palpate/bench/naive_tree.h"
#include "palpate/bench/press_and_hold.h"
#include "palpate/bench/timing.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/response/private/relax.h"
#include "palpate/sim/tick/private/linear_tick.h"

namespace palpate::bench {
namespace {

constexpr int kAgreementSteps = 20;
/// [m] The response is kept in floats, of some millimetres.
constexpr double kStepAgreement = 1e-7;
/// [m] What the tool feels follows, tick after tick (time_ticks.cpp).
constexpr double kTickAgreement = 1e-6;
/// [-] of the path, the share of a step: near the end of it a step has as much to do as ever.
constexpr double kShare = 0.3;
/// [m] of the tip above the surface, in the air.
constexpr double kAirHeight = 5e-3;

/// Three rows of the response for every particle that is pushed.
double count_rows(const TissueModel& tissue, const Load& load) {
  std::vector<int> pushed;
  for (const Push& push : load.pushes()) {
    const Triangle& corners = tissue.triangles[static_cast<std::size_t>(push.triangle)];
    pushed.insert(pushed.end(), corners.begin(), corners.end());
  }
  std::sort(pushed.begin(), pushed.end());
  pushed.erase(std::unique(pushed.begin(), pushed.end()), pushed.end());
  return 3.0 * static_cast<double>(pushed.size());
}

/// [s] at least: a multiplication and an addition for each number of the rows that are read, and
/// three for each displacement, read and written.
double bound_settling(const Scene& scene, const Load& load) {
  if (simd_targets().empty()) return 0.0;
  const double width = 3.0 * scene.bodies[0].response->size.moved;
  const double numbers = width * count_rows(scene.bodies[0].tissue, load);
  const double operations = 2.0 * numbers + 3.0 * width;
  const double bytes = 4.0 * numbers + 20.0 * width;
  const Limits limits = measure_limits(simd_targets().front(), static_cast<std::size_t>(bytes));
  return compute_bound(limits, operations, bytes);
}

/// Come from above and settled, a press held.
World press(const std::string& work, const Scene& scene, const Place& place) {
  World world(scene);
  press_and_hold(work, scene, place, world);
  return world;
}

/// The tick of a first program: the textbook tree, everything moved in every substep.
void tick_naively(const Scene& scene, const HapticSample& sample, double dt, NaiveTree& tree,
                  NaiveResponse& response, World& world) {
  find_naively(scene, sample, tree, world);
  for (int s = 0; s < world.bodies[0].substeps; ++s) {
    balance_tool(scene.instruments[0].tool, scene.instruments[0].coupling, sample.position,
                 world.pairs[0].candidates, scene.bodies[0].tissue.triangles,
                 world.bodies[0].tissue.position, world.instruments[0].tool, world.bodies[0].load);
    const double share = choose_linear_share(scene, 0, dt / world.bodies[0].substeps,
                                             *find_response(world.bodies[0]), world);
    response.step(scene.bodies[0].tissue, world.bodies[0].load, share,
                  world.bodies[0].tissue.position);
  }
}

/// [m] How far tissue and tool of both forms are apart after some ticks from the same world.
double compare_ticks(const Scene& scene, const HapticSample& sample, World ours, World naive) {
  NaiveTree tree(naive.bodies[0].tissue.position, scene.bodies[0].tissue.triangles);
  NaiveResponse response(*scene.bodies[0].response);
  response.follow(find_response(naive.bodies[0])->state);
  for (int i = 0; i < 5; ++i) {
    tick(scene, sample, 1.0 / scene.rate, ours);
    tick_naively(scene, sample, 1.0 / scene.rate, tree, response, naive);
  }
  return std::max(
      largest_difference(ours.bodies[0].tissue.position, naive.bodies[0].tissue.position),
      (ours.instruments[0].tool.position - naive.instruments[0].tool.position).norm());
}

BenchRow time_world(const std::string& work, const Scene& scene, const HapticSample& sample,
                    World world, const BenchOptions& options) {
  World naive = world;
  naive.pairs[0].candidates.lanes = {};  // which knows no vectors
  require_agreement(work, compare_ticks(scene, sample, world, naive), kTickAgreement);
  NaiveTree tree(naive.bodies[0].tissue.position, scene.bodies[0].tissue.triangles);
  NaiveResponse response(*scene.bodies[0].response);
  response.follow(find_response(naive.bodies[0])->state);
  const double dt = 1.0 / scene.rate;
  BenchRow row = time_against(
      options, 1, [&] { tick(scene, sample, dt, world); },
      [&] { tick_naively(scene, sample, dt, tree, response, naive); });
  row.work = work;
  row.substeps = world.bodies[0].substeps;
  row.share_of_bound = bound_settling(scene, world.bodies[0].load) / row.median;
  if (!simd_targets().empty()) row.simd_target = simd_targets().front();
  row.physics = std::to_string(world.bodies[0].load.push_count) +
                " contacts, refit, candidates, depth of the press, response in float; naive has a "
                "textbook tree, moves everything in every substep and checks no depth";
  return row;
}

}  // namespace

BenchRow time_linear_step(const std::string& work, const Scene& scene,
                          const BenchOptions& options) {
  const World world = press(work, scene, find_press_place(scene.bodies[0].tissue));
  ResponseState ours(*scene.bodies[0].response);
  NaiveResponse naive(*scene.bodies[0].response);
  Vec3Array x = scene.bodies[0].tissue.rest_position, y = x;
  const auto step_ours = [&] {
    relax(*scene.bodies[0].response, scene.bodies[0].tissue, world.bodies[0].load, kShare, ours);
    settle(*scene.bodies[0].response, scene.bodies[0].tissue, ours, x);
  };
  const auto step_naively = [&] {
    naive.step(scene.bodies[0].tissue, world.bodies[0].load, kShare, y);
  };
  for (int s = 0; s < kAgreementSteps; ++s) {
    step_ours();
    step_naively();
  }
  require_agreement(work, largest_difference(x, y), kStepAgreement);
  BenchRow row = time_against(options, 1, step_ours, step_naively);
  row.work = work;
  row.elements = scene.bodies[0].response->size.moved;
  row.share_of_bound = bound_settling(scene, world.bodies[0].load) / row.median;
  if (!simd_targets().empty()) row.simd_target = simd_targets().front();
  row.physics = std::to_string(world.bodies[0].load.push_count) +
                " contacts held, damping, gravity; quasi-static, the response in float";
  return row;
}

std::vector<BenchRow> time_linear_ticks(const std::string& work, const Scene& scene,
                                        const BenchOptions& options) {
  const Place place = find_press_place(scene.bodies[0].tissue);
  std::vector<BenchRow> rows;
  World hovering(scene);
  const HapticSample above = hold_at(scene, place, kAirHeight);
  for (int i = 0; i < 5; ++i) tick(scene, above, 1.0 / scene.rate, hovering);
  rows.push_back(time_world(work, scene, above, std::move(hovering), options));
  rows.back().physics = "hand in the air, " + rows.back().physics;
  if (!options.press) return rows;
  rows.push_back(time_world(work, scene, hold_at(scene, place, -kPressDepth),
                            press(work, scene, place), options));
  rows.back().physics = "3 mm press held, " + rows.back().physics;
  return rows;
}

}  // namespace palpate::bench
