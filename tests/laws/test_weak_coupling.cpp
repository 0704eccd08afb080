// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/private/device_coupling.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/tissues.h"

// A device that keeps less of a spring passive than an instrument's own coupling has: the hand's
// spring then follows the tissue, as far as the device bears that [stability: weak coupling].

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kTick = 1e-3;   // [s]
constexpr double kOwn = 1000.0;  // [N/m] of the instrument

/// [N/m] Of two springs in a row.
double in_series(double a, double b) { return a * b / (a + b); }

/// An organ on its base, as stiff as `links` [N/m] make it, before a tip that is held by kOwn.
Scene make_scene(double links) {
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  SurfaceOptions options;
  options.drag = 100.0;
  options.home_stiffness = 5e3 * links;
  const SurfaceMesh mesh = scenes::make_organ_mesh(2);
  options.fixed = scenes::find_base(mesh);
  scene.bodies[0].tissue = build_mass_spring(mesh, {}, links, options);
  scene.instruments[0].coupling = {.stiffness = kOwn, .force_max = 20.0};
  return build_scene(std::move(scene));
}

/// A hand above the organ's top, 0 where it begins to touch and below it inside.
struct Press {
  Press(double links, double passive, double delay = 1.5e-3)
      : scene(make_scene(links)), world(scene) {
    world.instruments[0].device.passive_stiffness = passive;
    world.instruments[0].device.delay = delay;
  }

  /// [N] on the hand at this height and this far aside [m].
  Vec3 go(double height, double aside = 0.0) {
    HapticSample hand;
    hand.time = time;
    hand.position = Vec3(0.001 + aside, 0.0015, 0.03 + Tool{}.radius + height);
    time += kTick;
    return tick(scene, hand, kTick, world).force;
  }
  const DeviceCoupling& device() const { return world.instruments[0].device; }

  Scene scene;
  World world;
  double time = 0.0;
};

/// [N/m] What the hand feels and what the tool meets, each a slope between two depths at rest.
struct Slopes {
  double hand = 0.0, tissue = 0.0;
  double spring = 0.0;  ///< [N/m] of the hand there
  double learnt = 0.0;  ///< [N/m] as the tick has learnt the tissue
  double shown = 0.0;   ///< [-] as the error that is shown
};

Slopes feel(double links, double passive) {
  constexpr double kDeep = 4e-3, kBeside = 2.5e-4;
  Press press(links, passive);
  for (int t = 0; t < 200; ++t) press.go(2e-3 + 40e-3 * (1.0 - t / 200.0));
  for (int t = 0; t < 400; ++t) press.go(2e-3 - (2e-3 + kDeep) * std::min(1.0, t / 300.0));
  // as a hand that holds still trembles, which lets the spring come to rest as well
  for (int t = 0; t < 1500; ++t) press.go(-kDeep + kBeside * std::sin(2 * M_PI * t / 250.0));
  double force[2], place[2];
  for (const int side : {0, 1}) {
    for (int t = 0; t < 400; ++t) {
      const double from = side == 0 ? 0.0 : -kBeside, to = side == 0 ? -kBeside : kBeside;
      force[side] = press.go(-kDeep + from + (to - from) * std::min(1.0, t / 200.0)).z();
    }
    place[side] = press.world.instruments[0].tool.position.z();
  }
  const double rise = force[0] - force[1];
  return {rise / (2 * kBeside), rise / (place[1] - place[0]), press.device().stiffness,
          press.device().tissue, find_stiffness_error(press.device())};
}

}  // namespace

TEST_CASE("the hand's spring before a tissue is the softest that lets nine tenths of it be felt") {
  CHECK(fit_coupling(500.0, 150.0, 0.0) == 150.0);
  CHECK(fit_coupling(500.0, 150.0, 10.0) == 150.0);  // 9 times 10 is less
  CHECK(fit_coupling(500.0, 150.0, 30.0) == 270.0);
  CHECK(in_series(270.0, 30.0) == Approx(27.0));      // nine tenths
  CHECK(fit_coupling(500.0, 150.0, 100.0) == 500.0);  // its own, and no stiffer
  CHECK(fit_coupling(500.0, 600.0, 100.0) == 500.0);  // the device bears it
  // 150 . 600/450: 600 behind it feels as stiff as is passive
  CHECK(fit_coupling(500.0, 150.0, 600.0) == Approx(200.0));
  CHECK(in_series(200.0, 600.0) == Approx(150.0));
}

