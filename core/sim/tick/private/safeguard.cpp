// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/safeguard.h"

#include <algorithm>

#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/response/private/relax.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/move_tissue.h"
#include "palpate/sim/tick/private/sleep.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// [s] without an alarm before the safeguard below is tried; twice as long after each climb, so
/// that what needs its safeguard for good is not felt trying every second.
constexpr double kShortestCalm = 1.0;
constexpr double kLongestCalm = 16.0;

// --- going back ----------------------------------------------------------------------------------

/// What a guard knows, into a checkpoint or out of one.
template <class From, class To>
void copy_guard(const From& from, To& to) noexcept {
  to.last_time = from.last_time;
  to.last_energy = from.last_energy;
  to.work = from.work;
  to.given_energy = from.given_energy;
  to.reference_energy = from.reference_energy;
  to.rising_steps = from.rising_steps;
  to.strained_checks = from.strained_checks;
}

void keep(const ReferenceKernel&, const SoftState& state, BodyCheckpoint& kept) noexcept {
  std::ranges::copy(state.tissue.position, kept.position.begin());
  std::ranges::copy(state.tissue.velocity, kept.velocity.begin());
  std::ranges::copy(state.tissue.internal, kept.internal.begin());
}

void keep(const PackedKernel& kernel, const SoftState&, BodyCheckpoint& kept) noexcept {
  keep_checkpoint(*kernel.model, kernel.state, kept.packed);
  kept.lag = kernel.lag;
}

void keep(const ResponseKernel& kernel, const SoftState&, BodyCheckpoint& kept) noexcept {
  std::ranges::copy(kernel.state.displacement, kept.displacement.begin());
}

BodyCheckpoint& find_latest(BodyInternals& work) noexcept {
  return work.checkpoints[static_cast<std::size_t>(work.latest)];
}
BodyCheckpoint& find_earlier(BodyInternals& work) noexcept {
  return work.checkpoints[static_cast<std::size_t>(1 - work.latest)];
}

void keep(long tick, SoftState& state) noexcept {
  BodyInternals& work = internals(state);
  work.calm.climbed = work.calm.went_back = false;
  // of one that sleeps a tick changes time and guard alone
  if (!state.asleep) work.latest = 1 - work.latest;
  BodyCheckpoint& kept = find_latest(work);
  kept.time = state.tissue.time;
  copy_guard(state.guard, kept);
  if (state.asleep) return;
  kept.tick = tick;
  std::visit([&](const auto& kernel) { keep(kernel, state, kept); }, work.kernel);
}

void rewind(ReferenceKernel& kernel, const SoftBody& body, const BodyCheckpoint& kept,
            SoftState& state) noexcept {
  kernel.unsolved = false;
  std::ranges::copy(kept.position, state.tissue.position.begin());
  std::ranges::copy(kept.velocity, state.tissue.velocity.begin());
  std::ranges::copy(kept.internal, state.tissue.internal.begin());
  move_skin(body.tissue.skin, state.tissue.position, state.skin);
}

void rewind(PackedKernel& kernel, const SoftBody& body, const BodyCheckpoint& kept,
            SoftState& state) noexcept {
  rewind(*kernel.model, kept.packed, kernel.state);
  kernel.lag = kept.lag;
  kernel.lag.behind = true;
  catch_up(body, state);
}

void rewind(ResponseKernel& kernel, const SoftBody& body, const BodyCheckpoint& kept,
            SoftState& state) noexcept {
  // a tick has settled: no force is on its way
  std::ranges::copy(kept.displacement, kernel.state.displacement.begin());
  place_near(*kernel.response, body.tissue, kernel.state, kernel.response->particle,
             state.tissue.position);
  move_skin(body.tissue.skin, state.tissue.position, state.skin);
}

/// Where all was at `kept`, but for time and what the guard remembers.
void rewind_tissue(const BodyCheckpoint& kept, const SoftBody& body, SoftState& state) noexcept {
  std::visit([&](auto& kernel) { rewind(kernel, body, kept, state); }, internals(state).kernel);
  // a check that found nothing has taken note of where all was after the tick
  std::ranges::copy(state.tissue.position, state.guard.last_position.begin());
}

