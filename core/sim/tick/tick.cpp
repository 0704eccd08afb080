// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/check_input.h"
#include "palpate/sim/tick/private/choose_substeps.h"
#include "palpate/sim/tick/private/contact_pace.h"
#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/private/device_coupling.h"
#include "palpate/sim/tick/private/follow_button.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/move_tissue.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/sleep.h"
#include "palpate/sim/tick/private/stop_at_scenery.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_hard.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Begins a tick: the trees of the bodies that are awake follow their surfaces.
void follow_bodies(const Scene& scene, World& world) noexcept {
  if (world.measures_costs) {
    std::ranges::fill(world.costs.bodies, BodyCost{});
    std::ranges::fill(world.costs.instruments, InstrumentCost{});
    std::ranges::fill(world.costs.pairs, PairCost{});
    std::ranges::fill(world.costs.body_pairs, PairCost{});
    std::ranges::fill(world.costs.scenery, PairCost{});
    world.costs.rigid = {};
  }
  Stopwatch watch(world.measures_costs);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (!world.bodies[b].asleep) follow_tissue(scene, b, world);
    watch.add_to(world.costs.bodies[b].follow);
  }
}

void begin_bodies(const Scene& scene, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (!world.bodies[b].asleep) begin_moving(scene, b, world);
    watch.add_to(world.costs.bodies[b].step);
  }
}

/// [m/s] No hand is faster: what is, is a device that jumps. It is followed at this speed, for the
/// impact of a jump would tear the tissue.
constexpr double kFastestHand = 3.0;

Vec3 follow_hand(const Vec3& hand, double dt, const InstrumentState& instrument) noexcept {
  if (!instrument.tool.placed) return hand;
  const Vec3 travel = hand - instrument.hand;
  const double most = kFastestHand * dt;
  return travel.norm() > most ? Vec3(instrument.hand + travel * (most / travel.norm())) : hand;
}

/// place_tool() with every tissue of the scene.
bool place_among_bodies(const Vec3& hand, const Tool& tool, World& world,
                        ToolState& state) noexcept {
  if (state.placed) return true;
  state.position = hand;
  state.placed = std::ranges::all_of(world.bodies, [&](const SoftState& body) noexcept {
    return has_room(body.tree, surface_position(body), hand, tool, state.orientation,
                    state.jaw_angle);
  });
  state.placed = state.placed && has_room_at_hard(world, hand, tool, state);
  return state.placed;
}

/// [J] No less than an instrument can give to tissue before its hand moves again.
double bound_energy(const Scene& scene, std::size_t i, const Vec3& hand, World& world) noexcept {
  const Instrument& instrument = scene.instruments[i];
  const ToolState& tool = world.instruments[i].tool;
  const double springs =
      bound_stored_energy(instrument.tool, find_coupling(instrument, world.instruments[i]), hand,
                          tool, list_surfaces(scene, i, world));
  if (!instrument.tool.jaws) return springs;
  return springs + 2.0 * tool.grip_limit * measure_arm(instrument.tool) * kMostTurnInTick;
}

/// Draws a tool to its hand, finds what it may touch on the path there, and follows the button.
void read_hand(const Scene& scene, const HapticSample& sample, double dt, std::size_t i,
               World& world) noexcept {
  const Instrument& instrument = scene.instruments[i];
  InstrumentState& state = world.instruments[i];
  HandMotion& motion = workspace(world).hands[i];
  const bool was_placed = state.tool.placed;
  motion.hand = follow_hand(sample.position, dt, state);
  motion.travel = was_placed ? (motion.hand - state.hand).norm() : 0.0;
  motion.felt.setZero();
  choose_coupling(instrument, motion.travel, dt, state);
  limit_hand(scene, i, dt, world);
  Stopwatch watch(world.measures_costs);
  if (!was_placed) state.tool.position = motion.hand;
  turn_tool(instrument, sample.orientation, dt, motion.bearable, state.tool);
  follow_jaws(scene, i, sample, dt, world);
  if (place_among_bodies(motion.hand, instrument.tool, world, state.tool)) {
    watch.add_to(world.costs.instruments[i].read);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      find_touchable(scene, i, b, motion.hand, world);
      watch.add_to(world.costs.pairs[i * world.bodies.size() + b].candidates);
    }
    find_touchable_hard(scene, i, motion.hand, world);
    if (!instrument.tool.jaws) follow_button(scene, i, sample.buttons, dt, world);
  }
  // a tool that has just appeared may touch already, and nothing is known of what that stores
  motion.stored_energy = was_placed ? bound_energy(scene, i, motion.hand, world)
                                    : std::numeric_limits<double>::infinity();
  state.hand = motion.hand;
  watch.add_to(world.costs.instruments[i].read);
}

