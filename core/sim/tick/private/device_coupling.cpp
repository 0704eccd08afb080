// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/device_coupling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// [m/s] The tool moves no faster than that because its spring becomes another: the force on the
/// hand then changes by no more than passive_stiffness times it.
constexpr double kFastestChange = 0.02;

/// [s] In which a spring that carries next to nothing becomes another.
constexpr double kChangeTime = 0.05;

/// [m] Of the tool's way, over which what is older is forgotten. By way and not by time: a hand
/// that rests teaches nothing, and takes nothing back.
constexpr double kMemory = 1e-3;

/// [m] A way that is shorter shows less of a tissue than what is known of it.
constexpr double kLeastWay = 2e-5;

/// Of passive_stiffness, below which 9 times a tissue's must fall for the spring not to follow it
/// any more.
constexpr double kReturn = 0.8;

/// [J] That may be given to the hand by springs that become stiffer under load; a part of what the
/// passivity controller lets pass (SafetyLimits::energy_max).
constexpr double kMostEnergy = 2.5e-4;

/// Of what the device's damping takes up beyond the contact's need, that may be given as well.
constexpr double kGivenShare = 0.5;

/// The spring towards `wanted` [N/m] while it carries f [N]: its compliance c, times which that is
/// the tool's way from the hand, changes by so much at most. What the hand will get back grows by
/// -f² dc/2, which must be there.
void approach(double wanted, double f, double dt, DeviceCoupling& device) noexcept {
  const double c = 1.0 / device.stiffness, most = kFastestChange * dt / std::max(f, 1e-12);
  const double growth = std::exp(dt / kChangeTime);
  const double share =
      std::clamp(std::clamp(1.0 / wanted, c - most, c + most) / c, 1.0 / growth, growth);
  const double dc = std::max((share - 1.0) * c, -2.0 * device.energy / (f * f));
  device.stiffness = 1.0 / (c + dc);
  device.energy = std::clamp(device.energy + 0.5 * f * f * dc, 0.0, kMostEnergy);
}

/// The damping b = K (T/2 + d) that a device declared takes up (b - k' (T/2 + d)) v² of a spring
/// k'.
void take_up(double travel, double felt, double dt, DeviceCoupling& device) noexcept {
  const double spare = std::max(0.0, device.passive_stiffness - felt) * device.delay;
  device.energy = std::min(kMostEnergy, device.energy + kGivenShare * spare * travel * travel / dt);
}

/// What is not in touch is told to be soft at once: no force is felt that could jump.
void begin_touch(const Instrument& instrument, InstrumentState& state) noexcept {
  DeviceCoupling& device = state.device;
  const double passive = device.passive_stiffness;
  device = {.passive_stiffness = passive,
            .delay = device.delay,
            .stiffness = fit_coupling(instrument.coupling.stiffness, passive, 0.0),
            .energy = device.energy,
            .tool = state.tool.position};
}

/// [-] Volumes and lengths, in parts of those at rest, at which a hand pushes no harder: three
/// times what would end the run.
constexpr double kBorne = 0.15;

/// [-] The same of strain, in parts of what would.
constexpr double kBorneStrain = 0.75;

/// Ticks by which a volume that shrinks is foretold.
constexpr double kAhead = 2.0;

/// [1/s] How fast the limit falls at most, and how fast it comes back: under a hand that has eased,
/// and under one that still pushes with all it may. That one would come to the same again and
/// again: in a narrow crease what jaws held went up and down by 0.5 N, six times a second.
constexpr double kFall = 100.0, kRise = 10.0, kRisePushed = 0.1;

/// [1/s] How fast it falls where a volume shrinks so that it would be at the alarm's limit within
/// as many ticks, or is below that: what is drawn through a rim gives way in no more, and the run
/// ends after ten ticks.
constexpr double kFallAtEnd = 300.0, kEnd = 5.0;

/// [-] Of the limit: a hand that feels less has eased.
constexpr double kHasEased = 0.95;

/// [-] Of the hand's own limit: a hand pushes with so much in any case.
constexpr double kLeast = 0.02;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// [-] What is left of the reserve before the run would end: 1 where the hand is to push no harder,
/// 0 or less at the alarm's own limits or not far from them, more than 1 where it may.
double measure_reserve(const SoftBody& body, const SoftState& state) noexcept {
  const Stretch& stretch = state.stretch;
  const double volume = foresee_volume(kAhead, state);
  const double strain = (stretch.longest - 1.0) / find_strain_limit(body.tissue);
  return std::min(
      {volume / kBorne, stretch.shortest / kBorne, (1.0 - strain) / (1.0 - kBorneStrain)});
}

/// [-] Of the thickness of a barrier: what is so deep in another body has no reserve left.
constexpr double kDeepest = 0.2;

/// [-] Likewise of the barriers between a body and others, less than 1 where something is in it.
double measure_reserve_of_gaps(const Scene& scene, std::size_t body, const World& world) noexcept {
  double reserve = kNone;
  for (std::size_t p = 0; p < world.body_pairs.size(); ++p) {
    const BodyPair& pair = scene.body_pairs[p];
    const BodyPairState& state = world.body_pairs[p];
    const auto index = static_cast<int>(body);
    if ((pair.first != index && pair.second != index) || state.touching == 0) continue;
    reserve = std::min(reserve, 1.0 + state.least_gap / (kDeepest * pair.thickness));
  }
  return reserve;
}

