// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/time_active.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "palpate/bench/naive.h"
#include "palpate/bench/press_and_hold.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/timing.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate::bench {
namespace {

/// Particle steps, enough to come down at 30 mm/s. The rule of the active set is for a hand, not
/// for an impact: on 500k vertices a press at 150 mm/s was off by 0.64 %, at 30 mm/s by 0.14 %.
constexpr double kSlowly = 1e11;

/// [-] of the force of the press that sleeping tissue may cost.
constexpr double kAllowedError = 2e-3;

double largest_norm(const Vec3Array& forces) {
  double largest = 0.0;
  for (const Vec3& force : forces) largest = std::max(largest, force.norm());
  return largest;
}

/// [-] of the largest force of the full run.
double compare_forces(const Vec3Array& full, const Vec3Array& active) {
  double most = 0.0;
  for (std::size_t i = 0; i < full.size(); ++i) most = std::max(most, (full[i] - active[i]).norm());
  return most / largest_norm(full);
}

std::string describe(const PackedKernel& kernel, double error) {
  std::ostringstream text;
  text << "3 mm press held, springs with dashpots, home, drag; " << kernel.state.slices.count
       << " of " << kernel.model->slice_count << " slices awake; force off by "
       << std::setprecision(2) << 100.0 * error << " % of the press, " << 100.0 * kAllowedError
       << " % allowed; naive steps all of it";
  return text.str();
}

}  // namespace

BenchRow time_active_step(const std::string& work, const Scene& scene,
                          const BenchOptions& options) {
  const Place place = find_press_place(scene.bodies[0].tissue);
  World full(scene);
  const Vec3Array forces = press_and_hold(work, scene, place, full, kSlowly);
  Scene sleeping = scene;
  sleeping.bodies[0].force_error = kAllowedError * largest_norm(forces);
  World world(sleeping);
  PackedKernel* const kernel = find_packed(world.bodies[0]);
  if (!kernel) throw std::logic_error("bench: " + work + ": no vector code here");
  const double error =
      compare_forces(forces, press_and_hold(work, sleeping, place, world, kSlowly));
  if (!(error <= kAllowedError)) {
    throw std::logic_error("bench: " + work + ": the force is off by " + std::to_string(error) +
                           " of the press, expected at most " + std::to_string(kAllowedError));
  }
  const double dt = 1.0 / scene.rate / world.bodies[0].substeps;
  BenchRow row = time_against(
      options, 1, [&] { step(*kernel->model, world.bodies[0].load, dt, kernel->state); },
      [&] {
        step_naively(scene.bodies[0].tissue, full.bodies[0].load, dt, full.bodies[0].tissue);
      });
  row.work = work;
  row.elements = static_cast<double>(scene.bodies[0].tissue.springs.ends.size());
  const double awake = double(kernel->state.slices.count) / kernel->model->slice_count;
  row.share_of_bound = awake * bound_step(scene.bodies[0].tissue) / row.median;
  row.simd_target = simd_target(*kernel->model);
  row.physics = describe(*kernel, error);
  return row;
}

}  // namespace palpate::bench
