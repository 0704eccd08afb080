// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "calls.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/loop/private/exchange_tree.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tree/queries.h"
#include "scenes/solids.h"
#include "scenes/tissues.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

struct Case {
  std::string name;
  Scene scene;
  Vec3 top = Vec3::Zero();  ///< [m] of its surface
};

Case make_case(std::string name, TissueModel tissue) {
  Case made{std::move(name), {}};
  for (const Vec3& x : compute_surface(tissue, tissue.rest_position)) {
    if (x.z() > made.top.z()) made.top = x;
  }
  made.scene.bodies[0].kernel = Kernel::packed;
  made.scene.bodies[0].tissue = std::move(tissue);
  made.scene = build_scene(std::move(made.scene));
  return made;
}

/// Hollow organs of springs and of molecules, and a solid whose surface rides on it.
std::vector<Case> make_cases() {
  const scenes::Losses losses{.damping_ratio = 0.2, .drag = 3.0};
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.020}, 3);
  SurfaceOptions options;
  options.home_stiffness = 4e5;
  options.fixed = scenes::find_base(mesh);
  const Material wall = {.wall_thickness = 0.003};
  std::vector<Case> cases;
  cases.push_back(make_case("springs", build_mass_spring(mesh, wall, 100.0, options)));
  cases.push_back(make_case("molecules", build_molecular(mesh, wall, {100.0, 1e-5, 0.0}, options)));
  cases.push_back(make_case("covered solid", scenes::make_covered_organ(4, 0.9, losses)));
  return cases;
}

/// Comes down, presses, slides aside and pulls, then flicks through at 3 m/s and away.
HapticSample hand_at(const Case& c, int tick) {
  const double radius = c.scene.instruments[0].tool.radius;
  const double height[] = {4e-3, -2e-3, -2e-3, 5e-3, 2e-3};
  HapticSample sample;
  const int phase = std::min(tick / 60, 4);
  const double part = phase == 0 ? 0.0 : (tick - 60 * phase) / 60.0;
  const int before = std::max(0, phase - 1);
  double z = height[before] + (height[phase] - height[before]) * std::min(1.0, part);
  if (tick >= 250) z = std::max(-8e-3, 2e-3 - 3e-3 * (tick - 250));
  if (tick >= 275) z = 2e-2;
  const double aside = phase >= 2 ? 4e-3 * std::min(1.0, (tick - 120) / 60.0) : 0.0;
  sample.position = c.top + Vec3(aside, 0.5 * aside, radius + z);
  sample.buttons = phase == 3 ? kAttachButton : 0;
  return sample;
}
constexpr int kTicks = 300;

World caught_up(const Scene& scene, const World& world) {
  World whole = world;
  catch_up(scene, whole);
  return whole;
}

std::vector<int> list_candidates(const World& world) {
  const auto& all = world.pairs[0].candidates.triangles;
  return {all.begin(), all.begin() + world.pairs[0].candidates.count};
}

/// Triangles that come within reach of the path, one by one.
std::vector<int> find_by_force(const Scene& scene, std::span<const Vec3> x, const Vec3& from,
                               const Vec3& to) {
  std::vector<int> found;
  for (std::size_t t = 0; t < scene.bodies[0].tissue.triangles.size(); ++t) {
    const auto& [a, b, c] = scene.bodies[0].tissue.triangles[t];
    bool near = false;
    for (int i = 0; i <= 8 && !near; ++i) {
      const Vec3 p = from + i / 8.0 * (to - from);
      const double distance =
          find_closest_on_triangle(p, x[static_cast<std::size_t>(a)],
                                   x[static_cast<std::size_t>(b)], x[static_cast<std::size_t>(c)])
              .distance;
      near = distance <= scene.instruments[0].tool.radius + kCandidateMargin;
    }
    if (near) found.push_back(static_cast<int>(t));
  }
  return found;
}

