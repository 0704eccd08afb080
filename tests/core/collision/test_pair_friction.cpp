// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "core/collision/moved_surface.h"
#include "palpate/sim/collision/private/edge_points.h"
#include "palpate/sim/collision/private/pair_friction.h"
#include "palpate/sim/collision/private/surface_contacts.h"
#include "palpate/sim/tree/queries.h"

using namespace palpate;

namespace {

constexpr double kFriction = 0.5;
constexpr Barrier kUndamped{4e-4, 5e6, 0.0};

/// Begins a substep: no forces so far.
void clear(Moved& surface) {
  take_pushes(surface.touch, [](const Push&) {});
}

/// A triangle of particles of a gram each.
TissueModel make_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  TissueModel tissue;
  tissue.rest_position = {a, b, c};
  tissue.mass.assign(3, 1e-3);
  tissue.triangles = {{0, 1, 2}};
  return tissue;
}

/// A triangle of 6 mm² stands with a corner over the middle of a large one, half the thickness away
/// from it: 2 mm² push with k_A tau, 4 mN.
struct Standing {
  explicit Standing(const Barrier& barrier, double friction = kFriction)
      : lower(make_triangle({-0.03, -0.03, 0.0}, {0.06, -0.03, 0.0}, {-0.03, 0.06, 0.0})),
        upper(make_triangle({0.0, 0.0, 2e-4}, {0.003, 0.0, 0.0052}, {0.0, 0.0024, 2e-4 + 0.0032})),
        contacts(surface_of(upper.tissue), surface_of(lower.tissue), barrier) {
    contacts.bristles = PointBristles(friction, contacts.area.size());
    renew_lists(upper.x, lower.tree, lower.x, 0.0, contacts);
    find_near(upper.x, lower.tissue.triangles, lower.x, contacts);
    area = contacts.area[0];
    stiffness = barrier.stiffness * area;
    pressed = stiffness * barrier.thickness;
  }

  /// [N] On the corner, after a move by `way` [m]. Forces of both surfaces are those of this alone.
  Vec3 rub(const Vec3& way = Vec3::Zero()) {
    upper.move_to(gone += way);
    clear(upper);
    clear(lower);
    begin_rubbing(contacts.bristles);
    push_contacts(1e-4, upper.view(), lower.view(), contacts);
    sum = rub_contacts(upper.view(), lower.view(), contacts);
    return upper.touch.force[0];
  }

  Moved lower, upper;
  SurfaceContacts contacts;
  double area = 0.0, stiffness = 0.0, pressed = 0.0;
  Vec3 gone = Vec3::Zero();
  FrictionSum sum;
};

}  // namespace

TEST_CASE("a point that is drawn over a triangle is held back by k_A times area times the way") {
  Standing standing(kUndamped);
  CHECK(standing.area == doctest::Approx(standing.contacts.area[1]));
  const Vec3 at_rest = standing.rub();
  CHECK(at_rest.z() == doctest::Approx(standing.pressed));
  CHECK(at_rest.head<2>().norm() == 0.0);
  const Vec3 held = standing.rub({3e-5, -4e-5, 0.0});
  CHECK(held.x() == doctest::Approx(-standing.stiffness * 3e-5));
  CHECK(held.y() == doctest::Approx(standing.stiffness * 4e-5));
  CHECK(held.z() == doctest::Approx(standing.pressed));
  CHECK(standing.sum.energy == doctest::Approx(0.5 * standing.stiffness * 5e-5 * 5e-5));
  CHECK((standing.sum.force + Vec3(held.x(), held.y(), 0.0)).norm() < 1e-12);
  // and it goes back to where it sticks
  const Vec3 back = standing.rub({-3e-5, 4e-5, 0.0});
  CHECK(back.head<2>().norm() < 1e-9 * standing.pressed);
}

TEST_CASE("friction is mu times what presses at most, against the way, and does not wind up") {
  Standing standing(kUndamped);
  standing.rub();
  // it sticks up to mu tau, 0.2 mm
  for (int i = 0; i < 10; ++i) standing.rub({1e-4, 0.0, 0.0});
  const Vec3 slides = standing.rub({1e-4, 0.0, 0.0});
  CHECK(slides.x() == doctest::Approx(-kFriction * standing.pressed));
  CHECK(slides.y() == 0.0);
  const Vec3 back = standing.rub({-2e-4, 0.0, 0.0});
  CHECK(back.head<2>().norm() < 1e-9 * standing.pressed);
  CHECK(standing.rub({-4e-4, 0.0, 0.0}).x() == doctest::Approx(kFriction * standing.pressed));
}

