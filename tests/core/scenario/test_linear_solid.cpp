// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstring>

#include "palpate/sim/base/error.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/linear_solids.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

Scenario make_linear_scenario() {
  Scenario made;
  made.title = "Linear";
  made.scene.bodies[0].tissue =
      limit_reach(scenes::make_covered_linear_organ(3, 0.25, 0.2), {0, 1, 2, 3, 4});
  made.scene.gravity = {0.0, 0.0, -9.81};
  made.scene = build_scene(std::move(made.scene));
  return made;
}

/// The sentence with which a file is refused of which one number of a table is another.
template <class Number>
std::string refuse_with(const std::string& table, std::size_t index, Number number) {
  Container changed = scenario::pack(make_linear_scenario());
  auto& bytes = changed.arrays.at("scene/bodies/0/tissue/elastic/" + table).bytes;
  REQUIRE((index + 1) * sizeof(number) <= bytes.size());
  std::memcpy(bytes.data() + index * sizeof(number), &number, sizeof(number));
  try {
    scenario::unpack(std::move(changed), "file");
  } catch (const FileError& refusal) {
    return refusal.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a linear solid comes back with every number, and its response is solved for again") {
  const Scenario made = make_linear_scenario();

  const Scenario found = scenario::unpack(scenario::pack(made), "file");

  const Elastic &one = made.scene.bodies[0].tissue.elastic,
                &other = found.scene.bodies[0].tissue.elastic;
  CHECK(other.corners == one.corners);
  CHECK(other.lame == one.lame);
  CHECK(other.shear == one.shear);
  CHECK(other.around == one.around);
  CHECK(other.reach == one.reach);
  CHECK(other.nodal_share == 0.25);
  CHECK(other.damping_time == one.damping_time);
  CHECK(found.scene.bodies[0].kernel == Kernel::response);
  CHECK(found.scene.bodies[0].response->compliance == made.scene.bodies[0].response->compliance);
  CHECK(found.scene.bodies[0].response->sag == made.scene.bodies[0].response->sag);
}

TEST_CASE("what is felt of a linear solid that comes back is the same to the bit") {
  const Scenario made = make_linear_scenario();
  const Scenario found = scenario::unpack(scenario::pack(made), "file");
  World one(made.scene), other(found.scene);
  HapticSample hand;

  double force = 0.0;
  for (int i = 0; i < 200; ++i) {
    hand.position = {0.0, 0.0, 0.031 - 3e-5 * i};
    force = tick(made.scene, hand, 1e-3, one).force.z();
    tick(found.scene, hand, 1e-3, other);
  }

  CHECK(force > 0.01);
  CHECK(compute_hash(one) == compute_hash(other));
}

TEST_CASE("a damaged table of a linear solid is refused, table and row named") {
  CHECK(contains(refuse_with("corners", 4, 4200), "elastic/corners: row 1: got particle 4200"));
  CHECK(contains(refuse_with("corners", 4, -1), "elastic/corners: row 1: got particle -1"));
  CHECK(contains(refuse_with("lame", 3, -2.0), "elastic.lame: row 3: got -2 Pa"));
  CHECK(contains(refuse_with("shear", 0, 0.0), "elastic/shear: row 0: got 0, expected"));
  CHECK(contains(refuse_with("reach", 0, 4200), "elastic.reach: row 0: got particle 4200"));
  CHECK(contains(refuse_with("reach", 1, 0), "elastic.reach: row 1: got particle 0"));
}

TEST_CASE("a linear solid that nothing holds is refused as a file, as it is as a scene") {
  Container loose = scenario::pack(make_linear_scenario());
  Array& fixed = loose.arrays.at("scene/bodies/0/tissue/fixed");
  fixed.bytes.clear();
  fixed.shape = {0};

  std::string refusal;
  try {
    scenario::unpack(std::move(loose), "file");
  } catch (const FileError& problem) {
    refusal = problem.what();
  }

  CHECK(contains(refusal, "linear solid: fixed: got a body that can move"));
}
