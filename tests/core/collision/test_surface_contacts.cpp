// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/collision/moved_surface.h"
#include "palpate/sim/collision/private/surface_contacts.h"
#include "palpate/sim/tree/queries.h"

using namespace palpate;

namespace {

constexpr Barrier kBarrier{4e-4, 5e6, 0.3};

/// [m] From a vertex to the nearest of all triangles.
double measure(const Vec3& p, const Moved& other) {
  double least = 1.0;
  for (const auto& [a, b, c] : other.tissue.triangles) {
    const double distance = find_closest_on_triangle(p, other.x[static_cast<std::size_t>(a)],
                                                     other.x[static_cast<std::size_t>(b)],
                                                     other.x[static_cast<std::size_t>(c)])
                                .distance;
    least = std::min(least, distance);
  }
  return least;
}

double sum_energy(const SurfaceContacts& contacts, Moved& vertices, Moved& triangles) {
  double energy = 0.0;
  for (const int vertex : contacts.active_in_use()) {
    const auto v = static_cast<std::size_t>(vertex);
    const VertexContact contact =
        find_contact(contacts, vertex, vertices.x[v], triangles.tissue.triangles, triangles.x,
                     contacts.barrier.thickness);
    if (contact.triangle < 0) continue;
    energy += contacts.area[v] * compute_barrier_energy(contacts.barrier, contact.gap);
  }
  return energy;
}

/// Two balls that have been pushed `into` each other [m], and the contacts of the first's vertices.
struct Pressed {
  explicit Pressed(double into, const Barrier& barrier = kBarrier)
      : lower(make_ball(3)),
        upper(make_ball(3)),
        contacts(surface_of(upper.tissue), surface_of(lower.tissue), barrier) {
    const Quaternion turn(Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 0.5).normalized()));
    upper.move_to({0.0, 0.0, 0.06}, turn);
    const double gap = measure_gap();
    upper.move_to({0.0, 0.0, 0.06 - gap - into}, turn);
    renew_lists(upper.x, lower.tree, lower.x, 0.0, contacts);
    find_near(upper.x, lower.tissue.triangles, lower.x, contacts);
  }
  double measure_gap() {
    double least = 1.0;
    for (const Vec3& p : upper.x) least = std::min(least, measure(p, lower));
    return least;
  }

  Moved lower, upper;
  SurfaceContacts contacts;
};

/// [m/s] At which the gap of a vertex of the upper body grows.
double find_gap_speed(Pressed& pressed, int vertex, const VertexContact& contact) {
  double speed = pressed.upper.view().velocity_of(vertex).dot(contact.normal);
  const Triangle& corners =
      pressed.lower.tissue.triangles[static_cast<std::size_t>(contact.triangle)];
  for (int c = 0; c < 3; ++c) {
    speed -=
        contact.weights[c] *
        pressed.lower.view().velocity_of(corners[static_cast<std::size_t>(c)]).dot(contact.normal);
  }
  return speed;
}

}  // namespace

TEST_CASE("S3: on any path, lists hold all that brute force finds within the thickness") {
  Moved ball(make_ball(3)), other(make_ball(2));
  SurfaceContacts contacts(surface_of(ball.tissue), surface_of(other.tissue), kBarrier);
  Vec3Array last;
  long within = 0, looked_at = 0;
  for (int i = 0; i < 400; ++i) {
    // through each other, turning, at up to 0.4 m/s
    const double t = 0.01 * i;
    last = ball.x;
    ball.move_to(Vec3(0.002 * std::sin(9.0 * t), 0.004 * t, 0.043 - 0.004 * std::sin(3.0 * t)),
                 Quaternion(Eigen::AngleAxisd(0.3 * t, Vec3::UnitY())));
    double move = 0.0;
    for (std::size_t v = 0; v < last.size() && i > 0; ++v) {
      move = std::max(move, (ball.x[v] - last[v]).norm());
    }
    const double before = contacts.moved;
    renew_lists(ball.x, other.tree, other.x, move, contacts);
    REQUIRE(contacts.moved == before + move);
    looked_at += std::ranges::count(contacts.near_until, contacts.moved);
    find_near(ball.x, other.tissue.triangles, other.x, contacts);
    if (i % 4 != 0) continue;
    for (std::size_t v = 0; v < ball.x.size(); ++v) {
      const double distance = measure(ball.x[v], other);
      if (distance >= kBarrier.thickness) continue;
      ++within;
      CAPTURE(i);
      CAPTURE(v);
      REQUIRE(contacts.near_count[v] > 0);
      const auto listed = std::span<const int>(contacts.listed[v]).first(contacts.listed_count[v]);
      for (std::size_t s = 0; s < other.tissue.triangles.size(); ++s) {
        const auto& [a, b, c] = other.tissue.triangles[s];
        const SurfacePoint nearest = find_closest_on_triangle(
            ball.x[v], other.x[static_cast<std::size_t>(a)], other.x[static_cast<std::size_t>(b)],
            other.x[static_cast<std::size_t>(c)]);
        if (nearest.distance >= kBarrier.thickness) continue;
        REQUIRE(std::ranges::count(listed, static_cast<int>(s)) == 1);
      }
      const VertexContact contact =
          find_contact(contacts, static_cast<int>(v), ball.x[v], other.tissue.triangles, other.x,
                       kBarrier.thickness);
      REQUIRE(contact.triangle >= 0);
      REQUIRE(std::abs(contact.gap) == doctest::Approx(distance).epsilon(1e-9));
    }
  }
  CHECK(within > 200);
  // a tick finds some of the lists again, not all
  CHECK(looked_at < 400L * static_cast<long>(ball.x.size()) / 4);
}

