// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/move_tissue.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <numeric>
#include <utility>

#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/private/sum_over_pushes.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/contact_pace.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/stop_at_scenery.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Makes a displacement measured in float no shorter than it was.
constexpr double kWiden = 1.0 + 1e-6;

/// Whether `what` has not been listed in this tick; from now on it has.
bool is_new(int what, long tick, std::vector<long>& last_at) noexcept {
  long& last = last_at[static_cast<std::size_t>(what)];
  return std::exchange(last, tick) != tick;
}

/// Adds `what` to `list` unless it is there in this tick already.
void add_once(int what, long tick, std::vector<long>& last_at, std::vector<int>& list,
              int& count) noexcept {
  if (is_new(what, tick, last_at)) list[static_cast<std::size_t>(count++)] = what;
}

void add_vertex(const TissueModel& tissue, int vertex, long tick, NearList& near) noexcept {
  if (tissue.skin.corners.empty()) {
    add_once(vertex, tick, near.particle_last_at, near.particles, near.particle_count);
    return;
  }
  add_once(vertex, tick, near.skin_last_at, near.skin, near.skin_count);
  for (const int p : tissue.skin.corners[static_cast<std::size_t>(vertex)]) {
    add_once(p, tick, near.particle_last_at, near.particles, near.particle_count);
  }
}

void add_near(const TissueModel& tissue, int triangle, long tick, NearList& near) noexcept {
  if (triangle < 0 || !is_new(triangle, tick, near.triangle_last_at)) return;
  for (const int i : tissue.triangles[static_cast<std::size_t>(triangle)]) {
    add_vertex(tissue, i, tick, near);
  }
}

/// All of a body, whatever is in the list.
void add_all(NearList& near) noexcept {
  near.particle_count = static_cast<int>(near.particles.size());
  near.skin_count = static_cast<int>(near.skin.size());
  std::iota(near.particles.begin(), near.particles.end(), 0);
  std::iota(near.skin.begin(), near.skin.end(), 0);
}

/// A body, and what moves it in a tick.
struct Moved {
  Moved(const Scene& scene_in, std::size_t body_in, World& world_in) noexcept
      : scene(scene_in),
        index(body_in),
        body(scene.bodies[body_in]),
        world(world_in),
        state(world.bodies[body_in]) {}

  const Scene& scene;
  std::size_t index;
  const SoftBody& body;
  World& world;
  SoftState& state;
};

/// Lists what tools and other bodies may touch, or hold, and what may tear or has torn.
void list_near(const Moved& moved, NearList& near) noexcept {
  const TissueModel& tissue = moved.body.tissue;
  const World& world = moved.world;
  const auto index = static_cast<int>(moved.index);
  if (is_followed_within(moved.index, moved.world)) return add_all(near);
  near.clear();
  internals(moved.state).tear.for_each_particle([&](int particle) noexcept {
    add_once(particle, world.tick_count, near.particle_last_at, near.particles,
             near.particle_count);
  });
  for_each_touched(
      moved.index, moved.world,
      [&](int vertex) noexcept { add_vertex(tissue, vertex, world.tick_count, near); },
      [&](int triangle) noexcept { add_near(tissue, triangle, world.tick_count, near); });
  for_each_rigid_triangle(moved.index, moved.world, [&](int triangle) noexcept {
    add_near(tissue, triangle, world.tick_count, near);
  });
  for_each_stopped_vertex(moved.scene, moved.index, moved.world, [&](int vertex) noexcept {
    add_vertex(tissue, vertex, world.tick_count, near);
  });
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    const ToolState& tool = world.instruments[i].tool;
    for_each_touchable(moved.world, i, moved.index, [&](int triangle) noexcept {
      add_near(tissue, triangle, world.tick_count, near);
    });
    for (int k = 0; k < tool.patch_count; ++k) {
      const ToolState::PatchPoint& point = tool.patch[static_cast<std::size_t>(k)];
      if (point.body == index) add_near(tissue, point.triangle, world.tick_count, near);
    }
    if (tool.carrier.body == index) {
      add_near(tissue, tool.carrier.triangle, world.tick_count, near);
    }
  }
}

