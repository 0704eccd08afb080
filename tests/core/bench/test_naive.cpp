// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "core/bench/scene_of.h"
#include "palpate/bench/bench.h"
#include "palpate/bench/naive.h"
#include "palpate/bench/naive_tree.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

SurfaceMesh organ() { return scenes::make_ellipsoid({0.05, 0.035, 0.03}, 2); }

SurfaceOptions at_home() {
  SurfaceOptions options;
  options.home_stiffness = 3e5;
  return options;
}

TissueModel molecular() {
  return build_molecular(organ(), Material{},
                         {.bond_stiffness = 40.0, .bend_stiffness = 1e-4, .stretch_coupling = 0.05},
                         at_home());
}

}  // namespace

TEST_CASE("the naive molecular step moves every particle as the kernel does") {
  const TissueModel model = molecular();
  State ours(model), naive(model);
  ours.position[7] += Vec3(0.001, -0.0005, 0.002);
  naive.position = ours.position;

  for (int s = 0; s < 50; ++s) {
    step(model, Load(), 1e-4, ours);
    bench::step_naively(model, Load(), 1e-4, naive);
  }

  for (std::size_t i = 0; i < ours.position.size(); ++i) {
    CHECK((ours.position[i] - naive.position[i]).norm() < 1e-12);
  }
}

TEST_CASE("the bench has one row for every piece of work, with positive figures") {
  const Scene mass_spring = scene_of(build_mass_spring(organ(), Material{}, 40.0, at_home()));
  const Scene mms = scene_of(molecular());

  const auto rows = bench::run_bench(mass_spring, mms, {.budget = 1e-3, .least_runs = 3});

  std::vector<std::string> expected = {
      "mss_step",         "mss_dashpot_step", "mms_step", "mms_dashpot_step", "refit",
      "segment",          "closest",          "sphere",   "mss_tick",         "mss_tick",
      "mss_dashpot_tick", "mss_dashpot_tick", "mms_tick", "mms_tick",         "mms_dashpot_tick",
      "mms_dashpot_tick", "active_step"};
  if (simd_targets().empty()) expected.pop_back();
  REQUIRE(rows.size() == expected.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    CHECK(rows[r].work == expected[r]);
    CHECK(rows[r].vertices == static_cast<int>(mass_spring.bodies[0].tissue.mass.size()));
    CHECK(rows[r].median > 0.0);
    CHECK(rows[r].ratio_to_naive > 0.0);
    CHECK(!rows[r].physics.empty());
    CHECK(!rows[r].compiler_flags.empty());
    CHECK(rows[r].ns_per_element() > 0.0);
    const bool ticks = rows[r].work.ends_with("_tick");
    CHECK((rows[r].substeps > 0) == ticks);
    if (ticks || rows[r].work.ends_with("_step")) {
      CHECK(rows[r].simd_target == (simd_targets().empty() ? "" : simd_targets().front()));
      CHECK(rows[r].share_of_bound < 1.0);
    }
  }
}

TEST_CASE("a textbook tree answers what looking at every triangle answers, moved as at rest") {
  const SurfaceMesh mesh = organ();
  bench::NaiveTree tree(mesh.vertices, mesh.triangles);
  Vec3Array x = mesh.vertices;
  for (Vec3& p : x) p += Vec3(0.3 * p.y(), 0.1 * p.z(), -0.2 * p.x());

  tree.refit(x);

  std::vector<int> found(mesh.triangles.size());
  for (std::size_t v = 0; v < x.size(); v += 7) {
    const Vec3 beside = 1.1 * x[v];
    double closest = 1.0;
    int within = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
      const double d =
          find_closest_on_triangle(beside, x[static_cast<std::size_t>(i)],
                                   x[static_cast<std::size_t>(j)], x[static_cast<std::size_t>(k)])
              .distance;
      closest = std::min(closest, d);
      within += d <= 0.01;
    }
    CHECK(tree.find_closest_point(x, beside)->distance == closest);
    CHECK(tree.find_in_sphere(x, beside, 0.01, found) == within);
    const Vec3 middle = (x[v] + 1e-3 * Vec3(1.0, 0.3, 0.7)) * 0.9;
    const auto hit = tree.find_segment_hit(x, beside, middle);
    REQUIRE(hit);
    CHECK((hit->point - hit->distance * (middle - beside).normalized() - beside).norm() < 1e-15);
  }
  CHECK_FALSE(tree.find_segment_hit(x, {0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}));
}

TEST_CASE("the bench does only the works asked for, at the substeps asked for") {
  const Scene mass_spring = scene_of(build_mass_spring(organ(), Material{}, 40.0, at_home()));
  const Scene mms = scene_of(molecular());
  bench::BenchOptions options{.budget = 1e-3, .least_runs = 3};
  options.works = {"mss_tick", "refit"};
  options.air_substeps = {1, 4, 10};
  options.press = false;

  const auto rows = bench::run_bench(mass_spring, mms, options);

  REQUIRE(rows.size() == 4);
  CHECK(rows[0].work == "refit");
  CHECK(rows[1].substeps == 1);
  CHECK(rows[2].substeps == 4);
  CHECK(rows[3].substeps == 10);
  options.works = {"mss_walk"};
  CHECK_THROWS_AS(bench::run_bench(mass_spring, mms, options), std::invalid_argument);
  options.works = {};
  options.air_substeps = {0};
  CHECK_THROWS_AS(bench::run_bench(mass_spring, mms, options), std::invalid_argument);
}

TEST_CASE("the bench refuses two scenes on different surfaces") {
  const Scene mass_spring = scene_of(build_mass_spring(organ(), Material{}, 40.0, at_home()));

  CHECK_THROWS_AS(bench::run_bench(mass_spring, mass_spring), std::invalid_argument);
}
