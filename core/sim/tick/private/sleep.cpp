// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/sleep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/tick/private/choose_substeps.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/stop_at_scenery.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Ticks between two tries to sleep, each of which copies the state of a body.
constexpr int kPatience = 50;

/// Of a body in vector code beside others: no particle has gone farther in kPatience ticks, nor is
/// faster, than this. Rounding moves untouched organs by 1e-9 m and 1e-6 m/s [motion: sleep].
constexpr float kSettledMove = 1e-7f;   // [m]
constexpr float kSettledSpeed = 1e-5f;  // [m/s]

using Bytes = std::span<const std::byte>;

/// All that a step of a body reads and writes, but for time. At most as many laws keep variables
/// of their own as there is room for here.
std::array<Bytes, 8> list_state(const SoftState& state) noexcept {
  if (const PackedKernel* kernel = find_packed(state)) {
    std::array<Bytes, 8> parts = {std::as_bytes(std::span(kernel->state.displacement)),
                                  std::as_bytes(std::span(kernel->state.velocity))};
    std::size_t next = 2;
    for (const auto& internal : kernel->state.internal) {
      if (!internal.empty()) parts[next++] = std::as_bytes(std::span(internal));
    }
    return parts;
  }
  if (const ResponseKernel* kernel = find_response(state)) {
    return {std::as_bytes(std::span(kernel->state.displacement))};
  }
  return {std::as_bytes(std::span(state.tissue.position)),
          std::as_bytes(std::span(state.tissue.velocity)),
          std::as_bytes(std::span(state.tissue.internal))};
}

void keep_copy(const SoftState& state, std::vector<std::byte>& copy) noexcept {
  std::byte* to = copy.data();
  for (const Bytes part : list_state(state)) to = std::ranges::copy(part, to).out;
}

bool is_copy(const SoftState& state, const std::vector<std::byte>& copy) noexcept {
  const std::byte* from = copy.data();
  for (const Bytes part : list_state(state)) {
    if (!part.empty() && std::memcmp(part.data(), from, part.size()) != 0) return false;
    from += part.size();
  }
  return true;
}

/// Another body may touch it, soft or rigid, a scenery stop it, an instrument may or holds it, or
/// remembers that its tool was on it.
bool is_at_hand(std::size_t body, World& world) noexcept {
  if (is_touched(body, world) || is_stopped(body, world)) return true;
  if (is_rigid_near(body, world)) return true;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    if (is_near(world, i, body)) return true;
    const ToolState::Carrier& carrier = world.instruments[i].tool.carrier;
    if (carrier.triangle >= 0 && carrier.body == static_cast<int>(body)) return true;
  }
  return false;
}

/// What follows the tissue a part at a time has seen all of it since it last moved.
bool is_followed(const World& world, const SoftState& state) noexcept {
  const PackedKernel* kernel = find_packed(state);
  return !kernel || !lags(world, state) || kernel->lag.moved == kernel->lag.at_last_round;
}

/// Cheap, and false wherever something has moved by more than can be squared in float.
bool may_be_at_rest(const SoftState& state) noexcept {
  const PackedKernel* kernel = find_packed(state);
  return !kernel || kernel->measure.largest_move == 0.0;
}

/// Parts of it may sleep alone.
bool has_active_set(const SoftState& state) noexcept {
  const PackedKernel* kernel = find_packed(state);
  return kernel && kernel->active.on;
}

/// Not a particle was in motion in this tick, nor has begun to be.
bool all_sleeps(const SoftState& state) noexcept {
  const PackedKernel& kernel = *find_packed(state);
  return kernel.began_still && kernel.state.slices.count == 0;
}

/// Compares with the copy of kPatience ticks ago. Only vector code needs it: the others come to
/// rest to the bit.
bool has_settled(const SoftState& state, const std::vector<std::byte>& copy) noexcept {
  const PackedKernel* kernel = find_packed(state);
  if (!kernel) return false;
  const auto& displacement = kernel->state.displacement;
  const std::byte* from = copy.data();
  for (const float now : displacement) {
    float before;
    std::memcpy(&before, from, sizeof before);
    from += sizeof before;
    if (!(std::abs(now - before) < kSettledMove)) return false;
  }
  return std::ranges::all_of(kernel->state.velocity,
                             [](float v) noexcept { return std::abs(v) < kSettledSpeed; });
}

/// The tick has left every bit as it was, found by a copy that is made once in a while and compared
/// one tick later; or, beside other bodies, the copy of before has hardly been left.
bool rests(const SoftState& state, const World& world, Rest& rest) noexcept {
  if (rest.is_tried && is_copy(state, rest.copy)) return true;
  rest.is_tried = false;
  if (rest.patience > 0) return false;
  const bool beside_others = world.bodies.size() > 1;
  if (beside_others && rest.has_copy && has_settled(state, rest.copy)) return true;
  rest.is_tried = may_be_at_rest(state) && is_followed(world, state);
  if (!rest.is_tried && !beside_others) return false;
  keep_copy(state, rest.copy);
  rest.has_copy = true;
  rest.patience = kPatience;
  return false;
}

}  // namespace

/// A tick of a body reads its state, its load, the length and number of its steps, and nothing
/// else. Two that are alike in these are alike in what they write.
void fall_asleep(const Scene& scene, std::size_t body, double dt, World& world) noexcept {
  SoftState& state = world.bodies[body];
  Rest& rest = internals(state).rest;
  if (rest.patience > 0) --rest.patience;
  const bool calm =
      !is_at_hand(body, world) && state.load.push_count == 0 && state.guard.strained_checks == 0;
  if (!calm) {
    rest.is_tried = rest.has_copy = false;
    rest.patience = kPatience;
    return;
  }
  rest.at_any_step = has_active_set(state);
  if (rest.at_any_step ? !all_sleeps(state) : !rests(state, world, rest)) return;
  rest.step = dt / state.substeps;
  rest.substeps = state.substeps;
  rest.gravity = state.load.gravity;
  catch_up(scene.bodies[body], state);
  rest.has_copy = false;
  state.asleep = true;
}

void wake_body(std::size_t body, double dt, World& world) noexcept {
  SoftState& state = world.bodies[body];
  if (!state.asleep) return;
  const Rest& rest = internals(state).rest;
  const bool alike =
      rest.at_any_step || (state.substeps == rest.substeps && dt / state.substeps == rest.step &&
                           state.load.gravity == rest.gravity);
  state.asleep = alike && !is_at_hand(body, world);
}

void wake_bodies(double dt, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) wake_body(b, dt, world);
}

/// Time is the sum of the steps, to the bit that they would have summed to. The guard forgets what
/// it was given as time goes on (check_energy), and a linear solid has no energy to guard.
Alarm end_asleep(const Scene& scene, std::size_t body, double dt, World& world) noexcept {
  SoftState& state = world.bodies[body];
  double& time = state.tissue.time;
  for (int s = 0; s < state.substeps; ++s) time += dt / state.substeps;
  if (PackedKernel* kernel = find_packed(state)) kernel->state.time = time;
  if (find_response(state)) return {};
  const double elapsed = std::max(0.0, time - state.guard.last_time);
  Alarm alarm =
      check_energy(scene.bodies[body].tissue, state.guard.last_energy, 0.0, elapsed, state.guard);
  state.guard.last_time = time;
  if (alarm) alarm.time = time;
  return alarm;
}

}  // namespace palpate
