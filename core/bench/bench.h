// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "palpate/sim/tick/scene.h"

namespace palpate::bench {

/// What one piece of work costs, beside the same work done naively in the same process.
struct BenchRow {
  std::string work;  ///< "mss_step", "refit", "mms_tick", ...
  int vertices = 0;
  int substeps = 0;             ///< of a tick; 0 for other work
  double median = 0.0;          ///< [s] CPU time of the calling thread
  double p99 = 0.0;             ///< [s]
  double naive_median = 0.0;    ///< [s] of the naive form
  double ratio_to_naive = 0.0;  ///< [-] naive_median / median: above 1 is faster than naive
  double elements = 1.0;  ///< links, triangles, queries, ... that the time is for; 1 for a tick
  /// [-] the least time this machine needs, by its measured arithmetic and memory, over median; 0
  /// where no such time is stated
  double share_of_bound = 0.0;
  std::string simd_target;     ///< "AVX3", "AVX2", ...; empty for plain code
  std::string compiler_flags;  ///< of all forms alike
  std::string physics;         ///< what is in it, in words

  /// [ns]
  double ns_per_element() const noexcept { return 1e9 * median / elements; }
};

struct BenchOptions {
  double budget = 0.4;  ///< [s] of CPU time per row, the naive form not counted
  int least_runs = 30;  ///< fewer where a run takes so long that they would take 20 budgets
  std::vector<std::string> works = {};  ///< of bench_works(); all where empty
  std::vector<int> air_substeps = {1};  ///< of ticks with the hand in the air: a row for each
  bool press = true;                    ///< and a row with a press held, at its own substeps
};

/// Every work this machine can do, in the order of the rows.
std::vector<std::string> bench_works();

/// Times the steps, queries and ticks of two scenes on the same surface, one of the mass-spring
/// and one of the molecular model. Ours and the naive form take turns, so a slow moment of the
/// machine falls on both. The ends of both are compared before a ratio is stated: throws
/// std::logic_error where they disagree, std::invalid_argument where the scenes do not fit or a
/// work is not known.
std::vector<BenchRow> run_bench(const Scene& mass_spring, const Scene& molecular,
                                const BenchOptions& options = {});

/// Every work of bodies: walls of prisms, solids of springs and volumes, linear solids.
std::vector<std::string> bench_body_works();

/// Times the step and the tick of one body beside its naive form, as run_bench does. What is asked
/// for and not of this kind of body is left out. A linear solid has one row in the air, since its
/// ticks there have one substep. Throws as run_bench does, and std::invalid_argument for a tissue
/// of another kind or under a skin.
std::vector<BenchRow> run_body_bench(const Scene& scene, const BenchOptions& options = {});

}  // namespace palpate::bench
