// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/model/refusal.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/multirate/slow_tissue.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/held_block.h"

using namespace palpate;
using doctest::Approx;
using testing::press_scene;

namespace {

constexpr int kPressed = 500, kSlipped = 1000, kTicks = 1400;  // where each part ends
constexpr double kPi = std::numbers::pi;

/// A press of 6 mm in 0.4 s, a slip of 4 mm, and a release at 20 mm/s, with a tremor of 0.5 mm at
/// 8 Hz; above a place of the surface by the radius of a tip at 1 mm depth less.
HapticSample move_hand(int t, const Vec3& place) {
  const double time = 1e-3 * t;
  const double depth = time < 1.0 ? 0.006 * std::min(1.0, time / 0.4) : 0.006 - 0.02 * (time - 1.0);
  const double part = std::clamp((time - 0.5) / 0.5, 0.0, 1.0);
  const double aside = 0.002 * (1.0 - std::cos(kPi * part));
  const double tremor = 0.0005 * std::sin(2.0 * kPi * 8.0 * time);
  HapticSample sample;
  sample.time = time;
  sample.position = place + Vec3(aside, 0.0, 0.004 - depth + tremor);
  return sample;
}

/// A block of 5 kPa, 100 x 100 x 50 mm.
Scene block_scene(double rate = 1000.0) {
  const scenes::Held held = scenes::make_held_block(3);
  Scene scene;
  scene.rate = rate;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].tissue = build_solid(held.solid, held.material, held.options);
  scene.bodies[0].tissue.drag = 30.0;
  return build_scene(std::move(scene));
}

const Vec3 kOnBlock(0.003, 0.002, 0.025);

std::vector<Vec3> feel_in_full(const Scene& scene, const Vec3& place) {
  World world(scene);
  std::vector<Vec3> forces;
  for (int t = 0; t < kTicks; ++t) {
    forces.push_back(tick(scene, move_hand(t, place), 1e-3, world).force);
  }
  REQUIRE_FALSE(world.alarm);
  return forces;
}

std::vector<Vec3> feel_slowly(const Scene& scene, const Vec3& place, int ticks,
                              LocalForceMode mode = LocalForceMode::local_stiffness) {
  SlowTissue slow(scene, 1000.0, ticks, mode);
  std::vector<Vec3> forces;
  for (int t = 0; t < kTicks; ++t) forces.push_back(slow.tick(move_hand(t, place)).force);
  REQUIRE_FALSE(slow.alarm());
  return forces;
}

/// [-] Root of the mean of squares of a part of the ticks, over the largest force.
double compare(const std::vector<Vec3>& felt, const std::vector<Vec3>& full, int from, int to) {
  double sum = 0.0, most = 0.0;
  for (int t = from; t < to; ++t) {
    sum += (felt[static_cast<std::size_t>(t)] - full[static_cast<std::size_t>(t)]).squaredNorm();
  }
  for (const Vec3& force : full) most = std::max(most, force.norm());
  return std::sqrt(sum / (to - from)) / most;
}

/// [N] The largest change of force from one tick to the next.
double find_jump(const std::vector<Vec3>& felt) {
  double most = 0.0;
  for (std::size_t t = 1; t < felt.size(); ++t) {
    most = std::max(most, (felt[t] - felt[t - 1]).norm());
  }
  return most;
}

}  // namespace

TEST_CASE(
    "at 100 and 50 Hz press, slip and release are felt as in full, where a held force is not") {
  const Scene scene = block_scene();
  const std::vector<Vec3> full = feel_in_full(scene, kOnBlock);

  for (const int ticks : {10, 20}) {
    CAPTURE(ticks);
    const std::vector<Vec3> local = feel_slowly(scene, kOnBlock, ticks);
    const std::vector<Vec3> hold = feel_slowly(scene, kOnBlock, ticks, LocalForceMode::hold);

    CHECK(compare(local, full, 0, kPressed) < 0.05);
    CHECK(compare(local, full, kPressed, kSlipped) < 0.05);
    CHECK(compare(local, full, kSlipped, kTicks) < 0.05);
    CHECK(find_jump(local) < 2.0 * find_jump(full));
    CHECK(compare(local, full, 0, kTicks) < 0.6 * compare(hold, full, 0, kTicks));
    CHECK(find_jump(hold) > 4.0 * find_jump(local));
  }
}

TEST_CASE("the error grows with the interval, and at every tick is that of one tick" *
          doctest::test_suite("landing")) {
  const Scene scene = block_scene();
  const std::vector<Vec3> full = feel_in_full(scene, kOnBlock);

  double last = 0.0;
  for (const int ticks : {1, 10, 40}) {
    const double error = compare(feel_slowly(scene, kOnBlock, ticks), full, 0, kTicks);
    CHECK(error > last);
    last = error;
  }
  CHECK(compare(feel_slowly(scene, kOnBlock, 1), full, 0, kTicks) < 0.01);
}

