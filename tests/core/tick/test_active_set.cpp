// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/tick/press_scene.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// A wall of 60 x 50 x 40 mm and 2562 vertices whose pulls fade within 4 mm, held by home springs.
Scene make_wall(bool molecular, double force_error) {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.020}, 4);
  const Material material{.wall_thickness = 0.003};
  SurfaceOptions options;
  options.home_stiffness = 1e6;
  options.drag = 60.0;
  Scene scene;
  scene.bodies[0].tissue =
      molecular
          ? build_molecular(
                mesh, material,
                {.bond_stiffness = 20.0, .bend_stiffness = 1e-5, .stretch_coupling = 5e-3}, options)
          : build_mass_spring(mesh, material, 20.0, options);
  scene.bodies[0].force_error = force_error;
  return build_scene(std::move(scene));
}

/// Presses 3 mm into the pole, slides 8 mm along the wall, and lets go; in 1.2 s. Then the air.
Vec3 hand_at(int i) {
  const double down = std::clamp(i / 300.0, 0.0, 1.0), up = std::clamp((i - 900) / 100.0, 0.0, 1.0);
  const double along = std::clamp((i - 400) / 400.0, 0.0, 1.0);
  const double z = 0.024 - 0.004 * down + 0.010 * up - 0.0015 * along;
  return {0.008 * along, 0.002, z};
}

struct Run {
  std::vector<Vec3> forces;
  double largest = 0.0;  ///< [N]
};

void advance(const Scene& scene, World& world, int begin, int end, Run& run) {
  for (int i = begin; i < end; ++i) {
    HapticSample sample;
    sample.position = hand_at(i);
    run.forces.push_back(tick(scene, sample, 1e-3, world).force);
    run.largest = std::max(run.largest, run.forces.back().norm());
  }
}

/// Where the hand is from tick `at` on [m], on a straight path from the key before.
struct Key {
  int at;
  double x, z;
  bool attached = false;
};

/// The pole gives `depth` [m] in 0.2 s, is held, slowly let go to a tenth of it, and left; then the
/// same 12 mm away.
std::vector<Key> press_twice(double depth) {
  constexpr double kTouch = 0.0229, kTouchAway = 0.0216, kAir = 0.026;
  return {{0, 0, 0.024},
          {50, 0, kTouch},
          {250, 0, kTouch - depth},
          {400, 0, kTouch - depth},
          {800, 0, kTouch - 0.1 * depth},
          {900, 0, kTouch - 0.1 * depth},
          {950, 0, kAir},
          {1050, 0.012, kAir},
          {1100, 0.012, kTouchAway},
          {1300, 0.012, kTouchAway - depth},
          {1400, 0.012, kTouchAway - depth}};
}

void follow(const Scene& scene, World& world, const std::vector<Key>& keys, Run& run) {
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const Key &from = keys[k - 1], &to = keys[k];
    for (int i = from.at; i < to.at; ++i) {
      const double part = double(i - from.at) / (to.at - from.at);
      HapticSample sample;
      sample.position = {from.x + part * (to.x - from.x), 0.002, from.z + part * (to.z - from.z)};
      sample.buttons = to.attached ? kAttachButton : 0;
      run.forces.push_back(tick(scene, sample, 1e-3, world).force);
      run.largest = std::max(run.largest, run.forces.back().norm());
    }
  }
  REQUIRE_FALSE(world.alarm);
}

Run follow(const Scene& scene, const std::vector<Key>& keys) {
  World world(scene);
  Run run;
  follow(scene, world, keys, run);
  return run;
}

double compare(const Run& a, const Run& b, int begin, int end) {
  double most = 0.0;
  for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
    most = std::max(most, (a.forces[i] - b.forces[i]).norm());
  }
  return most;
}

struct Press {
  bool molecular;
  double depth, share;  ///< [m], [-] of the largest force
};

void check_pressed_twice(const Press& press) {
  CAPTURE(press.molecular);
  CAPTURE(press.depth);
  const Run full = follow(make_wall(press.molecular, 0.0), press_twice(press.depth));
  const double allowed = press.share * full.largest;
  const Run part = follow(make_wall(press.molecular, allowed), press_twice(press.depth));
  CHECK(compare(full, part, 0, 400) < allowed);     // press, hold
  CHECK(compare(full, part, 400, 900) < allowed);   // retreat, rest
  CHECK(compare(full, part, 900, 1400) < allowed);  // elsewhere
  CHECK(compare(full, part, 300, 400) > 0.0);       // it does sleep
}