/// Shares out the time [s] in which a tool was balanced among what it may touch or holds.
void note_balance(double seconds, std::size_t instrument, World& world) noexcept {
  const std::size_t bodies = world.bodies.size();
  const ToolState& tool = world.instruments[instrument].tool;
  const auto weigh = [&](std::size_t body) noexcept {
    double weight = world.pair(instrument, body).candidates.count;
    weight += second_jaw(world, instrument, body).count;
    for (int h = 0; h < tool.hold_count; ++h) {
      const ToolState::Hold& hold = tool.holds[static_cast<std::size_t>(h)];
      if (hold.body == static_cast<int>(body)) weight += 1.0;
    }
    return weight;
  };
  double all = 0.0;
  for (std::size_t b = 0; b < bodies; ++b) all += weigh(b);
  if (all == 0.0) {
    world.costs.instruments[instrument].balance += seconds;
    return;
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    world.costs.pairs[instrument * bodies + b].contact += seconds * weigh(b) / all;
  }
}

/// Every tool moves to where its hand and the tissues as they stand balance, in a substep of dt
/// [s].
void balance_instruments(const Scene& scene, double dt, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    ToolState& tool = world.instruments[i].tool;
    if (!tool.placed) continue;
    HandMotion& motion = workspace(world).hands[i];
    const Instrument& its = scene.instruments[i];
    const Coupling coupling = find_limited_coupling(scene, i, world);
    motion.felt +=
        its.tool.jaws
            ? balance_jaws(its.tool, coupling, motion.hand, list_jaw_surfaces(scene, i, world), dt,
                           tool, motion.most_fall)
            : balance_tool(its.tool, coupling, motion.hand, list_surfaces(scene, i, world), tool);
    if (watch.on()) note_balance(watch.lap(), i, world);
  }
}

/// What instruments and other bodies do to a body in a step that is as long as a substep.
void take_load(std::size_t body, World& world) noexcept {
  Load& load = world.bodies[body].load;
  load.clear();
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    for (const Push& push : world.pair(i, body).load.pushes()) load.add(push);
  }
  take_touch_pushes(body, world, [&](const Push& push) noexcept { load.add(push); });
  for (const Push& push : list_rigid_pushes(body, world)) load.add(push);
}

/// Substep s of `finest`: the bodies whose turn it is go a step. One that takes longer steps stands
/// still between them, and the force on it is the mean over the substeps.
void move_bodies(const Scene& scene, double dt, int s, int finest, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SoftState& state = world.bodies[b];
    if (state.asleep) {
      take_touch_pushes(b, world, [](const Push&) noexcept {});
      continue;
    }
    const int substeps_per_step = finest / state.substeps;
    if (substeps_per_step == 1) {
      take_load(b, world);
    } else {
      MeanLoad& mean = internals(state).mean_load;
      for (std::size_t i = 0; i < world.instruments.size(); ++i) {
        mean.add(world.pair(i, b).load.pushes());
      }
      take_touch_pushes(b, world, [&](const Push& push) noexcept { mean.add({&push, 1}); });
      mean.add(list_rigid_pushes(b, world));
      if ((s + 1) % substeps_per_step != 0) continue;
      mean.take(substeps_per_step, state.load);
    }
    workspace(world).work[b] += move_tissue(scene, b, dt / state.substeps, s + 1 == finest, world);
    watch.add_to(world.costs.bodies[b].step);
    stop_at_scenery(scene, b, dt / state.substeps, state.substeps, world);
    watch.lap();
  }
}

