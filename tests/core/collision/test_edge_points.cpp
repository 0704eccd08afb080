// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "palpate/sim/collision/private/edge_points.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tree/queries.h"
#include "scenes/scenes.h"

// The middles of long edges over the triangles of another surface [contact: bodies].

using namespace palpate;

namespace {

constexpr Barrier kBarrier{4e-4, 5e6, 0.0};

struct Moved {
  explicit Moved(int subdivisions)
      : tissue(build_mass_spring(scenes::make_ellipsoid({0.030, 0.025, 0.020}, subdivisions),
                                 {.wall_thickness = 0.003}, 100.0)),
        x(tissue.rest_position),
        velocity(x.size(), Vec3::Zero()),
        tree(x, tissue.triangles),
        touch(tissue) {}

  SurfaceMesh mesh() const { return {tissue.rest_position, tissue.triangles}; }
  TouchingSurface view() { return {tissue, x, velocity, touch}; }

  TissueModel tissue;
  Vec3Array x, velocity;
  AabbTree tree;
  SurfaceTouch touch;
};

/// A ball whose edges of up to 16 mm meet one of fine triangles, `into` it [m].
struct Pressed {
  explicit Pressed(double into) : lower(3), upper(1), points(upper.mesh(), lower.mesh(), kBarrier) {
    move_to(0.06);
    move_to(0.06 - measure_gap() - into);
    renew_lists(points.x, lower.tree, lower.x, 0.0, points.contacts);
    find_near(points.x, lower.tissue.triangles, lower.x, points.contacts);
  }

  void move_to(double height) {
    const Quaternion turn(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 0.5).normalized()));
    for (std::size_t v = 0; v < upper.x.size(); ++v) {
      upper.x[v] = Vec3(0.0, 0.0, height) + turn * upper.tissue.rest_position[v];
    }
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

TEST_CASE("edges longer than ten thicknesses have a middle, with a sixth of the triangles beside") {
  // a triangle with sides of 3, 4 and 5 mm: an area of 6 mm²
  const SurfaceMesh mesh{{{0, 0, 0}, {0.003, 0, 0}, {0, 0.004, 0}}, {{0, 1, 2}}};
  const EdgePoints points(mesh, mesh, {4.5e-4, 5e6, 0.3});
  REQUIRE(points.ends.size() == 1);
  CHECK(points.ends[0] == std::array<int, 2>{1, 2});
  CHECK(points.contacts.area[0] == doctest::Approx(1e-6));
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
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), momentum = Vec3::Zero();
  double whole = 0.0;
  for (Moved* surface : {&pressed.upper, &pressed.lower}) {
    for (std::size_t v = 0; v < surface->x.size(); ++v) {
      force += surface->touch.force[v];
      moment += surface->x[v].cross(surface->touch.force[v]);
      momentum += surface->touch.impulse[v] / surface->touch.inverse_mass[v];
      whole += surface->touch.force[v].norm();
    }
  }
  REQUIRE(whole > 0.0);
  CHECK(force.norm() < 1e-12 * whole);
  CHECK(moment.norm() < 1e-12 * whole);
  CHECK(momentum.norm() < 1e-12 * whole);
}

TEST_CASE("what middles of edges push with is minus the gradient of the barrier's energy") {
  Pressed pressed(1e-4);
  push_contacts(1e-4, pressed.view(), pressed.lower.view(), pressed.points.contacts);
  constexpr double kStep = 1e-9;  // [m]
  int checked = 0;
  for (Moved* surface : {&pressed.upper, &pressed.lower}) {
    for (const int vertex : surface->touch.pushed) {
      const auto v = static_cast<std::size_t>(vertex);
      for (int axis = 0; axis < 3; ++axis) {
        const double at = surface->x[v][axis];
        surface->x[v][axis] = at + kStep;
        const double more = pressed.sum_energy();
        surface->x[v][axis] = at - kStep;
        const double less = pressed.sum_energy();
        surface->x[v][axis] = at;
        CHECK((less - more) / (2.0 * kStep) ==
              doctest::Approx(surface->touch.force[v][axis]).epsilon(1e-4).scale(1e-2));
        ++checked;
      }
    }
  }
  CHECK(checked >= 15);
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
