// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/packed.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/packed/private/packed_kernels.h"

namespace palpate {
namespace {

/// Where a particle's three numbers stand, `width` apart.
std::size_t find_in_slices(const PackedModel& model, std::size_t row) noexcept {
  const std::size_t lane = row & static_cast<std::size_t>(model.width - 1);
  return 3 * (row - lane) + lane;
}

/// Whether more than pushes is added to the force rows.
bool has_added_forces(const PackedModel& model) noexcept {
  if (model.skin.pack_count > 0) return true;
  return std::ranges::any_of(model.kernels->laws, [&](const packed_kernels::PackedLaw& law) {
    return law.is_present(model);
  });
}

/// Calls take(row, weight) for every particle that carries a vertex of the surface.
template <class Take>
void for_each_carrier(const PackedModel& model, int vertex, Take take) noexcept {
  const auto v = static_cast<std::size_t>(vertex);
  if (model.riding.corners.empty()) return take(v, 1.0);
  for (std::size_t k = 0; k < 4; ++k) {
    take(static_cast<std::size_t>(model.riding.corners[v][k]), model.riding.weights[v][k]);
  }
}

/// The slice of a row. A width is a power of two, and a division costs more than all the rest.
std::size_t find_slice(const PackedModel& model, std::size_t row) noexcept {
  return row >> std::countr_zero(static_cast<unsigned>(model.width));
}

void add_force(const PackedModel& model, std::size_t row, const Vec3& force,
               PackedState& state) noexcept {
  float* row_force = state.force_rows.data() + 4 * row;
  row_force[0] += static_cast<float>(force.x());
  row_force[1] += static_cast<float>(force.y());
  row_force[2] += static_cast<float>(force.z());
  state.pushed[find_slice(model, row)] = 1;
}

std::size_t find_row(const PackedModel& model, const ParticleForce& of) noexcept {
  return static_cast<std::size_t>(model.row[static_cast<std::size_t>(of.particle)]);
}

/// What is done beside the laws, but for gravity.
void add_load(const PackedModel& model, const Load& load, PackedState& state) noexcept {
  for (const Push& push : load.pushes()) {
    const Triangle& corners = model.surface[static_cast<std::size_t>(push.triangle)];
    for (int c = 0; c < 3; ++c) {
      if (push.weights[c] == 0.0) continue;  // bodies push single vertices
      for_each_carrier(model, corners[static_cast<std::size_t>(c)],
                       [&](std::size_t row, double weight) {
                         add_force(model, row, weight * push.weights[c] * push.force, state);
                       });
    }
  }
  for (const ParticleForce& each : load.forces) {
    add_force(model, find_row(model, each), each.force, state);
  }
}

void clear_pushed(const PackedModel& model, const Load& load, PackedState& state) noexcept {
  const auto clear = [&](std::size_t row) { state.pushed[find_slice(model, row)] = 0; };
  for (const Push& push : load.pushes()) {
    for (const int vertex : model.surface[static_cast<std::size_t>(push.triangle)]) {
      for_each_carrier(model, vertex, [&](std::size_t row, double) { clear(row); });
    }
  }
  for (const ParticleForce& each : load.forces) clear(find_row(model, each));
}

bool has_moved_far(const PackedMeasure& measure, const Guard& guard, int steps) noexcept {
  return !(measure.largest_move <= kFarthestMove * guard.shortest_rest_length * steps);
}

bool is_strained(const Stretch& stretch) noexcept {
  return stretch.longest > 1.0 + kLargestStrain || stretch.shortest < kShortestLink ||
         stretch.smallest_volume < kSmallestVolume;
}

/// For as many checks that it is time to ask which link or volume it is.
bool is_long_strained(const PackedMeasure& measure, const Guard& guard) noexcept {
  return is_strained(measure.stretch) && guard.strained_checks + 1 >= kStrainedChecks;
}

/// Where the pressure's work will begin.
void remember_rows(const PackedModel& model, PackedState& packed) noexcept {
  if (packed.last_rows.empty()) return;
  const std::size_t rows = 4 * static_cast<std::size_t>(model.width);
  const float* now = packed.position_rows[static_cast<std::size_t>(packed.current)].data();
  for (const int slice : packed.slices.span()) {
    const std::size_t at = rows * static_cast<std::size_t>(slice);
    std::copy_n(now + at, rows, packed.last_rows.data() + at);
  }
}

}  // namespace

void recall_last_check(const PackedModel& model, const TissueModel& tissue,
                       const PackedState& packed, Vec3Array& position) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  const auto recall = [&](std::size_t i, const CacheAligned<float>& displacement) noexcept {
    const std::size_t at = find_in_slices(model, static_cast<std::size_t>(model.row[i]));
    const float* u = displacement.data() + at;
    position[i] = tissue.rest_position[i] + Vec3(u[0], u[width], u[2 * width]);
  };
  for (std::size_t i = 0; i < model.row.size(); ++i) recall(i, packed.displacement);
  if (packed.checked) return;
  for (const int slice : packed.slices.span()) {
    const auto first = width * static_cast<std::size_t>(slice);
    for (const int particle : std::span(model.particle).subspan(first, width)) {
      if (particle >= 0) recall(static_cast<std::size_t>(particle), packed.last_displacement);
    }
  }
}

