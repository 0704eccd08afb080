// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/contact_pace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/move_tissue.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/touch_bodies.h"

namespace palpate {
namespace {

/// [m] by which the surfaces of a pair may move together in a tick that looks at them once. Lists
/// have room for what is that near.
constexpr double kFar = 5e-4;

/// [m] by which they move from one look to the next in a tick that looks more often.
constexpr double kStride = 2.5e-4;

/// [m] A tree is refitted when its surface may have left it by so much.
constexpr double kLeft = 3e-4;

/// [-] of the thickness by which surfaces may come nearer than was expected: what pushes them apart
/// is at hand then, if late.
constexpr double kSurprise = 0.4;

/// [-] of the thickness that a gap may close by in one substep.
constexpr double kLongestApproach = 0.3;

/// [-] As many substeps as bodies have at most by default: a first look holds for one of them.
constexpr double kMostSubsteps = 32.0;

/// Of bodies that are near others, what their surfaces have done in the last `elapsed` [s].
void follow_surfaces(double elapsed, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SurfaceTouch& touch = workspace(world).touched[b];
    touch.move = 0.0;
    if (!internals(world.bodies[b]).meets) {
      touch.has_last = false;
    } else if (!world.bodies[b].asleep || !touch.has_last) {
      follow_move(surface_position(world.bodies[b]), elapsed, touch);
    } else {
      touch.speed = 0.0;
    }
  }
}

/// Calls `visit(contacts)` for pairs that are near each other.
template <class Visit>
void for_each_near(World& world, Visit visit) {
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    if (world.body_pairs[p].near) visit(workspace(world).contacts[p]);
  }
}

/// [m/s] At which the surfaces of a pair move, together.
double add_speeds(const BodyContacts& contacts, World& world) noexcept {
  const std::vector<SurfaceTouch>& touched = workspace(world).touched;
  return touched[contacts.bodies[0]].speed + touched[contacts.bodies[1]].speed;
}

double find_fastest(World& world) noexcept {
  double fastest = 0.0;
  for_each_near(world, [&](const BodyContacts& contacts) noexcept {
    fastest = std::max(fastest, add_speeds(contacts, world));
  });
  return fastest;
}

/// How far the surfaces of a pair go until they are looked at again, which is in `next` [s] where
/// that is within the tick.
Travel foretell(const BodyContacts& contacts, double next, World& world) noexcept {
  const TickBuffers& work = workspace(world);
  const SurfaceTouch& first = work.touched[contacts.bodies[0]];
  const SurfaceTouch& second = work.touched[contacts.bodies[1]];
  const double move = first.move + second.move;
  Travel travel = expect_same(move);
  if (!work.pace.within) return travel;
  travel.ahead = expect_same(add_speeds(contacts, world) * next).ahead;
  return travel;
}

void find_pair(const Scene& scene, std::size_t p, double next, World& world) noexcept {
  TickBuffers& work = workspace(world);
  BodyContacts& contacts = work.contacts[p];
  const auto& bodies = contacts.bodies;
  Travel travel = foretell(contacts, next, world);
  for (std::size_t k = 0; k < contacts.side_count; ++k) {
    SurfaceContacts& side = contacts.sides[k];
    EdgePoints& edges = contacts.edges[k];
    if (!world.body_pairs[p].near) {
      for (SurfaceContacts* apart : {&side, &edges.contacts}) {
        apart->begun = false;
        apart->active_count = 0;
      }
      continue;
    }
    const SoftState &first = world.bodies[bodies[k]], &second = world.bodies[bodies[1 - k]];
    const Vec3Array& before = work.touched[bodies[1 - k]].before;
    travel.behind = work.touched[bodies[1 - k]].behind;
    const auto find = [&](std::span<const Vec3> x, std::span<const Vec3> x_before,
                          SurfaceContacts& of) noexcept {
      renew_lists(x, second.tree, surface_position(second), travel, of);
      find_near(x, scene.bodies[bodies[1 - k]].tissue.triangles, surface_position(second), of,
                {x_before, before});
    };
    find(surface_position(first), work.touched[bodies[k]].before, side);
    if (!edges.ends.empty()) {
      follow(surface_position(first), work.touched[bodies[k]].before, edges);
      find(edges.x, edges.before, edges.contacts);
    }
    if (side.active_count + edges.contacts.active_count == 0 && !work.pace.within) continue;
    for (const std::size_t b : bodies) work.touched[b].is_touched = true;
  }
}