TEST_CASE("friction has the barrier's damping, within mu times what presses") {
  Standing standing({4e-4, 5e6, 0.3});
  // of a gram on a third of each of three
  const double mass = 1e-3 / (1.0 + 1.0 / 3.0);
  const double damping = 2.0 * 0.3 * std::sqrt(standing.stiffness * mass);
  const auto move_at = [&](double speed) {
    for (Vec3& v : standing.upper.velocity) v = {speed, 0.0, 0.0};
    return standing.rub().x();
  };
  CHECK(move_at(1e-3) == doctest::Approx(-damping * 1e-3));
  CHECK(move_at(1.0) == doctest::Approx(-kFriction * standing.pressed));
}

TEST_CASE("a point that has left sticks where it comes down again") {
  Standing standing(kUndamped);
  standing.rub();
  CHECK(standing.rub({5e-5, 0.0, 0.0}).x() < 0.0);
  CHECK(standing.rub({0.0, 0.0, 3e-4}).norm() == 0.0);
  CHECK(standing.rub({0.0, 0.0, -3e-4}).head<2>().norm() == 0.0);
  // nor is it held from one tick to a later one in which nobody asked
  CHECK(standing.rub({5e-5, 0.0, 0.0}).x() < 0.0);
  begin_rubbing(standing.contacts.bristles);
  CHECK(standing.rub().head<2>().norm() == 0.0);
}

TEST_CASE("friction takes energy over every cycle, and gives none of it back while it sticks") {
  for (const double reach : {5e-5, 1e-3}) {
    CAPTURE(reach);
    Standing standing(kUndamped);
    constexpr int kSteps = 400;
    double work = 0.0, most = 0.0;
    Vec3 before = standing.rub();
    for (int i = 1; i <= 3 * kSteps; ++i) {
      const auto place = [&](int n) {
        const double angle = 2.0 * 3.14159265358979 * n / kSteps;
        return Vec3(reach * std::sin(angle), reach * (1.0 - std::cos(angle)), 0.0);
      };
      const Vec3 way = place(i) - place(i - 1);
      const Vec3 now = standing.rub(way);
      work += 0.5 * (before + now).dot(way);
      most = std::max(most, work);
      before = now;
    }
    CHECK(most <= 1e-12);
    if (reach < 1e-4) CHECK(work == doctest::Approx(0.0).scale(standing.pressed * reach));
    // around three circles, less what is drawn back at the start of the first
    const double slid = kFriction * standing.pressed * 3.0 * 6.2832 * reach;
    if (reach > 1e-4) CHECK(-work == doctest::Approx(slid).epsilon(0.05));
  }
}

TEST_CASE("without friction nothing is kept, and contacts are as stiff as they were") {
  Standing standing(kUndamped, 0.0);
  CHECK(standing.contacts.bristles.points.empty());
  CHECK(standing.contacts.bristles.steepening == 1.0);
  standing.upper.move_to({1e-5, 0.0, 0.0});
  push_contacts(1e-4, standing.upper.view(), standing.lower.view(), standing.contacts);
  CHECK(standing.upper.touch.force[0].head<2>().norm() == 0.0);
}

TEST_CASE("what sticks is taken back to where it was kept") {
  Standing standing(kUndamped);
  standing.rub();
  const Vec3 held = standing.rub({5e-5, 0.0, 0.0});
  keep_bristles(standing.contacts.bristles);
  standing.rub({1e-3, 1e-3, 0.0});
  standing.rub({0.0, 0.0, 1e-3});
  standing.upper.move_to(standing.gone = {5e-5, 0.0, 0.0});
  rewind_bristles(standing.contacts.bristles);
  CHECK(standing.rub() == held);
  // likewise where nothing was held
  Standing fresh(kUndamped);
  keep_bristles(fresh.contacts.bristles);
  fresh.rub();
  fresh.rub({5e-5, 0.0, 0.0});
  rewind_bristles(fresh.contacts.bristles);
  CHECK(fresh.rub().head<2>().norm() == 0.0);
}