/// Brings particles up to date where a tool may touch; how far one of them has gone at most [m].
double unpack_near(const TissueModel& tissue, const PackedKernel& kernel,
                   SoftState& state) noexcept {
  return unpack_particles(*kernel.model, tissue, kernel.state, kernel.near.particles_in_use(),
                          state.tissue);
}

/// And the skin on them.
void move_near_skin(const TissueModel& tissue, const NearList& near, SoftState& state) noexcept {
  for (const int vertex : near.skin_in_use()) {
    const auto v = static_cast<std::size_t>(vertex);
    state.skin[v] = place_on_skin(tissue.skin, v, state.tissue.position);
  }
}

/// The tree follows what moves in this tick, and nothing else.
void choose_in_tree(PackedKernel& kernel, AabbTree& tree) noexcept {
  const PackedModel& model = *kernel.model;
  const auto width = static_cast<std::size_t>(model.width);
  for (std::size_t s = 0; s < kernel.in_tree.size(); ++s) {
    if (kernel.in_tree[s] == kernel.active.awake[s]) continue;
    kernel.in_tree[s] = kernel.active.awake[s];
    std::span<const int> particles = std::span(model.particle).subspan(width * s, width);
    while (particles.back() < 0) particles = particles.first(particles.size() - 1);
    tree.set_moving(particles, kernel.in_tree[s] != 0);
  }
}

/// Before the substeps of a tick: how far what instruments hold is stretched is asked at its end.
void watch_held(const Moved& moved) noexcept {
  Tear& tear = internals(moved.state).tear;
  if (!tear.may_tear()) return;
  tear.begin_watch(moved.world.tick_count);
  const auto index = static_cast<int>(moved.index);
  const TissueModel& tissue = moved.body.tissue;
  const auto watch = [&](int triangle) noexcept {
    for (const int vertex : tissue.triangles[static_cast<std::size_t>(triangle)]) {
      if (tissue.skin.corners.empty()) {
        tear.watch(vertex);
        continue;
      }
      for (const int particle : tissue.skin.corners[static_cast<std::size_t>(vertex)]) {
        tear.watch(particle);
      }
    }
  };
  for (const InstrumentState& instrument : moved.world.instruments) {
    const ToolState& tool = instrument.tool;
    for (const ToolState::Anchor& anchor :
         std::span(tool.anchors).first(static_cast<std::size_t>(tool.anchor_count))) {
      if (anchor.body == index) watch(anchor.triangle);
    }
    for (const ToolState::Hold& hold :
         std::span(tool.holds).first(static_cast<std::size_t>(tool.hold_count))) {
      if (hold.body == index) watch(hold.triangle);
    }
  }
}

/// [N] That cancel what torn parts bear where the tissue is as a substep begins. Before the last
/// one of a tick the guard is told what energy those have.
std::span<const ParticleForce> cancel_torn(const Moved& moved, bool last) noexcept {
  Tear& tear = internals(moved.state).tear;
  if (!tear.has_torn()) return {};
  const State& now = moved.state.tissue;
  if (last) moved.state.guard.torn_energy = tear.compute_energy(now.position);
  return tear.cancel(moved.body.tissue, now.position);
}

Stretch measure_whole(const Moved& moved) noexcept {
  const Tear& tear = internals(moved.state).tear;
  return measure_stretch(moved.body.tissue, moved.state.tissue.position,
                         {moved.state.guard.torn_links, tear.torn_triangles()});
}

// --- begin, step and end of each kernel ----------------------------------------------------------

void begin(ReferenceKernel&, const Moved& moved) noexcept { watch_held(moved); }

/// By which a body is stepped in double: its own integrator, or its safeguard's.
Integrator choose_integrator(const SoftBody& body, const SoftState& state) noexcept {
  return is_stepped_in_double(state) ? Integrator::symplectic_euler_implicit_damping
                                     : body.integrator;
}

/// False where there is no solution, or no memory to find it with.
bool step_implicitly(const SoftBody& body, const Load& load, double dt, OwnStepper& own,
                     SoftState& state) noexcept {
  try {
    if (!own.stepper || own.model != &body.tissue) {
      own.stepper =
          std::make_unique<ImplicitStepper>(body.tissue, body.integrator, body.iterations);
      own.model = &body.tissue;
    }
    return own.stepper->step(load, dt, state.tissue) > 0;
  } catch (const std::exception&) {
    return false;
  }
}

