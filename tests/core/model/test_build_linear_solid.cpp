// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/tissue_model.h"
#include "refusal.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using doctest::Approx;

TEST_CASE("a linear solid stores what its material does, in every uniform strain") {
  const Material material;
  const auto [lambda, mu] = compute_lame_constants(material);
  const SolidMesh solid = scenes::make_round_block(3);
  for (const double share : {0.0, 0.9}) {
    const TissueModel model = build_linear_solid(solid, material, {.nodal_share = share});
    for (const int seed : {1, 2, 3}) {
      Mat3 strain;
      for (int k = 0; k < 9; ++k) strain(k / 3, k % 3) = scenes::scatter(9 * seed + k);
      strain = 0.5 * (strain + strain.transpose()).eval();
      Eigen::VectorXd u(3 * particle_count(model));
      for (int i = 0; i < particle_count(model); ++i) {
        u.segment<3>(3 * i) = strain * model.rest_position[i];
      }

      const double stored =
          0.5 * u.dot(compute_stiffness(model, model.rest_position, Projection::none) * u);

      CHECK(stored / compute_volume(solid) ==
            Approx(mu * strain.squaredNorm() + 0.5 * lambda * strain.trace() * strain.trace()));
    }
  }
}

TEST_CASE("a linear solid is the body of the solid, with another law") {
  const SolidMesh solid = scenes::make_round_block(3);
  const Material material;
  SolidOptions options;
  options.fixed = scenes::find_base(solid);
  options.stiffness_scale.assign(solid.vertices.size(), 2.0);

  const TissueModel model = build_linear_solid(solid, material, options);
  const TissueModel springs = build_solid(solid, material, options);

  CHECK(model.mass == springs.mass);
  CHECK(model.fixed == springs.fixed);
  CHECK(model.triangles == springs.triangles);
  CHECK(model.elastic.shear[0] == Approx(2.0 * compute_lame_constants(material).mu));
  CHECK(describe(model).find("linear, 162 tetrahedra") != std::string::npos);
}

TEST_CASE("the damping time is that of a shear wave on its way along an edge") {
  // one edge of a kind: 10 mm thrice and 14.1 mm thrice; mu = 1.72 kPa, 0.785 s/m
  const SolidMesh corner{{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}}, {{0, 1, 2, 3}}};
  Material material;
  material.damping_ratio = 0.5;

  const TissueModel model = build_linear_solid(corner, material);

  const double edge = 0.01 * (1.0 + std::sqrt(2.0)) / 2.0;
  CHECK(model.elastic.damping_time ==
        Approx(edge * std::sqrt(1060.0 / compute_lame_constants(material).mu)));
}

TEST_CASE("the reach of pushes is that of the particles that carry a vertex") {
  const TissueModel bare = scenes::make_linear_organ(2, 0.9);
  const TissueModel covered = scenes::make_covered_linear_organ(2, 0.9);

  CHECK(limit_reach(bare, {26, 24, 26}).elastic.reach == std::vector<int>{24, 26});
  std::vector<int> carriers(covered.skin.corners[5].begin(), covered.skin.corners[5].end());
  std::sort(carriers.begin(), carriers.end());
  CHECK(limit_reach(covered, {5}).elastic.reach == carriers);
}

TEST_CASE("a reach that is none is refused with a sentence") {
  const TissueModel model = scenes::make_linear_organ(2, 0.9);

  CHECK(find_refusal([&] { limit_reach(model, {}); }) ==
        "reach: surface_vertices: got none, expected at least one");
  CHECK(find_refusal([&] {
          limit_reach(model, {3, 27});
        }) == "reach: surface_vertices: row 1: got vertex 27, expected 0 to 26");
  CHECK(find_refusal([&] { limit_reach(scenes::make_solid_organ(2, 0.0), {0}); }) ==
        "reach: model: got another law, expected a linear solid, as build_linear_solid makes it");
}

TEST_CASE("a table of a linear solid that is not as it says is refused") {
  const TissueModel good = scenes::make_linear_organ(2, 0.9);
  const auto refusal_of = [&](auto spoil) {
    TissueModel model = good;
    spoil(model);
    return find_refusal([&] { validate(model); });
  };

  CHECK(refusal_of([](TissueModel& m) { m.elastic.shear[3] = 0.0; }) ==
        "model: elastic.shear: row 3: got 0 Pa, expected a positive number");
  CHECK(refusal_of([](TissueModel& m) { m.elastic.lame[2] = -1.0; }) ==
        "model: elastic.lame: row 2: got -1 Pa, expected 0 or a positive number");
  CHECK(refusal_of([](TissueModel& m) { m.elastic.lame.pop_back(); }) ==
        "model: elastic.lame: got 47 rows, expected 48");
  CHECK(refusal_of([](TissueModel& m) {
          std::swap(m.elastic.corners[0][0], m.elastic.corners[0][1]);
        }).find("model: elastic.corners: row 0: got a volume of -") == 0);
  CHECK(refusal_of([](TissueModel& m) { m.elastic.nodal_share = 1.5; }) ==
        "model: elastic.nodal_share: got 1.5, expected 0 to 1");
  CHECK(refusal_of([](TissueModel& m) { m.elastic.damping_time = -1.0; }) ==
        "model: elastic.damping_time: got -1 s, expected 0 or a positive number");
  CHECK(refusal_of([](TissueModel& m) {
          m.elastic.reach = {4, 4};
        }) == "model: elastic.reach: row 1: got particle 4, expected ascending particles, 0 to 26");
  CHECK(refusal_of([](TissueModel& m) {
          m.elastic.around[0] = 7;
        }).find("model: elastic.around: got other tables") == 0);
  CHECK(refusal_of([](TissueModel& m) { m.pressure = 10.0; }) ==
        "model: elastic: got a pressure beside it, expected no other law");
  CHECK(refusal_of([](TissueModel& m) { m.springs = scenes::make_solid_organ(2, 0.0).springs; }) ==
        "model: elastic: got springs beside it, expected no other law");
}
