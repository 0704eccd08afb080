// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "palpate/sim/dynamics/elastic_energy.h"
#include "palpate/sim/dynamics/follow_motion.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/packed_kernels.h"

namespace palpate {
namespace {

/// How far the tool may go, in parts of its reach, before what it keeps awake is found anew.
constexpr double kKeptMargin = 0.03;

/// Part of the threshold by which the forces at the start may move what begins asleep.
constexpr double kStill = 0.1;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

ActiveSet::Table make_table(std::vector<std::vector<int>> rows) {
  ActiveSet::Table table;
  table.first.push_back(0);
  for (std::vector<int>& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    table.numbers.insert(table.numbers.end(), row.begin(), row.end());
    table.first.push_back(static_cast<int>(table.numbers.size()));
  }
  return table;
}

/// The slices that a pack has corners in, each once.
std::vector<int> find_slices(const PackedModel& model, const PackedTriangles& packs, int pack) {
  const std::size_t corners = 3 * at(model.width);
  std::vector<int> slices;
  for (std::size_t c = 0; c < corners; ++c) {
    slices.push_back(packs.corner[at(pack) * corners + c] / model.width);
  }
  std::sort(slices.begin(), slices.end());
  slices.erase(std::unique(slices.begin(), slices.end()), slices.end());
  return slices;
}

/// Lanes without a triangle stand at row 0, so that the first slice is asked for more packs than
/// it has corners in. That costs time, and changes nothing.
ActiveSet::Table find_packs(const PackedModel& model, const PackedTriangles& packs) {
  std::vector<std::vector<int>> rows(at(model.slice_count));
  for (int p = 0; p < packs.pack_count; ++p) {
    for (const int slice : find_slices(model, packs, p)) rows[at(slice)].push_back(p);
  }
  return make_table(std::move(rows));
}

/// Who pulls at whom: over links, and the sides of triangles.
ActiveSet::Table find_neighbours(const PackedModel& model) {
  std::vector<std::vector<int>> rows(at(model.slice_count));
  for (int s = 0; s < model.slice_count; ++s) {
    for (int slot = model.links.first_slot[at(s)]; slot < model.links.first_slot[at(s + 1)];
         ++slot) {
      for (int lane = 0; lane < model.width; ++lane) {
        const int other = model.links.neighbour[at(slot * model.width + lane)] / model.width;
        if (other != s) rows[at(s)].push_back(other);
      }
    }
  }
  for (const PackedTriangles* packs : {&model.triangles, &model.skin}) {
    const std::size_t width = at(model.width);
    for (std::size_t lane = 0; lane < at(packs->pack_count) * width; ++lane) {
      const std::size_t first = 3 * (lane - lane % width) + lane % width;
      for (std::size_t a = 0; a < 3; ++a) {
        const int one = packs->corner[first + a * width] / model.width;
        const int two = packs->corner[first + (a + 1) % 3 * width] / model.width;
        if (one != two) rows[at(one)].push_back(two), rows[at(two)].push_back(one);
      }
    }
  }
  return make_table(std::move(rows));
}

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

void list_all(const ActiveSet& active, PackedState& packed) noexcept {
  list_awake(active.awake, packed.slices);
  list_pulling(active.pulling, packed.packs);
  list_pulling(active.pulling_skin, packed.skin);
}

void take_anchor(const PackedModel& model, int slice, ActiveSet& active,
                 const PackedState& packed) noexcept {
  const std::size_t size = 3 * at(model.width), from = size * at(slice);
  std::copy_n(packed.displacement.data() + from, size, active.anchor.data() + from);
  active.quiet[at(slice)] = 0;
}

/// What sleeps keeps the energy it had. While it slept, whoever moved has left forces in its rows.
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

/// Both tables of rows get the same numbers: whoever reads on sees it at rest in every step.
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
  packed.asleep_energy += packed.slice_energy[at(slice)];
  for (const int p : active.packs.row(slice)) {
    if (--active.pulling[at(p)] == 0) packed.asleep_energy += packed.pack_energy[at(p)];
  }
  for (const int p : active.skin.row(slice)) --active.pulling_skin[at(p)];
}

void stop(const PackedModel& model, int slice, State& state) noexcept {
  for (int lane = 0; lane < model.width; ++lane) {
    const int particle = model.particle[at(slice * model.width + lane)];
    if (particle >= 0) state.velocity[at(particle)].setZero();
  }
}

/// Whether the forces of the start leave every particle of a slice where it is.
bool starts_still(const PackedModel& model, const TissueModel& tissue, const State& state,
                  const Vec3Array& force, int slice, double threshold) {
  for (int lane = 0; lane < model.width; ++lane) {
    const auto row = at(slice * model.width + lane);
    if (model.particle[row] < 0 || model.inverse_mass[row] == 0.0f) continue;
    const std::size_t i = at(model.particle[row]);
    if (force[i].norm() > kStill * threshold * tissue.home[i]) return false;
    if (!state.velocity[i].isZero(0.0)) return false;
  }
  return true;
}

/// Whether there is no more energy than the threshold stands for. What sleeps with more would give
/// it back when it wakes, and nobody would know from where.
bool is_relaxed(const TissueModel& tissue, const State& state, double threshold) {
  double home = 0.0;
  for (const double h : tissue.home) home += h;
  const auto where = [&](int i) -> const Vec3& { return state.position[at(i)]; };
  return compute_elastic_energy(tissue, where) <= 0.5 * home * threshold * threshold;
}

void measure_slices(const PackedModel& model, const TissueModel& tissue, ActiveSet& active) {
  for (int s = 0; s < model.slice_count; ++s) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int lane = 0; lane < model.width; ++lane) {
      const int particle = model.particle[at(s * model.width + lane)];
      if (particle < 0) continue;
      low = low.cwiseMin(tissue.rest_position[at(particle)]);
      high = high.cwiseMax(tissue.rest_position[at(particle)]);
    }
    active.centre.push_back(0.5 * (low + high));
    active.radius.push_back(0.5 * (high - low).norm());
  }
}

