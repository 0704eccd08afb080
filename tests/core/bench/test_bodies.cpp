// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include "core/bench/scene_of.h"
#include "palpate/bench/bench.h"
#include "palpate/bench/naive.h"
#include "palpate/bench/naive_linear.h"
#include "palpate/bench/press_and_hold.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/response/private/relax.h"
#include "scenes/linear_solids.h"
#include "scenes/shells.h"

using namespace palpate;

namespace {

TissueModel make_damped_solid(double nodal_share) {
  return scenes::make_solid_organ(4, nodal_share, {.damping_ratio = 0.2, .drag = 2.0});
}

/// [m] The largest distance between both forms after some steps from the same push.
double compare_steps(const TissueModel& model) {
  State ours(model), naive(model);
  const auto top = static_cast<std::size_t>(model.triangles.front()[0]);
  ours.position[top] += Vec3(5e-4, -3e-4, 8e-4);
  naive.position = ours.position;
  bench::NaiveVolumes kept(model.volumes);
  for (int s = 0; s < 50; ++s) {
    step(model, Load(), 1e-5, ours);
    bench::step_naively(model, Load(), 1e-5, naive, kept);
  }
  double most = 0.0;
  for (std::size_t i = 0; i < ours.position.size(); ++i) {
    most = std::max(most, (ours.position[i] - naive.position[i]).norm());
  }
  return most;
}

}  // namespace

TEST_CASE("the naive step of a solid moves every particle as the kernel does") {
  for (const double share : {0.0, 0.4, 0.9, 1.0}) {
    CAPTURE(share);
    CHECK(compare_steps(make_damped_solid(share)) < 1e-12);
  }
}

TEST_CASE("the naive step of a wall of prisms moves every particle as the kernel does") {
  CHECK(compare_steps(scenes::make_shell_organ(2, {.damping_ratio = 0.2, .drag = 2.0})) < 1e-12);
}

TEST_CASE("a naive response goes where that of floats goes") {
  const Scene scene = scene_of(scenes::make_linear_organ(4, 0.9, 0.2));
  World world(scene);
  bench::press_and_hold("linear_step", scene, bench::find_press_place(scene.bodies[0].tissue),
                        world);
  ResponseState ours(*scene.bodies[0].response);
  bench::NaiveResponse naive(*scene.bodies[0].response);
  Vec3Array x = scene.bodies[0].tissue.rest_position, y = x;

  for (int s = 0; s < 30; ++s) {
    relax(*scene.bodies[0].response, scene.bodies[0].tissue, world.bodies[0].load, 0.2, ours);
    settle(*scene.bodies[0].response, scene.bodies[0].tissue, ours, x);
    naive.step(scene.bodies[0].tissue, world.bodies[0].load, 0.2, y);
  }

  double moved = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    moved = std::max(moved, (y[i] - scene.bodies[0].tissue.rest_position[i]).norm());
    CHECK((x[i] - y[i]).norm() < 1e-8);
  }
  CHECK(moved > 5e-4);
}

TEST_CASE("a body is pressed from outside, never at a particle within it") {
  const TissueModel solid = make_damped_solid(0.9);

  const bench::Place place = bench::find_press_place(solid);

  CHECK(place.outward.norm() == doctest::Approx(1.0));
  CHECK(place.point.z() > 0.02);
}

TEST_CASE("every kind of body has its rows, with positive figures") {
  const std::vector<std::pair<std::string, Scene>> bodies = {
      {"shell", scene_of(scenes::make_shell_organ(2, {.damping_ratio = 0.2, .drag = 2.0}))},
      {"solid", scene_of(make_damped_solid(0.9))},
      {"linear", scene_of(scenes::make_linear_organ(4, 0.9, 0.2))}};
  for (const auto& body : bodies) {
    const std::string& kind = body.first;  // clang 14 captures no structured binding
    const Scene& scene = body.second;
    CAPTURE(kind);
    const auto rows =
        bench::run_body_bench(scene, {.budget = 1e-3, .least_runs = 3, .air_substeps = {1, 12}});

    REQUIRE(rows.size() == (kind == "linear" ? 3 : 4));
    CHECK(rows.front().work == kind + "_step");
    for (const bench::BenchRow& row : rows) {
      CHECK(row.work.starts_with(kind));
      CHECK(row.vertices == static_cast<int>(scene.bodies[0].tissue.mass.size()));
      CHECK(row.median > 0.0);
      CHECK(row.ratio_to_naive > 0.0);
      CHECK(row.elements > 0.0);
      CHECK((row.substeps > 0) == row.work.ends_with("_tick"));
      CHECK(row.share_of_bound < 1.0);
      CHECK((row.share_of_bound > 0.0 || row.physics.starts_with("hand in the air") ||
             simd_targets().empty()));
      CHECK(row.simd_target == (simd_targets().empty() ? "" : simd_targets().front()));
      CHECK(!row.physics.empty());
    }
  }
}

TEST_CASE("a body is timed at what is asked for, and nothing else is a body") {
  const Scene solid = scene_of(make_damped_solid(0.9));
  bench::BenchOptions options{.budget = 1e-3, .least_runs = 3, .works = {"solid_step"}};

  CHECK(bench::run_body_bench(solid, options).size() == 1);
  options.works = {"shell_step"};
  CHECK(bench::run_body_bench(solid, options).empty());
  options.works = {"mss_step"};
  CHECK_THROWS_AS(bench::run_body_bench(solid, options), std::invalid_argument);
  options.works = {};
  options.air_substeps = {0};
  CHECK_THROWS_AS(bench::run_body_bench(solid, options), std::invalid_argument);
  CHECK_THROWS_AS(bench::run_body_bench(scene_of(scenes::make_covered_organ(4, 0.9))),
                  std::invalid_argument);
}