void find_pairs(const Scene& scene, double next, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    find_pair(scene, p, next, world);
    watch.add_to(world.costs.body_pairs[p].candidates);
  }
}

void ask_for_approach(double approach, const BodyContacts& contacts, World& world) noexcept {
  for (const std::size_t b : contacts.bodies) {
    SurfaceTouch& touch = workspace(world).touched[b];
    touch.approach = std::max(touch.approach, approach / contacts.sides[0].barrier.thickness);
  }
}

/// What the contacts of all pairs ask of the steps of a tick.
void find_need(const Scene& scene, double dt, World& world) noexcept {
  TickBuffers& work = workspace(world);
  Stopwatch watch(world.measures_costs);
  for (std::size_t p = 0; p < work.contacts.size(); ++p) {
    BodyContacts& contacts = work.contacts[p];
    const auto& bodies = contacts.bodies;
    for (std::size_t k = 0; k < contacts.side_count; ++k) {
      const auto ask = [&](const TouchingSurface& points, SurfaceContacts& side) noexcept {
        const ContactNeed need =
            accumulate_stiffness(dt, points, view_surface(scene, bodies[1 - k], world), side);
        ask_for_approach(need.approach * dt, contacts, world);
      };
      for_each_side(scene, contacts, k, world, ask);
    }
    watch.add_to(world.costs.body_pairs[p].candidates);
  }
  for (SurfaceTouch& touch : work.touched) {
    touch.went = 0.0;
    if (!touch.is_touched) continue;
    touch.stiffness = *std::ranges::max_element(touch.row);
    std::ranges::fill(touch.row, 0.0);
  }
}

/// What comes to be near within a tick is not known when its steps are chosen.
void ask_for_speed(double dt, World& world) noexcept {
  for_each_near(world, [&](const BodyContacts& contacts) noexcept {
    ask_for_approach(add_speeds(contacts, world) * dt, contacts, world);
  });
}

void follow_tree(SoftState& state, SurfaceTouch& touch) noexcept {
  touch.behind += touch.move;
  if (!(touch.behind > kLeft)) return;
  state.tree.refit(surface_position(state));
  touch.behind = 0.0;
}

/// Whether surfaces have gone farther than the contacts that were found bear, or as far as to
/// another one that was not near. Within a tick that looks before every substep there is nothing
/// better.
bool has_outrun(double dt, World& world) noexcept {
  const ContactPace& pace = workspace(world).pace;
  if (pace.within) return pace.outrun && pace.hold > 0.0;
  bool outrun = false, known = true;
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    const BodyContacts& contacts = workspace(world).contacts[p];
    const SurfaceContacts& side = contacts.sides[0];
    double move = 0.0;
    for (const std::size_t b : contacts.bodies) move += measure_move(dt, world.bodies[b]);
    const double most =
        world.body_pairs[p].near ? side.ahead + kSurprise * side.barrier.thickness : contacts.apart;
    outrun = outrun || move > most;
    known = known && std::isfinite(move);
  }
  return outrun && known;
}

/// Bodies that were not near, and come near in this tick.
void meet_within(double dt, World& world) noexcept {
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    const BodyContacts& contacts = workspace(world).contacts[p];
    double move = 0.0;
    for (const std::size_t b : contacts.bodies) move += measure_move(dt, world.bodies[b]);
    if (world.body_pairs[p].near || !(move > contacts.apart)) continue;
    world.body_pairs[p].near = true;
    for (const std::size_t b : contacts.bodies) {
      if (internals(world.bodies[b]).meets) continue;
      internals(world.bodies[b]).meets = true;
      workspace(world).touched[b].behind = std::numeric_limits<double>::infinity();
    }
  }
}

