// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/bench.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "palpate/bench/check_options.h"
#include "palpate/bench/time_active.h"
#include "palpate/bench/time_queries.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/time_ticks.h"
#include "palpate/sim/packed/simd_targets.h"

namespace palpate::bench {
namespace {

Scene without_dashpots_in(const Scene& scene) {
  Scene plain = scene;
  plain.bodies[0].tissue = without_dashpots(scene.bodies[0].tissue);
  // without damping fewer substeps are needed, but the same are taken, so that rows compare
  plain.bodies[0].spectrum_damping = 0.0;
  return plain;
}

using Timer = std::function<std::vector<BenchRow>(const std::string& work, const Scene& mass_spring,
                                                  const Scene& molecular, const BenchOptions&)>;
struct Work {
  std::string name;
  Timer time;
};

Timer step_timer(bool of_molecular, bool damped) {
  return [=](const std::string& work, const Scene& mass_spring, const Scene& molecular,
             const BenchOptions& options) -> std::vector<BenchRow> {
    const Scene& scene = of_molecular ? molecular : mass_spring;
    return {time_step(work, damped ? scene : without_dashpots_in(scene), options)};
  };
}

Timer tick_timer(bool of_molecular, bool damped) {
  return [=](const std::string& work, const Scene& mass_spring, const Scene& molecular,
             const BenchOptions& options) {
    const Scene& scene = of_molecular ? molecular : mass_spring;
    return time_ticks(work, damped ? scene : without_dashpots_in(scene), options);
  };
}

std::vector<BenchRow> time_active_work(const std::string& work, const Scene& mass_spring,
                                       const Scene&, const BenchOptions& options) {
  return {time_active_step(work, mass_spring, options)};
}

std::vector<BenchRow> time_tree_work(const std::string& work, const Scene& mass_spring,
                                     const Scene&, const BenchOptions& options) {
  return {work == "refit" ? time_refit(mass_spring.bodies[0].tissue, options)
                          : time_query(work, mass_spring.bodies[0].tissue, options)};
}

const std::vector<Work>& works() {
  static const std::vector<Work> all = {
      {"mss_step", step_timer(false, false)},
      {"mss_dashpot_step", step_timer(false, true)},
      {"mms_step", step_timer(true, false)},
      {"mms_dashpot_step", step_timer(true, true)},
      {"refit", time_tree_work},
      {"segment", time_tree_work},
      {"closest", time_tree_work},
      {"sphere", time_tree_work},
      {"mss_tick", tick_timer(false, false)},
      {"mss_dashpot_tick", tick_timer(false, true)},
      {"mms_tick", tick_timer(true, false)},
      {"mms_dashpot_tick", tick_timer(true, true)},
      {"active_step", time_active_work},
  };
  return all;
}

void check(const Scene& mass_spring, const Scene& molecular, const BenchOptions& options) {
  if (mass_spring.bodies[0].tissue.springs.ends.empty() ||
      molecular.bodies[0].tissue.bonds.ends.empty() ||
      mass_spring.bodies[0].tissue.triangles != molecular.bodies[0].tissue.triangles) {
    throw std::invalid_argument(
        "run_bench: expected a mass-spring and a molecular scene on the same surface");
  }
  check_options("run_bench", bench_works(), options);
}

}  // namespace

bool is_wanted(const std::string& work, const BenchOptions& options) {
  return options.works.empty() ||
         std::find(options.works.begin(), options.works.end(), work) != options.works.end();
}

void check_options(const std::string& where, const std::vector<std::string>& known,
                   const BenchOptions& options) {
  for (const std::string& work : options.works) {
    if (std::find(known.begin(), known.end(), work) != known.end()) continue;
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    throw std::invalid_argument(where + ": works: got '" + work + "', expected one of " + names);
  }
  for (const int substeps : options.air_substeps) {
    if (substeps >= 1) continue;
    throw std::invalid_argument(where + ": air_substeps: got " + std::to_string(substeps) +
                                ", expected at least 1");
  }
}

std::vector<std::string> bench_works() {
  std::vector<std::string> names;
  for (const Work& work : works()) {
    // nothing sleeps under the reference kernel
    if (work.name == "active_step" && simd_targets().empty()) continue;
    names.push_back(work.name);
  }
  return names;
}

std::vector<BenchRow> run_bench(const Scene& mass_spring, const Scene& molecular,
                                const BenchOptions& options) {
  check(mass_spring, molecular, options);
  std::vector<BenchRow> rows;
  const std::vector<std::string> names = bench_works();
  for (const auto& [name, time] : works()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    if (!is_wanted(name, options)) continue;
    for (BenchRow& row : time(name, mass_spring, molecular, options)) {
      row.vertices = particle_count(mass_spring.bodies[0].tissue);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace palpate::bench
