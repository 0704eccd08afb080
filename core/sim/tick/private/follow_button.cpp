// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/follow_button.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/tick/private/device_coupling.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Radii of the tip that a hand which pulls as hard as it can slides on before it is out of its
/// grip.
constexpr double kSlipInRadii = 1.0;

/// A grip lets go at this part of the strain of a link that would end the run
/// (dynamics/private/alarms.h), and where a length or volume is down to these parts of it at rest:
/// the run would end at 0.05.
constexpr double kStrainHeld = 0.75, kShortestHeld = 0.1, kSmallestHeld = 0.1;

/// [s] In which it then lets go, a fifth of the load a tick: a hand that jerks at 1 m/s turns an
/// element inside out in less than a release takes.
constexpr double kAlarmReleaseTime = 0.005;

/// And at this part of how far a linear solid may be moved.
constexpr double kDeepestHeld = 0.9;

/// An instrument that holds, and the surfaces it may touch.
struct Holding {
  const Instrument& instrument;
  InstrumentState& state;
  std::span<const TouchedSurface> surfaces;

  std::span<ToolState::Hold> holds() const noexcept {
    return {state.tool.holds.data(), static_cast<std::size_t>(state.tool.hold_count)};
  }
};

int count_ticks(double time, double dt) noexcept {
  return std::max(1, static_cast<int>(std::lround(time / dt)));
}

/// Whether a volume, as fast as it shrinks, would be near an alarm before a grip has let go of half
/// its load: at 3 m/s one of a kidney loses a tenth of what it is at rest in every tick.
bool nears_alarm(double dt, const SoftState& state) noexcept {
  return foresee_volume(0.5 * kAlarmReleaseTime / dt, state) < kSmallestHeld;
}

/// In how many ticks a grip of what is near an alarm is to let go; 0 for one that need not. A
/// linear solid is never turned inside out: it has been moved too far to be right, and there is
/// time.
int count_alarm_ticks(const Scene& scene, double dt, const World& world,
                      const Holding& grip) noexcept {
  int checked = -1, ticks = 0;
  for (const ToolState::Hold& hold : grip.holds()) {
    if (hold.body == checked) continue;  // those of a body follow one another
    checked = hold.body;
    const auto b = static_cast<std::size_t>(hold.body);
    if (!is_near_alarm(scene.bodies[b], world.bodies[b]) && !nears_alarm(dt, world.bodies[b])) {
      continue;
    }
    const int needed =
        count_ticks(find_response(world.bodies[b]) ? kReleaseTime : kAlarmReleaseTime, dt);
    ticks = ticks > 0 ? std::min(ticks, needed) : needed;
  }
  return ticks;
}

bool is_out_of_grip(const Holding& grip) noexcept {
  return measure_slip(find_coupling(grip.instrument, grip.state), grip.state.hand,
                      grip.state.tool) > kSlipInRadii * grip.instrument.tool.radius;
}

/// A fall over fewer ticks is the end of one from a larger load.
void begin_release(int ticks, double dt, const Holding& grip) noexcept {
  grip.state.release_ticks = ticks;
  const double load = measure_held_load(grip.state.tool, grip.surfaces);
  grip.state.release_load = load * (static_cast<double>(count_ticks(kReleaseTime, dt)) / ticks);
}

/// The part of its stiffness that a hold keeps so as to carry F [N] in the next tick. Its length is
/// then what it is and by how much the hand's spring K shortens as it comes down to F:
///
///     k' = F / (sum |f| / k + (|h - p| - F/K))
double find_part(const Holding& grip, double force) noexcept {
  double stiffness = 0.0;
  for (const ToolState::Hold& hold : grip.holds()) stiffness += hold.stiffness;
  const double reach = (grip.state.hand - grip.state.tool.position).norm();
  const double spring = find_coupling(grip.instrument, grip.state).stiffness;
  const double carried = measure_held_load(grip.state.tool, grip.surfaces) +
                         stiffness * std::max(0.0, reach - force / spring);
  return carried > force ? force / carried : 1.0;
}

/// Let go at once the holds would kick hand and tissue: what they carry falls linearly
/// [contact: release]. If it were their stiffness, nearly all of the load would be left to the last
/// ticks, for where the tissue is softer than the holds it stretches them as they soften.
void fade_holds(double dt, const Holding& grip) noexcept {
  const double left = (grip.state.release_ticks - 1) / std::max(1.0, std::round(kReleaseTime / dt));
  const double part = find_part(grip, left * grip.state.release_load);
  for (ToolState::Hold& hold : grip.holds()) {
    hold.stiffness *= part;
    hold.sideways *= part;
  }
  for (const TouchedSurface& surface : grip.surfaces) surface.candidates->near.grip.force *= part;
  if (--grip.state.release_ticks == 0) release_tool(grip.state.tool);
}

}  // namespace

