// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/touch_rigid.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/rigid_touch.h"
#include "palpate/sim/tick/private/touch_hard.h"
#include "palpate/sim/tree/private/box_distance.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// [-] How much stiffer than its mesh is what instruments make of it: they press up to the barrier,
/// and stick to it.
constexpr double kUnderInstruments = 4.0;

/// Substeps that rigid bodies may ask for: what is too light for them is moved as heavier.
constexpr int kMostSubsteps = 16;

std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

RigidView view(const Scene& scene, std::size_t r, double dt, World& world) noexcept {
  return {scene.rigid[r], world.rigid[r], workspace(world).rigid.bodies[r], dt};
}

/// The spheres and the mesh where a body is now.
void place_rigid(const Scene& scene, std::size_t r, World& world) noexcept {
  TickBuffers& work = workspace(world);
  const RigidState& state = world.rigid[r];
  const RigidBody& body = scene.rigid[r];
  for (std::size_t s = 0; s < body.sphere_centres.size(); ++s) {
    work.rigid.bodies[r].centre[s] = place_of(state, body.sphere_centres[s]);
  }
  HardSurface& mesh = work.hard[scene.scenery.size() + r];
  for (std::size_t v = 0; v < mesh.x.size(); ++v)
    mesh.x[v] = place_of(state, body.mesh.vertices[v]);
}

/// The largest row, after which all are 0 again.
void take_row(const Scene& scene, std::size_t b, World& world) noexcept {
  RigidContacts& rigid = workspace(world).rigid;
  const TissueModel& tissue = scene.bodies[b].tissue;
  std::vector<double>& rows = internals(world.bodies[b]).vertex_scratch;
  double most = 0.0;
  const auto take = [&](int row) noexcept {
    most = std::max(most, rows[at(row)]);
    rows[at(row)] = 0.0;
  };
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const SphereLists& lists = rigid.on_tissue[r * world.bodies.size() + b];
    for (std::size_t s = 0; lists.near && s < lists.end.size(); ++s) {
      for (const int t : lists.of(s)) {
        for (const int v : tissue.triangles[at(t)]) {
          if (tissue.skin.corners.empty()) {
            take(v);
          } else {
            for (const int particle : tissue.skin.corners[at(v)]) take(particle);
          }
        }
      }
    }
  }
  rigid.row[b] = most;
}

/// [m] How far beyond its radius a sphere looks in a tick of dt [s].
double find_margin(const RigidState& state, double reach, double dt) noexcept {
  const double speed = state.velocity.norm() + reach * state.angular_velocity.norm();
  return kCandidateMargin + 2.0 * speed * dt;
}

void list_spheres(const AabbTree& tree, std::span<const Vec3> x, const RigidView& body,
                  double margin, SphereLists& lists) noexcept {
  std::size_t end = 0;
  for (std::size_t s = 0; s < body.sphere_count(); ++s) {
    if (lists.near) {
      const std::span<int> room = std::span(lists.triangles).subspan(end);
      const double reach = body.fixed.sphere_radii[s] + margin;
      const int found = find_in_sphere(tree, x, body.moved.centre[s], reach, room);
      end += std::min(at(found), room.size());
    }
    lists.end[s] = end;
  }
}

/// [N/m] Of the triangles that an instrument pushed, where it begins to.
double find_pushing_stiffness(const Tool& tool, const HardPair& pair) noexcept {
  double area = 0.0;
  for (const Push& push : pair.load.pushes()) area += pair.areas[at(push.triangle)];
  return tool.stiffness * area;
}

/// What an instrument does to a mesh has no mass and no damping of its own: what a body does within
/// a tick beyond the motion that it began it with is damped, as critically as other contacts.
void damp_under_instruments(std::size_t r, double k, const RigidView& body, World& world) noexcept {
  const RigidState& began = workspace(world).rigid.kept_states[r];
  const MovedMass& moved = body.moved.moved;
  const double rate = std::min(0.6 * std::sqrt(k / moved.mass), 0.5 / body.dt);  // [1/s]
  const Quaternion& turn = body.state.orientation;
  const Vec3 spin = turn.conjugate() * Vec3(body.state.angular_velocity - began.angular_velocity);
  body.moved.wrench.force -= rate * moved.mass * (body.state.velocity - began.velocity);
  body.moved.wrench.torque -= rate * (turn * spin.cwiseProduct(moved.inertia));
}