/// All substeps of a tick. Which triangles may be touched is settled once per tick. Where and how
/// hard they are touched changes with every substep: held over the tick, it would buzz on the hand
/// and diverge.
void run_substeps(const Scene& scene, double dt, int finest, World& world) noexcept {
  std::ranges::fill(workspace(world).work, 0.0);
  for (HandMotion& motion : workspace(world).hands) motion.felt.setZero();
  begin_stopping(world);
  begin_rigid(scene, dt / finest, world);
  for (int s = 0; s < finest; ++s) {
    balance_instruments(scene, dt / finest, world);
    touch_bodies(scene, s, finest, dt / finest, world);
    touch_rigid(scene, dt / finest, world);
    move_bodies(scene, dt, s, finest, world);
    move_rigid(scene, dt / finest, world);
  }
  end_touching(finest, world);
  end_rigid(finest, world);
}

void raise(const Alarm& alarm, int body, World& world) noexcept {
  if (!alarm || world.alarm) return;
  world.alarm = alarm;
  world.alarm_body = body;
}

/// Checks every body, and what is to be felt.
void end_bodies(const Scene& scene, double dt, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  const TickBuffers& work = workspace(world);
  // a contact that makes energy would count as a hand that gives it
  double most_work = 0.0;
  for (const HandMotion& motion : work.hands) most_work += motion.stored_energy;
  most_work += bound_rigid_work(scene, dt, world);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const double most = most_work + bound_touch_work(b, world);
    const Alarm alarm = world.bodies[b].asleep
                            ? end_asleep(scene, b, dt, world)
                            : end_moving(scene, b, std::min(work.work[b], most), world);
    raise(alarm, static_cast<int>(b), world);
    watch.add_to(world.costs.bodies[b].guard);
  }
  for (const HandMotion& motion : work.hands) {
    if (motion.felt.allFinite()) continue;
    raise({AlarmKind::not_finite, -1, motion.felt.norm(), 0.0, world.bodies[0].tissue.time}, -1,
          world);
  }
  for (const RigidState& state : world.rigid) {
    if (state.position.allFinite() && state.angular_velocity.allFinite()) continue;
    raise({AlarmKind::not_finite, -1, state.position.norm(), 0.0, world.bodies[0].tissue.time}, -1,
          world);
  }
}

/// Ends a tick in which nothing was wrong.
void settle_bodies(const Scene& scene, double dt, World& world) noexcept {
  Stopwatch watch(world.measures_costs);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (world.bodies[b].asleep) continue;
    tear_links(scene, b, dt, world);
    settle_moving(world.bodies[b]);
    fall_asleep(scene, b, dt, world);
    watch.add_to(world.costs.bodies[b].guard);
  }
}

/// The substeps of a tick, again and again under the next safeguard as long as there is one for
/// the body that would blow up [motion: ladder]. Returns the substeps of the last try.
int run_safeguarded(const Scene& scene, double dt, int finest, World& world) noexcept {
  keep_checkpoint(world);
  choose_stiff_parts(scene, dt, world);
  run_substeps(scene, dt, finest, world);
  end_bodies(scene, dt, world);
  while (take_back_outrun(scene, dt, world)) {
    finest = fit_substeps(scene, world);
    choose_stiff_parts(scene, dt, world);
    run_substeps(scene, dt, finest, world);
    end_bodies(scene, dt, world);
  }
  const Alarm first = world.alarm;
  const int first_body = world.alarm_body;
  while (world.alarm && climb(scene, world)) {
    finest = fit_substeps(scene, world);
    wake_again(scene, dt, world);
    choose_stiff_parts(scene, dt, world);
    run_substeps(scene, dt, finest, world);
    end_bodies(scene, dt, world);
  }
  if (world.alarm) {
    world.alarm = first;
    world.alarm_body = first_body;
  }
  return finest;
}

