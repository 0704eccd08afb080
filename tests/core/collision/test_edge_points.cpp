// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/collision/moved_surface.h"
#include "palpate/sim/collision/private/edge_points.h"
#include "palpate/sim/tree/queries.h"

// The middles of long edges over the triangles of another surface [contact: bodies].

using namespace palpate;

namespace {

constexpr Barrier kBarrier{4e-4, 5e6, 0.0};

/// A ball whose edges of up to 16 mm meet one of fine triangles, `into` it [m].
struct Pressed {
  explicit Pressed(double into)
      : lower(make_ball(3)),
        upper(make_ball(1)),
        points(surface_of(upper.tissue), surface_of(lower.tissue), kBarrier) {
    move_to(0.06);
    move_to(0.06 - measure_gap() - into);
    renew_lists(points.x, lower.tree, lower.x, 0.0, points.contacts);
    find_near(points.x, lower.tissue.triangles, lower.x, points.contacts);
  }

  void move_to(double height) {
    upper.move_to({0.0, 0.0, height},
                  Quaternion(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 0.5).normalized())));
    follow(upper.x, upper.x, points);
  }
  double measure_gap() {
    double least = 1.0;
    for (const Vec3& p : points.x) {
      least = std::min(least, find_closest_point(lower.tree, lower.x, p)->distance);
    }
    return least;
  }
  TouchingSurface view() {
    follow_active(upper.x, points);
    TouchingSurface view = upper.view();
    view.x = points.x;
    view.edges = points.ends;
    return view;
  }
  VertexContact find(int point) const {
    return find_contact(points.contacts, point, points.x[static_cast<std::size_t>(point)],
                        lower.tissue.triangles, lower.x, kBarrier.thickness);
  }
  double sum_energy() {
    follow_active(upper.x, points);
    double energy = 0.0;
    for (const int point : points.contacts.active_in_use()) {
      const VertexContact contact = find(point);
      if (contact.triangle < 0) continue;
      energy += points.contacts.area[static_cast<std::size_t>(point)] *
                compute_barrier_energy(kBarrier, contact.gap);
    }
    return energy;
  }

  Moved lower, upper;
  EdgePoints points;
};

}  // namespace

TEST_CASE("edges longer than ten thicknesses have a middle, with a quarter of the triangles") {
  // a triangle with sides of 3, 4 and 5 mm: an area of 6 mm²
  const SurfaceMesh mesh{{{0, 0, 0}, {0.003, 0, 0}, {0, 0.004, 0}}, {{0, 1, 2}}};
  const EdgePoints points(mesh, mesh, {4.5e-4, 5e6, 0.3});
  REQUIRE(points.ends.size() == 1);
  CHECK(points.ends[0] == std::array<int, 2>{1, 2});
  CHECK(points.contacts.area[0] == doctest::Approx(1.5e-6));
  CHECK(EdgePoints(mesh, mesh, {5.1e-4, 5e6, 0.3}).ends.empty());
  CHECK(EdgePoints(mesh, mesh, {3.9e-4, 5e6, 0.3}).ends.size() == 2);
}

TEST_CASE("a middle is pushed by area times pressure, half on either end") {
  Pressed pressed(-1e-4);
  const ContactSum sum =
      push_contacts(1e-4, pressed.view(), pressed.lower.view(), pressed.points.contacts);
  REQUIRE(sum.touching == 1);
  double force = 0.0;
  for (const int point : pressed.points.contacts.active_in_use()) {
    const VertexContact contact = pressed.find(point);
    if (contact.triangle < 0) continue;
    const auto e = static_cast<std::size_t>(point);
    force = pressed.points.contacts.area[e] * compute_pressure(kBarrier, contact.gap);
    for (const int end : pressed.points.ends[e]) {
      const Vec3& on_end = pressed.upper.touch.force[static_cast<std::size_t>(end)];
      CHECK((on_end - 0.5 * force * contact.normal).norm() < 1e-12 * force);
    }
  }
  CHECK(force > 0.0);
  CHECK(sum.force.norm() == doctest::Approx(force));
}

TEST_CASE("middles of edges push with opposite forces and moments") {
  Pressed pressed(3e-4);
  for (Vec3& v : pressed.upper.velocity) v = {0.02, 0.01, -0.1};
  push_contacts(1e-4, pressed.view(), pressed.lower.view(), pressed.points.contacts);
  const Done done = sum_done(pressed.lower, pressed.upper);
  REQUIRE(done.whole > 0.0);
  CHECK(done.force.norm() < 1e-12 * done.whole);
  CHECK(done.moment.norm() < 1e-12 * done.whole);
  CHECK(done.momentum.norm() < 1e-12 * done.whole);
}

TEST_CASE("what middles of edges push with is minus the gradient of the barrier's energy") {
  Pressed pressed(1e-4);
  push_contacts(1e-4, pressed.view(), pressed.lower.view(), pressed.points.contacts);
  const auto sum_energy = [&] { return pressed.sum_energy(); };
  CHECK(check_gradient(pressed.upper, pressed.lower, sum_energy) >= 15);
}

TEST_CASE("what a middle asks of the steps is that of its ends") {
  Pressed pressed(-1e-4);
  accumulate_stiffness(1e-4, pressed.view(), pressed.lower.view(), pressed.points.contacts);
  for (const int point : pressed.points.contacts.active_in_use()) {
    const VertexContact contact = pressed.find(point);
    if (contact.triangle < 0) continue;
    const auto e = static_cast<std::size_t>(point);
    // gradients of the gap: n/2 on each end and -w n on the corners, 2 in all
    const double part = contact.gap / kBarrier.thickness;
    const double slope = kBarrier.stiffness * pressed.points.contacts.area[e] / (part * part);
    for (const int end : pressed.points.ends[e]) {
      const auto v = static_cast<std::size_t>(end);
      CHECK(pressed.upper.touch.row[v] ==
            doctest::Approx(slope * pressed.upper.touch.inverse_mass[v]));
    }
  }
}
