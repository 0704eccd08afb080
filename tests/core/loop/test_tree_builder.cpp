// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "calls.h"
#include "core/loop/collapse_scene.h"
#include "palpate/sim/loop/private/tree_builder.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tree/queries.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

bool is_same_order(const AabbTree& a, const AabbTree& b) {
  return std::equal(a.order().begin(), a.order().end(), b.order().begin(), b.order().end());
}

/// [m] To the closest point, from the triangles alone.
double find_closest_by_force(const World& world, const Vec3& p) {
  const std::span<const Vec3> x = surface_position(world.bodies[0]);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : world.bodies[0].tree.triangles()) {
    const SurfacePoint found = find_closest_on_triangle(p, x[static_cast<std::size_t>(t[0])],
                                                        x[static_cast<std::size_t>(t[1])],
                                                        x[static_cast<std::size_t>(t[2])]);
    nearest = std::min(nearest, found.distance);
  }
  return nearest;
}

void check_queries(World& world) {
  world.bodies[0].tree.refit(surface_position(world.bodies[0]));
  for (std::uint32_t q = 0; q < 30; ++q) {
    const Vec3 p =
        0.05 * Vec3(scenes::scatter(3 * q), scenes::scatter(3 * q + 1), scenes::scatter(3 * q + 2));
    const auto found =
        find_closest_point(world.bodies[0].tree, surface_position(world.bodies[0]), p);
    REQUIRE(found);
    CHECK(found->distance == find_closest_by_force(world, p));
  }
}

