// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/model/tissue_model.h"
#include "refusal.h"
#include "scenes/solids.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// [J/m³] that a body stores when all of it is strained alike, from its tangent at rest.
double compute_density(const TissueModel& model, const Mat3& strain) {
  Eigen::VectorXd u(3 * particle_count(model));
  double volume = 0.0;
  for (int i = 0; i < particle_count(model); ++i) {
    u.segment<3>(3 * i) = strain * model.rest_position[i];
  }
  for (const double v : model.volumes.rest_volume) volume += v;
  return 0.5 * u.dot(compute_stiffness(model, model.rest_position, Projection::none) * u) / volume;
}

double exact_density(const Material& material, const Mat3& strain) {
  const auto [lambda, mu] = compute_lame_constants(material);
  return 0.5 * lambda * strain.trace() * strain.trace() + mu * strain.squaredNorm();
}

}  // namespace

TEST_CASE("the springs of a tetrahedron have 5/2 mu V / L² and its volume has lambda - mu") {
  const SolidMesh corner{{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}}, {{0, 1, 2, 3}}};
  // E = 3 kPa, nu = 0.25: lambda = mu = 1.2 kPa; V = 1e-6/6 m³
  const Material material{.density = 1200.0, .young_modulus = 3e3, .poisson_ratio = 0.25};

  const TissueModel model = build_solid(corner, material);

  CHECK(model.mass[0] == Approx(1200.0 * 1e-6 / 24.0));
  CHECK(model.springs.ends.size() == 6);
  CHECK(model.springs.stiffness[0] == Approx(2.5 * 1.2e3 * (1e-6 / 6.0) / 1e-4));
  CHECK(model.springs.stiffness[5] == Approx(2.5 * 1.2e3 * (1e-6 / 6.0) / 2e-4));
  CHECK(model.volumes.bulk[0] == Approx(0.0));
  CHECK(model.triangles.size() == 4);
}

TEST_CASE("a block answers a change of volume as its material does, at every nodal share") {
  for (const double nu : {0.25, 0.35, 0.45, 0.49}) {
    for (const double share : {0.0, 0.5, 1.0}) {
      Material material{.young_modulus = 5e3, .poisson_ratio = nu};
      const TissueModel model = build_solid(scenes::make_block({0.02, 0.02, 0.02}, {6, 6, 6}),
                                            material, {.nodal_share = share});
      const Mat3 dilation = Mat3::Identity();

      // all lengths change alike, so the springs are exact too: (5/2 mu 6 / 2 + 9/2 (lambda - mu))
      CHECK(compute_density(model, dilation) ==
            Approx(exact_density(material, dilation)).epsilon(1e-9));
    }
  }
}

TEST_CASE("averaged over the axes a block answers shear as its material does" *
          doctest::test_suite("landing")) {
  const Material material{.young_modulus = 5e3, .poisson_ratio = 0.45};
  const TissueModel model =
      build_solid(scenes::make_block({0.02, 0.02, 0.02}, {6, 6, 6}), material);
  // the mean over all rotations of a strain, by 24 turned at random but always the same
  double found = 0.0, expected = 0.0;
  for (std::uint32_t r = 0; r < 400; ++r) {
    const Quaternion turn = Quaternion(scenes::scatter(4 * r), scenes::scatter(4 * r + 1),
                                       scenes::scatter(4 * r + 2), scenes::scatter(4 * r + 3))
                                .normalized();
    Mat3 shear = Mat3::Zero();
    shear(0, 1) = shear(1, 0) = 1.0;
    shear = turn * shear * turn.conjugate();
    found += compute_density(model, shear);
    expected += exact_density(material, shear);
  }

  CHECK(found == Approx(expected).epsilon(0.02));
}

TEST_CASE("what cannot be built as a solid is refused with the range") {
  const SolidMesh solid = scenes::make_block({0.02, 0.02, 0.02}, {1, 1, 1});
  const auto refusal = [&](Material material, SolidOptions options = {}) {
    return find_refusal([&] { build_solid(solid, material, options); });
  };

  CHECK(refusal({.poisson_ratio = 0.2}) ==
        "material: poisson_ratio: got 0.2, expected 0.25 to 0.49 for a solid");
  CHECK(refusal({.poisson_ratio = 0.5}) ==
        "material: poisson_ratio: got 0.5, expected 0.25 to 0.49 for a solid");
  CHECK(refusal({.wall_thickness = 2e-3}) ==
        "material: wall_thickness: got 2 mm, expected none: a solid is filled");
  CHECK(refusal({}, {.nodal_share = 1.5}) == "options: nodal_share: got 1.5, expected 0 to 1");
  CHECK(refusal({}, {.stiffness_scale = {1.0}}) ==
        "options: stiffness_scale: got 1 rows, expected none, or one per vertex: 8");
  CHECK(refusal({}, {.fixed = {8}}) == "options: fixed: row 0: got vertex 8, expected 0 to 7");
}