TEST_CASE("whatever the tissue is, no more than what is passive is felt, and no jump between") {
  constexpr double kPassive = 150.0;
  double before = kPassive;
  for (double tissue = 0.1; tissue < 1e6; tissue *= 1.01) {
    const double spring = fit_coupling(kOwn, kPassive, tissue), felt = in_series(spring, tissue);
    CHECK(spring >= kPassive * (1.0 - 1e-12));
    CHECK(felt <= kPassive * (1.0 + 1e-12));
    CHECK(felt >= std::min({0.9 * tissue, in_series(kOwn, tissue), kPassive}) * (1.0 - 1e-12));
    CHECK(std::abs(spring - before) < 0.2 * before);
    before = spring;
  }
}

TEST_CASE("a tissue is felt as stiff as the device bears, and the part that is missing is shown") {
  constexpr double kPassive = 60.0;
  for (const double links : {10.0, 30.0, 90.0, 300.0}) {
    CAPTURE(links);
    const Slopes own = feel(links, 0.0), felt = feel(links, kPassive);
    CAPTURE(own.tissue);
    CAPTURE(felt.tissue);
    CAPTURE(felt.spring);
    CAPTURE(felt.hand);
    CHECK(own.hand == Approx(in_series(kOwn, own.tissue)).epsilon(0.01));
    CHECK(felt.learnt == Approx(felt.tissue).epsilon(0.15));
    // more than behind a spring that is passive before every tissue, and no more than is
    CHECK(felt.hand > 1.05 * in_series(kPassive, felt.tissue));
    CHECK(felt.hand > 0.9 * in_series(felt.spring, felt.tissue));
    CHECK(felt.hand < 1.1 * kPassive);  // the spring still learns
    CHECK(std::abs(felt.shown - (1.0 - felt.hand / felt.tissue)) < 0.08);
  }
}

TEST_CASE("where the device bears the instrument's own coupling nothing is other than without") {
  Press own(30.0, 0.0), borne(30.0, 1.01 * kOwn);
  for (int t = 0; t < 300; ++t) {
    const double height = 1e-3 - 5e-3 * std::sin(M_PI * t / 300.0);
    CHECK(own.go(height) == borne.go(height));
  }
  CHECK(borne.device().stiffness == 0.0);
  CHECK(compute_hash(own.world) == compute_hash(borne.world));
}

namespace {

/// A device of this mass and damping without a hand, whose forces come `late` ticks late.
struct Device {
  double mass = 0.12, damping = 0.1;  // [kg], [N·s/m]
  int late = 1;

  double passive() const { return damping / (0.5 * kTick + late * kTick); }  // [N/m]
};

/// How it swings where it leans on an organ with a weight of 0.3 N: the widest motion [m] in its
/// first half second after 2 s, and in its last after 8.
struct Swing {
  double early = 0.0, late = 0.0;
};

Swing lean(const Device& device, double links, double passive) {
  constexpr double kWeight = 0.3;  // [N]
  Press press(links, passive);
  std::deque<double> forces(static_cast<std::size_t>(device.late), 0.0);
  double x = 1e-4, v = 0.0;
  Swing swing;
  double low = 0.0, high = 0.0;
  // of m v' = F - b v over a tick, exactly
  const double left = std::exp(-device.damping / device.mass * kTick);
  for (int t = 0; t < 8000; ++t) {
    forces.push_back(press.go(x).z());
    const double end = (forces.front() - kWeight) / device.damping;
    forces.pop_front();
    x += end * kTick + (v - end) * (1.0 - left) * device.mass / device.damping;
    v = end + (v - end) * left;
    if (t % 500 == 0) low = high = x;
    low = std::min(low, x);
    high = std::max(high, x);
    if (t == 2499) swing.early = high - low;
  }
  swing.late = high - low;
  return swing;
}

}  // namespace