void step_by(Integrator integrator, const SoftBody& body, const Load& load, double dt,
             ReferenceKernel* kernel, SoftState& state) noexcept {
  if (is_implicit(integrator) && kernel) {
    kernel->unsolved = !step_implicitly(body, load, dt, kernel->implicit, state);
  } else if (state.safeguard == Safeguard::implicit_euler) {
    step_stiff_part(body, state);
  } else {
    step(body.tissue, load, dt, integrator, state.tissue);
  }
}

/// A step of the plain laws in double, on SoftState::tissue itself; returns the pushes' work [J].
/// `kernel` where that is the reference: it keeps what implicit integrators need.
double step_in_double(const SoftBody& body, double dt, ReferenceKernel* kernel,
                      SoftState& state) noexcept {
  const TissueModel& tissue = body.tissue;
  const Integrator integrator = choose_integrator(body, state);
  const std::span<const Push> pushes = state.load.pushes();
  const double before = sum_over_pushes(pushes, tissue, state.tissue.position);
  if (wants_kick(integrator)) {
    Load bare;
    bare.gravity = state.load.gravity;
    const double work = kick(tissue, state.load, dt, state.tissue);
    step_by(integrator, body, bare, dt, kernel, state);
    move_skin(tissue.skin, state.tissue.position, state.skin);
    // at rest under a push explicit Euler has -dt f/m before each kick and none after it, by which
    // the kicks would take dt² f²/(2 m) of each step from what was given, for ever
    if (integrator != Integrator::explicit_euler) return work;
    return sum_over_pushes(pushes, tissue, state.tissue.position) - before;
  }
  step_by(integrator, body, state.load, dt, kernel, state);
  move_skin(tissue.skin, state.tissue.position, state.skin);
  if (integrator == Integrator::symplectic_euler ||
      integrator == Integrator::symplectic_euler_implicit_damping) {
    return dt * sum_over_pushes(pushes, tissue, state.tissue.velocity);
  }
  return sum_over_pushes(pushes, tissue, state.tissue.position) - before;
}

double step_kernel(ReferenceKernel& kernel, const Moved& moved, double dt, bool) noexcept {
  forget_way(moved.index, moved.world);
  if (kernel.unsolved) return 0.0;
  return step_in_double(moved.body, dt, &kernel, moved.state);
}

Alarm report_unsolved(const Moved& moved) noexcept {
  const double step = 1.0 / (moved.scene.rate * moved.state.substeps);
  return {AlarmKind::not_solved, -1, step, step, moved.state.tissue.time};
}

Alarm end(ReferenceKernel& kernel, const Moved& moved, double work) noexcept {
  const TissueModel& tissue = moved.body.tissue;
  SoftState& state = moved.state;
  if (kernel.unsolved || internals(state).stiff.unsolved) return report_unsolved(moved);
  state.stretch = measure_whole(moved);
  return check(tissue, state.load.gravity, state.tissue, work, state.guard, state.substeps);
}

void begin(PackedKernel& kernel, const Moved& moved) noexcept {
  watch_held(moved);
  list_near(moved, kernel.near);
  if (is_stepped_in_double(moved.state)) catch_up(moved.body, moved.state);
  if (!kernel.active.on) return;
  wake_near(*kernel.model, moved.body.tissue, kernel.near.particles_in_use(), kernel.active,
            kernel.state);
  kernel.began_still = kernel.state.slices.count == 0;
  choose_in_tree(kernel, moved.state.tree);
}

double step_kernel(PackedKernel& kernel, const Moved& moved, double dt, bool last) noexcept {
  const TissueModel& tissue = moved.body.tissue;
  SoftState& state = moved.state;
  if (is_stepped_in_double(state)) {
    forget_way(moved.index, moved.world);
    return step_in_double(moved.body, dt, nullptr, state);
  }
  step(*kernel.model, state.load, dt, kernel.state, last ? &kernel.measure : nullptr);
  add_way(moved.index, kernel.skin_gain * unpack_near(tissue, kernel, state), moved.world);
  move_near_skin(tissue, kernel.near, state);
  return dt * sum_over_pushes(state.load.pushes(), tissue, state.tissue.velocity);
}

