// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/multirate/private/exchange.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/multirate/private/measure_local_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/device_coupling.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {
namespace {

/// [m/s] No hand is faster, as in a tick of the tissue: what is, is a device that jumps.
constexpr double kFastestHand = 3.0;

std::vector<Candidates> make_scratch(const Scene& scene, const World& world) {
  std::vector<Candidates> scratch;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const TissueModel& tissue = scene.bodies[b].tissue;
    const int count = std::min(kMostTriangles, static_cast<int>(tissue.triangles.size()));
    scratch.emplace_back(count);
    if (const PackedKernel* packed = find_packed(world.bodies[b])) {
      scratch.back().lanes = ContactLanes(count, simd_target(*packed->model));
    }
    if (scene.bodies[b].near_field) scratch.back().near = {count, surface_count(tissue)};
    scratch.back().border = world.pair(0, b).candidates.border;
  }
  return scratch;
}

Vec3Array& surface_of(SoftState& body) noexcept {
  return body.skin.empty() ? body.tissue.position : body.skin;
}

}  // namespace

Exchange::Exchange(const World& world)
    : hands(world.instruments.size()),
      models(world.instruments.size()),
      held(world.instruments.size(), 0),
      substeps(world.bodies.size(), 0),
      safeguards(world.bodies.size(), Safeguard::none),
      averted(world.bodies.size()) {
  for (const SoftState& body : world.bodies) {
    const std::span<const Vec3> surface = surface_position(body);
    surfaces.emplace_back(surface.begin(), surface.end());
  }
}

SlowSide::SlowSide(const Scene& scene, int ticks)
    : scene_(scene),
      world_(scene),
      ticks_(ticks),
      told_(scene.instruments.size()),
      commands_(scene.instruments.size()),
      scales_(scene.instruments.size()),
      scratch_(make_scratch(scene, world_)) {
  world_.follows_all = false;
}

void SlowSide::follow(Exchange& exchange) {
  const std::int64_t begun = read_clock();
  if (!std::exchange(has_hands_, true)) told_ = exchange.hands;
  move(exchange.hands);
  tell(exchange);
  exchange.cost = 1e-9 * static_cast<double>(read_clock() - begun);
}

void SlowSide::move(std::span<const HapticSample> hands) noexcept {
  for (int t = 0; t < ticks_; ++t) {
    for (std::size_t i = 0; i < hands.size(); ++i) {
      const Vec3 from = told_[i].position;
      told_[i] = hands[i];
      told_[i].position = from + (hands[i].position - from) / (ticks_ - t);
    }
    tick(scene_, told_, 1.0 / scene_.rate, world_, commands_);
  }
}

void SlowSide::tell(Exchange& exchange) {
  catch_up(scene_, world_);
  for (SoftState& body : world_.bodies) body.tree.refit(surface_position(body));
  for (std::size_t i = 0; i < told_.size(); ++i) {
    LocalModel& model = exchange.models[i];
    model = world_.alarm ? LocalModel{.force = commands_[i].force, .held = true}
                         : measure_local_model(scene_, i, world_.instruments[i].hand,
                                               commands_[i].force, world_, scratch_);
    if (!world_.alarm) {
      scales_[i].follow(world_.instruments[i].hand, scene_.instruments[i].coupling.stiffness,
                        model);
    }
    model.time = exchange.time;
    exchange.held[i] = world_.instruments[i].tool.hold_count;
  }
  for (std::size_t b = 0; b < world_.bodies.size(); ++b) {
    std::ranges::copy(surface_position(world_.bodies[b]), exchange.surfaces[b].begin());
    exchange.substeps[b] = world_.bodies[b].substeps;
    exchange.safeguards[b] = world_.bodies[b].safeguard;
    exchange.averted[b] = world_.bodies[b].averted;
  }
  exchange.alarm = world_.alarm;
  exchange.alarm_body = world_.alarm_body;
  if (exchange.wants_hash) exchange.hash = compute_hash(world_);
}

FastSide::FastSide(const Scene& scene, LocalForceMode mode, double step, int ticks)
    : step_(step), ticks_(ticks), hands_(scene.instruments.size()) {
  for (const Instrument& instrument : scene.instruments) {
    forces_.emplace_back(instrument.coupling, mode, ticks * step);
  }
}

void FastSide::follow(std::span<const HapticSample> samples) noexcept {
  for (std::size_t i = 0; i < hands_.size(); ++i) {
    const Vec3 before = hands_[i].position, travel = samples[i].position - before;
    const double most = kFastestHand * step_;
    hands_[i] = samples[i];
    if (tick_ == 0 || !(travel.norm() > most)) continue;
    hands_[i].position = before + travel * (most / travel.norm());
  }
}

void FastSide::take(const Exchange& exchange) noexcept {
  for (std::size_t i = 0; i < forces_.size(); ++i) forces_[i].take(exchange.models[i], now());
}

void FastSide::tell(Exchange& exchange) noexcept {
  std::ranges::copy(hands_, exchange.hands.begin());
  exchange.time = now();
  told_at_ = tick_;
}

void FastSide::render(std::span<HapticCommand> commands) noexcept {
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    commands[i] = {.force = forces_[i].render(hands_[i].position, now())};
  }
  ++tick_;
}

void show_tick(const FastSide& fast, const Scene& scene, std::span<const HapticCommand> commands,
               World& world) noexcept {
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    InstrumentState& state = world.instruments[i];
    state.hand = fast.hands()[i].position;
    state.last_force = commands[i].force;
    state.tool.placed = true;
    const LocalForce& force = fast.forces()[i];
    // where the hand's spring gives this force
    state.tool.position = state.hand + state.last_force / force.stiffness();
    state.tool.touching = !state.last_force.isZero(0.0);
    if (!limits_coupling(scene.instruments[i], state)) continue;
    state.device.stiffness = force.stiffness();
    state.device.tissue = state.tool.touching ? force.tissue() : 0.0;
    follow_tissue_stiffness(state.device);
  }
  ++world.tick_count;
}

void show_exchange(Exchange& exchange, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    std::swap(exchange.surfaces[b], surface_of(world.bodies[b]));
    world.bodies[b].substeps = exchange.substeps[b];
    world.bodies[b].safeguard = exchange.safeguards[b];
    world.bodies[b].averted = exchange.averted[b];
  }
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    world.instruments[i].tool.hold_count = exchange.held[i];
  }
  if (world.alarm || !exchange.alarm) return;
  world.alarm = exchange.alarm;
  world.alarm_body = exchange.alarm_body;
}

int count_exchange_ticks(const Scene& scene) noexcept {
  return scene.exchange_rate > 0.0 ? static_cast<int>(std::lround(scene.rate / scene.exchange_rate))
                                   : 0;
}

}  // namespace palpate
