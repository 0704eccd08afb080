// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <string>

#include "core/tick/press_scene.h"
#include "palpate/sim/loop/private/exchange_tree.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "scenes/linear_solids.h"
#include "scenes/solids.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kDt = 1e-3;
const Vec3 kFar(0.0, 0.0, 0.2);  ///< [m]

struct Case {
  std::string name;
  Scene scene;
  double touch = 0.0;   ///< [m] height of the hand at which the tool touches
  int rest_ticks = 60;  ///< within which it has come to rest after a press
};

/// One body of each kernel, each of which comes to rest: as it is, or within a granted error.
std::vector<Case> make_cases() {
  std::vector<Case> cases;
  Scene plain = press_scene();
  plain.bodies[0].kernel = Kernel::reference;
  cases.push_back({"reference", build_scene(std::move(plain)), 0.023, 0});
  Scene relaxing = press_scene();
  relaxing.bodies[0].kernel = Kernel::reference;
  relaxing.bodies[0].tissue.maxwell = {.ratio = 0.5, .time = 0.05};
  cases.push_back({"relaxing", build_scene(std::move(relaxing)), 0.023, 0});
  Scene solid;
  solid.gravity = {0.0, 0.0, -9.81};
  solid.bodies[0].tissue = scenes::make_linear_organ(5, 0.9, 0.2);
  double top = 0.0;
  for (const Vec3& x : solid.bodies[0].tissue.rest_position) top = std::max(top, x.z());
  cases.push_back({"response", build_scene(std::move(solid)), top + 0.003, 3000});
  if (simd_targets().empty()) return cases;
  Scene wall = press_scene();
  wall.bodies[0].kernel = Kernel::packed;
  wall.bodies[0].tissue.drag = 60.0;
  wall.bodies[0].force_error = 0.02;
  cases.push_back({"packed", build_scene(std::move(wall)), 0.023, 1500});
  return cases;
}

/// The tissue of press_scene() somewhere else, at rest to the bit there.
TissueModel make_hollow(const Vec3& offset) {
  SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.020}, 2);
  SurfaceOptions options;
  options.fixed = press_scene().bodies[0].tissue.fixed;
  options.home_stiffness = 4e5;
  for (Vec3& x : mesh.vertices) x += offset;
  return build_mass_spring(mesh, {.wall_thickness = 0.003}, 100.0, options);
}

HapticSample at(const Vec3& position, bool attach = false) {
  HapticSample sample;
  sample.position = position;
  sample.buttons = attach ? kAttachButton : 0;
  return sample;
}

/// Far away, down onto the body in 60 ms, 3 mm into it, holding it on the way up, and away again.
HapticSample visit(const Case& c, int tick) {
  constexpr int kComes = 200, kThere = 260, kDeep = 320, kUp = 380, kGone = 400;
  const Vec3 above(0.001, 0.002, c.touch + 0.010), deep(0.001, 0.002, c.touch - 0.003);
  const auto between = [&](const Vec3& from, const Vec3& to, int begin, int end) {
    return Vec3(from + (to - from) * (double(tick - begin) / (end - begin)));
  };
  if (tick < kComes || tick >= kGone) return at(kFar);
  if (tick < kThere) return at(between(kFar, above, kComes, kThere));
  if (tick < kDeep) return at(between(above, deep, kThere, kDeep));
  if (tick < kUp) return at(between(deep, above, kDeep, kUp), true);
  return at(between(above, kFar, kUp, kGone));
}

bool same_state(const Scene& scene, const World& a, const World& b) {
  World one = a, other = b;
  catch_up(scene, one);
  catch_up(scene, other);
  return compute_hash(one) == compute_hash(other) &&
         one.bodies[0].tissue.time == other.bodies[0].tissue.time &&
         one.bodies[0].tissue.position == other.bodies[0].tissue.position &&
         one.bodies[0].skin == other.bodies[0].skin;
}

/// Stays far away until the body sleeps.
void wait_for_sleep(const Case& c, World& world, int most) {
  for (int i = 0; i < most && !world.bodies[0].asleep; ++i) tick(c.scene, at(kFar), kDt, world);
  REQUIRE(world.bodies[0].asleep);
}

}  // namespace

