// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "rigid_surface.h"

// Contacts under a near field on a plane that gives nowhere: all of the dent is the near field's.

using namespace palpate;

namespace {

constexpr double kModulus = RigidSurface::kModulus;

/// A plane of 60 mm.
struct Plane : RigidSurface {
  explicit Plane(double edge) : RigidSurface(0.06, edge, 0.0, 0.0) {}

  /// [N] What a ball feels whose lowest point is `depth` [m] deep, and that is lifted by `lift`
  /// [m].
  Vec3 press(const Tool& tool, double x0, double y0, double depth, double lift) {
    candidates.near.lift = {0.0, 0.0, lift};
    return press_at(tool, {x0, y0, tool.radius - depth + lift});
  }
};

}  // namespace

TEST_CASE("a plane that gives nowhere is felt as a half space within 2 %, on edges of 1 to 20 mm") {
  for (const double edge : {0.001, 0.002, 0.005, 0.010, 0.020}) {
    Plane plane(edge);
    for (const double radius : {0.002, 0.005, 0.008}) {
      const LocalPress half{kModulus, radius, 0.0, 0.0};
      for (const double part : {0.05, 0.2, 0.5, 0.6, 1.0, 1.5}) {
        CAPTURE(edge);
        CAPTURE(radius);
        CAPTURE(part);
        const double depth = part * radius, lift = std::max(0.0, depth - 0.55 * radius);
        const Vec3 force = plane.press({.radius = radius}, 0.0011, 0.0007, depth, lift);
        CHECK(force.z() == doctest::Approx(half.compute_force(depth)).epsilon(0.02));
        CHECK(force.head<2>().norm() < 0.01 * force.z());
      }
    }
  }
}

TEST_CASE("over 10 mm of such a plane the force ripples by less than 1 %, lifted or not") {
  for (const double edge : {0.001, 0.005, 0.020}) {
    Plane plane(edge);
    for (const double depth : {0.0015, 0.004}) {
      double least = 1e9, most = 0.0;
      for (int i = 0; i <= 100; ++i) {
        const double s = 1e-4 * i, lift = std::max(0.0, depth - 0.00165);
        const double force = plane.press({.radius = 0.003}, s, 0.3 * s, depth, lift).z();
        least = std::min(least, force);
        most = std::max(most, force);
      }
      CAPTURE(edge);
      CAPTURE(depth);
      CHECK(most - least < 0.01 * most);
    }
  }
}

TEST_CASE("below the barrier a force does not depend on the lift, which goes to what is left") {
  Plane plane(0.005);
  const Tool tool{.radius = 0.003};
  const double depth = 0.0018;
  const double still = plane.press(tool, 0.0011, 0.0007, depth, 0.0).z();
  // what is beyond 0.55 R is lifted off
  CHECK(plane.candidates.near.next_lift.z() == doctest::Approx(depth - 0.55 * tool.radius));
  for (const double lift : {1e-4, 4e-4, 1e-3}) {
    CHECK(plane.press(tool, 0.0011, 0.0007, depth, lift).z() ==
          doctest::Approx(still).epsilon(0.01));
    CHECK(plane.candidates.near.next_lift.z() == doctest::Approx(depth - 0.55 * tool.radius));
  }
  // a shallow press has none, a deep one no more than 1.2 R
  plane.press(tool, 0.0, 0.0, 0.001, 0.0);
  CHECK(plane.candidates.near.next_lift == Vec3::Zero());
  plane.press(tool, 0.0, 0.0, 0.006, 0.0036);
  CHECK(plane.candidates.near.next_lift.z() == doctest::Approx(1.2 * tool.radius));
}

TEST_CASE("beyond its lift the barrier adds to the force, and bears what a hand can push") {
  Plane plane(0.005);
  const Tool tool{.radius = 0.003};
  const LocalPress half{kModulus, tool.radius, 0.0, 0.0};
  double last = 0.0;
  for (const double part : {1.8, 1.95, 2.05, 2.1, 2.15}) {
    const double depth = part * tool.radius;
    const double force = plane.press(tool, 0.0011, 0.0007, depth, 1.2 * tool.radius).z();
    CHECK(force > last);
    if (part > 1.9) CHECK(force > 1.02 * half.compute_force(depth));
    last = force;
  }
}

TEST_CASE("a tool that was put elsewhere has no lift") {
  NearContacts contacts(4, 4);
  contacts.centre = {0.0, 0.0, 0.002};
  contacts.lift = {0.0, 0.0, 0.001};
  CHECK(find_lift(contacts, {0.0, 0.0, 0.001}) == contacts.lift);
  CHECK(find_lift(contacts, {0.0, 0.0, 0.003}) == Vec3::Zero());
}