bool can_sleep() { return !simd_targets().empty(); }

}  // namespace

TEST_CASE("the force of an active set is that of the full solve, within what the scene allows") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  for (const bool molecular : {false, true}) {
    CAPTURE(molecular);
    const Scene full = make_wall(molecular, 0.0);
    World of_full(full);
    Run a;
    advance(full, of_full, 0, 1300, a);
    REQUIRE_FALSE(of_full.alarm);
    for (const double allowed : {1e-3, 1e-4}) {
      CAPTURE(allowed);
      const Scene part = make_wall(molecular, allowed);
      World of_part(part);
      REQUIRE(find_packed(of_part.bodies[0])->active.on);
      Run b;
      advance(part, of_part, 0, 1300, b);
      REQUIRE_FALSE(of_part.alarm);
      CHECK(a.largest > 100.0 * allowed);
      CHECK(compare(a, b, 0, 400) < allowed);     // press
      CHECK(compare(a, b, 400, 900) < allowed);   // slide
      CHECK(compare(a, b, 900, 1300) < allowed);  // release
    }
  }
}

TEST_CASE("particles sleep until displacement reaches them, and again when they are at rest") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const Scene scene = make_wall(false, 1e-3);
  World world(scene);
  CHECK(find_packed(world.bodies[0])->state.slices.count == 0);  // nothing has touched it yet

  Run run;
  advance(scene, world, 0, 380, run);
  const int pressed = find_packed(world.bodies[0])->state.slices.count;
  CHECK(pressed > 0);
  CHECK(pressed < find_packed(world.bodies[0])->model->slice_count / 2);

  advance(scene, world, 380, 1100, run);
  advance(scene, world, 1100, 2500, run);
  CHECK(find_packed(world.bodies[0])->state.slices.count == 0);
  for (const Vec3& v : world.bodies[0].tissue.velocity) CHECK(v == Vec3::Zero());
}

TEST_CASE("nothing within two decay lengths of the tool ever sleeps while it touches") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const Scene scene = make_wall(false, 0.05);  // so much that nobody else would wake
  World world(scene);
  const ActiveRule rule = derive_active_rule(
      scene.bodies[0].tissue, scene.instruments[0].tool.radius, scene.bodies[0].force_error);
  Run run;
  for (int i = 0; i < 900; ++i) {
    advance(scene, world, i, i + 1, run);
    if (!world.instruments[0].tool.touching) continue;
    const Vec3& foot = scene.bodies[0].tissue.rest_position[static_cast<std::size_t>(
        find_packed(world.bodies[0])->near.particles[0])];
    for (std::size_t p = 0; p < scene.bodies[0].tissue.mass.size(); ++p) {
      if ((scene.bodies[0].tissue.rest_position[p] - foot).norm() > 2.0 * rule.decay) continue;
      const int slice =
          find_packed(world.bodies[0])->model->row[p] / find_packed(world.bodies[0])->model->width;
      CHECK(find_packed(world.bodies[0])->active.awake[static_cast<std::size_t>(slice)] == 1);
    }
  }
  CHECK(run.largest > 0.1);
}

TEST_CASE("the same hand wakes and puts to sleep the same particles, to the bit") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const Scene scene = make_wall(true, 1e-3);
  World first(scene), second(scene);
  Run a, b;
  advance(scene, first, 0, 1300, a);
  advance(scene, second, 0, 1300, b);
  CHECK(a.forces == b.forces);
  CHECK(find_packed(first.bodies[0])->active.awake == find_packed(second.bodies[0])->active.awake);
  CHECK(compute_hash(first) == compute_hash(second));
}