TEST_CASE("S4: two surfaces push each other with opposite forces and moments") {
  for (const double into : {-2e-4, 2e-5, 3e-4}) {
    CAPTURE(into);
    Pressed pressed(into);
    for (Vec3& v : pressed.upper.velocity) v = {0.02, 0.01, -0.1};
    const ContactSum sum =
        push_contacts(1e-4, pressed.upper.view(), pressed.lower.view(), pressed.contacts);
    REQUIRE(sum.touching > 0);
    CHECK(sum.force.z() < 0.0);
    const Done done = sum_done(pressed.upper, pressed.lower);
    CHECK(done.force.norm() < 1e-12 * done.whole);
    // a vertex is pushed along the line to its nearest point
    CHECK(done.moment.norm() < 1e-12 * done.whole);
  }
}

TEST_CASE("what contacts push with is minus the gradient of the barrier's energy") {
  Pressed pressed(1e-4, {4e-4, 5e6, 0.0});
  push_contacts(1e-4, pressed.upper.view(), pressed.lower.view(), pressed.contacts);
  const auto energy = [&] { return sum_energy(pressed.contacts, pressed.upper, pressed.lower); };
  CHECK(check_gradient(pressed.upper, pressed.lower, energy) > 20);
}

TEST_CASE("nearer than a tenth of the thickness approach is stopped, and nothing is thrown back") {
  Pressed pressed(0.0, {4e-4, 5e6, 0.0});
  for (Vec3& v : pressed.upper.velocity) v = {0.0, 0.0, -0.5};
  const double dt = 1e-4;
  push_contacts(dt, pressed.upper.view(), pressed.lower.view(), pressed.contacts);
  int stopped = 0;
  for (const int vertex : pressed.contacts.active_in_use()) {
    const auto v = static_cast<std::size_t>(vertex);
    const VertexContact contact =
        find_contact(pressed.contacts, vertex, pressed.upper.x[v], pressed.lower.tissue.triangles,
                     pressed.lower.x, kBarrier.thickness);
    if (contact.triangle < 0 || contact.gap > kClosestPart * kBarrier.thickness) continue;
    const double speed = find_gap_speed(pressed, vertex, contact);
    // to the bit alone; with neighbours that share a corner, no more than they have left
    CHECK(speed > -0.25);
    CHECK(speed < 0.05);
    ++stopped;
  }
  CHECK(stopped > 0);
}

TEST_CASE("what would pass the floor within a step is slowed down to reach it, no more") {
  // 0.2 mm before a floor of 0.04 mm: of 4.5 m/s in a step of 40 us, 4 m/s are left
  const Barrier barrier{4e-4, 0.0, 0.0};
  for (const double speed : {3.0, 4.5, 20.0}) {
    CAPTURE(speed);
    Pressed pressed(-2e-4, barrier);
    constexpr double kStep = 4e-5;
    for (Vec3& v : pressed.upper.velocity) v = {0.0, 0.0, -speed};
    push_contacts(kStep, pressed.upper.view(), pressed.lower.view(), pressed.contacts);
    double least = 1.0;
    for (const int vertex : pressed.contacts.active_in_use()) {
      const auto v = static_cast<std::size_t>(vertex);
      const VertexContact contact =
          find_contact(pressed.contacts, vertex, pressed.upper.x[v], pressed.lower.tissue.triangles,
                       pressed.lower.x, barrier.thickness);
      if (contact.triangle < 0) continue;
      const double rate = find_gap_speed(pressed, vertex, contact);
      least = std::min(least, contact.gap + kStep * rate);
    }
    // the last one to be looked at is stopped at the floor, those before it there or farther away
    if (speed < 4.0) CHECK(least == doctest::Approx(2e-4 - kStep * speed).epsilon(0.01));
    if (speed > 4.0) CHECK(least == doctest::Approx(4e-5).epsilon(0.01));
  }
}

