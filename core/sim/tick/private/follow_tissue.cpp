// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/follow_tissue.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Part of a round that a tick does at least: what is still is nearly free to follow.
constexpr double kLeastShare = 1.0 / 64.0;

/// [m] More than any rounding of positions.
constexpr double kRounding = 1e-12;

/// Part of a round that keeps the boxes from being behind by more than the radius of a tool: they
/// are up to two rounds old, and the tissue goes on moving as in the last tick.
double choose_share(const Scene& scene, const PackedKernel& kernel) noexcept {
  const double move = kernel.skin_gain * kernel.measure.largest_move;
  const double share = 2.0 * move / find_smallest_radius(scene);
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
void do_parts(const SoftBody& body, std::size_t begin, std::size_t end, const PackedKernel& kernel,
              SoftState& state) noexcept {
  const auto slices = static_cast<std::size_t>(kernel.model->slice_count);
  const std::size_t skin = state.skin.size(), steps = state.tree.refit_step_count();
  const Part unpacked(begin, end, 0, slices), moved(begin, end, slices, skin);
  const Part refitted(begin, end, slices + skin, steps);
  unpack_positions(
      *kernel.model, body.tissue, kernel.state.displacement,
      kernel.state.slices.span().subspan(unpacked.begin, unpacked.end - unpacked.begin),
      state.tissue.position);
  for (std::size_t v = moved.begin; v < moved.end; ++v) {
    state.skin[v] = place_on_skin(body.tissue.skin, v, state.tissue.position);
  }
  state.tree.refit_steps(surface_position(state), refitted.begin, refitted.end);
}

void follow_in_turn(const SoftBody& body, double share, PackedKernel& kernel,
                    SoftState& state) noexcept {
  const std::size_t all = static_cast<std::size_t>(kernel.model->slice_count) + state.skin.size() +
                          state.tree.refit_step_count();
  Lag& lag = kernel.lag;
  if (share == 1.0) {
    lag.next = 0;
    lag.at_round = lag.moved;
  }
  const auto count = static_cast<std::size_t>(std::ceil(share * static_cast<double>(all)));
  const std::size_t end = std::min(lag.next + count, all);
  do_parts(body, lag.next, end, kernel, state);
  lag.next = end;
  if (end < all) return;
  lag.next = 0;
  lag.at_last_round = lag.at_round;
  lag.at_round = lag.moved;
}

/// Brings the corners of the triangles up to date, each once in a tick.
void read_corners(const TissueModel& tissue, std::span<const int> triangles, long tick,
                  PackedKernel& kernel, SoftState& state) noexcept {
  const Skin& skin = tissue.skin;
  const auto read = [&](int particle) noexcept {
    unpack_particle(*kernel.model, tissue, kernel.state, static_cast<std::size_t>(particle),
                    state.tissue);
  };
  for (const int t : triangles) {
    for (const int i : tissue.triangles[static_cast<std::size_t>(t)]) {
      const auto v = static_cast<std::size_t>(i);
      if (kernel.last_read_at[v] == tick) continue;
      kernel.last_read_at[v] = tick;
      if (skin.corners.empty()) {
        read(i);
      } else {
        for (const int particle : skin.corners[v]) read(particle);
        state.skin[v] = place_on_skin(skin, v, state.tissue.position);
      }
    }
  }
}

/// Triangles of all leaves that a tool may come near to, each once, with the tree `lag` [m] behind.
std::span<const int> list_broad(const Sweep& sweep, double lag, const AabbTree& tree,
                                PackedKernel& kernel) noexcept {
  const std::span<int> room = kernel.broad_candidates;
  std::size_t found = 0;
  for (const SweptPart& part : sweep.list()) {
    const double reach = part.radius + kCandidateMargin + lag;
    found += static_cast<std::size_t>(
        find_leaves_near_segment(tree, part.from, part.to, reach, room.subspan(found)));
  }
  if (sweep.count == 1) return room.first(found);
  std::sort(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(found));
  const auto end = std::unique(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(found));
  return room.first(static_cast<std::size_t>(end - room.begin()));
}

/// What one part of a tool may touch of a body on its path from `position` to `hand` [m].
void find_near_axes(const Scene& scene, const Shape& shape, std::size_t body, const Vec3& position,
                    const Vec3& hand, World& world, Candidates& candidates) noexcept {
  SoftState& state = world.bodies[body];
  const Vec3 lift = find_lift(candidates.near, position);
  const Sweep sweep(shape.tool, shape.axes, position + lift, hand + lift);
  const std::vector<double>& areas = scene.bodies[body].rest_areas;
  candidates.near.knows_compliance = candidates.near.found = false;
  if (!lags(world, state) || state.asleep) {
    find_candidates(state.tree, surface_position(state), sweep, position, hand, areas, candidates);
    return;
  }
  PackedKernel& kernel = *find_packed(state);
  const std::span<const int> broad = list_broad(sweep, bound_lag(state), state.tree, kernel);
  read_corners(scene.bodies[body].tissue, broad, world.tick_count, kernel, state);
  choose_candidates(state.tree, surface_position(state), sweep, position, hand, areas, broad,
                    candidates);
}

/// A hand that is not in the scene yet may be anywhere.
bool all_placed(const World& world) noexcept {
  return std::ranges::all_of(world.instruments, [](const InstrumentState& instrument) noexcept {
    return instrument.tool.placed;
  });
}

}  // namespace