TEST_CASE("what sleeps stands still: it takes up momentum, and gives no energy") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const Scene scene = make_wall(false, 1e-3);
  World world(scene);
  Run run;
  advance(scene, world, 0, 380, run);
  for (int i = 0; i < 400; ++i) {
    const Vec3Array before = world.bodies[0].tissue.position;
    const std::vector<unsigned char> awake = find_packed(world.bodies[0])->active.awake;
    advance(scene, world, 380, 381, run);
    for (std::size_t p = 0; p < before.size(); ++p) {
      const auto slice = static_cast<std::size_t>(find_packed(world.bodies[0])->model->row[p] /
                                                  find_packed(world.bodies[0])->model->width);
      if (awake[slice] == 0 && find_packed(world.bodies[0])->active.awake[slice] == 0) {
        CHECK(world.bodies[0].tissue.position[p] == before[p]);
        CHECK(world.bodies[0].tissue.velocity[p] == Vec3::Zero());
      }
    }
  }
  // the alarm's energy is that of the whole tissue, asleep or not
  const Energy energy =
      compute_energy(scene.bodies[0].tissue, Vec3::Zero(), world.bodies[0].tissue);
  CHECK(find_packed(world.bodies[0])->measure.kinetic +
            find_packed(world.bodies[0])->measure.elastic +
            find_packed(world.bodies[0])->state.asleep_energy ==
        doctest::Approx(energy.total()).epsilon(1e-3));
}

TEST_CASE("a tissue that sags under gravity moves until it has found its rest, and then sleeps") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  Scene scene = make_wall(false, 1e-3);
  scene.gravity = {0, 0, -9.81};
  World world(scene);
  CHECK(find_packed(world.bodies[0])->state.slices.count ==
        find_packed(world.bodies[0])->model->slice_count);
  HapticSample far;
  far.position = {0, 0, 0.1};
  for (int i = 0; i < 1500; ++i) tick(scene, far, 1e-3, world);
  CHECK(find_packed(world.bodies[0])->state.slices.count == 0);
  CHECK(world.bodies[0].tissue.position[5].z() < scene.bodies[0].tissue.rest_position[5].z());
  CHECK_FALSE(world.alarm);
}

TEST_CASE("the tree of a partly sleeping tissue has the boxes of one refitted whole") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const Scene scene = make_wall(false, 1e-3);
  World world(scene);
  Run run;
  for (int i = 0; i < 1300; i += 50) {
    advance(scene, world, i, i + 50, run);
    AabbTree part = world.bodies[0].tree, whole = world.bodies[0].tree;
    part.refit_moving(world.bodies[0].tissue.position);
    whole.refit(world.bodies[0].tissue.position);
    for (std::size_t n = 0; n < whole.nodes().size(); ++n) {
      CHECK(part.nodes()[n].low == whole.nodes()[n].low);
      CHECK(part.nodes()[n].high == whole.nodes()[n].high);
    }
  }
}

TEST_CASE("a smaller error of the force asks for a lower threshold, at the same reach") {
  const Scene scene = make_wall(false, 0.0);
  const ActiveRule coarse = derive_active_rule(scene.bodies[0].tissue, 3e-3, 1e-2);
  const ActiveRule fine = derive_active_rule(scene.bodies[0].tissue, 3e-3, 1e-3);

  CHECK(coarse.threshold == doctest::Approx(10.0 * fine.threshold));
  CHECK(coarse.reach == fine.reach);
  CHECK(fine.reach == doctest::Approx(3e-3 + 2.0 * fine.decay));
  // three quarters of k L² / h in a lattice of equilateral triangles [motion: active set]
  CHECK(fine.decay ==
        doctest::Approx(std::sqrt(0.75 * 20.0 / (1e6 * std::sqrt(0.75)))).epsilon(0.1));
}

TEST_CASE("a tissue without home springs cannot sleep, and a force error is refused by name") {
  Scene scene = make_wall(false, 0.0);
  scene.bodies[0].force_error = -1.0;
  CHECK_THROWS_WITH_AS(build_scene(scene), doctest::Contains("force_error"), std::invalid_argument);
  scene.bodies[0].force_error = 1e-3;
  scene.bodies[0].tissue.home.clear();
  CHECK_THROWS_WITH_AS(build_scene(scene), doctest::Contains("home springs"),
                       std::invalid_argument);
}

TEST_CASE("however deep, let go and pressed elsewhere: the force stays within what is allowed") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  for (const Press& press : {Press{false, 4e-3, 2e-3}, Press{true, 1.5e-3, 2e-3}}) {
    check_pressed_twice(press);
  }
}

TEST_CASE("in more presses, too, the force stays within what is allowed" *
          doctest::test_suite("verify")) {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  for (const Press& press :
       {Press{false, 0.5e-3, 2e-3}, Press{false, 1.5e-3, 2e-2}, Press{true, 4e-3, 2e-2}}) {
    check_pressed_twice(press);
  }
}