TEST_CASE("a body that sleeps until a tool comes gives the bits of one that never sleeps") {
  for (const Case& c : make_cases()) {
    for (const bool follows_all : {true, false}) {
      CAPTURE(c.name);
      CAPTURE(follows_all);
      World sleeps(c.scene), wakes(c.scene);
      sleeps.follows_all = wakes.follows_all = follows_all;
      const int end = 400 + c.rest_ticks + 200;
      int slept = 0, touched = 0, first_touch = 0;
      for (int i = 0; i < end; ++i) {
        const HapticSample sample = visit(c, i);
        const Vec3 force = tick(c.scene, sample, kDt, sleeps).force;
        REQUIRE(force == tick(c.scene, sample, kDt, wakes).force);
        REQUIRE(sleeps.bodies[0].substeps == wakes.bodies[0].substeps);
        wakes.bodies[0].asleep = false;
        slept += sleeps.bodies[0].asleep;
        touched += force.norm() > 0.0;
        if (touched == 1 && first_touch == 0) first_touch = i;
        if (sleeps.instruments[0].tool.touching) REQUIRE_FALSE(sleeps.bodies[0].asleep);
        if (i % 20 == 0 || i + 1 == end) REQUIRE(same_state(c.scene, sleeps, wakes));
      }
      CHECK_FALSE(sleeps.alarm);
      CHECK(touched > 50);
      CHECK(slept > 100);
      if (c.rest_ticks > 0) CHECK(sleeps.bodies[0].asleep);
      const Guard &one = sleeps.bodies[0].guard, &other = wakes.bodies[0].guard;
      CHECK(one.last_time == other.last_time);
      CHECK(one.work == other.work);
      CHECK(one.given_energy == doctest::Approx(other.given_energy).epsilon(1e-12));
      CHECK(one.reference_energy == doctest::Approx(other.reference_energy).epsilon(1e-12));
      CHECK(one.strained_checks == other.strained_checks);
    }
  }
}

TEST_CASE("packed tissue without a granted error stays awake while rounding moves it") {
  SKIP_UNLESS(!simd_targets().empty(), "no vector code");
  Scene scene = press_scene();
  scene.bodies[0].kernel = Kernel::packed;
  const Scene built = build_scene(std::move(scene));
  World world(built);
  Vec3Array before;
  int stood_still = 0;
  for (int i = 0; i < 300; ++i) {
    before = world.bodies[0].tissue.position;
    tick(built, at(kFar), kDt, world);
    stood_still += before == world.bodies[0].tissue.position;
    if (world.bodies[0].asleep) REQUIRE(before == world.bodies[0].tissue.position);
  }
  if (stood_still == 0) CHECK_FALSE(world.bodies[0].asleep);
}

TEST_CASE(
    "a changed step, a changed gravity and a written tissue wake what is at rest to the bit") {
  const Case c = make_cases()[0];
  World world(c.scene);
  wait_for_sleep(c, world, 200);
  const double time = world.bodies[0].tissue.time;

  tick(c.scene, at(kFar), kDt, world);
  CHECK(world.bodies[0].asleep);
  CHECK(world.bodies[0].tissue.time == doctest::Approx(time + kDt));

  // a step of another length is tried before it is left out
  CHECK(internals(world.bodies[0]).rest.step == kDt / world.bodies[0].substeps);
  tick(c.scene, at(kFar), 2.0 * kDt, world);
  wait_for_sleep(c, world, 200);
  CHECK(internals(world.bodies[0]).rest.step == 2.0 * kDt / world.bodies[0].substeps);

  world.bodies[0].load.gravity = {0.0, 0.0, -9.81};
  const Vec3Array before = world.bodies[0].tissue.position;
  tick(c.scene, at(kFar), kDt, world);
  CHECK_FALSE(world.bodies[0].asleep);
  CHECK(world.bodies[0].tissue.position != before);

  World written(c.scene);
  wait_for_sleep(c, written, 200);
  written.bodies[0].tissue.velocity.back() = {0.0, 0.0, 0.01};
  written.bodies[0].asleep = false;
  const Vec3Array still = written.bodies[0].tissue.position;
  tick(c.scene, at(kFar), kDt, written);
  CHECK(written.bodies[0].tissue.position != still);
}

TEST_CASE("a body beside one that is pressed sleeps, and changes no bit of what is felt") {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    scene.bodies[b].tissue = make_hollow({0.1 * static_cast<double>(b), 0.0, 0.0});
    scene.bodies[b].kernel = Kernel::reference;
  }
  const Scene two = build_scene(std::move(scene));
  World sleeps(two), wakes(two);
  ScriptedDevice hand = press_script(0.006, 0.5, true);
  int slept = 0, alone = 0;
  for (int i = 0; i < 600; ++i) {
    // first at rest, so that both bodies sleep
    const HapticSample sample = hand.read(kDt * std::max(0, i - 100));
    REQUIRE(tick(two, sample, kDt, sleeps).force == tick(two, sample, kDt, wakes).force);
    slept += sleeps.bodies[0].asleep && sleeps.bodies[1].asleep;
    alone += !sleeps.bodies[0].asleep && sleeps.bodies[1].asleep;
    for (SoftState& body : wakes.bodies) body.asleep = false;
    if (i % 50 == 0) REQUIRE(compute_hash(sleeps) == compute_hash(wakes));
  }
  CHECK(slept > 0);
  CHECK(alone > 100);
  CHECK_FALSE(sleeps.alarm);
}

