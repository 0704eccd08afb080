// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/collision/private/choose_barrier.h"
#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/model/build_surface.h"
#include "scenes/layers.h"

using namespace palpate;
using namespace palpate::scenes;

namespace {

TissueModel make_at(const Vec3& offset, double modulus = 5e3) {
  return make_soft_block({0.02, 0.02, 0.02}, {4, 4, 4}, modulus, offset, false);
}

}  // namespace

TEST_CASE("the modulus of a tissue is found from its constants") {
  const SolidMesh solid = make_block({0.02, 0.02, 0.02}, {4, 4, 4});
  Material material;
  material.young_modulus = 5e3;
  material.poisson_ratio = 0.4;
  CHECK(estimate_modulus(build_neo_hookean_solid(solid, material)) == doctest::Approx(5e3));
  CHECK(estimate_modulus(build_corotated_solid(solid, material)) == doctest::Approx(5e3));
  CHECK(estimate_modulus(build_linear_solid(solid, material)) == doctest::Approx(5e3));
  CHECK(estimate_modulus(build_solid(solid, material)) == doctest::Approx(5e3).epsilon(0.02));
}

TEST_CASE("a wall has the modulus of its thickness, within a factor of two") {
  const SurfaceMesh mesh = make_ellipsoid({0.030, 0.025, 0.020}, 3);
  Material material;
  material.young_modulus = 5e4;
  material.wall_thickness = 0.003;
  const double found = estimate_modulus(build_membrane_springs(mesh, material));
  CHECK(found > 2.5e4);
  CHECK(found < 1e5);
}

TEST_CASE("a barrier is as thick as edges ask for, from 0.3 to 0.5 mm") {
  const auto choose = [](double side) {
    const TissueModel block =
        make_soft_block({8 * side, 8 * side, 8 * side}, {8, 8, 8}, 5e3, Vec3::Zero(), false);
    return choose_thickness(block, block);
  };
  CHECK(choose(1e-3) == 3e-4);
  CHECK(choose(1e-2) == 5e-4);
  CHECK(choose(2.3e-3) > 3.5e-4);
  CHECK(choose(2.3e-3) < 4.5e-4);
}

TEST_CASE("how near two bodies begin is found, and how deep in each other") {
  const Nearest apart = find_nearest_at_rest(make_at(Vec3::Zero()), make_at({0, 0, 0.0202}), 1e-3);
  CHECK(apart.gap == doctest::Approx(2e-4));
  CHECK(apart.vertex >= 0);
  const Nearest in = find_nearest_at_rest(make_at(Vec3::Zero()), make_at({0.001, 0, 0.019}), 1e-3);
  CHECK(in.gap == doctest::Approx(-1e-3));
  CHECK(find_nearest_at_rest(make_at(Vec3::Zero()), make_at({0, 0, 0.05}), 1e-3).vertex == -1);
}

TEST_CASE("constants that are not given follow from the stiffer body") {
  BodyPair pair;
  choose_barrier("pair", make_at(Vec3::Zero()), make_at({0, 0, 0.0205}, 5e4), pair);
  CHECK(pair.thickness == 5e-4);
  CHECK(pair.stiffness == doctest::Approx(5e4 / (3.0 * 5e-4)).epsilon(0.02));
}