bool is_near_alarm(const SoftBody& body, const SoftState& state) noexcept {
  if (const ResponseKernel* kernel = find_response(state)) {
    return measure_deepest_share(body, *kernel, state) > kDeepestHeld;
  }
  const double longest = 1.0 + kStrainHeld * find_strain_limit(body.tissue);
  return state.stretch.longest > longest || state.stretch.shortest < kShortestHeld ||
         state.stretch.smallest_volume < kSmallestHeld;
}

/// A button pressed while holds fade counts once they are gone; one that has been down since they
/// took hold must come up first.
void follow_button(const Scene& scene, std::size_t instrument, std::uint8_t buttons, double dt,
                   World& world) noexcept {
  InstrumentState& state = world.instruments[instrument];
  // nothing is fastened to what is hard
  const Holding grip{scene.instruments[instrument], state,
                     list_surfaces(scene, instrument, world).first(world.bodies.size())};
  const bool pressed = (buttons & kAttachButton) != 0;
  const bool holds = state.tool.hold_count > 0 && state.release_ticks == 0;
  const bool fades = state.release_ticks > 0;
  const int urgent = holds || fades ? count_alarm_ticks(scene, dt, world, grip) : 0;
  if (urgent > 0 && (holds || urgent < state.release_ticks)) {
    begin_release(urgent, dt, grip);
  } else if (holds && (!pressed || is_out_of_grip(grip))) {
    begin_release(count_ticks(kReleaseTime, dt), dt, grip);
  }
  if (state.release_ticks > 0) {
    fade_holds(dt, grip);
    state.attach_pressed = state.attach_pressed && pressed;
    return;
  }
  if (pressed && !state.attach_pressed) {
    attach_tool(grip.surfaces, grip.instrument.hold_stiffness, state.tool);
  }
  state.attach_pressed = pressed;
}

