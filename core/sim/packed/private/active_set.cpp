// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <numbers>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/laws.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/private/packed_kernels.h"

namespace palpate {
namespace {

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
  return laws::compute_elastic_energy(tissue, where) <= 0.5 * home * threshold * threshold;
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

/// [-] What a slice at the edge of what sleeps moves by, of what it would if nothing slept: over
/// its width the field falls to nothing, where a pull would fade over a decay length to either
/// side.
double compute_edge_part(const ActiveSet& active) {
  double radius = 0.0;
  for (const double r : active.radius) radius += r;
  const double width = std::numbers::sqrt2 * radius / static_cast<double>(active.radius.size());
  return std::min(1.0, 2.0 * width / active.decay);
}

}  // namespace

ActiveSet::ActiveSet(const PackedModel& model, const TissueModel& tissue, const Load& load,
                     const State& state, const ActiveRule& rule, int patience_in,
                     PackedState& packed)
    : on(true),
      threshold(static_cast<float>(rule.threshold)),
      reach(rule.reach),
      decay(rule.decay),
      patience(patience_in),
      neighbours(find_neighbours(model)),
      packs(find_packs(model, model.triangles)),
      skin(find_packs(model, model.skin)),
      anchor(packed.displacement),
      still(packed.displacement) {
  const std::size_t slices = at(model.slice_count);
  for (auto* flags : {&kept, &moved, &stirred, &settled}) flags->assign(slices, 0);
  awake.assign(slices, 1);
  quiet.assign(slices, 0);
  measure_slices(model, tissue, *this);
  const double edge_part = compute_edge_part(*this);
  product_limit_per_depth = edge_part * edge_part * rule.product_limit_per_depth;
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
  list_moving(*this, packed);
}

}  // namespace palpate
