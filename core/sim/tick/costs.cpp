// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/costs.h"

#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {
namespace {

void add_seconds(double seconds, DurationHistogram& durations) noexcept {
  durations.add(std::llround(1e9 * seconds));
}

}  // namespace

Percentiles percentiles_of(const DurationHistogram& durations) noexcept {
  return {1e-9 * durations.percentile(0.5), 1e-9 * durations.percentile(0.99),
          1e-9 * durations.percentile(0.999), 1e-9 * static_cast<double>(durations.largest())};
}

CostHistograms::CostHistograms(const World& world)
    : bodies_(world.bodies.size()),
      instruments_(world.instruments.size()),
      pairs_(world.pairs.size()),
      body_pairs_(world.body_pairs.size()),
      scenery_(world.scenery_contacts.size()),
      rigid_(world.rigid.empty() ? 0 : 1),
      parts_(std::make_unique<DurationHistogram[]>(1 + bodies_ + instruments_ + pairs_ +
                                                   body_pairs_ + scenery_ + rigid_)) {}

void CostHistograms::add(const TickCosts& costs) noexcept {
  DurationHistogram* part = parts_.get();
  add_seconds(costs.tick, *part++);
  for (const BodyCost& cost : costs.bodies) add_seconds(cost.total(), *part++);
  for (const InstrumentCost& cost : costs.instruments) add_seconds(cost.total(), *part++);
  for (const PairCost& cost : costs.pairs) add_seconds(cost.total(), *part++);
  for (const PairCost& cost : costs.body_pairs) add_seconds(cost.total(), *part++);
  for (const PairCost& cost : costs.scenery) add_seconds(cost.total(), *part++);
  if (rigid_ > 0) add_seconds(costs.rigid.total(), *part++);
}

SceneCosts CostHistograms::summarise() const {
  const DurationHistogram* part = parts_.get();
  SceneCosts costs;
  costs.ticks = static_cast<long>(part->count());
  costs.tick = percentiles_of(*part++);
  const auto take = [&part](std::size_t count, std::vector<Percentiles>& to) {
    for (std::size_t i = 0; i < count; ++i) to.push_back(percentiles_of(*part++));
  };
  take(bodies_, costs.bodies);
  take(instruments_, costs.instruments);
  take(pairs_, costs.pairs);
  take(body_pairs_, costs.body_pairs);
  take(scenery_, costs.scenery);
  if (rigid_ > 0) costs.rigid = percentiles_of(*part++);
  return costs;
}

SceneCosts measure_costs(const Scene& scene, std::span<const HapticSample> samples) {
  World world(scene);
  const std::size_t instruments = world.instruments.size();
  if (samples.empty() || samples.size() % instruments != 0) {
    refuse("measure costs: samples", write_text(samples.size()),
           write_text("one of each instrument for every tick, a multiple of ", instruments));
  }
  world.measures_costs = true;
  world.follows_all = false;  // as in the live loop
  world.recovers = false;     // the scene is judged as it is
  CostHistograms histograms(world);
  std::vector<HapticCommand> commands(instruments);
  for (std::size_t i = 0; i < samples.size() && !world.alarm; i += instruments) {
    tick(scene, samples.subspan(i, instruments), 1.0 / scene.rate, world, commands);
    if (!world.alarm) histograms.add(world.costs);
  }
  SceneCosts costs = histograms.summarise();
  costs.alarm = world.alarm;
  return costs;
}

}  // namespace palpate
