// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/touch_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/collision/private/choose_barrier.h"
#include "palpate/sim/tick/private/contact_pace.h"
#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tree/private/box_distance.h"

namespace palpate {
namespace {

/// [m] Beyond the thickness: nearer than this, surfaces are looked at; farther than twice it, no
/// longer.
constexpr double kMeeting = 3.0 * kListMargin;

/// [m] Between the boxes of two surfaces, each grown by what its tree may be behind.
double measure_between(const SoftState& a, const SoftState& b) noexcept {
  return measure_between(a.tree, b.tree) - bound_lag(a) - bound_lag(b);
}

/// Of a body that has stepped, velocities have what impulses did in them.
void forget_impulses(int s, int finest, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SurfaceTouch& touch = workspace(world).touched[b];
    if (!touch.has_impulse) continue;
    if (s > 0 && s % (finest / world.bodies[b].substeps) != 0) continue;
    std::ranges::fill(touch.impulse, Vec3::Zero());
    touch.has_impulse = false;
  }
}

/// Calls `visit(bristles)` for all of a pair, where its surfaces rub.
template <class Visit>
void for_each_bristles(BodyContacts& contacts, Visit visit) {
  if (!(contacts.sides[0].bristles.friction > 0.0)) return;
  for (std::size_t k = 0; k < contacts.side_count; ++k) {
    visit(contacts.sides[k].bristles);
    visit(contacts.edges[k].contacts.bristles);
  }
}

void note(const ContactSum& sum, double towards_second, BodyPairState& pair) noexcept {
  pair.touching += sum.touching;
  if (sum.touching > 0) pair.least_gap = std::min(pair.least_gap, sum.least_gap);
  pair.force += towards_second * sum.force;
}

void add(const FrictionSum& friction, ContactSum& sum) noexcept {
  sum.energy += friction.energy;
  sum.force += friction.force;
}

/// What bodies of a pair must be like, each.
void check_touching(const Scene& scene, int index) {
  const SoftBody& body = scene.bodies[static_cast<std::size_t>(index)];
  const std::string where = write_text("scene: bodies[", index, "].");
  if (!body.tissue.elastic.corners.empty() && body.kernel != Kernel::reference) {
    refuse(where + "kernel", "a linear solid under its response",
           "reference, or a tissue of another law, for a body of body_pairs: contacts with other "
           "bodies are not solved with a precomputed response");
  }
  if (body.force_error > 0.0) {
    refuse(where + "force_error [N]", write_text(body.force_error),
           "0 for a body of body_pairs: how wrong sleep makes a force is known of balls");
  }
  if (scene.exchange_rate > 0.0) {
    refuse("scene: exchange_rate [Hz]", write_text(scene.exchange_rate),
           "0 for a scene with body_pairs: between two exchanges bodies do not touch each other");
  }
}

void check_body_pair(const Scene& scene, std::size_t p, const std::string& where) {
  const BodyPair& pair = scene.body_pairs[p];
  const auto count = static_cast<int>(scene.bodies.size());
  for (const int body : {pair.first, pair.second}) {
    if (body >= 0 && body < count) continue;
    refuse(where, write_text("body ", body),
           write_text("one of the ", count, " bodies, counted from 0"));
  }
  if (pair.first == pair.second && !scene.bodies[static_cast<std::size_t>(pair.first)].may_fold) {
    refuse(where, write_text("body ", pair.first, " with itself"),
           "two bodies, or one that may_fold");
  }
  for (std::size_t other = 0; other < p; ++other) {
    const BodyPair& earlier = scene.body_pairs[other];
    const bool same =
        std::min(earlier.first, earlier.second) == std::min(pair.first, pair.second) &&
        std::max(earlier.first, earlier.second) == std::max(pair.first, pair.second);
    if (!same) continue;
    refuse(where, write_text("bodies ", pair.first, " and ", pair.second, " again"),
           "each pair once");
  }
  for (const int body : {pair.first, pair.second}) check_touching(scene, body);
}

}  // namespace

void build_body_pairs(Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto index = static_cast<int>(b);
    const bool listed = std::ranges::any_of(scene.body_pairs, [&](const BodyPair& pair) {
      return pair.first == index && pair.second == index;
    });
    if (scene.bodies[b].may_fold && !listed) {
      scene.body_pairs.push_back({.first = index, .second = index});
    }
  }
  for (std::size_t p = 0; p < scene.body_pairs.size(); ++p) {
    BodyPair& pair = scene.body_pairs[p];
    const std::string where = write_text("scene: body_pairs[", p, "]");
    check_body_pair(scene, p, where);
    choose_barrier(where, scene.bodies[static_cast<std::size_t>(pair.first)].tissue,
                   scene.bodies[static_cast<std::size_t>(pair.second)].tissue, pair);
  }
}