PackedState::PackedState(const PackedModel& model, const TissueModel& tissue, const State& state)
    : time(state.time),
      displacement(model.rest.size(), 0.0f),
      velocity(model.rest.size(), 0.0f),
      force_rows(4 * model.particle.size(), 0.0f),
      pushed(static_cast<std::size_t>(model.slice_count), has_added_forces(model)),
      slices(model.slice_count),
      packs(model.triangles.pack_count),
      skin(model.skin.pack_count),
      faces(kFaceColumns * model.volumes.inverse_rest.size() *
                (model.volumes.stiffness_around.empty() ? 0 : 1),
            0.0f),
      volume_sums(model.volumes.stiffness_around.size(), 0.0f) {
  const std::size_t rows = 4 * model.particle.size();
  position_rows.fill(CacheAligned<float>(rows, 0.0f));
  if (!model.links.damping.values.empty() || !model.triangles.bond_damping.values.empty() ||
      !model.prisms.damping.empty()) {
    velocity_rows.fill(CacheAligned<float>(rows, 0.0f));
  }
  const auto width = static_cast<std::size_t>(model.width);
  for (std::size_t i = 0; i < model.row.size(); ++i) {
    const auto row = static_cast<std::size_t>(model.row[i]);
    const std::size_t in_slices = find_in_slices(model, row);
    const bool held = model.inverse_mass[row] == 0.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const auto u = static_cast<float>(state.position[i][axis] - tissue.rest_position[i][axis]);
      const auto v = held ? 0.0f : static_cast<float>(state.velocity[i][axis]);
      displacement[in_slices + k * width] = u;
      velocity[in_slices + k * width] = v;
      position_rows[0][4 * row + k] = model.rest[in_slices + k * width] + u;
      if (!velocity_rows[0].empty()) velocity_rows[0][4 * row + k] = v;
    }
  }
  for (const packed_kernels::PackedLaw& law : model.kernels->laws) {
    const bool has_some = law.count_internal != nullptr && law.is_present(model);
    internal.emplace_back(has_some ? law.count_internal(model) : 0, 0.0f);
  }
  last_displacement = displacement;
  if (model.skin.pack_count > 0) last_rows = position_rows[0];
}

bool has_packed_form(const TissueModel& model) noexcept {
  return model.elastic.corners.empty() && model.corotated.corners.empty() &&
         model.neo_hookean.corners.empty();
}

std::string_view simd_target(const PackedModel& model) noexcept {
  return model.kernels ? model.kernels->target : "";
}

void step(const PackedModel& model, const Load& load, double dt, PackedState& state,
          PackedMeasure* measure) noexcept {
  if (measure != nullptr) *measure = {};
  const std::span<const packed_kernels::PackedLaw> laws = model.kernels->laws;
  for (std::size_t law = 0; law < laws.size(); ++law) {
    if (!laws[law].is_present(model)) continue;
    laws[law].accumulate(model, state, state.internal[law], measure);
  }
  if (model.skin.pack_count > 0) model.kernels->accumulate_pressure(model, state);
  add_load(model, load, state);
  model.kernels->advance(model, load.gravity.cast<float>(), static_cast<float>(dt), state, measure);
  state.checked = false;
  if (!has_added_forces(model)) clear_pushed(model, load, state);
  state.current = 1 - state.current;
  state.last_dt = dt;
  state.time += dt;
}