namespace {

/// [rad/s] Jaws that a button closes turn by 1 rad in 100 ms.
constexpr double kFastestJaw = 10.0;

/// [s] Before that, in which what was pinched harder than its load asks for comes back.
constexpr double kEaseTime = 0.02;

/// [N] Jaws that carry no more let go at once: no hand feels it.
constexpr double kNoLoad = 1e-3;

/// [-] Of what is felt when jaws begin to let go: what it may change by from tick to tick until
/// that has settled, whatever the tissue does that slips and springs out of them.
constexpr double kMostChange = 1.0 / 15.0;

/// [N] By which it may change in any case while jaws open in a dent: less in a tick no hand feels.
constexpr double kOpeningChange = 0.01;

/// [-] Of what is felt of closed jaws: by how much it may fall from tick to tick beside what the
/// hand's own way changes, whatever slips out of them, and [N] by how much in any case.
constexpr double kMostFall = 0.15, kLeastFall = 0.1;

/// Of the closing force: what is left of it after a tick in which the tissue could bear no more,
/// and at which jaws open instead.
constexpr double kYield = 0.9, kLeastGrip = 0.02;

/// The same where a volume shrinks so fast that the run would end before a grip has let go: what
/// jaws close on may be gone in ten ticks.
constexpr double kYieldFast = 0.7;

/// Of the way that jaws open: a hand that is so wide has opened.
constexpr double kOpen = 0.9;

/// Of the closing force: that with which jaws that were closed open in tissue. With all of it they
/// would wedge themselves in the dent that they have pressed, and friction would hold them there.
constexpr double kOpening = 0.05;

/// [rad] How far the hand would have each jaw open.
double find_goal(const Jaws& jaws, const HapticSample& sample) noexcept {
  if ((sample.buttons & kAttachButton) != 0) return 0.0;
  return std::clamp(jaws.open - sample.grip, 0.0, jaws.open);
}

/// The part of their closing force that jaws keep in this tick; 1 where all they hold can bear it.
double find_kept_grip(const Scene& scene, double dt, const World& world,
                      const ToolState& tool) noexcept {
  int checked = -1;
  double kept = 1.0;
  for (int k = 0; k < tool.anchor_count; ++k) {
    const int body = tool.anchors[static_cast<std::size_t>(k)].body;
    if (body == checked) continue;
    checked = body;
    const auto b = static_cast<std::size_t>(body);
    if (b >= world.bodies.size()) continue;  // what is hard bears all
    const SoftState& state = world.bodies[b];
    const bool moves = !find_response(state);
    if (is_near_alarm(scene.bodies[b], state) || (moves && nears_alarm(dt, state))) {
      kept = std::min(kept, kYield);
    }
    if (moves && foresee_volume(kAlarmReleaseTime / dt, state) < kSmallestVolume) {
      kept = std::min(kept, kYieldFast);
    }
  }
  return kept;
}

void turn_toward(double goal, double dt, ToolState& tool) noexcept {
  const double most = kFastestJaw * dt;
  tool.jaw_wanted += std::clamp(goal - tool.jaw_wanted, -most, most);
}

/// [N] By which each jaw holds, the mean of both: what presses where tissue sticks.
double measure_grip(const ToolState& tool) noexcept {
  double sum = 0.0;
  for (int k = 0; k < tool.anchor_count; ++k) {
    sum += tool.anchors[static_cast<std::size_t>(k)].pressed;
  }
  return 0.5 * sum;
}

/// [-] Of what sticks to the jaws, the mean of its pairs' coefficients by what presses there.
double find_held_friction(const Instrument& instrument, const ToolState& tool) noexcept {
  double pressed = 0.0, rubbed = 0.0;
  for (int k = 0; k < tool.anchor_count; ++k) {
    const ToolState::Anchor& anchor = tool.anchors[static_cast<std::size_t>(k)];
    pressed += anchor.pressed;
    rubbed +=
        find_friction_part(instrument, static_cast<std::size_t>(anchor.body)) * anchor.pressed;
  }
  return instrument.tool.friction * (pressed > 0.0 ? rubbed / pressed : 1.0);
}

/// Jaws that let go of what is near an alarm have no more time than a hold has: what was left of
/// their force goes in as many ticks, and what is felt may change by as much of it.
void hurry(double dt, int slips, InstrumentState& state) noexcept {
  ToolState& held = state.tool;
  const int urgent = count_ticks(kAlarmReleaseTime, dt);
  if (state.release_ticks <= urgent) return;
  state.release_ticks = urgent;
  state.release_load = held.grip_limit * slips / urgent;
  held.felt_change = std::max(held.felt_change, state.last_force.norm() / urgent);
}

/// The force comes down to what just carries the load F, 2 mu N = F, and from there with less in
/// every tick: what slips then is no more than a tick's part of it.
void let_go(const Instrument& instrument, double dt, bool urgent, InstrumentState& state) noexcept {
  ToolState& held = state.tool;
  const int slips = count_ticks(kReleaseTime, dt);
  if (state.release_ticks == 0) {
    const double least = held.held_load / (2.0 * find_held_friction(instrument, held));
    const double part = std::min(1.0, least / std::max(measure_grip(held), kNoLoad));
    state.release_ticks = slips + static_cast<int>(std::round((1.0 - part) * kEaseTime / dt));
    state.release_load = held.grip_limit * part;
    held.felt_before = state.last_force;
    held.felt_change = kMostChange * std::max(state.last_force.norm(), kNoLoad);
  }
  if (urgent) hurry(dt, slips, state);
  const int eases = state.release_ticks - slips;
  --state.release_ticks;
  held.grip_limit = eases > 0 ? held.grip_limit + (state.release_load - held.grip_limit) / eases
                              : state.release_load * state.release_ticks / slips;
  if (state.release_ticks > 0) return;
  release_tool(held);
  state.attach_pressed = false;
  held.jaw_wanted = std::max(held.jaw_wanted, held.jaw_angle);
  held.grip_limit = kOpening * instrument.tool.jaws->grip;
}

/// Jaws that open in a dent push at what is beside them: by that a hand is to be moved as evenly,
/// until they are out of it, or open as far as the hand would and in balance.
void follow_change(double goal, InstrumentState& state) noexcept {
  ToolState& tool = state.tool;
  const bool lets_go = state.release_ticks > 0;
  if (!lets_go) tool.felt_change = std::max(tool.felt_change, kOpeningChange);
  const bool pushes = tool.touching && goal > tool.jaw_angle + kGripRise;
  if (!lets_go && !pushes && tool.residual.norm() < kNoLoad) tool.felt_change = 0.0;
  tool.felt_before = state.last_force;
}

/// [N] What tissue that slips out of closed jaws leaves to the hand goes within some ticks, for an
/// instrument has a mass that it must move: without one it would be at the hand at once. Where the
/// hand is limited, the tool follows what that asks for.
void limit_fall(const Instrument& instrument, InstrumentState& state, HandMotion& motion) noexcept {
  const double moved = find_coupling(instrument, state).stiffness * motion.travel;
  const double felt = state.last_force.norm();
  state.tool.felt_before = state.last_force;
  motion.most_fall =
      moved + std::max(kMostFall * felt, kLeastFall) + std::max(0.0, felt - motion.bearable);
}

/// Jaws that carry next to nothing begin to open at once.
void begin_opening(InstrumentState& state) noexcept {
  if (state.tool.felt_change > 0.0) return;
  state.tool.felt_before = state.last_force;
  state.tool.felt_change = std::max(kMostChange * state.last_force.norm(), kOpeningChange);
}

/// Whether tissue shuts jaws again that were open and in balance: of the force with which they open
/// little is left until they are out of it. It is as uneven as when they began to open.
bool is_shut_again(const Tool& tool, double goal, const InstrumentState& state) noexcept {
  const ToolState& jaws = state.tool;
  return jaws.touching && jaws.felt_change == 0.0 && goal >= jaws.jaw_wanted &&
         jaws.grip_limit <= kOpening * tool.jaws->grip && goal > jaws.jaw_angle + kGripRise;
}

/// From what collapses jaws come away as fast as they can: held back for what a hand feels, whose
/// limit falls faster, they would stand still in it.
void follow_freely(InstrumentState& state) noexcept {
  double& most = state.tool.felt_change;
  if (most > 0.0) most = std::max(most, state.last_force.norm());
}

/// Whether jaws that a hand has opened as far as it would are still on their way there, in a dent.
bool is_opening(double goal, const InstrumentState& state) noexcept {
  return !state.attach_pressed && state.tool.felt_change > 0.0 && goal >= state.tool.jaw_wanted;
}

/// Tissue that could not bear more makes the jaws yield, for good until the hand opens; where even
/// jaws that hardly close strain it, they open.
void yield(const Tool& tool, double kept, InstrumentState& state) noexcept {
  ToolState& jaws = state.tool;
  jaws.grip_limit *= kept;
  if (jaws.grip_limit < kLeastGrip * tool.jaws->grip) state.opens = true;
}

}  // namespace

