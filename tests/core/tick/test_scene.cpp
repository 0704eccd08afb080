// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/tick/press_scene.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/tick/scene.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

std::string refusal(const std::function<void(Scene&)>& spoil) {
  Scene scene = press_scene();
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
  spoil(scene);
  try {
    build_scene(std::move(scene));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool names(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("a built scene has as many substeps as its tissue needs at rest") {
  Scene scene = press_scene();
  const double needed = 1e-3 / stable_step(scene.bodies[0].tissue);

  CHECK(scene.bodies[0].substeps == std::max(1, static_cast<int>(std::ceil(needed))));

  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
  scene.rate = 100.0;
  CHECK(build_scene(scene).bodies[0].substeps == static_cast<int>(std::ceil(10.0 * needed)));
}

TEST_CASE("contact may raise the substeps by a third, and always to thirty-two") {
  Scene scene = press_scene();
  for (const auto& [substeps, most] : {std::pair(2, 32), {12, 32}, {24, 32}, {27, 36}, {30, 40}}) {
    scene.bodies[0].substeps = substeps;
    scene.bodies[0].substeps_max = 0;
    CHECK(build_scene(scene).bodies[0].substeps_max == most);
  }
}

TEST_CASE("a scene's own substeps are kept") {
  Scene scene = press_scene();
  scene.bodies[0].substeps = 7;
  scene.bodies[0].substeps_max = 7;

  scene = build_scene(std::move(scene));

  CHECK(scene.bodies[0].substeps == 7);
  CHECK(scene.bodies[0].substeps_max == 7);
}

TEST_CASE("the rest areas of a built scene sum to its surface") {
  const Scene scene = press_scene();
  const SurfaceMesh mesh{scene.bodies[0].tissue.rest_position, scene.bodies[0].tissue.triangles};

  const double sum =
      std::accumulate(scene.bodies[0].rest_areas.begin(), scene.bodies[0].rest_areas.end(), 0.0);

  CHECK(sum == doctest::Approx(compute_area(mesh)));
}

TEST_CASE("a scene that cannot run is refused by the name of the field") {
  const double nan = std::numeric_limits<double>::quiet_NaN();

  CHECK(names(refusal([](Scene& s) { s.instruments[0].tool.radius = 0.0; }), "tool.radius"));
  CHECK(names(refusal([&](Scene& s) { s.instruments[0].tool.stiffness = nan; }), "tool.stiffness"));
  CHECK(names(refusal([&](Scene& s) { s.instruments[0].tool.friction = nan; }), "tool.friction"));
  CHECK(names(refusal([](Scene& s) { s.instruments[0].tool.friction = -0.1; }), "tool.friction"));
  const auto with_pairs = [](double own, std::vector<double> pairs) {
    return refusal([&](Scene& s) {
      s.instruments[0].tool.friction = own;
      s.instruments[0].pair_friction = pairs;
    });
  };
  CHECK(
      names(with_pairs(0.3, {0.1, 0.1}), "pair_friction [-]: got 2 numbers, expected 1, one per"));
  CHECK(names(with_pairs(0.3, {-0.1}), "pair_friction [-]: got -0.1"));
  CHECK(names(with_pairs(0.3, {nan}), "pair_friction [-]: got nan"));
  CHECK(names(with_pairs(0.0, {0.1}), "pair_friction [-]: got 0.1, expected 0 for all with"));
  CHECK(names(refusal([](Scene& s) { s.instruments[0].coupling.stiffness = -1; }),
              "coupling.stiffness"));
  CHECK(names(refusal([](Scene& s) { s.instruments[0].coupling.force_max = 0; }),
              "coupling.force_max"));
  CHECK(names(refusal([](Scene& s) { s.instruments[0].hold_stiffness = 0; }), "hold_stiffness"));
  CHECK(names(refusal([&](Scene& s) { s.gravity.y() = nan; }), "gravity"));
  CHECK(names(refusal([](Scene& s) { s.rate = 0; }), "rate"));
  CHECK(names(refusal([](Scene& s) { s.bodies[0].substeps = -1; }), "substeps"));
  CHECK(names(refusal([](Scene& s) { s.bodies[0].substeps = 5, s.bodies[0].substeps_max = 4; }),
              "substeps_max"));
  CHECK(names(refusal([](Scene& s) { s.bodies[0].tissue.mass[3] = -1; }), "mass"));
  CHECK(names(refusal([](Scene& s) { s.bodies[0].tissue.triangles.clear(); }), "triangles"));
  CHECK(names(refusal([](Scene& s) { s.rate = 1e-3; }), "substeps"));
  CHECK(refusal([](Scene&) {}) == "");
}

TEST_CASE("a tissue that no tick has room for is refused with the part of it that one has") {
  const auto refuse_part = [](double part) {
    return refusal([part](Scene& s) {
      for (double& number : s.bodies[0].tissue.springs.stiffness) number *= part;
      for (double& number : s.bodies[0].tissue.springs.damping) number *= part;
      for (double& number : s.bodies[0].tissue.home) number *= part;
      s.rate = 0.01;
    });
  };
  const std::string told = refuse_part(1.0);
  REQUIRE(names(told, "at most 10000 substeps per tick, as this with 0."));
  const double part = std::stod(told.substr(told.find("as this with ") + 13));
  CHECK(refuse_part(part) == "");
  CHECK(names(refuse_part(1.15 * part), "scene: tissue: got one of 1"));
}

TEST_CASE("a world wants a scene that was built") {
  Scene scene;
  scene.bodies[0].tissue = press_scene().bodies[0].tissue;

  CHECK_THROWS_AS(World{scene}, std::invalid_argument);
}