TEST_CASE("a tip that chatters on the wall is felt rightly only once it lies still") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  // so lightly that it bounces, between ticks 90 and 180: an instability that sleeping tissue, and
  // anything else, nudges into another beat
  const std::vector<Key> keys = {
      {0, 0, 0.024}, {50, 0, 0.0229}, {250, 0, 0.0224}, {400, 0, 0.0224}};
  const Run full = follow(make_wall(true, 0.0), keys);
  const double allowed = 2e-3 * full.largest;
  CHECK(compare(full, follow(make_wall(true, allowed), keys), 250, 400) < allowed);
}

TEST_CASE("a tool that pulls along the wall is felt within what is allowed" *
          doctest::test_suite("landing")) {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const std::vector<Key> keys = {{0, 0, 0.024},
                                 {100, 0, 0.0219},
                                 {150, 0, 0.0219},
                                 {400, 0.003, 0.0219, true},
                                 {700, 0.003, 0.0219, true},
                                 {1000, 0, 0.0219, true}};
  for (const bool molecular : {false, true}) {
    CAPTURE(molecular);
    const Run full = follow(make_wall(molecular, 0.0), keys);
    const double allowed = 2e-3 * full.largest;
    CHECK(compare(full, follow(make_wall(molecular, allowed), keys), 0, 1000) < allowed);
  }
}

TEST_CASE("what stands off at the rule's ring is felt by what is allowed, and not much less") {
  const Scene scene = make_wall(false, 0.0);
  constexpr double kAllowed = 1e-4, kHome = 1e6;
  const ActiveRule rule = derive_active_rule(scene.bodies[0].tissue, 3e-3, kAllowed);
  const double depth = rule.decay;
  const double off = std::sqrt(rule.product_limit_per_depth * depth);
  // the ring that such a tool moves by as much, found by halving
  double near = 2.0, far = 20.0;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (near + far);
    const double field = std::cyl_bessel_k(0.0, x) / std::cyl_bessel_k(0.0, 3e-3 / rule.decay);
    (field * depth > off ? near : far) = x;
  }
  const double stiffness = 2.0 * std::numbers::pi * kHome * rule.decay * rule.decay /
                           (std::cyl_bessel_i(0.0, near) * std::cyl_bessel_k(0.0, near));
  const double felt = stiffness * off * 2.0 * off / depth;
  CHECK(felt < kAllowed);
  CHECK(felt > 0.9 * kAllowed);
}

TEST_CASE("more sleeps under a deep tool than under one that might do anything") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  const Scene scene = make_wall(false, 1e-4);
  World any(scene), deep(scene);
  find_packed(any.bodies[0])->active.product_limit_per_depth = 0.0;
  Run run;
  long awake_under_any = 0, awake_under_deep = 0;
  for (int i = 0; i < 400; ++i) {
    advance(scene, any, i, i + 1, run);
    advance(scene, deep, i, i + 1, run);
    awake_under_any += find_packed(any.bodies[0])->state.slices.count;
    awake_under_deep += find_packed(deep.bodies[0])->state.slices.count;
  }
  CHECK(awake_under_deep < 0.8 * awake_under_any);

  // as deep as it is, and a tenth of a second after it has gone it counts no more
  CHECK(find_packed(deep.bodies[0])->active.depth > 1e-3);
  CHECK(find_packed(deep.bodies[0])->active.depth < 4e-3);
  CHECK(find_packed(deep.bodies[0])->active.product_limit ==
        doctest::Approx(find_packed(deep.bodies[0])->active.product_limit_per_depth *
                        find_packed(deep.bodies[0])->active.depth));
  advance(scene, deep, 400, 1100, run);
  CHECK(find_packed(deep.bodies[0])->active.product_limit == 0.0f);
}

TEST_CASE("the depth of a tool counts only where tissue has been seen at rest without it") {
  SKIP_UNLESS(can_sleep(), "this build has no vector code");
  Scene scene = make_wall(false, 1e-3);
  scene.gravity = {0, 0, -9.81};
  World world(scene);
  Run run;
  advance(scene, world, 0, 380, run);  // what sags is pressed before it has settled
  CHECK(run.largest > 0.05);
  CHECK(find_packed(world.bodies[0])->active.depth == 0.0);
  advance(scene, world, 900, 2500, run);
  CHECK(find_packed(world.bodies[0])->state.slices.count == 0);
  advance(scene, world, 0, 380, run);
  CHECK(find_packed(world.bodies[0])->active.depth > 1e-3);
  CHECK(find_packed(world.bodies[0])->active.depth < 4e-3);
}