/// Up to `closed` the motor closes with all its force; beyond, opening lessens it.
void follow_jaws(const Scene& scene, std::size_t instrument, const HapticSample& sample, double dt,
                 World& world) noexcept {
  const Tool& tool = scene.instruments[instrument].tool;
  if (!tool.jaws) return;
  InstrumentState& state = world.instruments[instrument];
  ToolState& jaws = state.tool;
  double goal = find_goal(*tool.jaws, sample);
  HandMotion& motion = workspace(world).hands[instrument];
  motion.most_fall = 0.0;
  if (jaws.felt_change > 0.0) follow_change(goal, state);
  if (is_shut_again(tool, goal, state)) {
    begin_opening(state);
    state.attach_pressed = false;
  }
  if (!jaws.placed) {
    jaws.jaw_angle = jaws.jaw_wanted = goal;
    return;
  }
  if (goal > kOpen * tool.jaws->open) {
    state.opens = false;
    if (state.release_ticks == 0 && !jaws.touching) jaws.grip_limit = tool.jaws->grip;
  }
  const double kept = find_kept_grip(scene, dt, world, jaws);
  if (kept < 1.0) yield(tool, kept, state);
  if (kept <= kYieldFast) follow_freely(state);
  if (state.opens) goal = tool.jaws->open;
  const double closed = std::max(jaws.jaw_wanted, jaws.jaw_angle - kGripRise);
  if (goal > closed) {
    // jaws that have let go open with the tissue that pushes them
    if (state.attach_pressed && jaws.held_load > kNoLoad) {
      return let_go(scene.instruments[instrument], dt, kept < 1.0, state);
    }
    if (state.attach_pressed) {
      jaws.grip_limit = kOpening * tool.jaws->grip;
      begin_opening(state);
    }
    state.attach_pressed = false;
    jaws.jaw_wanted = std::max(jaws.jaw_wanted, std::min(goal, jaws.jaw_angle));
  } else if (!is_opening(goal, state)) {
    const bool closes_again =
        goal < jaws.jaw_wanted && jaws.grip_limit == kOpening * tool.jaws->grip;
    if (state.release_ticks > 0 || closes_again) jaws.grip_limit = tool.jaws->grip;
    state.attach_pressed = true;
    jaws.felt_change = 0.0;
    state.release_ticks = 0;
    if (kept == 1.0) limit_fall(scene.instruments[instrument], state, motion);
  }
  turn_toward(goal, dt, jaws);
}

}  // namespace palpate
