// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/contact/contact_law.h"

using namespace palpate;

TEST_CASE("a contact pushes with pressure times area times the barrier, from the point touched") {
  const Tool tool{.radius = 0.003, .stiffness = 2e7};
  const Vec3 a(0, 0, 0), b(0.004, 0, 0), c(0, 0.004, 0);
  Contact contact;

  // depth 1 mm of radius 3 mm: z = 2/3, k = 2e7 x 8e-6 = 160 N/m
  REQUIRE(find_contact(tool, 8e-6, {0.001, 0.001, 0.002}, a, b, c, contact));
  CHECK(contact.force == doctest::Approx(160.0 * 0.001 / (2.0 / 3.0)));
  CHECK(contact.stiffness == doctest::Approx(160.0 / (4.0 / 9.0)));
  CHECK(contact.direction == Vec3(0, 0, 1));
  CHECK(contact.weights.isApprox(Vec3(0.5, 0.25, 0.25)));

  // depth 2.9 mm: 1 - d/r = 1/30 lies under the floor
  REQUIRE(find_contact(tool, 8e-6, {0.001, 0.001, 0.0001}, a, b, c, contact));
  CHECK(contact.force == doctest::Approx(160.0 * 0.0029 / 0.1));

  // beside the corner b: 0.5 mm of depth along 3-0-4
  REQUIRE(find_contact(tool, 8e-6, {0.0055, 0, 0.002}, a, b, c, contact));
  CHECK(contact.direction.isApprox(Vec3(0.6, 0, 0.8)));
  CHECK(contact.weights == Vec3(0, 1, 0));
  CHECK(contact.force == doctest::Approx(160.0 * 0.0005 / (5.0 / 6.0)));
}

TEST_CASE("a triangle seen ever more edge-on fades to nothing, without a jump") {
  const Tool tool{.radius = 0.003, .stiffness = 2e7};
  const Vec3 a(0, 0, 0), b(0.004, 0, 0), c(0, 0.004, 0);
  // 2 mm beside the corner b, at this sine above the plane
  const auto force_at = [&](double sine) {
    Contact contact;
    const Vec3 arm(std::sqrt(1.0 - sine * sine), 0, sine);
    const bool found = find_contact(tool, 8e-6, b + 0.002 * arm, a, b, c, contact);
    return found ? contact.force : 0.0;
  };
  const double full = 160.0 * 0.001 / (2.0 / 3.0);

  CHECK(force_at(0.5) == doctest::Approx(full));
  CHECK(force_at(0.25) == doctest::Approx(full));
  CHECK(force_at(0.125) == doctest::Approx(0.5 * full));
  CHECK(force_at(1e-6) == doctest::Approx(4e-6 * full));
  CHECK(force_at(0.0) == 0.0);
  CHECK(force_at(-0.1) == 0.0);
}

TEST_CASE("what only meets, stands off or lies behind is no contact") {
  const Tool tool{.radius = 0.003, .stiffness = 2e7};
  const Vec3 a(0, 0, 0), b(0.004, 0, 0), c(0, 0.004, 0);
  Contact contact;

  CHECK_FALSE(find_contact(tool, 8e-6, {0.001, 0.001, 0.0031}, a, b, c, contact));
  CHECK_FALSE(find_contact(tool, 8e-6, {0.001, 0.001, 0.003}, a, b, c, contact));
  CHECK_FALSE(find_contact(tool, 8e-6, {0.001, 0.001, -0.001}, a, b, c, contact));
}

TEST_CASE("the stiffness of a contact is the slope of its force above the barrier's floor") {
  const Tool tool{.radius = 0.003, .stiffness = 2e7};
  const Vec3 a(-0.1, -0.1, 0), b(0.2, -0.1, 0), c(-0.1, 0.2, 0);
  const double h = 1e-8;
  for (const double height : {0.0029, 0.002, 0.001, 0.0005}) {
    Contact here, up, down;
    REQUIRE(find_contact(tool, 1e-6, {0, 0, height}, a, b, c, here));
    REQUIRE(find_contact(tool, 1e-6, {0, 0, height + h}, a, b, c, up));
    REQUIRE(find_contact(tool, 1e-6, {0, 0, height - h}, a, b, c, down));
    CHECK((down.force - up.force) / (2.0 * h) == doctest::Approx(here.stiffness).epsilon(1e-5));
  }
}