TEST_CASE("a run is the same to the bit when it is done again") {
  const Scene scene = press_scene();
  const Vec3 place(0.001, 0.002, 0.020);

  CHECK(feel_slowly(scene, place, 10) == feel_slowly(scene, place, 10));
}

TEST_CASE("away from all tissue nothing is felt, with and after a press") {
  const Scene scene = press_scene();
  SlowTissue slow(scene, 1000.0, 10);
  ScriptedDevice hand = testing::press_script(0.004, 0.5);
  Vec3 most = Vec3::Zero();
  for (int t = 0; t < 1000; ++t) {
    const Vec3 force = slow.tick(hand.read(1e-3 * t)).force;
    if (t < 50 || t > 600) CHECK(force == Vec3::Zero());
    if (force.norm() > most.norm()) most = force;
  }
  CHECK(most.z() > 0.05);
}

TEST_CASE("an attached tool pulls the tissue along") {
  const Scene scene = press_scene();
  SlowTissue slow(scene, 1000.0, 10);
  ScriptedDevice hand = testing::press_script(0.004, 1.0, true);
  double least = 0.0;
  for (int t = 0; t < 900; ++t) {
    least = std::min(least, slow.tick(hand.read(1e-3 * t)).force.z());
  }
  CHECK(slow.model().held);
  CHECK(least < -0.1);
}

TEST_CASE("a tissue may tick more slowly than hands are read") {
  const std::vector<Vec3> full = feel_in_full(block_scene(), kOnBlock);
  const Scene slower = block_scene(250.0);

  SlowTissue slow(slower, 1000.0, 20);
  CHECK(slow.tissue_ticks() == 5);
  CHECK(slow.interval() == Approx(0.02));
  CHECK(compare(feel_slowly(slower, kOnBlock, 20), full, 0, kTicks) < 0.06);
}

TEST_CASE("after an alarm of the tissue the force fades, and no tick jumps") {
  const Scene scene = press_scene();
  SlowTissue slow(scene, 1000.0, 10);
  HapticSample sample;
  sample.position = {0.001, 0.002, 0.026};
  for (int t = 0; t < 20; ++t) slow.tick(sample);
  sample.position.z() = 0.020;
  double before = 0.0;
  for (int t = 0; t < 300; ++t) before = slow.tick(sample).force.z();
  REQUIRE(before > 0.05);

  sample.position.x() = std::nan("");
  double last = before;
  for (int t = 0; t < 60; ++t) {
    const double now = slow.tick(sample).force.z();
    CHECK(std::abs(now - last) < 0.25 * before);
    last = now;
  }

  CHECK(slow.alarm().kind == AlarmKind::invalid_input);
  CHECK(last == 0.0);
}

TEST_CASE("what has no meaning is refused with a sentence") {
  const Scene scene = press_scene();
  const auto refusal = [&](double rate, int ticks) {
    return find_refusal([&] { SlowTissue(scene, rate, ticks); });
  };

  CHECK(refusal(0.0, 10) == "slow tissue: hand_rate: got 0 Hz, expected a positive number");
  CHECK(refusal(1000.0, 0) == "slow tissue: ticks: got 0, expected at least 1");
  CHECK(refusal(3000.0, 1) ==
        "slow tissue: interval: got 0.333333 ticks of the tissue, which has 1000 a second, "
        "expected a whole number of them");
  SlowTissue slow(scene, 1000.0, 10);
  CHECK(find_refusal([&] { slow.tick(std::vector<HapticSample>(2)); }) ==
        "slow tissue: samples: got 2, expected 1, one for each instrument");
}

TEST_CASE("an instrument of capsules and scenery are refused, as with an exchange rate") {
  const auto refusal = [](auto change) {
    Scene scene = press_scene();
    change(scene);
    scene = build_scene(std::move(scene));
    return find_refusal([&] { SlowTissue(scene, 1000.0, 10); });
  };

  CHECK(refusal([](Scene& scene) {
          scene.instruments[0].tool.capsules = {{Vec3::Zero(), Vec3(0.0, 0.0, 0.02)}};
        }) ==
        "slow tissue: instruments[0].tool.capsules: got 1, expected none: between two exchanges a "
        "ball is felt");
  CHECK(refusal([](Scene& scene) {
          Scenery table;
          table.mesh.vertices = {{-1.0, -1.0, -0.1}, {1.0, -1.0, -0.1}, {0.0, 1.0, -0.1}};
          table.mesh.triangles = {{0, 1, 2}};
          scene.scenery.push_back(std::move(table));
        }) ==
        "slow tissue: scenery: got 1, expected none: between two exchanges nothing but tissue is "
        "felt");
}