/// What sticks to jaws is as stiff along a stone as the stone is across: pads press it where it is
/// round, which tips it out of springs softer than what they press with over its radius.
void stiffen_anchors(std::size_t surface, const HardPair& pair, const Tool& tool,
                     ToolState& state) noexcept {
  for (ToolState::Anchor& anchor : std::span(state.anchors).first(at(state.anchor_count))) {
    if (at(anchor.body) != surface) continue;
    anchor.stiffness = kBristle * tool.stiffness * pair.areas[at(anchor.triangle)];
  }
}

/// What the instruments have pushed its mesh with.
void take_instruments(const Scene& scene, std::size_t r, const RigidView& body,
                      World& world) noexcept {
  TickBuffers& work = workspace(world);
  const std::size_t h = scene.scenery.size() + r;
  const HardSurface& mesh = work.hard[h];
  int pushes = 0;
  double k = 0.0;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    if (!world.instruments[i].tool.placed) continue;
    const HardPair& pair = work.hard_pairs[i * work.hard.size() + h];
    const Tool& tool = scene.instruments[i].tool;
    k += find_pushing_stiffness(tool, pair);
    stiffen_anchors(world.bodies.size() + h, pair, tool, world.instruments[i].tool);
    for (const Push& push : pair.load.pushes()) {
      const Triangle& corners = mesh.tree.triangles()[at(push.triangle)];
      body.moved.wrench.add(compute_point(corners, push.weights, mesh.x), push.force,
                            body.state.position);
      body.state.instrument_force += push.force;
      ++pushes;
    }
  }
  body.moved.contacts += pushes;
  if (pushes > 0) damp_under_instruments(r, k, body, world);
}

/// [N/m] No less than what instruments that are near it make of it.
double bound_instruments(const Scene& scene, std::size_t r, World& world) noexcept {
  TickBuffers& work = workspace(world);
  const std::size_t h = scene.scenery.size() + r;
  const double least = 4.0 * scene.rigid[r].contact_stiffness;
  double k = 0.0;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    const HardPair& pair = work.hard_pairs[i * work.hard.size() + h];
    const int near = pair.candidates[0].count + pair.candidates[1].count;
    if (near == 0) continue;
    k += std::max(least, find_pushing_stiffness(scene.instruments[i].tool, pair));
  }
  return kUnderInstruments * k;
}

MovedBody make_moved(const RigidBody& body) {
  MovedBody moved;
  moved.volume = compute_rigid_volume(body);
  moved.centre.resize(body.sphere_radii.size());
  moved.moved = {body.mass, body.inertia};
  for (std::size_t s = 0; s < body.sphere_radii.size(); ++s) {
    moved.reach = std::max(moved.reach, body.sphere_centres[s].norm() + body.sphere_radii[s]);
  }
  return moved;
}

/// Room for what every sphere may touch, and its bristles.
void add_lists(const Scene& scene, RigidContacts& rigid) {
  std::size_t bristles = 0;
  const auto make = [&](std::size_t triangles, std::size_t spheres) {
    SphereLists lists;
    lists.triangles.resize(4 * triangles);
    lists.end.assign(spheres, 0);
    lists.first_bristle = bristles;
    bristles += spheres;
    return lists;
  };
  for (const RigidBody& body : scene.rigid) {
    const std::size_t spheres = body.sphere_radii.size();
    for (const SoftBody& soft : scene.bodies) {
      rigid.on_tissue.push_back(make(soft.tissue.triangles.size(), spheres));
    }
    for (const Scenery& scenery : scene.scenery) {
      rigid.on_scenery.push_back(make(scenery.mesh.triangles.size(), spheres));
    }
  }
  for (std::size_t a = 0; a < scene.rigid.size(); ++a) {
    for (std::size_t b = 0; b < scene.rigid.size(); ++b) {
      rigid.first_pair.push_back(bristles);
      if (a >= b) continue;
      bristles += scene.rigid[a].sphere_radii.size() * scene.rigid[b].sphere_radii.size();
    }
  }
  rigid.bristles.resize(bristles);
}

}  // namespace

