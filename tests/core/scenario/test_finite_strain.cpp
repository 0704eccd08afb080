// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/tick/tick.h"
#include "scenes/hyperelastic_solids.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

Scenario make_finite_scenario(const scenes::FiniteLaw& law) {
  Scenario made;
  made.title = law.name;
  SoftBody& body = made.scene.bodies[0];
  body.tissue = cover_with_skin(scenes::make_finite_organ(law, 3, 0.25, {.damping_ratio = 0.2}),
                                scenes::make_ellipsoid({0.045, 0.032, 0.027}, 2));
  body.contact_modulus = 6270.0;
  made.scene = build_scene(std::move(made.scene));
  return made;
}

/// [N] in ticks that press into the top.
std::vector<double> press(const Scene& scene) {
  World world(scene);
  std::vector<double> forces;
  for (int i = 0; i < 300; ++i) {
    HapticSample hand;
    hand.position = {0.001, 0.002, 0.031 - 2e-5 * i};
    forces.push_back(tick(scene, hand, 1e-3, world).force.z());
  }
  return forces;
}

}  // namespace

TEST_CASE("a solid at finite strain comes back with every number, and presses as it did") {
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    const Scenario made = make_finite_scenario(law);

    const Scenario found = scenario::unpack(scenario::pack(made), "file");

    const Hyperelastic& one = made.scene.bodies[0].tissue.*law.table;
    const Hyperelastic& other = found.scene.bodies[0].tissue.*law.table;
    CHECK(other.corners == one.corners);
    CHECK(other.lame == one.lame);
    CHECK(other.shear == one.shear);
    CHECK(other.viscosity == one.viscosity);
    CHECK(other.around == one.around);
    CHECK(other.nodal_share == 0.25);
    CHECK(found.scene.bodies[0].kernel == Kernel::reference);
    const std::vector<double> forces = press(made.scene);
    CHECK(press(found.scene) == forces);
    CHECK(forces.back() > 0.005);
  }
}

TEST_CASE("a corner of a solid at finite strain that is no particle is refused with its row") {
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    Scenario made = make_finite_scenario(law);
    const std::string table = law.table == &TissueModel::corotated ? "corotated" : "neo_hookean";
    Container changed = scenario::pack(made);
    auto& bytes = changed.arrays.at("scene/bodies/0/tissue/" + table + "/corners").bytes;
    bytes[4 * 4 * 2 + 3] = static_cast<std::uint8_t>(0x7f);  // row 2, its first corner

    CHECK(contains(refusal([&] { scenario::unpack(changed, "file"); }),
                   "scene/bodies/0/tissue/" + table + "/corners: row 2: got particle "));
  }
}