void unpack_particle(const PackedModel& model, const TissueModel& tissue, const PackedState& packed,
                     std::size_t particle, State& state) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  const std::size_t at = find_in_slices(model, static_cast<std::size_t>(model.row[particle]));
  const float* u = packed.displacement.data() + at;
  const float* v = packed.velocity.data() + at;
  state.position[particle] = tissue.rest_position[particle] + Vec3(u[0], u[width], u[2 * width]);
  state.velocity[particle] = Vec3(v[0], v[width], v[2 * width]);
}

double unpack_particles(const PackedModel& model, const TissueModel& tissue,
                        const PackedState& packed, std::span<const int> particles,
                        State& state) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  const Vec3* rest = tissue.rest_position.data();
  Vec3 *position = state.position.data(), *velocity = state.velocity.data();
  // where there are rows of velocities, the three numbers stand beside each other there
  const CacheAligned<float>& velocities =
      packed.velocity_rows[static_cast<std::size_t>(packed.current)];
  const float* in_rows = velocities.empty() ? nullptr : velocities.data();
  double most = 0.0;
  for (const int particle : particles) {
    const auto i = static_cast<std::size_t>(particle);
    const auto row = static_cast<std::size_t>(model.row[i]);
    const std::size_t at = find_in_slices(model, row);
    const float* u = packed.displacement.data() + at;
    const Vec3 now = rest[i] + Vec3(u[0], u[width], u[2 * width]);
    most = std::max(most, (now - position[i]).squaredNorm());
    position[i] = now;
    if (in_rows != nullptr) {
      velocity[i] = Eigen::Map<const Eigen::Vector3f>(in_rows + 4 * row).cast<double>();
    } else {
      const float* v = packed.velocity.data() + at;
      velocity[i] = Vec3(v[0], v[width], v[2 * width]);
    }
  }
  return std::sqrt(most);
}

void unpack(const PackedModel& model, const TissueModel& tissue, const PackedState& packed,
            State& state) noexcept {
  const std::span<const int> slices = packed.slices.span();
  unpack_positions(model, tissue, packed.displacement, slices, state.position);
  model.kernels->unpack(model, nullptr, packed.velocity.data(), slices, state.velocity.data());
  state.time = packed.time;
}

void unpack_positions(const PackedModel& model, const TissueModel& tissue,
                      std::span<const float> displacement, std::span<const int> slices,
                      std::span<Vec3> position) noexcept {
  model.kernels->unpack(model, tissue.rest_position.data(), displacement.data(), slices,
                        position.data());
}

bool needs_check(const PackedMeasure& measure, const Guard& guard, int steps) noexcept {
  return has_moved_far(measure, guard, steps) || is_long_strained(measure, guard);
}

/// The kernels only tell that something is wrong; which particle or link it is, and how wrong, the
/// reference says. Energies are those one step back, which symplectic Euler keeps (guard.cpp).
Alarm check(const PackedModel& model, const TissueModel& tissue, const State& state,
            const PackedMeasure& measure, double work, PackedState& packed, Guard& guard,
            int steps) noexcept {
  Alarm alarm, far;
  if (has_moved_far(measure, guard, steps)) {
    recall_last_check(model, tissue, packed, guard.last_position);
    alarm = check_particles(state, guard, steps);
    if (alarm.kind == AlarmKind::moved_far) std::swap(alarm, far);
  }
  Alarm strained;
  if (!alarm && is_long_strained(measure, guard)) {
    strained = check_strains(tissue, state.position, guard);
  } else {
    guard.strained_checks = is_strained(measure.stretch) ? guard.strained_checks + 1 : 0;
  }
  if (!alarm) {
    const double elapsed = std::max(0.0, state.time - guard.last_time);
    const double pressed =
        model.skin.pack_count > 0 ? model.kernels->compute_pressure_work(model, packed) : 0.0;
    alarm = check_energy(
        tissue, measure.kinetic + measure.elastic + packed.asleep_energy - guard.torn_energy,
        work + measure.gravity_work + pressed, elapsed, guard);
  }
  if (!alarm) alarm = confirm(tissue, far, strained, guard);
  guard.last_time = state.time;
  if (alarm) {
    recall_last_check(model, tissue, packed, guard.last_position);
    alarm.time = state.time;
    return alarm;
  }
  packed.checked = true;
  remember_rows(model, packed);
  return alarm;
}

}  // namespace palpate