/// Whether a volume that has no reserve left is about to collapse, or has and stays so.
bool collapses(const SoftState& state) noexcept {
  return state.stretch.smallest_volume < kBorne && foresee_volume(kEnd, state) < kSmallestVolume;
}

/// Whether an instrument pushed a body, or a rigid one that touches it, as the last tick ended.
bool pushes(const Scene& scene, std::size_t instrument, std::size_t body, World& world) noexcept {
  if (!world.pair(instrument, body).load.pushes().empty()) return true;
  TickBuffers& work = workspace(world);
  for (std::size_t r = 0; r < world.rigid.size(); ++r) {
    const std::size_t hard = scene.scenery.size() + r;
    if (work.hard_pairs[instrument * work.hard.size() + hard].load.pushes().empty()) continue;
    if (work.rigid.on_tissue[r * world.bodies.size() + body].near &&
        !world.rigid[r].tissue_force.isZero(0.0)) {
      return true;
    }
  }
  return false;
}

}  // namespace

void choose_coupling(const Instrument& instrument, double travel, double dt,
                     InstrumentState& state) noexcept {
  if (!limits_coupling(instrument, state)) return;
  DeviceCoupling& device = state.device;
  const double force = state.last_force.norm();
  const double tissue = device.tissue, spring = device.stiffness;
  take_up(travel, tissue > 0.0 ? spring * tissue / (spring + tissue) : 0.0, dt, device);
  if (!(device.stiffness > 0.0) || force == 0.0) return begin_touch(instrument, state);
  follow_tissue_stiffness(device);
  approach(fit_coupling(instrument.coupling.stiffness, device.passive_stiffness, device.tissue),
           force, dt, device);
}

void follow_tissue_stiffness(DeviceCoupling& device) noexcept {
  const double least = device.passive_stiffness * (device.follows_tissue ? kReturn : 1.0);
  device.follows_tissue = kCouplingShare * device.tissue > least;
}

/// With s the way of the tool against its force f and a = 1 - exp(-|dp| / L) of the way |dp| that
/// it has gone in any direction, the slope of f over s by least squares whose weights fall by 1/e
/// with each L, and for a way that shows nothing the slope that there was:
///
///     K' = (cov(s, f) + e² K) / (var(s) + e²)
///
/// means and moments as exponentially weighted ones [West79].
void learn_tissue(const Instrument& instrument, InstrumentState& state) noexcept {
  if (!limits_coupling(instrument, state)) return;
  DeviceCoupling& device = state.device;
  const Vec3 moved = state.tool.position - device.tool;
  device.tool = state.tool.position;
  const double force = state.last_force.norm();
  if (!(force > 0.0)) return;
  device.way -= moved.dot(state.last_force) / force;
  const double gain = 1.0 - std::exp(-moved.norm() / kMemory);
  const double way = device.way - device.mean_way, rise = force - device.mean_force;
  device.mean_way += gain * way;
  device.mean_force += gain * rise;
  device.way_square = (1.0 - gain) * (device.way_square + gain * way * way);
  device.way_force = (1.0 - gain) * (device.way_force + gain * way * rise);
  const double least = kLeastWay * kLeastWay;
  device.tissue =
      std::max(0.0, (device.way_force + least * device.tissue) / (device.way_square + least));
}

void limit_hand(const Scene& scene, std::size_t instrument, double dt, World& world) noexcept {
  HandMotion& motion = workspace(world).hands[instrument];
  const double force = world.instruments[instrument].last_force.norm();
  if (!(force > 0.0)) {
    motion.bearable = kNone;
    return;
  }
  double reserve = kNone;
  bool ends = false;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (find_response(world.bodies[b]) || !pushes(scene, instrument, b, world)) continue;
    reserve = std::min({reserve, measure_reserve(scene.bodies[b], world.bodies[b]),
                        measure_reserve_of_gaps(scene, b, world)});
    ends = ends || collapses(world.bodies[b]);
  }
  const double most = scene.instruments[instrument].coupling.force_max;
  if (motion.bearable == kNone) {
    if (!(reserve < 1.0)) return;
    motion.bearable = force;
  }
  const double rise = force < kHasEased * motion.bearable ? kRise : kRisePushed;
  const double rate = ends ? -kFallAtEnd : std::clamp(kFall * (reserve - 1.0), -kFall, rise);
  motion.bearable = std::max(motion.bearable * (1.0 + rate * dt), kLeast * most);
  if (!(motion.bearable < most)) motion.bearable = kNone;
}

Coupling find_limited_coupling(const Scene& scene, std::size_t instrument, World& world) noexcept {
  Coupling coupling = find_coupling(scene.instruments[instrument], world.instruments[instrument]);
  coupling.force_max = std::min(coupling.force_max, workspace(world).hands[instrument].bearable);
  return coupling;
}

}  // namespace palpate
