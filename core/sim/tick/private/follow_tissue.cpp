// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/follow_tissue.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/model/volumes.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Part of a round that a tick does at least: what is still is nearly free to follow.
constexpr double kLeastShare = 1.0 / 64.0;

/// [m] More than any rounding of positions.
constexpr double kRounding = 1e-12;

/// The packed kernel of a world of which only a part is followed, or null.
PackedKernel* find_lagging(World& world) noexcept {
  return lags(world) ? find_packed(world) : nullptr;
}

/// Part of a round that keeps the boxes from being behind by more than the tool's radius: they are
/// up to two rounds old, and the tissue goes on moving as in the last tick.
double choose_share(const Scene& scene, const PackedKernel& kernel) noexcept {
  const double move = kernel.skin_gain * kernel.measure.largest_move;
  const double share = 2.0 * move / scene.tool.radius;
  return share < 1.0 ? std::max(kLeastShare, share) : 1.0;
}

/// The part of a table of `size` that lies between two places of the round, of which the table
/// begins at `first`.
struct Part {
  Part(std::size_t from, std::size_t to, std::size_t first, std::size_t size) noexcept
      : begin(std::clamp(from, first, first + size) - first),
        end(std::clamp(to, first, first + size) - first) {}
  std::size_t begin, end;
};

/// A round is every slice unpacked, then every vertex of the skin moved, then every step of a
/// refit: each reads what the one before it has written since the round began.
void do_parts(const Scene& scene, std::size_t begin, std::size_t end, const PackedKernel& kernel,
              World& world) noexcept {
  const auto slices = static_cast<std::size_t>(kernel.model->slice_count);
  const std::size_t skin = world.skin.size(), steps = world.tree.refit_step_count();
  const Part unpacked(begin, end, 0, slices), moved(begin, end, slices, skin);
  const Part refitted(begin, end, slices + skin, steps);
  unpack_positions(
      *kernel.model, scene.tissue, kernel.state.displacement,
      kernel.state.slices.span().subspan(unpacked.begin, unpacked.end - unpacked.begin),
      world.tissue.position);
  for (std::size_t v = moved.begin; v < moved.end; ++v) {
    world.skin[v] = place_on_skin(scene.tissue.skin, v, world.tissue.position);
  }
  world.tree.refit_steps(surface_position(world), refitted.begin, refitted.end);
}

void follow_in_turn(const Scene& scene, PackedKernel& kernel, World& world) noexcept {
  const std::size_t all = static_cast<std::size_t>(kernel.model->slice_count) + world.skin.size() +
                          world.tree.refit_step_count();
  const double share = choose_share(scene, kernel);
  Lag& lag = kernel.lag;
  if (share == 1.0) {
    lag.next = 0;
    lag.at_round = lag.moved;
  }
  const auto count = static_cast<std::size_t>(std::ceil(share * static_cast<double>(all)));
  const std::size_t end = std::min(lag.next + count, all);
  do_parts(scene, lag.next, end, kernel, world);
  lag.next = end;
  if (end < all) return;
  lag.next = 0;
  lag.at_last_round = lag.at_round;
  lag.at_round = lag.moved;
}

/// Brings the corners of the triangles up to date, each once in a tick.
void read_corners(const Scene& scene, std::span<const int> triangles, PackedKernel& kernel,
                  World& world) noexcept {
  const Skin& skin = scene.tissue.skin;
  const auto read = [&](int particle) noexcept {
    unpack_particle(*kernel.model, scene.tissue, kernel.state, static_cast<std::size_t>(particle),
                    world.tissue);
  };
  for (const int t : triangles) {
    for (const int i : scene.tissue.triangles[static_cast<std::size_t>(t)]) {
      const auto v = static_cast<std::size_t>(i);
      if (kernel.last_read_at[v] == world.tick_count) continue;
      kernel.last_read_at[v] = world.tick_count;
      if (skin.corners.empty()) {
        read(i);
      } else {
        for (const int particle : skin.corners[v]) read(particle);
        world.skin[v] = place_on_skin(skin, v, world.tissue.position);
      }
    }
  }
}

}  // namespace

bool lags(const World& world) noexcept {
  const PackedKernel* kernel = find_packed(world);
  return !world.follows_all && kernel && !kernel->active.on;
}

bool is_behind(const World& world) noexcept {
  const PackedKernel* kernel = find_packed(world);
  return kernel && kernel->lag.behind;
}

double bound_lag(const World& world) noexcept {
  const PackedKernel* kernel = find_packed(world);
  return kernel ? kernel->lag.moved - kernel->lag.at_last_round + kRounding : 0.0;
}

void catch_up(const Scene& scene, World& world) noexcept {
  PackedKernel* kernel = find_packed(world);
  if (!kernel || !kernel->lag.behind) return;
  unpack(*kernel->model, scene.tissue, kernel->state, world.tissue);
  move_skin(scene.tissue.skin, world.tissue.position, world.skin);
  kernel->lag.behind = false;
}

void follow_tissue(const Scene& scene, World& world) noexcept {
  TreeCost& cost = internals(world).tree_cost;
  // a hand that is not in the scene yet may be anywhere
  PackedKernel* lagging = world.tool.placed ? find_lagging(world) : nullptr;
  if (lagging) {
    follow_in_turn(scene, *lagging, world);
    cost.follow(world.tree);
    return;
  }
  catch_up(scene, world);
  PackedKernel* packed = find_packed(world);
  if (packed && packed->active.on) {
    world.tree.refit_moving(world.tissue.position);
  } else {
    world.tree.refit(surface_position(world));
  }
  cost.follow(world.tree);
  if (packed) packed->lag = {};
}

void find_touchable(const Scene& scene, const Vec3& hand, World& world) noexcept {
  PackedKernel* kernel = find_lagging(world);
  if (!kernel) {
    find_candidates(world.tree, surface_position(world), scene.tool, world.tool.position, hand,
                    scene.rest_areas, world.candidates);
    return;
  }
  const double reach = scene.tool.radius + kCandidateMargin + bound_lag(world);
  const int found = find_leaves_near_segment(world.tree, world.tool.position, hand, reach,
                                             kernel->broad_candidates);
  const auto broad = std::span(kernel->broad_candidates).first(static_cast<std::size_t>(found));
  read_corners(scene, broad, *kernel, world);
  choose_candidates(world.tree, surface_position(world), scene.tool, world.tool.position, hand,
                    scene.rest_areas, broad, world.candidates);
}

}  // namespace palpate