/// Ticks until the builder has exchanged the tree, with time for it to work.
std::optional<Event> tick_until_exchanged(const Scene& scene, TreeBuilder& builder, World& world) {
  ScriptedDevice hand = sweep_script(1.0);
  for (int i = 0; i < 1000; ++i) {
    tick(scene, hand.read(1e-3 * i), 1e-3, world);
    if (const auto told = builder.serve(0, world)) return told;
    if (wants_tree(world.bodies[0])) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("a tissue at rest, pressed and let go keeps its tree") {
  const Scene scene = press_scene();
  World world(scene);
  ScriptedDevice hand = press_script(0.006, 0.5, true);

  for (int i = 0; i < 600; ++i) {
    tick(scene, hand.read(1e-3 * i), 1e-3, world);
    CHECK_FALSE(wants_tree(world.bodies[0]));
  }

  CHECK(internals(world.bodies[0]).tree_cost.growth() != 1.0);
}

TEST_CASE("a tissue that collapses gets another tree, cheaper, and feels the same to the bit") {
  const Scene scene = collapse_scene();
  World kept(scene), rebuilt(scene);
  const AabbTree first = kept.bodies[0].tree;
  ScriptedDevice hand = sweep_script(1.0);
  int rebuilds = 0, touched = 0, different = 0;

  for (int i = 0; i < 1000; ++i) {
    const HapticSample sample = hand.read(1e-3 * i);
    const Vec3 expected = tick(scene, sample, 1e-3, kept).force;
    different += tick(scene, sample, 1e-3, rebuilt).force != expected;
    touched += rebuilt.instruments[0].tool.touching;
    if (!wants_tree(rebuilt.bodies[0])) continue;
    const double before = compute_query_cost(rebuilt.bodies[0].tree);
    BuiltTree built =
        build_over(surface_position(rebuilt.bodies[0]), scene.bodies[0].tissue.triangles);
    exchange_tree(built, rebuilt.bodies[0]);
    ++rebuilds;
    CHECK_FALSE(wants_tree(rebuilt.bodies[0]));
    CHECK(compute_query_cost(rebuilt.bodies[0].tree) < 0.9 * before);
    CHECK(internals(rebuilt.bodies[0]).tree_cost.growth() == 1.0);
    check_queries(rebuilt);
  }

  CHECK_FALSE(kept.alarm);
  CHECK(rebuilds > 0);
  CHECK(touched > 100);
  CHECK(different == 0);
  CHECK(compute_hash(kept) == compute_hash(rebuilt));
  CHECK(is_same_order(kept.bodies[0].tree, first));
  CHECK_FALSE(is_same_order(rebuilt.bodies[0].tree, first));
}

TEST_CASE(
    "a builder exchanges the tree between two ticks for one over the positions it was asked") {
  const Scene scene = collapse_scene();
  World world(scene);
  TreeBuilder builder(world.bodies[0]);

  const auto told = tick_until_exchanged(scene, builder, world);

  REQUIRE(told);
  CHECK(told->kind == EventKind::tree_exchanged);
  CHECK(told->tick == world.tick_count);
  CHECK(told->value >= TreeCost::kWorthRebuilding);
  World again(scene);
  ScriptedDevice hand = sweep_script(1.0);
  for (int i = 0; i < told->tick - told->index; ++i) {
    tick(scene, hand.read(1e-3 * i), 1e-3, again);
  }
  CHECK(is_same_order(world.bodies[0].tree, AabbTree(surface_position(again.bodies[0]),
                                                     scene.bodies[0].tissue.triangles)));
  check_queries(world);
}

TEST_CASE("having a tree built and taking it over allocates, frees and locks nothing") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  const Scene scene = collapse_scene();
  World world(scene);
  TreeBuilder builder(world.bodies[0]);

  const Calls before = count_calls_of_this_thread();
  ScriptedDevice hand = sweep_script(1.0);
  const Calls scripted = count_calls_of_this_thread();
  int exchanged = 0;
  for (int i = 0; i < 1000; ++i) {
    tick(scene, hand.read(1e-3 * i), 1e-3, world);
    exchanged += builder.serve(0, world).has_value();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  const Calls after = count_calls_of_this_thread();

  CHECK(scripted.allocations > before.allocations);
  CHECK(exchanged > 0);
  CHECK(after.allocations == scripted.allocations);
  CHECK(after.locks == scripted.locks);
}

TEST_CASE("a builder that goes away while it builds, or is never asked, leaves nothing behind") {
  const Scene scene = collapse_scene();
  World world(scene);
  { const TreeBuilder never_asked(world.bodies[0]); }
  for (int i = 0; i < 400 && !wants_tree(world.bodies[0]); ++i) tick(scene, {}, 1e-3, world);
  REQUIRE(wants_tree(world.bodies[0]));

  for (int i = 0; i < 50; ++i) {
    TreeBuilder builder(world.bodies[0]);
    builder.serve(0, world);
  }

  CHECK(find_closest_point(world.bodies[0].tree, surface_position(world.bodies[0]), Vec3::Zero()));
}

TEST_CASE("a tree that is exchanged while most of the tissue sleeps goes on following what wakes") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  Scene scene = press_scene();
  scene.bodies[0].kernel = Kernel::packed;
  scene.bodies[0].force_error = 1e-4;
  scene = build_scene(std::move(scene));
  World kept(scene), exchanged(scene);
  REQUIRE(find_packed(exchanged.bodies[0])->active.on);
  ScriptedDevice hand = press_script(0.005, 0.5);
  int slept = 0, different = 0;

  for (int i = 0; i < 900; ++i) {
    const HapticSample sample = hand.read(1e-3 * (i % 500));
    if (i % 37 == 0) {
      BuiltTree built =
          build_over(surface_position(exchanged.bodies[0]), scene.bodies[0].tissue.triangles);
      exchange_tree(built, exchanged.bodies[0]);
    }
    const Vec3 expected = tick(scene, sample, 1e-3, kept).force;
    different += tick(scene, sample, 1e-3, exchanged).force != expected;
    slept += std::ranges::count(find_packed(exchanged.bodies[0])->active.awake, 0) > 0;
  }

  CHECK(slept > 100);
  CHECK(different == 0);
  follow_tissue(scene, 0, kept);
  follow_tissue(scene, 0, exchanged);
  const AabbTree fresh(surface_position(exchanged.bodies[0]), scene.bodies[0].tissue.triangles);
  CHECK(exchanged.bodies[0].tree.low() == fresh.low());
  CHECK(exchanged.bodies[0].tree.high() == fresh.high());
  const double cost = compute_query_cost(exchanged.bodies[0].tree);
  exchanged.bodies[0].tree.refit(surface_position(exchanged.bodies[0]));
  CHECK(compute_query_cost(exchanged.bodies[0].tree) == cost);
}