TEST_CASE("stiffness painted on half a block makes that half stiffer and nothing else") {
  const SolidMesh solid = scenes::make_block({0.04, 0.02, 0.02}, {4, 2, 2});
  SolidOptions options;
  for (const Vec3& x : solid.vertices) options.stiffness_scale.push_back(x.x() > 0.001 ? 3.0 : 1.0);

  const TissueModel plain = build_solid(solid, {}), painted = build_solid(solid, {}, options);

  for (std::size_t l = 0; l < plain.springs.ends.size(); ++l) {
    const auto [i, j] = plain.springs.ends[l];
    const double left = std::max(solid.vertices[i].x(), solid.vertices[j].x());
    const double right = std::min(solid.vertices[i].x(), solid.vertices[j].x());
    const double part = painted.springs.stiffness[l] / plain.springs.stiffness[l];
    if (left < -0.005) CHECK(part == Approx(1.0));
    if (right > 0.015) CHECK(part == Approx(3.0));
  }
}

TEST_CASE("a skin is where its surface was, inside of a tetrahedron or outside of the nearest") {
  const SolidMesh solid = scenes::make_round_block(4);
  const SurfaceMesh inner = scenes::make_ellipsoid({0.02, 0.02, 0.02}, 3);
  const SurfaceMesh outer = scenes::make_ellipsoid({0.048, 0.034, 0.029}, 3);
  for (const SurfaceMesh& surface : {inner, outer}) {
    const TissueModel model = cover_with_skin(build_solid(solid, {}), surface);
    const Vec3Array skin = compute_surface(model, model.rest_position);

    CHECK(model.triangles == surface.triangles);
    CHECK(scenes::max_difference(skin, surface.vertices) < 1e-15);
    for (const auto& w : model.skin.weights) {
      CHECK(w[0] + w[1] + w[2] + w[3] == Approx(1.0).epsilon(1e-14));
      const double smallest = *std::min_element(w.begin(), w.end());
      CHECK(smallest >= (&surface == &inner ? -1e-12 : -1.0));
    }
  }
}

TEST_CASE("a skin moves with its solid as one body, turned and stretched") {
  const TissueModel model = scenes::make_covered_organ(3, 0.9);
  Mat3 change;
  change << 1.1, 0.2, 0.0, -0.1, 0.9, 0.3, 0.0, 0.1, 1.2;
  const Vec3 shift(0.01, 0.02, 0.03);
  Vec3Array x = model.rest_position, expected = compute_surface(model, x);
  for (Vec3& p : x) p = change * p + shift;
  for (Vec3& p : expected) p = change * p + shift;

  CHECK(scenes::max_difference(compute_surface(model, x), expected) < 1e-15);
}

TEST_CASE("a surface far from the tetrahedra is refused, naming the vertex") {
  const TissueModel model = build_solid(scenes::make_block({0.02, 0.02, 0.02}, {2, 2, 2}), {});
  SurfaceMesh far = scenes::make_ellipsoid({0.008, 0.008, 0.008}, 1);
  far.vertices[7] = {0.0, 0.0, 0.08};

  const std::string refusal = find_refusal([&] { cover_with_skin(model, far); });

  CHECK(refusal.find("skin: vertex 7: got outside by ") == 0);
  CHECK(refusal.find("expected at most 1: fill with smaller cells") != std::string::npos);
}

TEST_CASE("volumes and skins that do not fit are refused, naming table and row") {
  const TissueModel good = scenes::make_covered_organ(2, 0.5);
  const auto refusal = [&](auto damage) {
    TissueModel model = good;
    damage(model);
    return find_refusal([&] { validate(model); });
  };

  CHECK(refusal([](TissueModel& m) {
          m.volumes.corners[3][1] = m.volumes.corners[3][0];
        }).find("model: volumes.corners: row 3: got") == 0);
  CHECK(refusal([](TissueModel& m) { m.volumes.rest_volume[2] = 0.0; }) ==
        "model: volumes.rest_volume: row 2: got 0 m³, expected a positive number");
  CHECK(refusal([](TissueModel& m) { m.volumes.bulk[1] = -1.0; }) ==
        "model: volumes.bulk: row 1: got -1 Pa, expected 0 or a positive number");
  CHECK(refusal([](TissueModel& m) { m.volumes.around[0] = 5; }).find("model: volumes.around") ==
        0);
  CHECK(refusal([](TissueModel& m) { m.volumes.nodal_share = 2.0; }) ==
        "model: volumes.nodal_share: got 2, expected 0 to 1");
  CHECK(refusal([](TissueModel& m) {
          std::swap(m.volumes.corners[0][0], m.volumes.corners[0][1]);
        }).find("model: volumes.corners: row 0: got a volume of -") == 0);
  CHECK(refusal([](TissueModel& m) { m.skin.weights[4][0] += 0.1; }) ==
        "model: skin.weights: row 4: got a sum of 1.1, expected 1");
  CHECK(refusal([](TissueModel& m) {
          m.skin.corners[4][0] = 100000;
        }).find("model: skin.corners: row 4: got") == 0);
  CHECK(refusal([](TissueModel& m) { m.pressure = 10.0; }) ==
        "model: pressure: got 10 Pa on a skin, expected 0: a solid has no inside for a pressure");
}