/// Who lies within reach of a place at rest [m]; the margin is for the way until the next time.
void keep_about(const Vec3& place, ActiveSet& active) noexcept {
  const double reach = active.reach * (1.0 + kKeptMargin);
  for (std::size_t s = 0; s < active.kept.size(); ++s) {
    const double far = reach + active.radius[s];
    active.kept[s] = (active.centre[s] - place).squaredNorm() < far * far;
  }
  active.kept_about = place;
  active.keeps = true;
}

}  // namespace

ActiveSet::ActiveSet(const PackedModel& model, const TissueModel& tissue, const Load& load,
                     const State& state, const ActiveRule& rule, int patience_in,
                     PackedState& packed)
    : on(true),
      threshold(static_cast<float>(rule.threshold)),
      reach(rule.reach),
      patience(patience_in),
      neighbours(find_neighbours(model)),
      packs(find_packs(model, model.triangles)),
      skin(find_packs(model, model.skin)),
      anchor(packed.displacement) {
  const std::size_t slices = at(model.slice_count);
  for (auto* flags : {&kept, &moved, &stirred}) flags->assign(slices, 0);
  awake.assign(slices, 1);
  quiet.assign(slices, 0);
  measure_slices(model, tissue, *this);
  pulling.assign(at(model.triangles.pack_count), 0);
  pulling_skin.assign(at(model.skin.pack_count), 0);
  for (const int p : packs.numbers) ++pulling[at(p)];
  for (const int p : skin.numbers) ++pulling_skin[at(p)];
  packed.slice_energy.assign(slices, 0.0f);
  packed.pack_energy.assign(pulling.size(), 0.0f);

  Vec3Array force(state.position.size());
  compute_forces(tissue, load, state.position, state.velocity, force);
  const bool relaxed = is_relaxed(tissue, state, rule.threshold);
  for (int s = 0; s < model.slice_count; ++s) {
    if (relaxed && starts_still(model, tissue, state, force, s, rule.threshold)) {
      put_to_sleep(model, s, *this, packed);
    }
  }
  list_all(*this, packed);
}

void wake_near(const PackedModel& model, const TissueModel& tissue, std::span<const int> near,
               ActiveSet& active, PackedState& packed) noexcept {
  if (near.empty()) {
    if (active.keeps) std::fill(active.kept.begin(), active.kept.end(), 0);
    active.keeps = false;
    return;
  }
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
  if (changed) list_all(active, packed);
}

void follow_motion(const PackedModel& model, ActiveSet& active, PackedState& packed,
                   State& state) noexcept {
  model.kernels->find_moved(model, active.threshold, active.anchor.data(), packed,
                            active.moved.data());
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
  if (changed) list_all(active, packed);
}

}  // namespace palpate
