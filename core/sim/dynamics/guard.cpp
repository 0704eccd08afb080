// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/laws.h"

namespace palpate {
namespace {

constexpr double kRise = 0.05;   // of E_ref in one check, ...
constexpr int kRisingSteps = 3;  // ... this often in a row
constexpr double kExcess = 0.5;  // of E_ref, at any time

/// [s] How long energy that damping has taken still counts as given: far longer than anything
/// trembles, far shorter than a lesson, over which work adds up to more than could ever blow up.
constexpr double kMemory = 1.0;

/// [m/s] Energy below that of the whole tissue moving this fast is no reason for an alarm: what
/// blows up swings in two steps, by less than 10 um at that speed, which no hand or eye notices.
/// And near rest it may be nothing but rounding: floats heat an undamped tissue of 100 000
/// particles to a tenth of this speed within some hundred steps.
constexpr double kUnnoticed = 1e-2;

/// [J] Kinetic and elastic energy one step back, at x - dt v, with the velocity halfway through the
/// kick that followed, v - dt f/(2m).
double compute_centred_energy(const TissueModel& model, const State& state, double dt) noexcept {
  double kinetic = 0.0;
  for_each_free(model, [&](int i) {
    const Vec3 v = state.velocity[i] - (0.5 * dt / model.mass[i]) * state.force[i];
    kinetic += 0.5 * model.mass[i] * v.squaredNorm();
  });
  return kinetic + laws::compute_elastic_energy(
                       model,
                       [&](int i) -> Vec3 { return state.position[i] - dt * state.velocity[i]; },
                       state.internal);
}

/// [J] what there is to blow up.
///
/// Symplectic Euler leaves velocities half a step behind positions, so that the energy of a mode w,
/// taken as it stands, trembles by a part w dt/2. Centred, that of a stable mode stays within
/// 1 - (w dt/2)² and 1 of a constant, and that of an unstable one grows as it should. The other
/// integrators have both at one time; of the two energies the smaller is the one to judge by.
double compute_least_energy(const TissueModel& model, const State& state, double dt) noexcept {
  return std::min(compute_centred_energy(model, state, dt),
                  compute_centred_energy(model, state, 0.0));
}

bool has_energy(const TissueModel& model) noexcept {
  return model.angle_law != AngleLaw::eq10 || model.angles.corners.empty();
}

double compute_unnoticed_energy(const TissueModel& model) noexcept {
  double mass = 0.0;
  for (const double m : model.mass) mass += m;
  return 0.5 * mass * kUnnoticed * kUnnoticed;
}

/// [J] done by gravity and pressure on the way from x to y: exactly m g·(y - x) for one, and for
/// the other the force half way, which on open surfaces too is right to third order.
double compute_field_work(const TissueModel& model, const Vec3& gravity, const Vec3Array& x,
                          const Vec3Array& y) noexcept {
  double work = 0.0;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    work += model.mass[i] * gravity.dot(y[i] - x[i]);
  }
  if (model.pressure == 0.0) return work;
  for (const auto& [a, b, c] : model.triangles) {
    const Vec3 at_a = 0.5 * (x[a] + y[a]), at_b = 0.5 * (x[b] + y[b]), at_c = 0.5 * (x[c] + y[c]);
    const Vec3 push = (model.pressure / 6.0) * (at_b - at_a).cross(at_c - at_a);
    work += push.dot((y[a] - x[a]) + (y[b] - x[b]) + (y[c] - x[c]));
  }
  return work;
}

/// The link that is stretched most, in `longest` if it is too long; returns the first that has
/// collapsed. Not asked of those that are `torn`.
Alarm check_links(const Links& links, const Vec3Array& x, std::size_t first_index,
                  std::span<const unsigned char> torn, Alarm& longest) noexcept {
  for (std::size_t l = 0; l < links.ends.size(); ++l) {
    if (!torn.empty() && torn[first_index + l] != 0) continue;
    const double length = (x[links.ends[l][1]] - x[links.ends[l][0]]).norm();
    const double part = length / links.rest_length[l];
    const auto index = static_cast<int>(first_index + l);
    if (part - 1.0 > std::max(kLargestStrain, longest.value)) {
      longest = {AlarmKind::overstretched, index, part - 1.0, kLargestStrain};
    }
    if (part < kShortestLink) return {AlarmKind::collapsed, index, part, kShortestLink};
  }
  return {};
}

Alarm check_volumes(const Volumes& volumes, const Vec3Array& x) noexcept {
  for (std::size_t t = 0; t < volumes.corners.size(); ++t) {
    const double part = measure_volume(volumes, t, x) / volumes.rest_volume[t];
    if (part < kSmallestVolume) {
      return {AlarmKind::inverted, static_cast<int>(t), part, kSmallestVolume};
    }
  }
  return {};
}

Alarm check_volumes(const Hyperelastic& table, const Vec3Array& rest, const Vec3Array& x) noexcept {
  for (std::size_t t = 0; t < table.corners.size(); ++t) {
    const auto& [a, b, c, d] = table.corners[t];
    const double part =
        compute_volume(x[a], x[b], x[c], x[d]) / compute_volume(rest[a], rest[b], rest[c], rest[d]);
    if (part < kSmallestVolume) {
      return {AlarmKind::inverted, static_cast<int>(t), part, kSmallestVolume};
    }
  }
  return {};
}

/// [m] Over all links, and all edges of tetrahedra at finite strain.
double find_shortest_rest_length(const TissueModel& model) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Links* links : {&model.springs, &model.bonds}) {
    for (const double length : links->rest_length) shortest = std::min(shortest, length);
  }
  const Vec3Array& x = model.rest_position;
  for (const Hyperelastic* table : {&model.corotated, &model.neo_hookean}) {
    for (const auto& corners : table->corners) {
      for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t q = 0; q < p; ++q) {
          shortest = std::min(shortest, (x[corners[p]] - x[corners[q]]).norm());
        }
      }
    }
  }
  return shortest;
}

}  // namespace