bool lags(const World& world, const SoftState& state) noexcept {
  const PackedKernel* kernel = find_packed(state);
  return !world.follows_all && kernel && !kernel->active.on && !internals(state).meets;
}

bool is_behind(const SoftState& state) noexcept {
  const PackedKernel* kernel = find_packed(state);
  return kernel && kernel->lag.behind;
}

double bound_lag(const SoftState& state) noexcept {
  const PackedKernel* kernel = find_packed(state);
  return kernel ? kernel->lag.moved - kernel->lag.at_last_round + kRounding : 0.0;
}

void catch_up(const SoftBody& body, SoftState& state) noexcept {
  PackedKernel* kernel = find_packed(state);
  if (!kernel || !kernel->lag.behind) return;
  unpack(*kernel->model, body.tissue, kernel->state, state.tissue);
  move_skin(body.tissue.skin, state.tissue.position, state.skin);
  kernel->lag.behind = false;
}

void catch_up(const Scene& scene, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) catch_up(scene.bodies[b], world.bodies[b]);
}

void follow_tissue(const Scene& scene, std::size_t body, World& world) noexcept {
  SoftState& state = world.bodies[body];
  TreeCost& cost = internals(state).tree_cost;
  PackedKernel* packed = find_packed(state);
  if (lags(world, state) && all_placed(world)) {
    follow_in_turn(scene.bodies[body], choose_share(scene, *packed), *packed, state);
    cost.follow(state.tree);
    return;
  }
  catch_up(scene.bodies[body], state);
  if (packed && packed->active.on) {
    state.tree.refit_moving(state.tissue.position);
  } else {
    state.tree.refit(surface_position(state));
  }
  cost.follow(state.tree);
  if (packed) packed->lag = {};
}

void find_touchable(const Scene& scene, std::size_t instrument, std::size_t body, const Vec3& hand,
                    World& world) noexcept {
  Candidates& candidates = world.pair(instrument, body).candidates;
  const Tool& tool = scene.instruments[instrument].tool;
  const ToolState& state = world.instruments[instrument].tool;
  if (!tool.jaws) {
    const Axes axes(tool, state.orientation);
    find_near_axes(scene, {tool, axes}, body, state.position, hand, world, candidates);
    return;
  }
  const OpenJaws jaws(tool, state.orientation, state.jaw_angle);
  Candidates& second = second_jaw(world, instrument, body);
  find_near_axes(scene, jaws.shape(0), body, state.position, hand, world, candidates);
  find_near_axes(scene, jaws.shape(1), body, state.position, hand, world, second);
}

}  // namespace palpate