void build_rigid_contacts(const Scene& scene, World& world) {
  RigidContacts& rigid = workspace(world).rigid;
  if (scene.rigid.empty()) return;
  std::size_t spheres = 0;
  for (const RigidBody& body : scene.rigid) {
    spheres += body.sphere_radii.size();
    world.rigid.push_back({.position = body.position, .orientation = body.orientation});
    rigid.bodies.push_back(make_moved(body));
  }
  add_lists(scene, rigid);
  rigid.kept_bristles = rigid.bristles;
  rigid.kept_states = world.rigid;
  rigid.row.assign(scene.bodies.size(), 0.0);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    rigid.loads.emplace_back(static_cast<int>(kMostSpherePushes * spheres));
  }
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) {
    place_rigid(scene, r, world);
    HardSurface& mesh = workspace(world).hard[scene.scenery.size() + r];
    mesh.tree.refit(mesh.x);
  }
}

void meet_rigid(const Scene& scene, double dt, World& world) noexcept {
  RigidContacts& rigid = workspace(world).rigid;
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const RigidState& state = world.rigid[r];
    const double reach = rigid.bodies[r].reach;
    const double margin = reach + find_margin(state, reach, dt);
    HardSurface& mesh = workspace(world).hard[scene.scenery.size() + r];
    mesh.tree.refit(mesh.x);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      SphereLists& lists = rigid.on_tissue[r * world.bodies.size() + b];
      const double far = measure_to_box(state.position, world.bodies[b].tree);
      lists.near = far - bound_lag(world.bodies[b]) < margin + kCandidateMargin;
      if (lists.near) internals(world.bodies[b]).meets = true;
    }
    for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
      const AabbTree& tree = workspace(world).hard[s].tree;
      rigid.on_scenery[r * scene.scenery.size() + s].near =
          measure_to_box(state.position, tree) < margin;
    }
  }
}

void find_rigid_contacts(const Scene& scene, double dt, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  TickBuffers& work = workspace(world);
  RigidContacts& rigid = work.rigid;
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const RigidView body = view(scene, r, dt, world);
    const double margin = find_margin(body.state, body.moved.reach, dt);
    body.moved.stiffness = bound_instruments(scene, r, world);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      SphereLists& lists = rigid.on_tissue[r * world.bodies.size() + b];
      list_spheres(world.bodies[b].tree, surface_position(world.bodies[b]), body, margin, lists);
      find_tissue_need(scene, b, lists, body, world);
    }
    for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
      SphereLists& lists = rigid.on_scenery[r * scene.scenery.size() + s];
      list_spheres(work.hard[s].tree, work.hard[s].x, body, margin, lists);
      for (std::size_t k = 0; k < body.sphere_count(); ++k) {
        if (!lists.of(k).empty()) body.moved.stiffness += body.fixed.contact_stiffness;
      }
    }
    for (std::size_t other = 0; other < rigid.bodies.size(); ++other) {
      const double apart = (world.rigid[other].position - body.state.position).norm();
      if (other == r || apart > body.moved.reach + rigid.bodies[other].reach + margin) continue;
      body.moved.stiffness += 4.0 * body.fixed.contact_stiffness;
    }
  }
  for (std::size_t b = 0; b < rigid.row.size(); ++b) take_row(scene, b, world);
  watch.add_to(world.costs.rigid.candidates);
}

bool is_rigid_near(std::size_t body, World& world) noexcept {
  const RigidContacts& rigid = workspace(world).rigid;
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const SphereLists& lists = rigid.on_tissue[r * world.bodies.size() + body];
    if (lists.near && lists.end.back() > 0) return true;
  }
  return false;
}

double bound_rigid_stiffness(std::size_t body, World& world) noexcept {
  const RigidContacts& rigid = workspace(world).rigid;
  return rigid.row.empty() ? 0.0 : rigid.row[body];
}

int refine_for_rigid(const Scene& scene, int finest, World& world) noexcept {
  double wanted = 1.0;
  for (std::size_t r = 0; r < world.rigid.size(); ++r) {
    const double k = workspace(world).rigid.bodies[r].stiffness;
    wanted = std::max(wanted, std::sqrt(2.0 * k / scene.rigid[r].mass) / scene.rate);
  }
  const double most = std::max(1.0, std::floor(kMostSubsteps / static_cast<double>(finest)));
  return finest * static_cast<int>(std::clamp(std::ceil(wanted / finest), 1.0, most));
}

