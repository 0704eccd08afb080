// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/wall_layer.h"
#include "scenes/scenes.h"
#include "scenes/walls.h"

using namespace palpate;

namespace {

constexpr double kYoung = 100e3, kPoisson = 0.45;                  // [Pa], [-]
constexpr double kModulus = kYoung / (1.0 - kPoisson * kPoisson);  ///< [Pa]

double bend(double thickness) { return kModulus * std::pow(thickness, 3) / 12.0; }

/** Reissner's shallow sphere: sqrt(3 (1 - nu²)) R/(4 E h²) under a point [Reissner46]. */
void check_thin_sphere(int subdivisions) {
  const double radius = 0.05, thickness = 1e-3;
  const double known = std::sqrt(3.0 * (1.0 - kPoisson * kPoisson)) * radius /
                       (4.0 * kYoung * thickness * thickness);
  const TissueModel model =
      scenes::make_sphere_wall(radius, subdivisions, thickness, kYoung, kPoisson);
  const NearField near = build_near_field(model, kModulus, 0.003);
  double sum = 0.0, count = 0.0;
  for (std::size_t v = 0; v < near.far_compliance.size() / 2; ++v, ++count) {
    sum += near.far_compliance[v];
  }
  CHECK(sum / count == doctest::Approx(known).epsilon(0.10));
}

}  // namespace

TEST_CASE("a thin plate on a foundation sinks as P l²/(8 D) under a point, prisms and tissue") {
  const WallLayer wall{kModulus, kYoung, 1e-4, 1.0};
  for (const double length : {0.01, 0.03}) {
    CAPTURE(length);
    const double plate = bend(wall.thickness), foundation = plate / std::pow(length, 4);
    const double known = length * length / (8.0 * plate);
    const double point = 1e-6 * length * length;
    CHECK(compute_prism_compliance(wall, point, foundation) ==
          doctest::Approx(known).epsilon(0.01));
    CHECK(compute_point_excess(wall, foundation) == doctest::Approx(known).epsilon(0.01));
  }
}

TEST_CASE("a wall twice as large in all its lengths gives way half as far") {
  const WallLayer small{kModulus, kYoung, 2e-3, 0.8}, large{kModulus, kYoung, 4e-3, 0.8};
  // a foundation goes as one over a length
  CHECK(compute_point_excess(large, 1e6) ==
        doctest::Approx(0.5 * compute_point_excess(small, 2e6)).epsilon(0.002));
  CHECK(compute_prism_compliance(large, 64e-6, 1e6) ==
        doctest::Approx(0.5 * compute_prism_compliance(small, 16e-6, 2e6)).epsilon(0.002));
}

TEST_CASE("under a patch wider than it is thick, tissue and prisms give way alike") {
  const WallLayer wall{kModulus, kYoung, 2e-3, 1.0};
  // of a bell of this spread a half space has (1/E*) sqrt(1/(pi spread))
  const double spread = std::pow(8e-3, 2), foundation = 2e5;
  const double length = std::pow(bend(2e-3) / foundation, 0.25);
  const double prisms = compute_prism_compliance(wall, spread, foundation);
  CHECK(prisms < 0.9 * length * length / (8.0 * bend(2e-3)));
  CHECK(prisms > 0.3 * length * length / (8.0 * bend(2e-3)));
}

TEST_CASE("on what gives way in proportion, the depth of a press solves its equation") {
  for (const double more : {0.0, 0.01, 0.3, 20.0}) {
    const LocalPress press{kModulus, 0.003, 50.0, 0.0};
    for (const double depth : {1e-7, 1e-4, 1e-3, 5e-3}) {
      CAPTURE(more);
      CAPTURE(depth);
      const double s = press.find_depth_on(depth, more);
      CHECK(s + more * press.compute_force(s) == doctest::Approx(depth).epsilon(1e-9));
    }
  }
  CHECK(LocalPress{kModulus, 0.003, 0.0, 0.0}.find_depth_on(0.0, 1.0) == 0.0);
}

/** Clamped all around: F a²/(16 pi D) in the middle [Timoshenko59]. */
TEST_CASE("the far compliance in the middle of a thin round plate is that of its bending") {
  const double radius = 0.03, thickness = 1e-3;
  const double known = radius * radius / (16.0 * std::numbers::pi * bend(thickness));
  for (const double edge : {0.002, 0.003, 0.006}) {
    CAPTURE(edge);
    const NearField near = build_near_field(
        scenes::make_round_plate(radius, edge, thickness, kYoung, kPoisson), kModulus, 0.003);
    CHECK(near.wall_thickness == doctest::Approx(thickness).epsilon(1e-9));
    CHECK(near.far_compliance[0] == doctest::Approx(known).epsilon(0.05));
  }
}

TEST_CASE("the far compliance of a thin sphere is Reissner's") { check_thin_sphere(3); }

TEST_CASE("the far compliance of a thin sphere is Reissner's on smaller triangles too" *
          doctest::test_suite("landing")) {
  check_thin_sphere(4);
}
