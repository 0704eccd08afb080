// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/packed/private/follow_motion.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/packed/private/packed_kernels.h"

namespace palpate {
namespace {

/// How far the tool may go, in parts of its reach, before what it keeps awake is found again.
constexpr double kKeptMargin = 0.03;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void list_awake(std::span<const unsigned char> awake, PackedList& list) noexcept {
  list.count = 0;
  for (std::size_t i = 0; i < awake.size(); ++i) {
    if (awake[i] != 0) list.numbers[at(list.count++)] = static_cast<int>(i);
  }
}

void list_pulling(std::span<const int> pulling, PackedList& list) noexcept {
  list.count = 0;
  for (std::size_t i = 0; i < pulling.size(); ++i) {
    if (pulling[i] > 0) list.numbers[at(list.count++)] = static_cast<int>(i);
  }
}

void take_anchor(const PackedModel& model, int slice, ActiveSet& active,
                 const PackedState& packed) noexcept {
  const std::size_t size = 3 * at(model.width), from = size * at(slice);
  std::copy_n(packed.displacement.data() + from, size, active.anchor.data() + from);
  active.quiet[at(slice)] = 0;
}

/// What sleeps keeps the energy it had. While it slept, what moved has left forces in its rows.
void wake(const PackedModel& model, int slice, ActiveSet& active, PackedState& packed) noexcept {
  active.awake[at(slice)] = 1;
  take_anchor(model, slice, active, packed);
  packed.asleep_energy -= packed.slice_energy[at(slice)];
  std::fill_n(packed.force_rows.data() + 4 * at(model.width) * at(slice), 4 * at(model.width),
              0.0f);
  for (const int p : active.packs.row(slice)) {
    if (active.pulling[at(p)]++ == 0) packed.asleep_energy -= packed.pack_energy[at(p)];
  }
  for (const int p : active.skin.row(slice)) ++active.pulling_skin[at(p)];
}

void stop(const PackedModel& model, int slice, State& state) noexcept {
  for (int lane = 0; lane < model.width; ++lane) {
    const int particle = model.particle[at(slice * model.width + lane)];
    if (particle >= 0) state.velocity[at(particle)].setZero();
  }
}

/// Who lies within reach of a place at rest [m]; the margin is for the distance until the next
/// time.
void keep_about(const Vec3& place, ActiveSet& active) noexcept {
  const double reach = active.reach * (1.0 + kKeptMargin);
  for (std::size_t s = 0; s < active.kept.size(); ++s) {
    const double far = reach + active.radius[s];
    active.kept[s] = (active.centre[s] - place).squaredNorm() < far * far;
  }
  active.kept_about = place;
  active.keeps = true;
}

/// [m] How far the tool has moved what it may touch, at most a decay length. Only that counts of
/// which is known where it stands untouched.
double measure_depth(const PackedModel& model, std::span<const int> near, const ActiveSet& active,
                     const PackedState& packed) noexcept {
  const std::size_t width = at(model.width);
  float deepest = 0.0f;
  for (const int i : near) {
    const std::size_t row = at(model.row[at(i)]), slice = row / width;
    if (active.settled[slice] == 0) continue;
    const float* u = packed.displacement.data() + 3 * width * slice + row % width;
    const float* still = active.still.data() + 3 * width * slice + row % width;
    const Eigen::Vector3f offset(u[0] - still[0], u[width] - still[width],
                                 u[2 * width] - still[2 * width]);
    deepest = std::max(deepest, offset.squaredNorm());
  }
  return std::min(std::sqrt(double(deepest)), active.decay);
}

}  // namespace

void list_moving(const ActiveSet& active, PackedState& packed) noexcept {
  list_awake(active.awake, packed.slices);
  list_pulling(active.pulling, packed.packs);
  list_pulling(active.pulling_skin, packed.skin);
}

/// Both tables of rows get the same numbers: later steps see it at rest in every step.
void put_to_sleep(const PackedModel& model, int slice, ActiveSet& active,
                  PackedState& packed) noexcept {
  const std::size_t width = at(model.width), rows = 4 * width * at(slice);
  const auto here = at(packed.current), there = 1 - here;
  active.awake[at(slice)] = 0;
  std::fill_n(packed.velocity.data() + 3 * width * at(slice), 3 * width, 0.0f);
  std::copy_n(packed.position_rows[here].data() + rows, 4 * width,
              packed.position_rows[there].data() + rows);
  if (!packed.velocity_rows[0].empty()) {
    for (auto& velocities : packed.velocity_rows) {
      std::fill_n(velocities.data() + rows, 4 * width, 0.0f);
    }
  }
  if (!active.keeps) {
    std::copy_n(packed.displacement.data() + 3 * width * at(slice), 3 * width,
                active.still.data() + 3 * width * at(slice));
    active.settled[at(slice)] = 1;
  }
  packed.asleep_energy += packed.slice_energy[at(slice)];
  for (const int p : active.packs.row(slice)) {
    if (--active.pulling[at(p)] == 0) packed.asleep_energy += packed.pack_energy[at(p)];
  }
  for (const int p : active.skin.row(slice)) --active.pulling_skin[at(p)];
}

void wake_near(const PackedModel& model, const TissueModel& tissue, std::span<const int> near,
               ActiveSet& active, PackedState& packed) noexcept {
  if (near.empty()) {
    if (active.keeps) std::fill(active.kept.begin(), active.kept.end(), 0);
    active.keeps = false;
    active.depth = 0.0;
    active.product_limit = 0.0f;
    return;
  }
  const double depth = measure_depth(model, near, active, packed);
  active.depth = std::min(depth, active.depth + (depth - active.depth) / active.patience);
  active.product_limit = static_cast<float>(active.product_limit_per_depth * active.depth);
  Vec3 middle = Vec3::Zero();
  for (const int i : near) middle += tissue.rest_position[at(i)];
  middle /= static_cast<double>(near.size());
  bool changed = false;
  const auto rouse = [&](int slice) noexcept {
    if (active.awake[at(slice)] != 0) return;
    wake(model, slice, active, packed);
    changed = true;
  };
  if (!active.keeps || (middle - active.kept_about).norm() > kKeptMargin * active.reach) {
    keep_about(middle, active);
    for (int s = 0; s < model.slice_count; ++s) {
      if (active.kept[at(s)] != 0) rouse(s);
    }
  }
  // a hand that flies past may touch beyond the reach
  for (const int i : near) {
    const int slice = model.row[at(i)] / model.width;
    rouse(slice);
    active.quiet[at(slice)] = 0;
  }
  if (changed) list_moving(active, packed);
}

void follow_motion(const PackedModel& model, ActiveSet& active, PackedState& packed,
                   State& state) noexcept {
  model.kernels->find_moved(model, active.threshold, active.product_limit, active.anchor.data(),
                            active.still.data(), packed, active.moved.data());
  std::fill(active.stirred.begin(), active.stirred.end(), 0);
  for (const int s : packed.slices.span()) {
    if (active.moved[at(s)] == 0) continue;
    take_anchor(model, s, active, packed);
    active.stirred[at(s)] = 1;
    for (const int n : active.neighbours.row(s)) active.stirred[at(n)] = 1;
  }
  bool changed = false;
  for (int s = 0; s < model.slice_count; ++s) {
    if (active.awake[at(s)] == 0) {
      if (active.stirred[at(s)] == 0) continue;
      wake(model, s, active, packed);
      changed = true;
    } else if (active.stirred[at(s)] != 0 || active.kept[at(s)] != 0) {
      active.quiet[at(s)] = 0;
    } else if (++active.quiet[at(s)] >= active.patience) {
      put_to_sleep(model, s, active, packed);
      stop(model, s, state);
      changed = true;
    }
  }
  if (changed) list_moving(active, packed);
}

}  // namespace palpate