void set_time(double time, SoftState& state) noexcept {
  state.tissue.time = time;
  if (PackedKernel* packed = find_packed(state)) packed->state.time = time;
}

void rewind(const SoftBody& body, SoftState& state) noexcept {
  const BodyCheckpoint& kept = find_latest(internals(state));
  copy_guard(kept, state.guard);
  if (!state.asleep) rewind_tissue(kept, body, state);
  set_time(kept.time, state);
}

/// Whether there is a checkpoint of the tick before: not where parts of the body may have slept.
bool can_go_back(SoftState& state) noexcept {
  BodyInternals& work = internals(state);
  const PackedKernel* packed = find_packed(state);
  return find_earlier(work).tick > 0 && find_earlier(work).tick == find_latest(work).tick - 1 &&
         !(packed && packed->active.on);
}

/// To where the tick before began, at the time that it is.
void go_back(const SoftBody& body, SoftState& state) noexcept {
  BodyInternals& work = internals(state);
  const BodyCheckpoint &kept = find_latest(work), &earlier = find_earlier(work);
  rewind_tissue(earlier, body, state);
  set_time(kept.time, state);
  if (PackedKernel* packed = find_packed(state)) {
    // the boxes of its tree are as far behind as the tick before has moved it, and once more
    packed->lag = kept.lag;
    packed->lag.moved += std::max(0.0, kept.lag.moved - earlier.lag.moved);
    packed->lag.behind = false;
  }
}

/// Where a tool is and what it holds, into a checkpoint or out of one.
template <class From, class To>
void copy_tool(const From& from, To& to) noexcept {
  to.position = from.position;
  to.carrier = from.carrier;
  to.touching = from.touching;
  to.residual = from.residual;
  std::copy_n(from.patch.begin(), from.patch_count, to.patch.begin());
  to.patch_count = from.patch_count;
  to.patch_position = from.patch_position;
  to.patch_normal = from.patch_normal;
  to.friction = from.friction;
  to.jaw_angle = from.jaw_angle;
  std::copy_n(from.anchors.begin(), from.anchor_count, to.anchors.begin());
  to.anchor_count = from.anchor_count;
}

// --- the ladder ----------------------------------------------------------------------------------

/// Whether steps may be the reason. What a hand strains too far is so with any.
bool is_of_steps(AlarmKind kind) noexcept {
  return kind == AlarmKind::not_finite || kind == AlarmKind::moved_far ||
         kind == AlarmKind::energy || kind == AlarmKind::not_solved;
}

/// In double the whole of a body moves, and variables of laws lie otherwise than in vector code. A
/// response does not swing.
bool can_step_in_double(const SoftBody& body, const SoftState& state) noexcept {
  if (is_implicit(body.integrator) || find_response(state)) return false;
  const PackedKernel* packed = find_packed(state);
  return !packed || (!packed->active.on && count_internal(body.tissue) == 0);
}

/// Whether a safeguard is more than the one below it.
bool is_available(const SoftBody& body, const SoftState& state, Safeguard safeguard) noexcept {
  const int wanted = internals(state).wanted_substeps;
  switch (safeguard) {
    case Safeguard::none:
      return true;
    case Safeguard::half_steps:
      return refine(body, safeguard, wanted) > wanted;
    case Safeguard::quarter_steps:
      return refine(body, safeguard, wanted) > refine(body, Safeguard::half_steps, wanted);
    case Safeguard::implicit_damping:
      return can_step_in_double(body, state) &&
             body.integrator != Integrator::symplectic_euler_implicit_damping;
    case Safeguard::implicit_euler:
      // a law with a memory advances with all of a step
      return can_step_in_double(body, state) && count_internal(body.tissue) == 0;
  }
  return false;
}

constexpr int kHighest = static_cast<int>(Safeguard::implicit_euler);

