// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/model/tissue_model.h"
#include "refusal.h"
#include "scenes/hyperelastic_solids.h"

using namespace palpate;
using doctest::Approx;
using scenes::FiniteLaw;
using scenes::kFiniteLaws;

TEST_CASE("a solid at finite strain is the body of the solid, with another law") {
  const SolidMesh solid = scenes::make_round_block(3);
  const Material material;
  SolidOptions options;
  options.fixed = scenes::find_base(solid);
  options.stiffness_scale.assign(solid.vertices.size(), 2.0);
  options.nodal_share = 0.7;
  options.drag = 4.0;
  const TissueModel springs = build_solid(solid, material, options);
  const LameConstants lame = compute_lame_constants(material);
  for (const FiniteLaw& law : kFiniteLaws) {
    const TissueModel model = law.build(solid, material, options);
    const Hyperelastic& table = model.*law.table;

    CHECK(model.mass == springs.mass);
    CHECK(model.fixed == springs.fixed);
    CHECK(model.triangles == springs.triangles);
    CHECK(model.drag == 4.0);
    CHECK(model.springs.ends.empty());
    CHECK(model.volumes.corners.empty());
    CHECK(table.shear[0] == Approx(2.0 * lame.mu));
    CHECK(table.lame[0] == Approx(2.0 * lame.lambda));
    CHECK(table.nodal_share == 0.7);
    CHECK(list_tetrahedra(model) == solid.tetrahedra);
    CHECK(describe(model).find(std::string(law.name) + ", 162 tetrahedra") != std::string::npos);
  }
}

TEST_CASE("the viscosity of a tetrahedron is what the links along its edges have") {
  // a lone corner: a quarter of 1060/6e-6 kg in each particle, three edges of 10 mm, three of 14.1
  const SolidMesh corner{{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}}, {{0, 1, 2, 3}}};
  Material material;
  material.damping_ratio = 0.5;
  const double mu = compute_lame_constants(material).mu, volume = 1e-6 / 6.0;
  const double reduced = 0.125 * material.density * volume;
  // c/k = 2 zeta sqrt(m/k), k = 5/2 mu V/L²
  const auto link_time = [&](double length) {
    return std::sqrt(reduced / (2.5 * mu * volume / (length * length)));
  };
  const double time = 0.5 * (link_time(0.01) + link_time(0.01 * std::sqrt(2.0)));
  for (const FiniteLaw& law : kFiniteLaws) {
    const TissueModel model = law.build(corner, material, {});
    CHECK((model.*law.table).viscosity[0] == Approx(mu * time));
  }
}

TEST_CASE("a table of a solid at finite strain that is not as it says is refused") {
  for (const FiniteLaw& law : kFiniteLaws) {
    const TissueModel good = scenes::make_finite_organ(law, 2, 0.9);
    const auto refusal_of = [&](auto spoil) {
      TissueModel model = good;
      spoil(model.*law.table);
      return find_refusal([&] { validate(model); });
    };
    const std::string table = law.table == &TissueModel::corotated ? "corotated" : "neo_hookean";

    CHECK(refusal_of([](Hyperelastic& h) { h.shear[3] = 0.0; }) ==
          "model: " + table + ".shear: row 3: got 0 Pa, expected a positive number");
    CHECK(refusal_of([](Hyperelastic& h) {
            std::swap(h.corners[0][0], h.corners[0][1]);
          }).find("model: " + table + ".corners: row 0: got a volume of -") == 0);
    CHECK(refusal_of([](Hyperelastic& h) { h.around[0] = 7; }) ==
          "model: " + table +
              ".around: got other tables than the corners give, expected those of "
              "build_hyperelastic");
  }
}