void build_body_contacts(const Scene& scene, World& world) {
  TickBuffers& work = workspace(world);
  world.body_pairs.resize(scene.body_pairs.size());
  work.contacts.resize(scene.body_pairs.size());
  if (scene.body_pairs.empty()) return;
  work.touched.resize(scene.bodies.size());
  for (std::size_t p = 0; p < scene.body_pairs.size(); ++p) {
    const BodyPair& pair = scene.body_pairs[p];
    const std::array bodies = {static_cast<std::size_t>(pair.first),
                               static_cast<std::size_t>(pair.second)};
    const Barrier barrier{pair.thickness, pair.stiffness, pair.damping};
    BodyContacts& contacts = work.contacts[p];
    contacts.bodies = bodies;
    contacts.side_count = bodies[0] == bodies[1] ? 1 : 2;
    const auto at_rest = [&](std::size_t body) {
      const TissueModel& tissue = scene.bodies[body].tissue;
      return SurfaceMesh{compute_surface(tissue, tissue.rest_position), tissue.triangles};
    };
    const std::array meshes = {at_rest(bodies[0]), at_rest(bodies[1])};
    for (std::size_t k = 0; k < contacts.side_count; ++k) {
      const TissueModel& tissue = scene.bodies[bodies[k]].tissue;
      contacts.sides[k] =
          SurfaceContacts(meshes[k], meshes[1 - k], barrier, bodies[0] == bodies[1]);
      if (contacts.side_count == 2)
        contacts.edges[k] = EdgePoints(meshes[k], meshes[1 - k], barrier);
      for (SurfaceContacts* side : {&contacts.sides[k], &contacts.edges[k].contacts}) {
        side->bristles = PointBristles(pair.friction, side->area.size());
      }
      SurfaceTouch& touch = work.touched[bodies[k]];
      if (touch.corner.empty()) touch = SurfaceTouch(tissue);
    }
  }
  meet_bodies(1.0 / scene.rate, world);
  find_body_contacts(scene, 1.0 / scene.rate, world);
}

void meet_bodies(double dt, World& world) noexcept {
  if (world.body_pairs.empty() && world.scenery_contacts.empty() && world.rigid.empty()) return;
  for (SoftState& body : world.bodies) internals(body).meets = false;
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    BodyPairState& pair = world.body_pairs[p];
    BodyContacts& contacts = workspace(world).contacts[p];
    const auto& bodies = contacts.bodies;
    SoftState &first = world.bodies[bodies[0]], &second = world.bodies[bodies[1]];
    const double reach = (pair.near ? 2.0 : 1.0) * kMeeting +
                         2.0 * (measure_move(dt, first) + measure_move(dt, second));
    contacts.apart = measure_between(first, second) - contacts.sides[0].barrier.thickness;
    pair.near = bodies[0] == bodies[1] || contacts.apart < reach;
    if (!pair.near) continue;
    internals(first).meets = internals(second).meets = true;
  }
}

void add_way(std::size_t body, double way, World& world) noexcept {
  if (!world.body_pairs.empty()) workspace(world).touched[body].went += way;
}

void forget_way(std::size_t body, World& world) noexcept {
  add_way(body, std::numeric_limits<double>::infinity(), world);
}

bool is_touched(std::size_t body, World& world) noexcept {
  return !world.body_pairs.empty() && workspace(world).touched[body].is_touched;
}

double bound_touch_stiffness(std::size_t body, World& world) noexcept {
  return is_touched(body, world) ? workspace(world).touched[body].stiffness : 0.0;
}

void touch_bodies(const Scene& scene, int s, int finest, double dt, World& world) noexcept {
  if (world.body_pairs.empty()) return;
  TickBuffers& work = workspace(world);
  follow_pace(scene, s, dt, world);
  Stopwatch watch(world.measures_costs);
  forget_impulses(s, finest, world);
  for (std::size_t p = 0; p < work.contacts.size(); ++p) {
    BodyPairState& pair = world.body_pairs[p];
    BodyContacts& contacts = work.contacts[p];
    if (s == 0) pair.least_gap = std::numeric_limits<double>::infinity();
    if (s == 0) pair.force.setZero();
    const auto& bodies = contacts.bodies;
    double energy = 0.0;
    pair.touching = 0;
    for_each_bristles(contacts, begin_rubbing);
    for (std::size_t k = 0; k < contacts.side_count; ++k) {
      const double towards_second = contacts.side_count == 1 ? 0.0 : k == 0 ? 1.0 : -1.0;
      const auto push = [&](const TouchingSurface& points, SurfaceContacts& side) noexcept {
        const TouchingSurface other = view_surface(scene, bodies[1 - k], world);
        ContactSum sum = push_contacts(dt, points, other, side, s == 0);
        if (side.bristles.friction > 0.0) add(rub_contacts(points, other, side), sum);
        note(sum, towards_second, pair);
        energy += sum.energy;
      };
      for_each_side(scene, contacts, k, world, push);
    }
    if (s == 0) contacts.stored_energy = energy;
    watch.add_to(world.costs.body_pairs[p].contact);
  }
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SurfaceTouch& touch = work.touched[b];
    touch.went = 0.0;
    if (s == 0) touch.lost = 0.0;
    touch.lost += dt * std::max(0.0, measure_lost(view_surface(scene, b, world)));
  }
  work.pace.since += dt;
}

void keep_pair_friction(World& world) noexcept {
  for (BodyContacts& contacts : workspace(world).contacts) {
    for_each_bristles(contacts, keep_bristles);
  }
}

void rewind_pair_friction(World& world) noexcept {
  for (BodyContacts& contacts : workspace(world).contacts) {
    for_each_bristles(contacts, rewind_bristles);
  }
}

void end_touching(int finest, World& world) noexcept {
  for (BodyPairState& pair : world.body_pairs) pair.force /= finest;
  // what is done again does not begin where this ends
  for (std::size_t b = 0; b < world.bodies.size(); ++b) forget_way(b, world);
  end_pace(world);
}

double bound_touch_work(std::size_t body, World& world) noexcept {
  double bound = 0.0;
  const TickBuffers& work = workspace(world);
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    const auto& bodies = work.contacts[p].bodies;
    if (bodies[0] != body && bodies[1] != body) continue;
    bound += work.contacts[p].stored_energy;
    const std::size_t other = bodies[0] == body ? bodies[1] : bodies[0];
    if (other == body) continue;
    // work is of the velocities after a step, so of none where that stops what flew
    bound += std::max(-work.work[other], work.touched[other].lost);
  }
  return bound;
}

}  // namespace palpate
