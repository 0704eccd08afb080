// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/packed.h"

#include "palpate/sim/dynamics/packed_kernels.h"

namespace palpate {
namespace {

/// Where a particle's three numbers stand, `width` apart.
std::size_t find_in_slices(const PackedModel& model, std::size_t row) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  return 3 * (row - row % width) + row % width;
}

bool has_forces_of_triangles(const PackedModel& model) noexcept {
  return model.triangles.pack_count > 0 || model.skin.pack_count > 0;
}

void add_pushes(const PackedModel& model, const Load& load, PackedState& state) noexcept {
  for (const Push& push : load.pushes()) {
    const Triangle& corners = model.surface[static_cast<std::size_t>(push.triangle)];
    for (int c = 0; c < 3; ++c) {
      const auto row = static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]);
      const Eigen::Vector3f force = (push.weights[c] * push.force).cast<float>();
      for (int k = 0; k < 3; ++k)
        state.force_rows[4 * row + static_cast<std::size_t>(k)] += force[k];
      state.pushed[row / static_cast<std::size_t>(model.width)] = 1;
    }
  }
}

void clear_pushed(const PackedModel& model, const Load& load, PackedState& state) noexcept {
  for (const Push& push : load.pushes()) {
    for (const int row : model.surface[static_cast<std::size_t>(push.triangle)]) {
      state.pushed[static_cast<std::size_t>(row / model.width)] = 0;
    }
  }
}

}  // namespace

PackedState::PackedState(const PackedModel& model, const TissueModel& tissue, const State& state)
    : time(state.time),
      displacement(model.rest.size(), 0.0f),
      velocity(model.rest.size(), 0.0f),
      force_rows(4 * model.particle.size(), 0.0f),
      pushed(static_cast<std::size_t>(model.slice_count), has_forces_of_triangles(model)) {
  const std::size_t rows = 4 * model.particle.size();
  position_rows.fill(CacheAligned<float>(rows, 0.0f));
  if (!model.links.damping.values.empty() || !model.triangles.bond_damping.values.empty()) {
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
}

std::string_view simd_target(const PackedModel& model) noexcept {
  return model.kernels ? model.kernels->target : "";
}

void step(const PackedModel& model, const Load& load, double dt, PackedState& state) noexcept {
  if (model.triangles.pack_count > 0) model.kernels->accumulate_triangles(model, state);
  if (model.skin.pack_count > 0) model.kernels->accumulate_pressure(model, state);
  add_pushes(model, load, state);
  model.kernels->advance(model, load.gravity.cast<float>(), static_cast<float>(dt), state);
  if (!has_forces_of_triangles(model)) clear_pushed(model, load, state);
  state.current = 1 - state.current;
  state.time += dt;
}

void unpack(const PackedModel& model, const TissueModel& tissue, const PackedState& packed,
            State& state) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  for (std::size_t i = 0; i < model.row.size(); ++i) {
    const std::size_t at = find_in_slices(model, static_cast<std::size_t>(model.row[i]));
    const float* u = packed.displacement.data() + at;
    const float* v = packed.velocity.data() + at;
    state.position[i] = tissue.rest_position[i] + Vec3(u[0], u[width], u[2 * width]);
    state.velocity[i] = Vec3(v[0], v[width], v[2 * width]);
  }
  state.time = packed.time;
}

}  // namespace palpate