/// [m] How far a particle has gone since the last check at most.
double find_largest_move(const SoftState& state) noexcept {
  double largest = 0.0;
  for (std::size_t i = 0; i < state.tissue.position.size(); ++i) {
    const Vec3 move = state.tissue.position[i] - state.guard.last_position[i];
    largest = std::max(largest, move.squaredNorm());
  }
  return std::sqrt(largest);
}

/// Of a tick that was stepped in double: from one tick to the next the packed tissue is the truth.
Alarm end_in_double(PackedKernel& kernel, const Moved& moved, double work) noexcept {
  const TissueModel& tissue = moved.body.tissue;
  SoftState& state = moved.state;
  state.stretch = measure_whole(moved);
  kernel.measure.largest_move = find_largest_move(state);
  kernel.lag.moved += kWiden * kernel.skin_gain * kernel.measure.largest_move;
  const Alarm alarm =
      internals(state).stiff.unsolved
          ? report_unsolved(moved)
          : check(tissue, state.load.gravity, state.tissue, work, state.guard, state.substeps);
  take_over(*kernel.model, tissue, state.tissue, kernel.state);
  kernel.lag.behind = true;
  catch_up(moved.body, state);
  return alarm;
}

Alarm end(PackedKernel& kernel, const Moved& moved, double work) noexcept {
  SoftState& state = moved.state;
  if (is_stepped_in_double(state)) return end_in_double(kernel, moved, work);
  state.tissue.time = kernel.state.time;
  kernel.lag.behind = true;
  kernel.lag.moved += kWiden * kernel.skin_gain * kernel.measure.largest_move;
  if (internals(state).tear.has_torn()) {  // which has the length it likes
    catch_up(moved.body, state);
    kernel.measure.stretch = measure_whole(moved);
  }
  state.stretch = kernel.measure.stretch;
  if (!lags(moved.world, state) || needs_check(kernel.measure, state.guard, state.substeps)) {
    catch_up(moved.body, state);
  }
  return check(*kernel.model, moved.body.tissue, state.tissue, kernel.measure, work, kernel.state,
               state.guard, state.substeps);
}

void begin(ResponseKernel& kernel, const Moved& moved) noexcept { list_near(moved, kernel.near); }

double step_kernel(ResponseKernel& kernel, const Moved& moved, double dt, bool) noexcept {
  move_linear(moved.scene, moved.index, dt, kernel, moved.world);
  move_near_skin(moved.body.tissue, kernel.near, moved.state);
  return 0.0;  // nothing swings, so that there is no energy to account for
}

Alarm end(ResponseKernel& kernel, const Moved& moved, double) noexcept {
  return end_linear(moved.scene, moved.index, kernel, moved.world);
}

}  // namespace

void begin_moving(const Scene& scene, std::size_t body, World& world) noexcept {
  const Moved moved(scene, body, world);
  std::visit([&](auto& kernel) { begin(kernel, moved); }, internals(moved.state).kernel);
}

double move_tissue(const Scene& scene, std::size_t body, double dt, bool last,
                   World& world) noexcept {
  const Moved moved(scene, body, world);
  moved.state.load.forces = cancel_torn(moved, last);
  const double work = std::visit([&](auto& kernel) { return step_kernel(kernel, moved, dt, last); },
                                 internals(moved.state).kernel);
  moved.state.load.forces = {};
  return work;
}

Alarm end_moving(const Scene& scene, std::size_t body, double work, World& world) noexcept {
  const Moved moved(scene, body, world);
  return std::visit([&](auto& kernel) { return end(kernel, moved, work); },
                    internals(moved.state).kernel);
}

void tear_links(const Scene& scene, std::size_t body, double dt, World& world) noexcept {
  SoftState& state = world.bodies[body];
  Tear& tear = internals(state).tear;
  if (!tear.may_tear()) return;
  tear.grow(scene.bodies[body].tissue, state.tissue.position, dt, state.guard);
  state.torn_count = tear.torn_count();
}

void settle_moving(SoftState& state) noexcept {
  PackedKernel* kernel = find_packed(state);
  if (!kernel || !kernel->active.on) return;
  follow_motion(*kernel->model, kernel->active, kernel->state, state.tissue);
}

}  // namespace palpate