void let_go(World& world) noexcept {
  for (InstrumentState& instrument : world.instruments) {
    release_tool(instrument.tool);
    instrument.tool.touching = false;
  }
}

/// Back to the last tick in which nothing was wrong, and no further [motion: alarm].
void stand_still(const Scene& scene, World& world) noexcept {
  rewind(scene, world);
  for (SoftState& state : world.bodies) {
    std::fill(state.tissue.velocity.begin(), state.tissue.velocity.end(), Vec3::Zero());
  }
  for (RigidState& state : world.rigid) {
    state.velocity.setZero();
    state.angular_velocity.setZero();
  }
  let_go(world);
}

/// [s] in which the force of the last tick before an alarm is taken back: dropped at once it would
/// be felt as a knock.
constexpr double kFadeTime = 0.02;

/// The forces after an alarm: f_n = f_0 (1 - n / N), N the whole ticks of kFadeTime.
void fade_out(const Scene& scene, World& world, std::span<HapticCommand> commands) noexcept {
  const bool first = world.fade_ticks++ == 0;
  const double rate = scene.rate > 0.0 && std::isfinite(scene.rate) ? scene.rate : 1000.0;
  const double ticks = std::max(1.0, std::floor(kFadeTime * rate));
  for (InstrumentState& instrument : world.instruments) {
    if (first) instrument.fade_from = instrument.last_force;
    instrument.last_force = instrument.fade_from * std::max(0.0, 1.0 - world.fade_ticks / ticks);
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    commands[i] = {};
    if (i < world.instruments.size()) commands[i].force = world.instruments[i].last_force;
  }
}

}  // namespace

void tick(const Scene& scene, std::span<const HapticSample> samples, double dt, World& world,
          std::span<HapticCommand> commands) noexcept {
  ++world.tick_count;
  if (world.alarm) return fade_out(scene, world, commands);
  raise(check_input(scene, samples, commands.size(), dt, world), -1, world);
  if (world.alarm) {
    let_go(world);
    return fade_out(scene, world, commands);
  }

  Stopwatch whole(world.measures_costs);
  const std::size_t instruments = world.instruments.size();
  calm_down(scene, dt, world);
  meet_bodies(dt, world);
  meet_scenery(world);
  meet_rigid(scene, dt, world);
  follow_bodies(scene, world);
  for (std::size_t i = 0; i < instruments; ++i) read_hand(scene, samples[i], dt, i, world);
  find_body_contacts(scene, dt, world);
  find_scenery_contacts(scene, world);
  find_rigid_contacts(scene, dt, world);
  const int chosen = choose_substeps(scene, dt, world);
  wake_bodies(dt, world);
  begin_bodies(scene, world);
  const int finest = run_safeguarded(scene, dt, chosen, world);
  if (world.alarm) {
    stand_still(scene, world);
    return fade_out(scene, world, commands);
  }
  settle_bodies(scene, dt, world);
  for (std::size_t i = 0; i < instruments; ++i) {
    const HandMotion& motion = workspace(world).hands[i];
    world.instruments[i].last_force = motion.felt / finest;
    learn_tissue(scene.instruments[i], world.instruments[i]);
    commands[i] = {.force = world.instruments[i].last_force};
  }
  world.costs.tick = whole.lap();
}

HapticCommand tick(const Scene& scene, const HapticSample& sample, double dt,
                   World& world) noexcept {
  HapticCommand command;
  tick(scene, {&sample, 1}, dt, world, {&command, 1});
  return command;
}

Felt compute_felt(const HapticCommand& command, const World& world,
                  std::size_t instrument) noexcept {
  const ToolState& tool = world.instruments[instrument].tool;
  Felt felt;
  felt.force = command.force.cast<float>();
  felt.position = tool.position.cast<float>();
  felt.touched = static_cast<std::uint8_t>((tool.touching ? kTouching : 0) |
                                           (tool.has_hold() ? kAttached : 0));
  return felt;
}

}  // namespace palpate
