// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/time_steps.h"

#include <algorithm>
#include <random>
#include <sstream>

#include "palpate/bench/limits.h"
#include "palpate/bench/naive.h"
#include "palpate/bench/timing.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/packed/private/packed.h"

namespace palpate::bench {
namespace {

constexpr int kAgreementSteps = 20;
/// [m] Both in double, they run different operations: only rounding may differ.
constexpr double kDoubleAgreement = 1e-9;
/// [m] A float rounds forces to some 1e-6; what tests/core/packed/test_packed.cpp allows 0.1 s.
constexpr double kFloatAgreement = 1e-7;

bool is_damped(const Links& links) {
  return std::any_of(links.damping.begin(), links.damping.end(), [](double c) { return c > 0.0; });
}

/// What a step does, counted in the kernels: float operations and bytes of each element.
struct Count {
  double operations, bytes;
};

Count count_step(const TissueModel& model) {
  const bool damped = is_damped(model.springs) || is_damped(model.bonds);
  const double particles = particle_count(model);
  const double link_ends = 2.0 * static_cast<double>(model.springs.ends.size());
  const double triangles = static_cast<double>(model.angles.corners.size());
  // per link end: differences 3, square 5, inverse root 5, scale 2, force 6; a dashpot 3 + 5 + 5
  const double per_end = damped ? 34.0 : 21.0;
  // per triangle: sides 9, squares 15, roots 15, lengths, cosines 18, tensions 45, pulls 18, sums 9
  const double per_triangle = damped ? 173.0 : 134.0;
  // per tetrahedron: sides and faces 36, twice with means; volume 5, its law 36, pulls 27, sums 8
  const double tetrahedra = static_cast<double>(model.volumes.corners.size());
  const double per_tetrahedron = model.volumes.nodal_share > 0.0 ? 153.0 : 104.0;
  // per prism: three sides of two diagonals, 16 each, shear 2, pulls 18; a dashpot 16
  const double prisms = static_cast<double>(model.prisms.corners.size());
  const double per_prism = damped ? 204.0 : 156.0;
  // a particle: rest, displacement, velocity and rows read and written
  const double per_particle = damped ? 130.0 : 98.0;
  return {per_end * link_ends + per_triangle * triangles + per_tetrahedron * tetrahedra +
              per_prism * prisms + 30.0 * particles,
          (damped ? 16.0 : 12.0) * link_ends + (damped ? 48.0 : 36.0) * triangles +
              40.0 * tetrahedra + (damped ? 60.0 : 48.0) * prisms + per_particle * particles};
}

BenchRow time_packed(const TissueModel& model, const Load& load, double dt, const State& start,
                     const std::function<void()>& naively, const BenchOptions& options) {
  const PackedModel packed = pack(model);
  PackedState state(packed, model, start);
  BenchRow row = time_against(
      options, 1, [&] { step(packed, load, dt, state); }, naively);
  row.simd_target = simd_target(packed);
  row.share_of_bound = bound_step(model) / row.median;
  return row;
}

std::string name_terms(const TissueModel& model) {
  if (!model.volumes.corners.empty()) {
    std::ostringstream share;
    share << model.volumes.nodal_share;
    return "springs with dashpots, volumes with a nodal share of " + share.str();
  }
  if (!model.prisms.corners.empty()) {
    return "two exact membranes with dashpots, pillars, shear of the sides";
  }
  const bool molecular = !model.bonds.ends.empty();
  const bool damped = is_damped(molecular ? model.bonds : model.springs);
  return std::string(molecular ? "bonds" : "springs") + (damped ? " with dashpots" : "") +
         (molecular ? ", angles, stretch-bend" : "");
}

std::size_t count_elements(const TissueModel& model) {
  if (!model.volumes.corners.empty()) return model.volumes.corners.size();
  if (!model.prisms.corners.empty()) return model.prisms.corners.size();
  return std::max(model.springs.ends.size(), model.angles.corners.size());
}

/// [m] How far apart the naive form and ours are after some steps from the same start.
double compare_ends(const TissueModel& model, const Load& load, double dt, const State& start) {
  State naive = start, ours = start;
  NaiveVolumes kept(model.volumes);
  for (int s = 0; s < kAgreementSteps; ++s) step_naively(model, load, dt, naive, kept);
  if (simd_targets().empty()) {
    for (int s = 0; s < kAgreementSteps; ++s) step(model, load, dt, ours);
  } else {
    const PackedModel packed = pack(model);
    PackedState running(packed, model, start);
    for (int s = 0; s < kAgreementSteps; ++s) step(packed, load, dt, running);
    unpack(packed, model, running, ours);
  }
  return largest_difference(ours.position, naive.position);
}

}  // namespace

TissueModel without_dashpots(TissueModel model) {
  std::fill(model.springs.damping.begin(), model.springs.damping.end(), 0.0);
  std::fill(model.bonds.damping.begin(), model.bonds.damping.end(), 0.0);
  return model;
}

State shake(const TissueModel& model) {
  State state(model);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> offset(-1.0, 1.0);
  // on a fine mesh that would be a wreck, whose motion amplifies every rounding
  double size = 1e-3 * compute_diagonal(model.rest_position);
  for (const Links* links : {&model.springs, &model.bonds}) {
    for (const double length : links->rest_length) size = std::min(size, 0.1 * length);
  }
  for (Vec3& x : state.position) x += size * Vec3(offset(random), offset(random), offset(random));
  for (const int i : model.fixed) {
    state.position[static_cast<std::size_t>(i)] = model.rest_position[static_cast<std::size_t>(i)];
  }
  return state;
}

double bound_step(const TissueModel& model) {
  if (simd_targets().empty()) return 0.0;
  const Count count = count_step(model);
  const Limits limits =
      measure_limits(simd_targets().front(), static_cast<std::size_t>(count.bytes));
  return compute_bound(limits, count.operations, count.bytes);
}

BenchRow time_step(const std::string& work, const Scene& scene, const BenchOptions& options) {
  const TissueModel& model = scene.bodies[0].tissue;
  const double dt = 1.0 / scene.rate / scene.bodies[0].substeps;
  Load load;
  load.gravity = {0.0, 0.0, -9.81};
  const State start = shake(model);
  const bool packed = !simd_targets().empty();
  require_agreement(work, compare_ends(model, load, dt, start),
                    packed ? kFloatAgreement : kDoubleAgreement);

  State naive = start, ours = start;
  NaiveVolumes kept(model.volumes);
  const auto naively = [&] { step_naively(model, load, dt, naive, kept); };
  BenchRow row = packed ? time_packed(model, load, dt, start, naively, options)
                        : time_against(
                              options, 1, [&] { step(model, load, dt, ours); }, naively);
  row.work = work;
  row.elements = static_cast<double>(count_elements(model));
  row.physics = name_terms(model) + (model.home.empty() ? "" : ", home") +
                ", drag, gravity; symplectic Euler, " +
                (packed ? "packed kernel in float" : "reference kernel in double");
  return row;
}

}  // namespace palpate::bench
