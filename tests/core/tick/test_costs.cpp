// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/model/refusal.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/tick/costs.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kDt = 1e-3;

/// Two organs side by side and two tools above the first.
Scene make_pair() {
  Scene scene = press_scene();
  SoftBody aside = scene.bodies[0];
  for (Vec3& x : aside.tissue.rest_position) x += Vec3(0.1, 0.0, 0.0);
  scene.bodies.push_back(aside);
  scene.instruments.resize(2);
  return build_scene(std::move(scene));
}

std::vector<HapticSample> read_both(ScriptedDevice& hand, int i) {
  HapticSample sample = hand.read(kDt * i), away = sample;
  away.position.z() += 0.05;
  return {sample, away};
}

double sum_up(const TickCosts& costs) {
  double sum = 0.0;
  for (const BodyCost& cost : costs.bodies) sum += cost.total();
  for (const InstrumentCost& cost : costs.instruments) sum += cost.total();
  for (const PairCost& cost : costs.pairs) sum += cost.total();
  return sum;
}

}  // namespace

TEST_CASE("costs are of every body, instrument and pair, and nothing is measured unless asked") {
  const Scene scene = make_pair();
  World quiet(scene), measured(scene);
  measured.measures_costs = true;
  ScriptedDevice hand = press_script(0.006, 0.2);
  std::vector<HapticCommand> first(2), second(2);
  for (int i = 0; i < 100; ++i) {
    const std::vector<HapticSample> samples = read_both(hand, i);
    tick(scene, samples, kDt, quiet, first);
    tick(scene, samples, kDt, measured, second);
    REQUIRE(first[0].force == second[0].force);
    REQUIRE(first[1].force == second[1].force);

    const TickCosts& costs = measured.costs;
    REQUIRE(costs.bodies.size() == 2);
    REQUIRE(costs.instruments.size() == 2);
    REQUIRE(costs.pairs.size() == 4);
    // laps of one clock within another: no time is counted twice
    CHECK(sum_up(costs) <= costs.tick * (1.0 + 1e-9));
    CHECK(costs.bodies[0].step > 0.0);
    CHECK(costs.pairs[0].candidates > 0.0);
    CHECK((costs.pairs[0].contact > 0.0) == (measured.pairs[0].candidates.count > 0));
    CHECK((costs.instruments[0].balance > 0.0) == (measured.pairs[0].candidates.count == 0));
    CHECK(costs.pairs[3].contact == 0.0);
  }
  CHECK(measured.pairs[0].candidates.count > 0);
  CHECK(compute_hash(quiet) == compute_hash(measured));
  CHECK(quiet.costs.tick == 0.0);
  CHECK(sum_up(quiet.costs) == 0.0);
}

TEST_CASE("a run of a scene has the median and the percentiles of every part") {
  const Scene scene = make_pair();
  ScriptedDevice hand = press_script(0.006, 0.2);
  std::vector<HapticSample> samples;
  for (int i = 0; i < 200; ++i) {
    for (const HapticSample& sample : read_both(hand, i)) samples.push_back(sample);
  }

  const SceneCosts costs = measure_costs(scene, samples);

  CHECK(costs.ticks == 200);
  CHECK_FALSE(costs.alarm);
  REQUIRE(costs.bodies.size() == 2);
  REQUIRE(costs.instruments.size() == 2);
  REQUIRE(costs.pairs.size() == 4);
  for (const Percentiles& part : costs.bodies) {
    CHECK(part.median > 0.0);
    CHECK(part.p99 >= part.median);
    CHECK(part.max >= part.p99);
    CHECK(part.max <= costs.tick.max);
  }
}

TEST_CASE("a run that ends with an alarm says so, and samples must be whole ticks") {
  Scene scene = press_scene();
  scene.bodies[0].kernel = Kernel::reference;
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
  scene.bodies[0].tissue.springs.stiffness.assign(scene.bodies[0].tissue.springs.stiffness.size(),
                                                  1e5);
  Scene wild = build_scene(std::move(scene));
  wild.bodies[0].substeps = wild.bodies[0].substeps_max = 1;
  ScriptedDevice hand = press_script(0.006, 0.2);
  std::vector<HapticSample> samples;
  for (int i = 0; i < 200; ++i) samples.push_back(hand.read(kDt * i));

  const SceneCosts costs = measure_costs(wild, samples);

  CHECK(costs.alarm);
  CHECK(costs.ticks > 0);
  CHECK(costs.ticks < 200);
  const Scene two = make_pair();
  CHECK(find_refusal([&] { measure_costs(two, std::span(samples).first(3)); }) ==
        "measure costs: samples: got 3, expected one of each instrument for every tick, a multiple "
        "of 2");
}
