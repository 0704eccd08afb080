// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/model/volumes.h"
#include "palpate/sim/tick/place_tool.h"
#include "palpate/sim/tick/private/check_input.h"
#include "palpate/sim/tick/private/choose_substeps.h"
#include "palpate/sim/tick/private/follow_button.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/move_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// [m/s] No hand is faster: what is, is a device that jumps. It is followed at this speed, for the
/// impact of a jump would tear the tissue.
constexpr double kFastestHand = 3.0;

Vec3 follow_hand(const Vec3& hand, double dt, const World& world) noexcept {
  if (!world.tool.placed) return hand;
  const Vec3 travel = hand - world.hand;
  const double most = kFastestHand * dt;
  return travel.norm() > most ? Vec3(world.hand + travel * (most / travel.norm())) : hand;
}

/// Back to the last tick in which nothing was wrong, and no further [motion: alarm].
void stand_still(const Scene& scene, World& world) noexcept {
  std::copy(world.guard.last_position.begin(), world.guard.last_position.end(),
            world.tissue.position.begin());
  move_skin(scene.tissue.skin, world.tissue.position, world.skin);
  std::fill(world.tissue.velocity.begin(), world.tissue.velocity.end(), Vec3::Zero());
  if (PackedKernel* packed = find_packed(world)) packed->lag.behind = false;
  release_tool(world.tool);
  world.tool.touching = false;
}

/// [s] in which the force of the last tick before an alarm is taken back: dropped at once it would
/// be felt as a knock.
constexpr double kFadeTime = 0.02;

/// The force after an alarm: f_n = f_0 (1 - n / N), N the whole ticks of kFadeTime.
HapticCommand fade_out(const Scene& scene, World& world) noexcept {
  if (world.fade_ticks++ == 0) world.fade_from = world.last_force;
  const double rate = scene.rate > 0.0 && std::isfinite(scene.rate) ? scene.rate : 1000.0;
  const double ticks = std::max(1.0, std::floor(kFadeTime * rate));
  world.last_force = world.fade_from * std::max(0.0, 1.0 - world.fade_ticks / ticks);
  return {.force = world.last_force};
}

}  // namespace

HapticCommand tick(const Scene& scene, const HapticSample& sample, double dt,
                   World& world) noexcept {
  ++world.tick_count;
  if (world.alarm) return fade_out(scene, world);
  world.alarm = check_input(scene, sample, dt, world);
  if (world.alarm) {
    release_tool(world.tool);
    world.tool.touching = false;
    return fade_out(scene, world);
  }

  const std::span<const Vec3> surface = surface_position(world);
  follow_tissue(scene, world);
  const Vec3 hand = follow_hand(sample.position, dt, world);
  const bool was_placed = world.tool.placed;
  const double travel = was_placed ? (hand - world.hand).norm() : 0.0;
  if (place_tool(world.tree, surface, hand, scene.tool.radius, world.tool)) {
    find_touchable(scene, hand, world);
    follow_button(scene, sample.buttons, dt, world);
  }
  world.substeps = choose_substeps(scene, travel, dt, world);
  world.hand = hand;
  // a tool that has just appeared may touch already, and nothing is known of what that stores
  const double most_work =
      was_placed ? bound_stored_energy(scene.tool, scene.coupling, hand, world.tool, world.load)
                 : std::numeric_limits<double>::infinity();
  const double substep = dt / world.substeps;
  begin_moving(scene, world);

  // Which triangles may be touched is settled once per tick. Where and how hard they are touched
  // changes with every substep: held over the tick, it would buzz on the hand and diverge.
  Vec3 felt = Vec3::Zero();
  double work = 0.0;
  for (int s = 0; s < world.substeps; ++s) {
    if (world.tool.placed) {
      felt += balance_tool(scene.tool, scene.coupling, hand, world.candidates,
                           scene.tissue.triangles, surface, world.tool, world.load);
    }
    work += move_tissue(scene, substep, s + 1 == world.substeps, world);
  }
  // a contact that makes energy would count as a hand that gives it
  world.alarm = end_moving(scene, std::min(work, most_work), world);
  if (!world.alarm && !felt.allFinite()) {
    world.alarm = {AlarmKind::not_finite, -1, felt.norm(), 0.0, world.tissue.time};
  }
  if (world.alarm) {
    stand_still(scene, world);
    return fade_out(scene, world);
  }
  world.last_force = felt / world.substeps;
  return {.force = world.last_force};
}

Felt compute_felt(const HapticCommand& command, const World& world) noexcept {
  Felt felt;
  felt.force = command.force.cast<float>();
  felt.position = world.tool.position.cast<float>();
  felt.touched = static_cast<std::uint8_t>((world.tool.touching ? kTouching : 0) |
                                           (world.tool.hold_count > 0 ? kAttached : 0));
  return felt;
}

}  // namespace palpate
