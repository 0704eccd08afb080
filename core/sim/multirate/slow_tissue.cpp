// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/multirate/slow_tissue.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/multirate/private/local_force.h"
#include "palpate/sim/multirate/private/measure_local_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {
namespace {

/// [-] By which an interval may miss a whole number of ticks: rounding.
constexpr double kRounding = 1e-6;

/// [m/s] No hand is faster, as in a tick of the tissue: what is, is a device that jumps.
constexpr double kFastestHand = 3.0;

double check_rate(double rate) {
  if (rate > 0.0 && std::isfinite(rate)) return rate;
  refuse("slow tissue: hand_rate", write_text(rate, " Hz"), "a positive number");
}

int check_ticks(int ticks) {
  if (ticks > 0) return ticks;
  refuse("slow tissue: ticks", write_text(ticks), "at least 1");
}

int count_tissue_ticks(double interval, double rate) {
  const double count = interval * rate;
  const double whole = std::round(count);
  if (whole >= 1.0 && std::abs(count - whole) <= kRounding * whole) return static_cast<int>(whole);
  refuse("slow tissue: interval",
         write_text(count, " ticks of the tissue, which has ", rate, " a second"),
         "a whole number of them");
}

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
  }
  return scratch;
}

}  // namespace

struct SlowTissue::Run {
  Run(const Scene& its, double hand_rate, int its_ticks, LocalForceMode mode)
      : scene(its),
        world(its),
        hand_step(1.0 / check_rate(hand_rate)),
        ticks(check_ticks(its_ticks)),
        tissue_ticks(count_tissue_ticks(ticks * hand_step, its.rate)),
        scratch(make_scratch(its, world)),
        hands(its.instruments.size()),
        told(its.instruments.size()),
        next(its.instruments.size()),
        commands(its.instruments.size()) {
    world.follows_all = false;
    for (const Instrument& instrument : its.instruments) {
      forces.emplace_back(instrument.coupling, mode, ticks * hand_step);
    }
  }

  double now() const noexcept { return static_cast<double>(tick) * hand_step; }  // [s]
  void follow_hands(std::span<const HapticSample> samples) noexcept;
  void move_tissue() noexcept;
  void exchange();

  const Scene& scene;
  World world;
  double hand_step;                     // [s]
  int ticks;                            // of the hands in an interval
  int tissue_ticks;                     // in an interval
  long tick = 0;                        // of the hands
  std::vector<Candidates> scratch;      // per body
  std::vector<LocalForce> forces;       // per instrument
  std::vector<HapticSample> hands;      // per instrument, followed at up to 3 m/s
  std::vector<HapticSample> told;       // per instrument, last
  std::vector<LocalModel> next;         // per instrument: told at the next exchange
  std::vector<HapticCommand> commands;  // per instrument, of the tissue's last tick
};

void SlowTissue::Run::follow_hands(std::span<const HapticSample> samples) noexcept {
  for (std::size_t i = 0; i < hands.size(); ++i) {
    const Vec3 before = hands[i].position, travel = samples[i].position - before;
    const double most = kFastestHand * hand_step;
    hands[i] = samples[i];
    if (tick == 0 || !(travel.norm() > most)) continue;
    hands[i].position = before + travel * (most / travel.norm());
  }
}

/// The tissue goes an interval on, from the hands told before to those of now.
void SlowTissue::Run::move_tissue() noexcept {
  for (int t = 0; t < tissue_ticks; ++t) {
    for (std::size_t i = 0; i < hands.size(); ++i) {
      const Vec3 from = told[i].position;
      told[i] = hands[i];
      told[i].position = from + (hands[i].position - from) / (tissue_ticks - t);
    }
    palpate::tick(scene, told, 1.0 / scene.rate, world, commands);
  }
}

void SlowTissue::Run::exchange() {
  move_tissue();
  catch_up(scene, world);
  for (SoftState& body : world.bodies) body.tree.refit(surface_position(body));
  for (std::size_t i = 0; i < hands.size(); ++i) {
    if (world.alarm) {
      next[i] = {.force = commands[i].force, .held = true};
    } else {
      next[i] = measure_local_model(scene, i, world.instruments[i].hand, commands[i].force, world,
                                    scratch);
    }
    next[i].time = now();
  }
}

SlowTissue::SlowTissue(const Scene& scene, double hand_rate, int ticks, LocalForceMode mode)
    : run_(std::make_unique<Run>(scene, hand_rate, ticks, mode)) {}
SlowTissue::SlowTissue(SlowTissue&&) noexcept = default;
SlowTissue::~SlowTissue() = default;

std::vector<HapticCommand> SlowTissue::tick(std::span<const HapticSample> samples) {
  Run& run = *run_;
  const std::size_t count = run.forces.size();
  if (samples.size() != count) {
    refuse("slow tissue: samples", write_text(samples.size()),
           write_text(count, ", one for each instrument"));
  }
  run.follow_hands(samples);
  if (run.tick == 0) run.told = run.hands;
  if (run.tick % run.ticks == 0) {
    for (std::size_t i = 0; i < count && run.tick > 0; ++i) {
      run.forces[i].take(run.next[i], run.now());
    }
    run.exchange();
  }
  std::vector<HapticCommand> commands(count);
  for (std::size_t i = 0; i < count; ++i) {
    commands[i].force = run.forces[i].render(run.hands[i].position, run.now());
  }
  ++run.tick;
  return commands;
}

HapticCommand SlowTissue::tick(const HapticSample& sample) { return tick({&sample, 1}).front(); }

const LocalModel& SlowTissue::model(std::size_t instrument) const {
  return run_->forces.at(instrument).model();
}
const Alarm& SlowTissue::alarm() const noexcept { return run_->world.alarm; }
double SlowTissue::interval() const noexcept { return run_->ticks * run_->hand_step; }
int SlowTissue::tissue_ticks() const noexcept { return run_->tissue_ticks; }

}  // namespace palpate
