// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>

#include "palpate/bench/bench.h"
#include "palpate/bench/check_options.h"
#include "palpate/bench/time_linear.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/time_ticks.h"

namespace palpate::bench {

std::vector<std::string> bench_body_works() {
  return {"shell_step", "shell_tick", "solid_step", "solid_tick", "linear_step", "linear_tick"};
}

namespace {

/// What the works of this tissue are called.
std::string find_kind(const Scene& scene) {
  const TissueModel& tissue = scene.bodies[0].tissue;
  const bool one_surface = tissue.skin.corners.empty() && !tissue.triangles.empty();
  if (one_surface && !tissue.prisms.corners.empty()) return "shell";
  if (one_surface && !tissue.volumes.corners.empty()) return "solid";
  if (one_surface && scene.bodies[0].response) return "linear";
  throw std::invalid_argument(
      "run_body_bench: expected a scene of a shell, or of a solid or linear solid without a skin");
}

}  // namespace

std::vector<BenchRow> run_body_bench(const Scene& scene, const BenchOptions& options) {
  check_options("run_body_bench", bench_body_works(), options);
  const std::string kind = find_kind(scene);
  std::vector<BenchRow> rows;
  const auto add = [&](std::vector<BenchRow> made) {
    for (BenchRow& row : made) {
      row.vertices = particle_count(scene.bodies[0].tissue);
      rows.push_back(std::move(row));
    }
  };
  const std::string step = kind + "_step", tick = kind + "_tick";
  if (is_wanted(step, options)) {
    add({kind == "linear" ? time_linear_step(step, scene, options)
                          : time_step(step, scene, options)});
  }
  if (is_wanted(tick, options)) {
    add(kind == "linear" ? time_linear_ticks(tick, scene, options)
                         : time_ticks(tick, scene, options));
  }
  return rows;
}

}  // namespace palpate::bench