Alarm check_particles(const State& state, const Guard& guard, int steps) noexcept {
  const double farthest = kFarthestMove * guard.shortest_rest_length * steps;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const auto index = static_cast<int>(i);
    if (!state.position[i].allFinite() || !state.velocity[i].allFinite()) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      return {AlarmKind::not_finite, index, kInfinity, std::numeric_limits<double>::max()};
    }
    const double moved = (state.position[i] - guard.last_position[i]).norm();
    if (moved > farthest) return {AlarmKind::moved_far, index, moved, farthest};
  }
  return {};
}

Alarm check_strains(const TissueModel& model, const Vec3Array& x, Guard& guard) noexcept {
  Alarm longest;
  Alarm alarm = check_links(model.springs, x, 0, guard.torn_links, longest);
  const std::size_t springs = model.springs.ends.size();
  if (!alarm) alarm = check_links(model.bonds, x, springs, guard.torn_links, longest);
  if (!alarm) alarm = check_volumes(model.volumes, x);
  if (!alarm) alarm = check_volumes(model.corotated, model.rest_position, x);
  if (!alarm) alarm = check_volumes(model.neo_hookean, model.rest_position, x);
  if (!alarm) alarm = longest;
  guard.strained_checks = alarm ? guard.strained_checks + 1 : 0;
  return guard.strained_checks >= kStrainedChecks ? alarm : Alarm{};
}

/// Energy may be what was given, and as much more as finite steps make it tremble. That is
/// measured in E_ref, the most that was lately given, because pushes take back what they have given
/// while the trembling stays. Too much of it is half of E_ref at once, or three rises in a row,
/// each beyond its work by a twentieth.
///
/// Beyond w dt/2 = 0.58 one mode alone trembles by a half. A tissue with most of its energy in
/// modes that near the limit may raise the alarm though it is stable; damping, and loads spread
/// over a patch, leave little energy there. Eq 10 has no energy, so this tells nothing about it.
Alarm check_energy(const TissueModel& model, double energy, double work, double elapsed,
                   Guard& guard) noexcept {
  const double fade = std::min(1.0, elapsed / kMemory);
  guard.work += work;
  guard.given_energy += work;
  const double given = guard.given_energy;
  const double now = std::max(given, guard.unnoticed_energy);
  double& reference = guard.reference_energy;
  reference = std::max(now, reference - fade * (reference - now));
  const double rise = energy - guard.last_energy - work;
  const double largest_rise = kRise * reference, most = given + kExcess * reference;
  const bool rises = rise > largest_rise && energy > given;
  guard.rising_steps = rises ? guard.rising_steps + 1 : 0;
  guard.last_energy = energy;
  guard.given_energy -= fade * std::max(0.0, given - energy);

  if (!has_energy(model)) return {};
  if (energy > most) return {AlarmKind::energy, -1, energy, most};
  if (guard.rising_steps >= kRisingSteps) return {AlarmKind::energy, -1, rise, largest_rise};
  return {};
}

double find_strain_limit(const TissueModel& model) noexcept {
  return has_energy(model) ? kTornStrain : kLargestStrain;
}

/// What energy trembles by in one check is no confirmation.
Alarm confirm(const TissueModel& model, const Alarm& far, const Alarm& strained,
              Guard& guard) noexcept {
  const double most = guard.given_energy + kRise * guard.reference_energy;
  const bool is_explained = has_energy(model) && guard.last_energy <= most;
  if (far && !is_explained) return far;
  if (strained.kind != AlarmKind::overstretched || !is_explained) return strained;
  guard.strained_checks = 0;
  if (!(strained.value > kTornStrain)) return {};
  Alarm torn = strained;
  torn.limit = kTornStrain;
  return torn;
}

Guard::Guard(const TissueModel& model, const Vec3&, const State& state)
    : last_position(state.position),
      last_time(state.time),
      shortest_rest_length(find_shortest_rest_length(model)),
      start_energy(compute_centred_energy(model, state, 0.0)),
      last_energy(start_energy),
      given_energy(start_energy),
      unnoticed_energy(compute_unnoticed_energy(model)),
      reference_energy(std::max(start_energy, unnoticed_energy)) {}

Alarm check(const TissueModel& model, const Vec3& gravity, const State& state, double work,
            Guard& guard, int steps) noexcept {
  const Alarm found = check_particles(state, guard, steps);
  const Alarm far = found.kind == AlarmKind::moved_far ? found : Alarm{};
  Alarm alarm = far ? Alarm{} : found;
  const Alarm strained = alarm ? Alarm{} : check_strains(model, state.position, guard);
  if (!alarm) {
    const double elapsed = std::max(0.0, state.time - guard.last_time);
    const double energy = compute_least_energy(model, state, elapsed / steps) - guard.torn_energy;
    const double field = compute_field_work(model, gravity, guard.last_position, state.position);
    alarm = check_energy(model, energy, work + field, elapsed, guard);
  }
  if (!alarm) alarm = confirm(model, far, strained, guard);
  if (!alarm) std::copy(state.position.begin(), state.position.end(), guard.last_position.begin());
  guard.last_time = state.time;
  if (alarm) alarm.time = state.time;
  return alarm;
}

}  // namespace palpate
