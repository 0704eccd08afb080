// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/follow_button.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/tick/private/linear_tick.h"

namespace palpate {
namespace {

/// [s] in which a hold that is let go fades: longer is no better [contact: release].
constexpr double kReleaseTime = 0.03;

/// Radii of the tip that a hand which pulls as hard as it can slides on before it is out of its
/// grip.
constexpr double kSlipInRadii = 1.0;

/// A grip lets go at this part of the strain of a link that would end the run
/// (dynamics/private/alarms.h), and where a length or volume is down to these parts of it at rest:
/// the run would end at 0.05.
constexpr double kStrainHeld = 0.75, kShortestHeld = 0.1, kSmallestHeld = 0.1;

/// And at this part of how far a linear solid may be moved.
constexpr double kDeepestHeld = 0.9;

/// The tissue could not be pulled much farther without an alarm.
bool is_near_alarm(const Scene& scene, const World& world) noexcept {
  if (const ResponseKernel* kernel = find_response(world)) {
    return measure_deepest_share(scene, *kernel, world) > kDeepestHeld;
  }
  const double longest = 1.0 + kStrainHeld * find_strain_limit(scene.tissue);
  return world.stretch.longest > longest || world.stretch.shortest < kShortestHeld ||
         world.stretch.smallest_volume < kSmallestHeld;
}

bool is_out_of_grip(const Scene& scene, const World& world) noexcept {
  return measure_slip(scene.coupling, world.hand, world.tool) > kSlipInRadii * scene.tool.radius;
}

void begin_release(double dt, World& world) noexcept {
  world.release_ticks = std::max(1, static_cast<int>(std::lround(kReleaseTime / dt)));
  world.release_load = measure_held_load(world.tool, world.load);
}

/// The part of its stiffness that a hold keeps so as to carry F [N] in the next tick. Its length is
/// then what it is and by how much the hand's spring K shortens as it comes down to F:
///
///     k' = F / (sum |f| / k + (|h - p| - F/K))
double find_part(const Scene& scene, const World& world, double force) noexcept {
  double stiffness = 0.0;
  for (int h = 0; h < world.tool.hold_count; ++h) {
    stiffness += world.tool.holds[static_cast<std::size_t>(h)].stiffness;
  }
  const double reach = (world.hand - world.tool.position).norm();
  const double carried = measure_held_load(world.tool, world.load) +
                         stiffness * std::max(0.0, reach - force / scene.coupling.stiffness);
  return carried > force ? force / carried : 1.0;
}

/// Let go at once the holds would kick hand and tissue: what they carry falls linearly
/// [contact: release]. If it were their stiffness, nearly all of the load would be left to the last
/// ticks, for where the tissue is softer than the holds it stretches them as they soften.
void fade_holds(const Scene& scene, double dt, World& world) noexcept {
  const double left = (world.release_ticks - 1) / std::max(1.0, std::round(kReleaseTime / dt));
  const double part = find_part(scene, world, left * world.release_load);
  for (int h = 0; h < world.tool.hold_count; ++h) {
    world.tool.holds[static_cast<std::size_t>(h)].stiffness *= part;
  }
  if (--world.release_ticks == 0) release_tool(world.tool);
}

}  // namespace

/// A button pressed while holds fade counts once they are gone; one that has been down since they
/// took hold must come up first.
void follow_button(const Scene& scene, std::uint8_t buttons, double dt, World& world) noexcept {
  const bool pressed = (buttons & kAttachButton) != 0;
  const bool holds = world.tool.hold_count > 0 && world.release_ticks == 0;
  if (holds && (!pressed || is_out_of_grip(scene, world) || is_near_alarm(scene, world))) {
    begin_release(dt, world);
  }
  if (world.release_ticks > 0) {
    fade_holds(scene, dt, world);
    world.attach_pressed = world.attach_pressed && pressed;
    return;
  }
  if (pressed && !world.attach_pressed) {
    attach_tool(world.load, scene.tissue.triangles, surface_position(world), scene.hold_stiffness,
                world.tool);
  }
  world.attach_pressed = pressed;
}

}  // namespace palpate
