// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/follow_tissue.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/find_suspects.h"
#include "palpate/sim/dynamics/packed.h"
#include "palpate/sim/haptics/move_tissue.h"
#include "palpate/sim/model/volumes.h"

namespace palpate {
namespace {

/// Part of a round that a tick does at least: what is still is nearly free to follow.
constexpr double kLeastShare = 1.0 / 64.0;

/// [m] More than any rounding of positions.
constexpr double kRounding = 1e-12;

/// Part of a round that keeps the boxes from being behind by more than the tool's radius: they are
/// up to two rounds old, and the tissue goes on moving as in the last tick.
double choose_share(const Scene& scene, const World& world) noexcept {
  const double way = world.skin_gain * world.measure.largest_move;
  const double share = 2.0 * way / scene.tool.radius;
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
void do_parts(const Scene& scene, std::size_t begin, std::size_t end, World& world) noexcept {
  const auto slices = static_cast<std::size_t>(world.packed_model->slice_count);
  const std::size_t skin = world.skin.size(), steps = world.tree.refit_step_count();
  const Part unpacked(begin, end, 0, slices), moved(begin, end, slices, skin);
  const Part refitted(begin, end, slices + skin, steps);
  unpack_positions(
      *world.packed_model, scene.tissue, world.packed.displacement,
      world.packed.slices.span().subspan(unpacked.begin, unpacked.end - unpacked.begin),
      world.tissue.position);
  for (std::size_t v = moved.begin; v < moved.end; ++v) {
    world.skin[v] = place_on_skin(scene.tissue.skin, v, world.tissue.position);
  }
  world.tree.refit_steps(surface_position(world), refitted.begin, refitted.end);
}

void follow_in_turn(const Scene& scene, World& world) noexcept {
  const std::size_t all = static_cast<std::size_t>(world.packed_model->slice_count) +
                          world.skin.size() + world.tree.refit_step_count();
  const double share = choose_share(scene, world);
  Lag& lag = world.lag;
  if (share == 1.0) {
    lag.next = 0;
    lag.at_round = lag.moved;
  }
  const auto count = static_cast<std::size_t>(std::ceil(share * static_cast<double>(all)));
  const std::size_t end = std::min(lag.next + count, all);
  do_parts(scene, lag.next, end, world);
  lag.next = end;
  if (end < all) return;
  lag.next = 0;
  lag.at_last_round = lag.at_round;
  lag.at_round = lag.moved;
}

/// Brings the corners of the triangles up to date, each once in a tick.
void read_corners(const Scene& scene, std::span<const int> triangles, World& world) noexcept {
  const Skin& skin = scene.tissue.skin;
  const auto read = [&](int particle) noexcept {
    unpack_particle(*world.packed_model, scene.tissue, world.packed,
                    static_cast<std::size_t>(particle), world.tissue);
  };
  for (const int t : triangles) {
    for (const int i : scene.tissue.triangles[static_cast<std::size_t>(t)]) {
      const auto v = static_cast<std::size_t>(i);
      if (world.last_read_at[v] == world.tick_count) continue;
      world.last_read_at[v] = world.tick_count;
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

double bound_lag(const World& world) noexcept {
  return world.lag.moved - world.lag.at_last_round + kRounding;
}

void catch_up(const Scene& scene, World& world) noexcept {
  if (!world.lag.behind) return;
  unpack(*world.packed_model, scene.tissue, world.packed, world.tissue);
  move_skin(scene.tissue.skin, world.tissue.position, world.skin);
  world.lag.behind = false;
}

void follow_tissue(const Scene& scene, World& world) noexcept {
  // a hand that is not in the scene yet may be anywhere
  if (lags(world) && world.tool.placed) {
    follow_in_turn(scene, world);
    world.tree_cost.follow(world.tree);
    return;
  }
  catch_up(scene, world);
  refit_tree(world);
  world.lag = {};
}

void find_touchable(const Scene& scene, const Vec3& hand, World& world) noexcept {
  if (!lags(world)) {
    find_candidates(world.tree, surface_position(world), scene.tool, world.tool.position, hand,
                    scene.rest_areas, world.candidates);
    return;
  }
  const double reach = scene.tool.radius + kCandidateMargin + bound_lag(world);
  const int found =
      find_leaves_near_segment(world.tree, world.tool.position, hand, reach, world.suspects);
  const auto suspects = std::span(world.suspects).first(static_cast<std::size_t>(found));
  read_corners(scene, suspects, world);
  choose_candidates(world.tree, surface_position(world), scene.tool, world.tool.position, hand,
                    scene.rest_areas, suspects, world.candidates);
}

}  // namespace palpate
