// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/packed_checkpoint.h"

#include <algorithm>

namespace palpate {
namespace {

/// Writes the rows of a slice from what it is displaced by, as a step does: rest + u in float.
void write_rows(const PackedModel& model, std::size_t slice, PackedState& packed) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  const auto here = static_cast<std::size_t>(packed.current);
  const std::size_t from = 3 * width * slice, to = 4 * width * slice;
  const bool damped = !packed.velocity_rows[0].empty();
  for (std::size_t lane = 0; lane < width; ++lane) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = from + k * width + lane, row = to + 4 * lane + k;
      packed.position_rows[here][row] = model.rest[at] + packed.displacement[at];
      if (damped) packed.velocity_rows[here][row] = packed.velocity[at];
    }
  }
  if (packed.last_rows.empty()) return;
  std::copy_n(packed.position_rows[here].data() + to, 4 * width, packed.last_rows.data() + to);
}

}  // namespace

PackedCheckpoint::PackedCheckpoint(const PackedState& packed)
    : displacement(packed.displacement), velocity(packed.velocity), internal(packed.internal) {}

void keep_checkpoint(const PackedModel& model, const PackedState& packed,
                     PackedCheckpoint& checkpoint) noexcept {
  checkpoint.time = packed.time;
  checkpoint.last_dt = packed.last_dt;
  const std::size_t size = 3 * static_cast<std::size_t>(model.width);
  for (const int slice : packed.slices.span()) {
    const std::size_t at = size * static_cast<std::size_t>(slice);
    std::copy_n(packed.displacement.data() + at, size, checkpoint.displacement.data() + at);
    std::copy_n(packed.velocity.data() + at, size, checkpoint.velocity.data() + at);
  }
  for (std::size_t law = 0; law < packed.internal.size(); ++law) {
    std::ranges::copy(packed.internal[law], checkpoint.internal[law].begin());
  }
}

void rewind(const PackedModel& model, const PackedCheckpoint& checkpoint,
            PackedState& packed) noexcept {
  packed.time = checkpoint.time;
  packed.last_dt = checkpoint.last_dt;
  packed.checked = true;
  const std::size_t size = 3 * static_cast<std::size_t>(model.width);
  for (const int slice : packed.slices.span()) {
    const std::size_t at = size * static_cast<std::size_t>(slice);
    std::copy_n(checkpoint.displacement.data() + at, size, packed.displacement.data() + at);
    std::copy_n(checkpoint.velocity.data() + at, size, packed.velocity.data() + at);
    write_rows(model, static_cast<std::size_t>(slice), packed);
  }
  for (std::size_t law = 0; law < packed.internal.size(); ++law) {
    std::ranges::copy(checkpoint.internal[law], packed.internal[law].begin());
  }
}

void take_over(const PackedModel& model, const TissueModel& tissue, const State& state,
               PackedState& packed) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  for (std::size_t i = 0; i < model.row.size(); ++i) {
    const auto row = static_cast<std::size_t>(model.row[i]);
    const std::size_t lane = row % width, at = 3 * (row - lane) + lane;
    const Vec3 u = state.position[i] - tissue.rest_position[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      packed.displacement[at + k * width] = static_cast<float>(u[axis]);
      packed.velocity[at + k * width] = static_cast<float>(state.velocity[i][axis]);
    }
  }
  for (int slice = 0; slice < model.slice_count; ++slice) {
    write_rows(model, static_cast<std::size_t>(slice), packed);
  }
  packed.time = state.time;
  packed.checked = true;
}

void take_over_particle(const PackedModel& model, const TissueModel& tissue, const State& state,
                        std::size_t particle, PackedState& packed) noexcept {
  const auto width = static_cast<std::size_t>(model.width);
  const auto row = static_cast<std::size_t>(model.row[particle]);
  const std::size_t lane = row % width, at = 3 * (row - lane) + lane;
  const auto here = static_cast<std::size_t>(packed.current);
  const Vec3 u = state.position[particle] - tissue.rest_position[particle];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const std::size_t to = at + k * width;
    packed.displacement[to] = static_cast<float>(u[axis]);
    packed.velocity[to] = static_cast<float>(state.velocity[particle][axis]);
    packed.position_rows[here][4 * row + k] = model.rest[to] + packed.displacement[to];
    if (packed.velocity_rows[0].empty()) continue;
    packed.velocity_rows[here][4 * row + k] = packed.velocity[to];
  }
}

}  // namespace palpate