/// The nearest that there is for a body, up (+1) or down (-1); the present one where there is none.
Safeguard find_next(const SoftBody& body, const SoftState& state, int direction) noexcept {
  for (int n = static_cast<int>(state.safeguard) + direction; n >= 0 && n <= kHighest;
       n += direction) {
    if (is_available(body, state, static_cast<Safeguard>(n))) return static_cast<Safeguard>(n);
  }
  return state.safeguard;
}

/// What there is of energy is taken for given: under the next safeguard it may not grow further.
void accept_energy(Guard& guard) noexcept {
  guard.given_energy = std::max(guard.given_energy, guard.last_energy);
  guard.reference_energy = std::max(guard.reference_energy, guard.given_energy);
  guard.rising_steps = 0;
}

}  // namespace

void keep_checkpoint(World& world) noexcept {
  TickBuffers& work = workspace(world);
  keep_rigid(world);
  keep_pair_friction(world);
  for (SoftState& state : world.bodies) keep(world.tick_count, state);
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    const ToolState& tool = world.instruments[i].tool;
    copy_tool(tool, work.instruments[i]);
  }
  for (std::size_t p = 0; p < world.pairs.size(); ++p) {
    work.near[p] = world.pairs[p].candidates.near;
    work.second_near[p] = work.second[p].near;
  }
}

void rewind(const Scene& scene, World& world) noexcept {
  TickBuffers& work = workspace(world);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) rewind(scene.bodies[b], world.bodies[b]);
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    copy_tool(work.instruments[i], world.instruments[i].tool);
  }
  for (std::size_t p = 0; p < world.pairs.size(); ++p) {
    static_cast<NearMemory&>(world.pairs[p].candidates.near) = work.near[p];
    static_cast<NearMemory&>(work.second[p].near) = work.second_near[p];
  }
  rewind_rigid(scene, world);
  rewind_pair_friction(world);
}

void calm_down(const Scene& scene, double dt, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SoftState& state = world.bodies[b];
    Calm& calm = internals(state).calm;
    calm.since += dt;
    if (state.safeguard == Safeguard::none) {
      if (calm.since >= kLongestCalm) calm.needed = 0.0;
    } else if (calm.since >= calm.needed) {
      state.safeguard = find_next(scene.bodies[b], state, -1);
      calm.since = 0.0;
    }
  }
}

bool climb(const Scene& scene, World& world) noexcept {
  if (!world.recovers || world.alarm_body < 0 || !is_of_steps(world.alarm.kind)) return false;
  const auto b = static_cast<std::size_t>(world.alarm_body);
  SoftState& state = world.bodies[b];
  Calm& calm = internals(state).calm;
  // energy is that of a step back: what the last step has added to it shows in the next tick alone
  const bool goes_back = calm.climbed && !calm.went_back && can_go_back(state);
  const Safeguard next = find_next(scene.bodies[b], state, +1);
  if (!goes_back && next == state.safeguard) return false;
  rewind(scene, world);
  if (!goes_back) {
    state.safeguard = next;
    state.averted = world.alarm;
    if (!calm.climbed) calm.needed = std::clamp(2.0 * calm.needed, kShortestCalm, kLongestCalm);
    calm.climbed = true;
    calm.since = 0.0;
  }
  calm.went_back = calm.went_back || goes_back;
  if (calm.went_back) go_back(scene.bodies[b], state);
  accept_energy(state.guard);
  world.alarm = {};
  world.alarm_body = -1;
  return true;
}

void wake_again(const Scene& scene, double dt, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (!world.bodies[b].asleep) continue;
    wake_body(b, dt, world);
    if (world.bodies[b].asleep) continue;
    begin_moving(scene, b, world);
    keep(world.tick_count, world.bodies[b]);
  }
}

int refine(const SoftBody& body, Safeguard safeguard, int wanted) noexcept {
  if (safeguard == Safeguard::none) return wanted;
  const int times = safeguard == Safeguard::half_steps ? 2 : 4;
  return std::max(wanted, std::min(times * wanted, body.substeps_max));
}

}  // namespace palpate
