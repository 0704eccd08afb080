// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/collision/private/stop.h"

using namespace palpate;

namespace {

constexpr double kDt = 1e-4;

/// Two particles of 1 g and 3 g.
struct Pair {
  Vec3Array position = {Vec3::Zero(), Vec3::UnitX()};
  Vec3Array velocity = {Vec3::Zero(), Vec3::Zero()};
  std::vector<double> inverse_mass = {1e3, 1e3 / 3.0};
};

CarriedPoint carry(std::initializer_list<double> parts) {
  CarriedPoint point;
  int index = 0;
  for (const double part : parts) {
    point.particle[point.count] = index++;
    point.part[point.count++] = part;
  }
  return point;
}

}  // namespace

TEST_CASE("a particle that has come through is put back on the surface and no longer falls") {
  Pair two;
  two.position[0] = {0.0, 0.0, -2e-4};
  two.velocity[0] = {0.5, 0.0, -2.0};
  const Vec3 impulse = stop_point(carry({1.0}), {Vec3::UnitZ(), 2e-4, 0.0}, kDt, two.inverse_mass,
                                  two.position, two.velocity);
  CHECK(two.position[0] == Vec3::Zero());
  CHECK(two.velocity[0] == Vec3(0.5, 0.0, 0.0));
  CHECK(impulse.isApprox(Vec3(0.0, 0.0, 2e-3)));  // 1 g from 2 m/s
}

TEST_CASE("what already comes out is put back and left its speed") {
  Pair two;
  two.velocity[0] = {0.0, 0.0, 1.0};
  const Vec3 impulse = stop_point(carry({1.0}), {Vec3::UnitZ(), 1e-4, 0.5}, kDt, two.inverse_mass,
                                  two.position, two.velocity);
  CHECK(two.position[0] == Vec3(0.0, 0.0, 1e-4));
  CHECK(two.velocity[0] == Vec3(0.0, 0.0, 1.0));
  CHECK(impulse == Vec3::Zero());
}

TEST_CASE(
    "friction takes of what is along the surface mu times what it stops, and no more than all") {
  Pair slides;
  slides.velocity[0] = {1.0, 0.0, -2.0};
  stop_point(carry({1.0}), {Vec3::UnitZ(), 0.0, 0.3}, kDt, slides.inverse_mass, slides.position,
             slides.velocity);
  CHECK(slides.velocity[0].x() == doctest::Approx(0.4));  // 1 - 0.3 * 2
  CHECK(slides.position[0].x() == doctest::Approx(-0.6 * kDt));

  Pair sticks;
  sticks.velocity[0] = {0.5, 0.0, -2.0};
  sticks.position[0] = kDt * sticks.velocity[0];
  stop_point(carry({1.0}), {Vec3::UnitZ(), 2.0 * kDt, 0.3}, kDt, sticks.inverse_mass,
             sticks.position, sticks.velocity);
  CHECK(sticks.velocity[0].norm() < 1e-15);
  CHECK(sticks.position[0].norm() < 1e-18);  // as if the step had not been
}

TEST_CASE("a point between particles is put back by them as their masses and weights say") {
  Pair two;
  two.velocity = {{0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}};
  const CarriedPoint point = carry({0.25, 0.75});
  const Vec3 before = point.sum_over(two.position);
  const Vec3 impulse = stop_point(point, {Vec3::UnitZ(), 1e-3, 0.0}, kDt, two.inverse_mass,
                                  two.position, two.velocity);
  CHECK((point.sum_over(two.position) - before).isApprox(Vec3(0.0, 0.0, 1e-3)));
  CHECK(point.sum_over(two.velocity).norm() < 1e-12);
  // 0.25²/1 g + 0.75²/3 g = 250 1/kg; each gets its weight of the impulse, over its mass
  CHECK(impulse.z() == doctest::Approx(1.0 / 250.0));
  CHECK(two.velocity[0].z() == doctest::Approx(-1.0 + 0.25 * 1e3 / 250.0));
  CHECK(two.velocity[1].z() == doctest::Approx(-1.0 + 0.75 * 1e3 / 3.0 / 250.0));
}

TEST_CASE("what is held stays, and a point that nothing can move is left where it is") {
  Pair two;
  two.inverse_mass[0] = 0.0;
  const Vec3 first = two.position[0];
  stop_point(carry({0.5, 0.5}), {Vec3::UnitZ(), 1e-3, 0.0}, kDt, two.inverse_mass, two.position,
             two.velocity);
  CHECK(two.position[0] == first);
  CHECK(two.position[1].z() == doctest::Approx(2e-3));
  CHECK(stop_point(carry({1.0}), {Vec3::UnitZ(), 1e-3, 0.0}, kDt, two.inverse_mass, two.position,
                   two.velocity) == Vec3::Zero());
  CHECK(two.position[0] == first);
}

TEST_CASE("a vertex of a skin is carried by each of its particles once") {
  TissueModel tissue;
  tissue.skin.corners = {{0, 1, 2, 3}, {2, 3, 4, 5}};
  tissue.skin.weights = {{0.4, 0.3, 0.2, 0.1}, {0.1, 0.2, 0.3, 0.4}};
  CarriedPoint point;
  point.add(tissue, 0, 0.5);
  point.add(tissue, 1, 0.5);
  REQUIRE(point.count == 6);
  CHECK(point.part[2] == doctest::Approx(0.15));
  CHECK(point.part[3] == doctest::Approx(0.15));
}
