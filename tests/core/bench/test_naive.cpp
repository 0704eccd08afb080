// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/bench/bench.h"
#include "palpate/bench/naive.h"
#include "palpate/sim/dynamics/simd_targets.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/build_mass_spring.h"
#include "palpate/sim/model/build_molecular.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

Scene scene_of(TissueModel tissue) {
  Scene scene;
  scene.tissue = std::move(tissue);
  return build_scene(std::move(scene));
}

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

  const std::vector<std::string> expected = {
      "mss_step", "mss_dashpot_step", "mms_step", "mms_dashpot_step",
      "refit",    "segment",          "closest",  "sphere",
      "mss_tick", "mss_dashpot_tick", "mss_tick", "mss_dashpot_tick",
      "mms_tick", "mms_dashpot_tick", "mms_tick", "mms_dashpot_tick"};
  REQUIRE(rows.size() == expected.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    CHECK(rows[r].work == expected[r]);
    CHECK(rows[r].vertices == static_cast<int>(mass_spring.tissue.mass.size()));
    CHECK(rows[r].median > 0.0);
    CHECK(rows[r].p99 >= rows[r].median);
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

TEST_CASE("the bench refuses two scenes on different surfaces") {
  const Scene mass_spring = scene_of(build_mass_spring(organ(), Material{}, 40.0, at_home()));

  CHECK_THROWS_AS(bench::run_bench(mass_spring, mass_spring), std::invalid_argument);
}
