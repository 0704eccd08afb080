// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/near_contact.h"

// Contacts under a near field on a plane that gives nowhere: all of the dent is the near field's.

using namespace palpate;

namespace {

constexpr double kModulus = 6270.0;  ///< [Pa]

/// A square of 60 mm facing up, of right triangles.
struct Plane {
  explicit Plane(double edge) {
    const int cells = static_cast<int>(std::lround(0.06 / edge));
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) x.push_back({edge * i - 0.03, edge * j - 0.03, 0.0});
    }
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const int a = i * (cells + 1) + j, b = a + cells + 1;
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
    }
    near.modulus = kModulus;
    near.far_compliance.assign(x.size(), 0.0);
    near.curvature.assign(x.size(), 0.0);
    near.first.assign(x.size() + 1, 0);
    const int count = static_cast<int>(triangles.size());
    candidates = Candidates(count);
    candidates.near = NearContacts(count, static_cast<int>(x.size()));
  }

  /// [N] What a ball feels whose lowest point is `depth` [m] deep, and that is lifted by `lift`
  /// [m].
  Vec3 press(const Tool& tool, double x0, double y0, double depth, double lift) {
    const Vec3 p(x0, y0, tool.radius - depth + lift);
    NearContacts& contacts = candidates.near;
    contacts.count = 0;
    contacts.knows_compliance = false;
    contacts.lift = {0.0, 0.0, lift};
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const auto at = static_cast<std::size_t>(contacts.count);
      if (!find_contact(tool, 1e-6, p, x[static_cast<std::size_t>(a)],
                        x[static_cast<std::size_t>(b)], x[static_cast<std::size_t>(c)],
                        contacts.closest[at])) {
        continue;
      }
      contacts.triangle[at] = static_cast<int>(t);
      ++contacts.count;
    }
    find_near_contacts(tool, {&candidates, triangles, x, nullptr, &near}, p);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
      sum += contacts.contact[i].force * contacts.contact[i].direction;
    }
    return sum;
  }

  Vec3Array x;
  std::vector<Triangle> triangles;
  NearField near;
  Candidates candidates;
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