TEST_CASE("a surface has no contact with what is next to it, and has with what folds onto it") {
  const TissueModel ball = make_ball(3);
  Moved surface(ball);
  SurfaceContacts contacts(surface_of(ball), surface_of(ball), kBarrier, true);
  renew_lists(surface.x, surface.tree, surface.x, 0.0, contacts);
  find_near(surface.x, ball.triangles, surface.x, contacts);
  CHECK(contacts.active_count == 0);
  const auto count = [&] {
    surface.tree.refit(surface.x);
    renew_lists(surface.x, surface.tree, surface.x, 0.05, contacts);
    find_near(surface.x, ball.triangles, surface.x, contacts);
    return push_contacts(1e-4, surface.view(), surface.view(), contacts);
  };
  // bent into a ring until its ends are 0.3 mm apart
  constexpr double kRadius = 0.03 / (std::numbers::pi - 0.0157);
  for (std::size_t v = 0; v < surface.x.size(); ++v) {
    const Vec3& x = ball.rest_position[v];
    const double angle = x.x() / kRadius, radius = kRadius + 0.1 * x.z();
    surface.x[v] = {radius * std::sin(angle), 0.1 * x.y(), radius * std::cos(angle)};
  }
  const ContactSum folded = count();
  CHECK(folded.touching > 0);
  CHECK(folded.least_gap == doctest::Approx(3e-4).epsilon(0.05));
  contacts = SurfaceContacts(surface_of(ball), surface_of(ball), kBarrier, true);
  // flattened: the halves are nearer than the thickness, but face away from each other
  for (std::size_t v = 0; v < surface.x.size(); ++v) {
    surface.x[v] = ball.rest_position[v];
    surface.x[v].z() *= 0.005;
  }
  CHECK(count().touching == 0);
}

TEST_CASE("an open surface pushes to the side that a vertex came from, and not over its border") {
  const SurfaceMesh sheet = {
      {{-0.01, -0.01, 0.0}, {0.01, -0.01, 0.0}, {0.01, 0.01, 0.0}, {-0.01, 0.01, 0.0}},
      {{0, 1, 2}, {0, 2, 3}}};
  const TissueModel model = build_mass_spring(sheet, {.wall_thickness = 0.003}, 100.0);
  const TissueModel ball = make_ball(2);
  Moved flat(model), moving(ball);
  for (const double side : {1.0, -1.0}) {
    SurfaceContacts contacts(surface_of(ball), surface_of(model), kBarrier);
    // a vertex 0.2 mm before the sheet, one as far behind it, and one beside it
    const auto place = [&](double height) {
      for (Vec3& x : moving.x) x = {0.0, 0.0, 1.0};
      moving.x[0] = {0.002, 0.001, side * height};
      moving.x[1] = {0.0101, 0.0, side * height};
    };
    place(2e-4);
    renew_lists(moving.x, flat.tree, flat.x, 0.0, contacts);
    find_near(moving.x, model.triangles, flat.x, contacts);
    const auto find = [&](int vertex) {
      return find_contact(contacts, vertex, moving.x[static_cast<std::size_t>(vertex)],
                          model.triangles, flat.x, kBarrier.thickness);
    };
    CHECK(find(0).normal.z() == doctest::Approx(side));
    CHECK(find(0).gap == doctest::Approx(2e-4));
    CHECK(find(1).triangle < 0);
    place(-1e-4);
    CHECK(find(0).normal.z() == doctest::Approx(side));
    CHECK(find(0).gap == doctest::Approx(-1e-4));
  }
}

TEST_CASE("a vertex that comes to another fold of a sheet has not come through it") {
  // two squares, one over the other, that face up
  SurfaceMesh folds;
  for (const double z : {0.0, 5e-4}) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      folds.vertices.emplace_back(0.01 * x, 0.01 * y, z);
    }
  }
  folds.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const TissueModel model = build_mass_spring(folds, {.wall_thickness = 0.003}, 100.0);
  const TissueModel ball = make_ball(2);
  Moved sheet(model), moving(ball);
  SurfaceContacts contacts(surface_of(ball), surface_of(model), kBarrier);
  Vec3Array last;
  const auto go = [&](double height) {
    last = moving.x;
    for (Vec3& x : moving.x) x = {0.0, 0.0, 1.0};
    moving.x[0] = {0.002, 0.001, height};
    if (!contacts.begun) last = moving.x;
    const double move = (moving.x[0] - last[0]).norm();
    renew_lists(moving.x, sheet.tree, sheet.x, move, contacts);
    find_near(moving.x, model.triangles, sheet.x, contacts, {last, sheet.x});
    return find_contact(contacts, 0, moving.x[0], model.triangles, sheet.x, kBarrier.thickness);
  };
  CHECK(go(2e-4).gap == doctest::Approx(2e-4));
  // nearer to the back of the upper one
  CHECK(go(4e-4).gap == doctest::Approx(1e-4));
  CHECK(go(4e-4).normal.z() == doctest::Approx(-1.0));
  // through it, and pushed back for as long as it is there
  CHECK(go(6e-4).gap == doctest::Approx(-1e-4));
  CHECK(go(6e-4).gap == doctest::Approx(-1e-4));
  CHECK(go(6e-4).normal.z() == doctest::Approx(-1.0));
  CHECK(go(4e-4).gap == doctest::Approx(1e-4));
}