/// A wall of springs below the hand, and a covered solid with volumes beside it, in vector code and
/// with nothing granted.
Scene make_packed_pair() {
  Scene scene = press_scene();
  SoftBody solid;
  solid.tissue = scenes::make_covered_organ(3, 0.9, {.damping_ratio = 0.1});
  for (Vec3& x : solid.tissue.rest_position) x.x() += 0.3;
  scene.bodies.push_back(solid);
  scene.gravity = {0.0, 0.0, -9.81};
  for (SoftBody& body : scene.bodies) {
    body.tissue.drag = 60.0;
    body.kernel = Kernel::packed;
  }
  return build_scene(std::move(scene));
}

/// [m]
double largest_distance(const SoftState& a, const SoftState& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.tissue.position.size(); ++i) {
    largest = std::max(largest, (a.tissue.position[i] - b.tissue.position[i]).norm());
  }
  return largest;
}

TEST_CASE("vector code beside other bodies sleeps within a micrometre of where it would rest") {
  SKIP_UNLESS(!simd_targets().empty(), "no vector code");
  const Scene scene = make_packed_pair();
  const Case presses{"packed pair", scene, 0.023, 0};
  World sleeps(scene), wakes(scene);
  constexpr int kSettles = 3000, kVisit = 500;
  std::array<int, 2> slept = {0, 0};
  double apart = 0.0, strongest = 0.0;
  for (int i = 0; i < 2 * kSettles + kVisit; ++i) {
    const HapticSample sample = i < kSettles ? at(kFar) : visit(presses, i - kSettles);
    const Vec3 force = tick(scene, sample, kDt, sleeps).force;
    const Vec3 awake = tick(scene, sample, kDt, wakes).force;
    for (SoftState& body : wakes.bodies) body.asleep = false;
    strongest = std::max(strongest, awake.norm());
    REQUIRE((force - awake).norm() < 1e-4);  // [N]
    for (std::size_t b = 0; b < 2; ++b) slept[b] += sleeps.bodies[b].asleep;
    if (i == kSettles - 1) CHECK((slept[0] > 0 && slept[1] > 0));
    if (sleeps.instruments[0].tool.touching) REQUIRE_FALSE(sleeps.bodies[0].asleep);
    if (i % 100 != 0) continue;
    catch_up(scene, sleeps);
    catch_up(scene, wakes);
    for (std::size_t b = 0; b < 2; ++b) {
      apart = std::max(apart, largest_distance(sleeps.bodies[b], wakes.bodies[b]));
    }
  }
  CHECK(strongest > 0.1);
  CHECK(apart > 0.0);
  CHECK(apart < 1e-6);
  CHECK((sleeps.bodies[0].asleep && sleeps.bodies[1].asleep));
  CHECK_FALSE(sleeps.alarm);
}

TEST_CASE("vector code beside other bodies stays awake while it swings or creeps") {
  SKIP_UNLESS(!simd_targets().empty(), "no vector code");
  const Scene scene = make_packed_pair();
  World world(scene);
  Vec3Array before = world.bodies[0].tissue.position;
  int moved = 0;
  for (int i = 1; i <= 1000; ++i) {
    tick(scene, at(kFar), kDt, world);
    if (i % 50 != 0) continue;
    catch_up(scene, world);
    double largest = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      largest = std::max(
          largest, (world.bodies[0].tissue.position[k] - before[k]).lpNorm<Eigen::Infinity>());
    }
    before = world.bodies[0].tissue.position;
    // tries and these samples lie up to 50 ticks apart
    if (largest > 4e-7) {
      CHECK_FALSE(world.bodies[0].asleep);
      ++moved;
    }
  }
  CHECK(moved > 1);
}

TEST_CASE("a tree that is exchanged while its body sleeps finds the tool as the old one did") {
  for (const Case& c : make_cases()) {
    CAPTURE(c.name);
    World one(c.scene), other(c.scene);
    int exchanged = 0;
    for (int i = 0; i < 400 + c.rest_ticks + 300; ++i) {
      const HapticSample sample = visit(c, i % (500 + c.rest_ticks));
      REQUIRE(tick(c.scene, sample, kDt, one).force == tick(c.scene, sample, kDt, other).force);
      if (!one.bodies[0].asleep || i % 50 != 0) continue;
      const SoftState& body = one.bodies[0];
      BuiltTree built = build_over(surface_position(body), c.scene.bodies[0].tissue.triangles);
      exchange_tree(built, one.bodies[0]);
      ++exchanged;
    }
    CHECK(exchanged > 0);
    CHECK(same_state(c.scene, one, other));
  }
}