void begin_rigid(const Scene& scene, double dt, World& world) noexcept {
  for (std::size_t r = 0; r < world.rigid.size(); ++r) {
    MovedBody& moved = workspace(world).rigid.bodies[r];
    const double k = moved.stiffness;
    moved.moved = raise_mass(scene.rigid[r], k, k * moved.reach * moved.reach, dt);
    world.rigid[r].tissue_force.setZero();
    world.rigid[r].instrument_force.setZero();
  }
}

void touch_rigid(const Scene& scene, double dt, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  TickBuffers& work = workspace(world);
  RigidContacts& rigid = work.rigid;
  for (Load& load : rigid.loads) load.clear();
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const RigidView body = view(scene, r, dt, world);
    body.moved.wrench = {};
    body.moved.stored_energy = 0.0;
    body.moved.last_contacts = body.moved.contacts;
    body.moved.contacts = 0;
  }
  for (std::size_t r = 0; r < rigid.bodies.size(); ++r) {
    const RigidView body = view(scene, r, dt, world);
    take_instruments(scene, r, body, world);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      const SphereLists& lists = rigid.on_tissue[r * world.bodies.size() + b];
      if (lists.near) touch_tissue(scene, b, lists, body, world);
    }
    for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
      const SphereLists& lists = rigid.on_scenery[r * scene.scenery.size() + s];
      if (lists.near) touch_scenery(work.hard[s], lists, body, rigid);
    }
    for (std::size_t other = r + 1; other < rigid.bodies.size(); ++other) {
      const RigidView its = view(scene, other, dt, world);
      if ((its.state.position - body.state.position).norm() > body.moved.reach + its.moved.reach) {
        continue;
      }
      const std::size_t first = rigid.first_pair[r * rigid.bodies.size() + other];
      touch_pair(body, its, std::span(rigid.bristles).subspan(first));
    }
    add_fluid(body.fixed, scene.fluid, scene.gravity, body.moved.volume, body.state,
              body.moved.wrench);
  }
  watch.add_to(world.costs.rigid.contact);
}

void move_rigid(const Scene& scene, double dt, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  for (std::size_t r = 0; r < world.rigid.size(); ++r) {
    const MovedBody& moved = workspace(world).rigid.bodies[r];
    advance_rigid(moved.moved, moved.wrench, dt, world.rigid[r]);
    place_rigid(scene, r, world);
  }
  watch.add_to(world.costs.rigid.contact);
}

void end_rigid(int finest, World& world) noexcept {
  for (RigidState& state : world.rigid) {
    state.tissue_force /= finest;
    state.instrument_force /= finest;
  }
}

std::span<const Push> list_rigid_pushes(std::size_t body, World& world) noexcept {
  const RigidContacts& rigid = workspace(world).rigid;
  if (rigid.loads.empty()) return {};
  return rigid.loads[body].pushes();
}

double bound_rigid_work(const Scene& scene, double dt, World& world) noexcept {
  double most = 0.0;
  for (std::size_t r = 0; r < world.rigid.size(); ++r) {
    const MovedBody& moved = workspace(world).rigid.bodies[r];
    const double fallen = world.rigid[r].velocity.norm() * dt;
    const RigidState& kept = workspace(world).rigid.kept_states[r];
    most += compute_kinetic_energy(moved.moved, kept) + 2.0 * moved.stored_energy +
            scene.rigid[r].mass * scene.gravity.norm() * fallen +
            world.rigid[r].instrument_force.norm() * fallen;
  }
  return most;
}

void keep_rigid(World& world) noexcept {
  RigidContacts& rigid = workspace(world).rigid;
  std::ranges::copy(world.rigid, rigid.kept_states.begin());
  std::ranges::copy(rigid.bristles, rigid.kept_bristles.begin());
}

void rewind_rigid(const Scene& scene, World& world) noexcept {
  RigidContacts& rigid = workspace(world).rigid;
  std::ranges::copy(rigid.kept_states, world.rigid.begin());
  std::ranges::copy(rigid.kept_bristles, rigid.bristles.begin());
  for (std::size_t r = 0; r < world.rigid.size(); ++r) place_rigid(scene, r, world);
}

}  // namespace palpate
