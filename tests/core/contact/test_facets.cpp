// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "palpate/sim/contact/private/facets.h"
#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "rigid_surface.h"

// How curved the facets under a ball are, and what a ball feels of them [contact: facets].

using namespace palpate;

namespace {

constexpr double kModulus = RigidSurface::kModulus;
constexpr double kCurvature = 40.0;  ///< [1/m]

/// A dome of 48 mm.
struct Dome : RigidSurface {
  Dome(double edge, double curvature, bool facets)
      : RigidSurface(0.048, edge, curvature, kCurvature) {
    if (facets) near.rest_position = x;
  }

  /// [N] What a ball feels at p.
  double press(const Tool& tool, const Vec3& p) { return press_at(tool, p).norm(); }
};

double press_half_space(double radius, double curvature, double depth) {
  return LocalPress{kModulus, radius, curvature, 0.0}.compute_force(depth);
}

}  // namespace

TEST_CASE("one facet has no curvature, and the two of a ridge that of their normals") {
  const Vec3Array rest = {{0, -1, 0}, {0, 1, 0}, {3, 0, -1.5}, {-3, 0, -1.5}};
  const Triangle right = {0, 2, 1}, left = {1, 3, 0};
  const Vec3 middle = Vec3::Constant(1.0 / 3.0);
  FacetSums one, two;
  one.add(2.0, right, middle, rest);
  one.add(1.0, right, {0.8, 0.1, 0.1}, rest);
  CHECK(one.covariance() == doctest::Approx(0.0));
  CHECK(one.curvature(1.0) == doctest::Approx(0.0));

  two.add(1.0, right, middle, rest);
  two.add(1.0, left, middle, rest);

  // normals (+-0.5, 0, 1)/sqrt(1.25), middles at x = +-1
  CHECK(two.covariance() == doctest::Approx(0.5 / std::sqrt(1.25)));
  CHECK(two.drop() == doctest::Approx(0.25 / std::sqrt(1.25)));
  CHECK(two.curvature(std::numbers::pi) == doctest::Approx(two.covariance() / 0.4));
}

TEST_CASE("a hollow is negatively curved, and its middle is no lower") {
  const Vec3Array rest = {{0, -1, 0}, {0, 1, 0}, {3, 0, 1.5}, {-3, 0, 1.5}};
  FacetSums two;
  two.add(1.0, {0, 2, 1}, Vec3::Constant(1.0 / 3.0), rest);
  two.add(1.0, {1, 3, 0}, Vec3::Constant(1.0 / 3.0), rest);

  CHECK(two.covariance() == doctest::Approx(-0.5 / std::sqrt(1.25)));
  CHECK(two.drop() == 0.0);
}

TEST_CASE("within one facet a ball feels a plane, whatever its vertices say") {
  const Tool tool{.radius = 0.008, .stiffness = 3e7};
  const Vec3 p(0.004, -0.004, tool.radius - 0.001);  // in the middle of a triangle of 24 mm
  Dome plane(0.024, 0.0, true), rounded(0.024, 0.0, false);

  CHECK(plane.press(tool, p) == doctest::Approx(press_half_space(0.008, 0.0, 0.001)).epsilon(0.01));
  CHECK(rounded.press(tool, p) < 0.9 * plane.press(tool, p));
}

TEST_CASE("of many facets a ball feels the sphere that they stand for, from its highest point on") {
  for (const double radius : {0.003, 0.008}) {
    const Tool tool{.radius = radius, .stiffness = 3e7};
    Dome dome(0.00075, kCurvature, true), before(0.00075, kCurvature, false);
    for (const double depth : {0.1 * radius, 0.2 * radius}) {
      const Vec3 p(0.0, 0.0, radius - depth);
      const double known = press_half_space(radius, kCurvature, depth);
      CAPTURE(radius);
      CAPTURE(depth);
      CHECK(dome.press(tool, p) == doctest::Approx(known).epsilon(0.03));
      // the depth below the middle of the facets, and their curvature, counted both
      CHECK(before.press(tool, p) < (radius > 0.005 ? 0.9 : 0.97) * known);
    }
  }
}