/// Whether no box of `lagging` would have to grow by more than `most` [m] to hold those of `exact`.
bool holds_within(const AabbTree& lagging, const AabbTree& exact, double most) {
  // both are rounded to float
  most += 1e-8;
  for (std::size_t n = 0; n < exact.nodes().size(); ++n) {
    const AabbTree::Node &late = lagging.nodes()[n], &now = exact.nodes()[n];
    for (std::size_t k = 0; k < AabbTree::kWidth; ++k) {
      if (now.count[k] < 0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (double(late.low[axis][k]) - most > double(now.low[axis][k])) return false;
        if (double(late.high[axis][k]) + most < double(now.high[axis][k])) return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE(
    "a world that follows what the tool may touch feels the same as a whole one, to the bit") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const Case& c : make_cases()) {
    CAPTURE(c.name);
    World whole(c.scene), part(c.scene);
    part.follows_all = false;
    int touched = 0, held = 0, lagged = 0;
    for (int i = 0; i < kTicks; ++i) {
      const HapticSample sample = hand_at(c, i);
      const Vec3 force = tick(c.scene, sample, 1e-3, whole).force;
      REQUIRE(tick(c.scene, sample, 1e-3, part).force == force);
      REQUIRE(list_candidates(part) == list_candidates(whole));
      REQUIRE(part.bodies[0].substeps == whole.bodies[0].substeps);
      REQUIRE(compute_hash(caught_up(c.scene, part)) == compute_hash(whole));
      touched += part.instruments[0].tool.touching;
      held += part.instruments[0].tool.hold_count > 0;
      lagged += is_behind(part.bodies[0]) &&
                part.bodies[0].tissue.position != whole.bodies[0].tissue.position;
    }
    CHECK_FALSE(whole.alarm);
    CHECK(touched > 50);
    CHECK(held > 20);
    CHECK(lagged > kTicks / 2);
  }
}

TEST_CASE("no triangle within the tool's reach is missed, and no box is behind by more than said") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const Case& c : make_cases()) {
    CAPTURE(c.name);
    World world(c.scene);
    world.follows_all = false;
    int in_reach = 0, behind = 0;
    double most = 0.0;
    for (int i = 0; i < kTicks; ++i) {
      World before = caught_up(c.scene, world);
      before.bodies[0].tree.refit(surface_position(before.bodies[0]));
      const double bound = bound_lag(world.bodies[0]);
      REQUIRE(holds_within(world.bodies[0].tree, before.bodies[0].tree, bound));
      behind += !holds_within(world.bodies[0].tree, before.bodies[0].tree, 1e-7);
      if (i < 250) most = std::max(most, bound);

      tick(c.scene, hand_at(c, i), 1e-3, world);

      const std::vector<int> near =
          find_by_force(c.scene, surface_position(before.bodies[0]), world.pairs[0].candidates.from,
                        world.pairs[0].candidates.to);
      const std::vector<int> found = list_candidates(world);
      REQUIRE(std::ranges::includes(found, near));
      in_reach += !near.empty();
    }
    CHECK(in_reach > 100);
    CHECK(behind > 50);
    // a press at 0.1 m/s is followed closely enough to visit few boxes
    CHECK(most < 3.0 * c.scene.instruments[0].tool.radius);
  }
}

TEST_CASE("a world may begin and end to follow all at any tick, and get another tree") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const Case c = make_cases().front();
  World whole(c.scene), turning(c.scene);
  for (int i = 0; i < kTicks; ++i) {
    turning.follows_all = i % 40 >= 33;
    if (i % 37 == 0) {
      BuiltTree built =
          build_over(surface_position(turning.bodies[0]), c.scene.bodies[0].tissue.triangles);
      exchange_tree(built, turning.bodies[0]);
    }
    World exact = caught_up(c.scene, turning);
    exact.bodies[0].tree.refit(surface_position(exact.bodies[0]));
    REQUIRE(
        holds_within(turning.bodies[0].tree, exact.bodies[0].tree, bound_lag(turning.bodies[0])));
    const HapticSample sample = hand_at(c, i);
    const Vec3 force = tick(c.scene, sample, 1e-3, whole).force;
    REQUIRE(tick(c.scene, sample, 1e-3, turning).force == force);
    if (turning.follows_all) REQUIRE(compute_hash(turning) == compute_hash(whole));
  }
}

TEST_CASE("what blows up raises the same alarm and stands at the same place, followed or not") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  Scene scene = press_scene();
  scene.bodies[0].kernel = Kernel::packed;
  const double rate = scene.rate / (4.0 * scene.bodies[0].substeps);
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 1;
  scene.rate = rate;
  World whole(scene), part(scene);
  whole.recovers = part.recovers = false;
  part.follows_all = false;
  HapticSample sample;

  for (int i = 0; i < 2000 && !whole.alarm; ++i) {
    sample.position = Vec3(0.0, 0.0, i == 0 ? 0.03 : 0.021);
    tick(scene, sample, 1.0 / rate, whole);
    tick(scene, sample, 1.0 / rate, part);
    REQUIRE(part.alarm.kind == whole.alarm.kind);
  }

  REQUIRE(whole.alarm);
  CHECK(part.alarm.index == whole.alarm.index);
  CHECK(part.alarm.value == whole.alarm.value);
  catch_up(scene, part);
  CHECK(part.bodies[0].tissue.position == whole.bodies[0].tissue.position);
  CHECK(part.bodies[0].tissue.velocity == whole.bodies[0].tissue.velocity);
}

TEST_CASE("following in turn and catching up allocate nothing and take no lock") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  for (const Case& c : make_cases()) {
    World world(c.scene);
    world.follows_all = false;
    const Calls before = count_calls_of_this_thread();
    for (int i = 0; i < kTicks; ++i) {
      tick(c.scene, hand_at(c, i), 1e-3, world);
      if (i % 8 == 0) catch_up(c.scene, world);
    }
    const Calls after = count_calls_of_this_thread();
    CHECK(after.allocations == before.allocations);
    CHECK(after.locks == before.locks);
  }
}

TEST_CASE("where parts sleep, and under the reference kernel, nothing is ever behind") {
  for (const bool sleeps : {false, true}) {
    Scene scene = press_scene();
    scene.bodies[0].kernel = sleeps ? Kernel::packed : Kernel::reference;
    scene.bodies[0].force_error = sleeps ? 1e-4 : 0.0;
    scene = build_scene(std::move(scene));
    World whole(scene), part(scene);
    part.follows_all = false;
    ScriptedDevice hand = press_script(0.005, 0.2);
    for (int i = 0; i < 200; ++i) {
      const HapticSample sample = hand.read(1e-3 * i);
      REQUIRE(tick(scene, sample, 1e-3, part).force == tick(scene, sample, 1e-3, whole).force);
      if (lags(part, part.bodies[0])) continue;
      REQUIRE_FALSE(is_behind(part.bodies[0]));
      REQUIRE(compute_hash(part) == compute_hash(whole));
    }
  }
}