TEST_CASE("a device that swings against a hard tissue through the instrument's coupling is calm") {
  const Device device;
  CHECK(device.passive() == Approx(66.7).epsilon(0.01));
  const double hard = 600.0;
  const Swing own = lean(device, hard, 0.0), fitted = lean(device, hard, device.passive());
  CAPTURE(own.early);
  CAPTURE(fitted.early);
  CAPTURE(fitted.late);

  CHECK(own.late > 1.5 * own.early);
  CHECK(fitted.late < 0.95 * fitted.early);
  CHECK(fitted.late < 0.3 * own.late);
  // as hard as it bears it comes to rest
  CHECK(lean(device, 30.0, device.passive()).late < 1e-4);
}

TEST_CASE("of a tissue that the device does not bear it is told how much is not felt") {
  const Device device;
  const Slopes felt = feel(120.0, device.passive());
  CAPTURE(felt.tissue);

  REQUIRE(felt.tissue > 1.5 * device.passive());
  CHECK(felt.hand < 1.1 * device.passive());
  CHECK(felt.shown == Approx(1.0 - device.passive() / felt.tissue).epsilon(0.1));
  CHECK(felt.shown > 0.3);
}

namespace {

/// Of a hand that nothing moves: what was given to it beyond what it put in [J], less what the
/// device takes up of that; the largest change of force in a tick [N]; how often the spring began
/// to follow the tissue.
struct Port {
  double given = 0.0, most_given = 0.0, put_in = 0.0, jump = 0.0;
  int begins = 0;
};

/// 5 mm pressed in `time` [s], 6 mm slipped and released, twice, with a tremor of 0.2 mm at 9 Hz.
Port play(const Device& device, double links, double passive, double time) {
  Press press(links, passive);
  Port port;
  Vec3 last_force = Vec3::Zero(), last_place = Vec3::Zero();
  bool followed = false;
  std::deque<Vec3> forces(static_cast<std::size_t>(device.late), Vec3::Zero());
  const auto whole = static_cast<int>(4.0 * time / kTick);
  for (int t = 0; t < 2 * whole; ++t) {
    const double part = (t % whole) / static_cast<double>(whole);
    const double down = std::clamp(std::min(part, 1.0 - part) * 4.0, 0.0, 1.0);
    const double tremor = 2e-4 * std::sin(2.0 * M_PI * 9.0 * t * kTick);
    const Vec3 place(6e-3 * std::clamp(4.0 * part - 1.5, 0.0, 1.0), 0.0,
                     1e-3 - 6e-3 * (3.0 - 2.0 * down) * down * down + tremor);
    forces.push_back(press.go(place.z(), place.x()));
    const Vec3 force = forces.front();
    forces.pop_front();
    if (t > 0) {
      const Vec3 moved = place - last_place;
      const double work = last_force.dot(moved);
      port.given += work - device.damping * moved.squaredNorm() / kTick;
      port.put_in += std::max(0.0, -work);
      port.most_given = std::max(port.most_given, port.given);
      port.jump = std::max(port.jump, (force - last_force).norm());
    }
    if (press.device().follows_tissue && !followed) ++port.begins;
    followed = press.device().follows_tissue;
    last_force = force;
    last_place = place;
  }
  return port;
}

}  // namespace

TEST_CASE("pressed, slipped and released it gives the hand nothing, and changes no force at once") {
  const Device device;
  for (const double links : {30.0, 120.0}) {
    for (const double time : {0.5, 0.06}) {  // [s] 10 and 80 mm/s
      CAPTURE(links);
      CAPTURE(time);
      const Port own = play(device, links, 0.0, time);
      const Port fitted = play(device, links, device.passive(), time);
      CAPTURE(own.jump);
      CAPTURE(fitted.jump);
      CAPTURE(fitted.put_in);
      CAPTURE(fitted.given);
      CHECK(fitted.most_given < 0.02 * fitted.put_in);
      CHECK(fitted.given < 0.0);
      CHECK(fitted.jump <= std::max(10e-3, 2.0 * own.jump));
      CHECK(fitted.begins <= (time > 0.1 ? 2 : 4));  // a tremor lets go of it
    }
  }
}