TEST_CASE("surfaces rub with opposite forces, vertices and middles of edges alike") {
  constexpr Barrier kBarrier{4e-4, 5e6, 0.3};
  for (const int subdivisions : {1, 3}) {
    CAPTURE(subdivisions);
    const bool of_edges = subdivisions == 1;
    Moved lower(make_ball(3)), upper(make_ball(subdivisions));
    EdgePoints edges(surface_of(upper.tissue), surface_of(lower.tissue), kBarrier);
    SurfaceContacts vertices(surface_of(upper.tissue), surface_of(lower.tissue), kBarrier);
    SurfaceContacts& contacts = of_edges ? edges.contacts : vertices;
    contacts.bristles = PointBristles(kFriction, contacts.area.size());
    const Quaternion turn(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 0.5).normalized()));
    const auto view = [&] {
      TouchingSurface seen = upper.view();
      if (!of_edges) return seen;
      follow(upper.x, upper.x, edges);
      seen.x = edges.x;
      seen.edges = edges.ends;
      return seen;
    };
    // down until something is 0.2 mm away
    double height = 0.06, least = 1.0;
    upper.move_to({0.0, 0.0, height}, turn);
    for (const Vec3& p : view().x) {
      least = std::min(least, find_closest_point(lower.tree, lower.x, p)->distance);
    }
    for (int i = 0; i < 20; ++i) {
      height -= least - 2e-4;
      upper.move_to({0.0, 0.0, height}, turn);
      least = 1.0;
      for (const Vec3& p : view().x) {
        least = std::min(least, find_closest_point(lower.tree, lower.x, p)->distance);
      }
    }
    renew_lists(view().x, lower.tree, lower.x, 0.0, contacts);
    find_near(view().x, lower.tissue.triangles, lower.x, contacts);
    for (Vec3& v : upper.velocity) v = {0.02, 0.01, 0.0};
    FrictionSum sum;
    for (int i = 0; i < 2; ++i) {
      clear(upper);
      clear(lower);
      begin_rubbing(contacts.bristles);
      push_contacts(1e-4, view(), lower.view(), contacts);
      sum = rub_contacts(view(), lower.view(), contacts);
    }
    const Done done = sum_done(upper, lower);
    REQUIRE(sum.force.norm() > 0.0);
    CHECK(sum.force.x() > 0.0);
    CHECK(done.force.norm() < 1e-12 * done.whole);
  }
}

TEST_CASE("a surface that is folded onto itself rubs on itself, and its forces sum to none") {
  const TissueModel ball = make_ball(3);
  constexpr Barrier kBarrier{4e-4, 5e6, 0.3};
  Moved surface(ball);
  SurfaceContacts contacts(surface_of(ball), surface_of(ball), kBarrier, true);
  contacts.bristles = PointBristles(kFriction, contacts.area.size());
  // bent into a ring until its ends are 0.3 mm apart, and then the ends past each other
  constexpr double kPi = 3.14159265358979, kRadius = 0.03 / (kPi - 0.0157);
  const auto bend = [&](double past) {
    for (std::size_t v = 0; v < surface.x.size(); ++v) {
      const Vec3& x = ball.rest_position[v];
      const double angle = x.x() / kRadius, radius = kRadius + 0.1 * x.z();
      surface.x[v] = {radius * std::sin(angle), 0.1 * x.y() + past * x.x() / 0.03,
                      radius * std::cos(angle)};
    }
    surface.tree.refit(surface.x);
  };
  bend(0.0);
  renew_lists(surface.x, surface.tree, surface.x, 0.05, contacts);
  find_near(surface.x, ball.triangles, surface.x, contacts);
  FrictionSum sum;
  for (const double past : {0.0, 2e-5}) {
    bend(past);
    clear(surface);
    begin_rubbing(contacts.bristles);
    REQUIRE(push_contacts(1e-4, surface.view(), surface.view(), contacts).touching > 0);
    sum = rub_contacts(surface.view(), surface.view(), contacts);
  }
  CHECK(sum.energy > 0.0);
  Vec3 all = Vec3::Zero();
  double whole = 0.0;
  for (const Vec3& f : surface.touch.force) {
    all += f;
    whole += f.norm();
  }
  CHECK(all.norm() < 1e-12 * whole);
}
