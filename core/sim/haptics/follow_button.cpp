// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/follow_button.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/hold.h"
#include "palpate/sim/haptics/device.h"
#include "palpate/sim/haptics/linear_tick.h"

namespace palpate {
namespace {

/// [s] in which a hold that is let go fades: longer is no better (TOOLS section 2).
constexpr double kReleaseTime = 0.03;

/// Radii of the tip that a hand which pulls as hard as it can slides on before it is out of its
/// grip.
constexpr double kSlipInRadii = 1.0;

/// A grip lets go at these parts of its length or volume at rest, well before an alarm would end
/// the run: at 3 and 0.05 (dynamics/alarms.h).
constexpr double kLongestHeld = 2.5, kShortestHeld = 0.1, kSmallestHeld = 0.1;

/// And at this part of how far a linear solid may be moved.
constexpr double kDeepestHeld = 0.9;

/// The tissue could not be pulled much farther without an alarm.
bool is_near_alarm(const Scene& scene, const World& world) noexcept {
  if (world.response) return measure_deepest_share(scene, world) > kDeepestHeld;
  return world.stretch.longest > kLongestHeld || world.stretch.shortest < kShortestHeld ||
         world.stretch.smallest_volume < kSmallestHeld;
}

bool is_out_of_grip(const Scene& scene, const World& world) noexcept {
  return measure_slip(scene.coupling, world.hand, world.tool) > kSlipInRadii * scene.tool.radius;
}

/// Let go at once the holds would kick hand and tissue: they fade linearly from the load they carry
/// (TOOLS section 2).
void begin_release(double dt, World& world) noexcept {
  world.release_ticks = std::max(1, static_cast<int>(std::lround(kReleaseTime / dt)));
}

void fade_holds(World& world) noexcept {
  const double part = double(world.release_ticks - 1) / world.release_ticks;
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
    fade_holds(world);
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