/// Has the tick look so often that contacts hold at these speeds, or before every substep, and ask
/// for the substeps that they need.
void look_more_often(const Scene& scene, double dt, World& world) noexcept {
  TickBuffers& work = workspace(world);
  ContactPace& pace = work.pace;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SurfaceTouch& touch = work.touched[b];
    touch.speed = std::max(touch.speed, measure_move(dt, world.bodies[b]) / dt);
  }
  meet_within(dt, world);
  pace.hold = pace.within ? 0.0 : kStride / find_fastest(world);
  pace.within = true;
  ask_for_speed(dt, world);
  for_each_near(world, [&](const BodyContacts& contacts) noexcept {
    for (const std::size_t b : contacts.bodies) work.touched[b].is_touched = true;
  });
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    int& wanted = internals(world.bodies[b]).wanted_substeps;
    const double most = scene.bodies[b].substeps_max;
    wanted = std::max(wanted, static_cast<int>(std::min(most, count_approach_substeps(b, world))));
  }
}

}  // namespace

void find_body_contacts(const Scene& scene, double dt, World& world) noexcept {
  if (world.body_pairs.empty()) return;
  TickBuffers& work = workspace(world);
  for (SurfaceTouch& touch : work.touched) {
    touch.is_touched = false;
    touch.stiffness = touch.approach = touch.behind = 0.0;
  }
  ContactPace& pace = work.pace;
  follow_surfaces(pace.since > 0.0 ? pace.since : dt, world);
  const double fastest = find_fastest(world);
  pace.within = fastest * dt > kFar;
  pace.hold = pace.within ? kStride / fastest : dt;
  pace.since = 0.0;
  find_pairs(scene, std::max(pace.hold, dt / kMostSubsteps), world);
  if (pace.within) ask_for_speed(dt, world);
  find_need(scene, dt, world);
}

void follow_pace(const Scene& scene, int s, double dt, World& world) noexcept {
  TickBuffers& work = workspace(world);
  ContactPace& pace = work.pace;
  if (s == 0) pace.outrun = false;
  // a tick that is done again begins where its surfaces were, not where they were looked at last
  const double elapsed = s == 0 ? 0.0 : pace.since;
  if (s == 0) pace.since = 0.0;
  if (!pace.within || (s > 0 && pace.since + dt <= pace.hold)) return;
  follow_surfaces(elapsed, world);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    follow_tree(world.bodies[b], work.touched[b]);
  }
  for_each_near(world, [&](const BodyContacts& contacts) noexcept {
    const SurfaceContacts& side = contacts.sides[0];
    double move = 0.0;
    for (const std::size_t b : contacts.bodies) move += work.touched[b].move;
    const double most = side.ahead + kSurprise * side.barrier.thickness;
    pace.outrun = pace.outrun || (elapsed > 0.0 && move > most);
  });
  if (const double fastest = find_fastest(world); fastest > 0.0) {
    pace.hold = std::min(pace.hold, kStride / fastest);
  }
  pace.since = 0.0;
  find_pairs(scene, std::max(pace.hold, dt), world);
}

void end_pace(World& world) noexcept {
  if (world.body_pairs.empty() || !workspace(world).pace.within) return;
  for (SoftState& state : world.bodies) {
    if (internals(state).meets && !state.asleep) state.tree.refit(surface_position(state));
  }
}

bool take_back_outrun(const Scene& scene, double dt, World& world) noexcept {
  if (world.body_pairs.empty() || !has_outrun(dt, world)) return false;
  world.alarm = {};
  world.alarm_body = -1;
  look_more_often(scene, dt, world);
  rewind(scene, world);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (internals(world.bodies[b]).meets && !world.bodies[b].asleep) begin_moving(scene, b, world);
  }
  wake_again(scene, dt, world);
  return true;
}

bool is_followed_within(std::size_t body, World& world) noexcept {
  return workspace(world).pace.within && internals(world.bodies[body]).meets;
}

double count_approach_substeps(std::size_t body, World& world) noexcept {
  if (!is_touched(body, world)) return 1.0;
  return std::ceil(workspace(world).touched[body].approach / kLongestApproach);
}

double measure_move(double dt, const SoftState& state) noexcept {
  if (state.asleep) return 0.0;
  if (const PackedKernel* packed = find_packed(state)) {
    return packed->skin_gain * packed->measure.largest_move;
  }
  double most = 0.0;
  for (const Vec3& v : state.tissue.velocity) most = std::max(most, v.squaredNorm());
  return dt * std::sqrt(most);
}

}  // namespace palpate
