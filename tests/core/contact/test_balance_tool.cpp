// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/tree/soups.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/tree/queries.h"
#include "tool_bench.h"

using namespace palpate;

namespace {

/// A pit of the given radius and depth in the plane z = 0, its floor a cone.
SurfaceMesh make_pit(double radius, double depth, int around, int rings) {
  SurfaceMesh mesh;
  const auto ring = [&](double r, double z) {
    for (int a = 0; a < around; ++a) {
      const double angle = 2.0 * std::numbers::pi * a / around;
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  };
  mesh.vertices.emplace_back(0.0, 0.0, -depth - 0.3 * radius);
  for (int r = 0; r <= rings; ++r) ring(radius, -depth + depth * r / rings);
  ring(5.0 * radius, 0.0);
  for (int a = 0; a < around; ++a) {
    const int b = (a + 1) % around;
    mesh.triangles.push_back({0, 1 + a, 1 + b});
    for (int r = 0; r <= rings; ++r) {
      const int low = 1 + r * around, high = low + around;
      mesh.triangles.push_back({low + a, high + a, high + b});
      mesh.triangles.push_back({low + a, high + b, low + b});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("a finer mesh feels the same: the sum of pushes nears the integral of the pressure") {
  // a plane at height H below the centre: 2 pi k_A r H (r ln(r/H) - (r - H))
  const Tool tool{.radius = 0.003, .stiffness = 2e7};
  const double r = tool.radius, height = 0.002;
  const double exact = 2.0 * std::numbers::pi * tool.stiffness * r * height *
                       (r * std::log(r / height) - (r - height));
  double last_error = 2.0;
  for (const int side : {17, 33, 65, 129}) {
    Bench bench(scenes::make_sheet(side, side, 0.016), tool);
    const Vec3 centre(0.0081, 0.0079, height);
    Vec3 sum = Vec3::Zero();
    for (std::size_t t = 0; t < bench.areas.size(); ++t) {
      const Triangle& k = bench.mesh.triangles[t];
      Contact contact;
      if (find_contact(tool, bench.areas[t], centre, bench.corner(k, 0), bench.corner(k, 1),
                       bench.corner(k, 2), contact)) {
        sum += contact.force * contact.direction;
      }
    }
    const double error = std::abs(sum.z() / exact - 1.0);
    CHECK(error < 0.6 * last_error);
    last_error = error;
  }
  CHECK(last_error < 0.11);
}

TEST_CASE("in free air the tool is where the hand is and the force is exactly zero") {
  Bench bench(make_ball());
  Dice dice(31);
  for (int i = 0; i < 100; ++i) {
    const Vec3 hand = 0.05 * dice.vector(1.0).normalized() + dice.vector(0.003);
    const Vec3 felt = bench.move_hand(hand);
    // a path that leads through the ball is another matter
    if (bench.candidates.count > 0) {
      bench.state.placed = false;
      continue;
    }
    CHECK(felt == Vec3::Zero());
    CHECK(bench.state.position == hand);
    CHECK(bench.load.push_count == 0);
    CHECK_FALSE(bench.state.touching);
  }
}

TEST_CASE("hovering 0.1 mm over the surface feels exactly 0 N, also while moving") {  // T5
  Bench bench(make_ball());
  for (int i = 0; i < 2000; ++i) {
    // along a spiral over the ball, up to 0.5 m/s
    const double polar = 0.2 + 0.0012 * i, azimuth = 0.02 * i;
    const Vec3 out(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                   std::cos(polar));
    const Vec3 hand = (0.025 + bench.tool.radius + 1e-4) * out;

    const Vec3 felt = bench.move_hand(hand);

    REQUIRE(bench.candidates.count > 0);
    REQUIRE(felt == Vec3::Zero());
    REQUIRE(bench.state.position == hand);
    REQUIRE(bench.load.push_count == 0);
    REQUIRE(bench.state.residual == Vec3::Zero());
  }
}

TEST_CASE("forces and torques on the particles balance the hand's spring") {  // T9
  for (const double depth : {0.0005, 0.002, 0.004}) {
    Bench bench(make_ball());
    Dice dice(32);
    for (int i = 0; i < 20; ++i) {
      const Vec3 out = dice.vector(1.0).normalized();
      bench.state.placed = false;
      bench.move_hand(0.032 * out);
      const Vec3 hand = (0.028 - depth) * out;

      // every single call tells what it leaves over
      Vec3 felt = bench.move_hand(hand);
      REQUIRE((bench.force_on_particles() + felt + bench.state.residual).norm() < 1e-12);

      // a tool at rest leaves nothing
      felt = bench.move_hand(hand, 300);
      Vec3 torque;
      const Vec3 force = bench.force_on_particles(&torque);
      const Vec3 spring = bench.coupling.stiffness * (bench.state.position - hand);
      REQUIRE(felt.norm() > 0.01);
      REQUIRE((felt - spring).norm() < 1e-12);
      REQUIRE((force + spring).norm() < 1e-9);
      REQUIRE((torque + bench.state.position.cross(spring)).norm() < 1e-9);
      REQUIRE(bench.state.residual.norm() < 1e-9);
      REQUIRE(bench.state.touching);
    }
  }
}

TEST_CASE("every call brings a tool at rest closer to balance") {
  Bench bench(make_ball());
  bench.move_hand({0, 0, 0.030});
  bench.move_hand({0.0005, 0.0002, 0.024}, 8);
  double last = bench.state.residual.norm();
  for (int i = 0; i < 10; ++i) {
    bench.move_hand({0.0005, 0.0002, 0.024});
    CHECK(bench.state.residual.norm() <= 0.9 * last + 1e-12);
    last = bench.state.residual.norm();
  }
}

TEST_CASE("the hand's spring never pulls harder than its limit, and the tissue bears just that") {
  Bench bench(make_ball());
  bench.coupling.force_max = 2.0;
  bench.move_hand({0, 0, 0.030});

  const Vec3 felt = bench.move_hand({0, 0, -0.2}, 500);

  CHECK(felt.norm() == doctest::Approx(2.0));
  CHECK((bench.force_on_particles() + felt).norm() < 1e-9);
  CHECK(bench.state.position.norm() > 0.025);
}

TEST_CASE("a weak hand that has lost the surface finds it again without a blow") {
  // it goes to the hand first, millimetres behind the surface, and comes back in the same call
  for (const double force : {0.005, 0.05, 0.5}) {
    for (const double deep : {0.5e-3, 1e-3, 3e-3}) {
      Bench bench(make_ball(), {.radius = 0.007, .stiffness = 3e7});
      bench.coupling = {.stiffness = 1000.0, .force_max = force};
      const double above = 0.025 + bench.tool.radius + 2e-5;
      bench.move_hand({0, 0, above});
      REQUIRE(!bench.state.touching);

      const Vec3 felt = bench.move_hand({0, 0, above - deep});

      CHECK(felt.norm() <= force * (1.0 + 1e-12));
      CHECK(bench.force_on_particles().norm() < 1.05 * force);
      CHECK(bench.state.residual.norm() < 0.05 * force);
    }
  }
}

TEST_CASE("no flick of the hand takes the tool through a surface, however far it goes") {
  Bench bench(make_ball(2), {.radius = 0.0015, .stiffness = 4e7});
  Dice dice(33);
  for (int i = 0; i < 300; ++i) {
    const Vec3 start = 0.027 * dice.vector(1.0).normalized();
    bench.state.placed = false;
    bench.move_hand(start);
    if (bench.state.touching) continue;
    const Vec3 hand = start * dice.number(-3.0, 0.5) + dice.vector(0.01);
    bench.move_hand(hand);
    for (int substep = 0; substep < 40; ++substep) {
      bench.balance(hand);
      const auto closest =
          find_closest_point(bench.tree, bench.mesh.vertices, bench.state.position);
      // the ball is convex, so outside means beyond the plane of the closest triangle
      const Triangle& t = bench.mesh.triangles[static_cast<std::size_t>(closest->triangle)];
      const Vec3 normal =
          (bench.corner(t, 1) - bench.corner(t, 0)).cross(bench.corner(t, 2) - bench.corner(t, 0));
      REQUIRE(bench.state.position.dot(normal) > bench.corner(t, 0).dot(normal));
    }
  }
}

TEST_CASE("a tool that is inside feels nothing and is not held there") {
  Bench bench(make_ball());

  CHECK(bench.move_hand({0, 0, 0.0245}) == Vec3::Zero());
  CHECK(bench.state.position == Vec3(0, 0, 0.0245));
  bench.move_hand({0, 0, 0.0245});
  CHECK(bench.load.push_count == 0);
  bench.move_hand({0, 0, 0.040}, 20);
  CHECK(bench.state.position == Vec3(0, 0, 0.040));
}

TEST_CASE(
    "a tool whose centre starts on the surface is pushed outwards and nothing crashes") {  // F7
  const SurfaceMesh sheet = scenes::make_sheet(9, 9, 0.016);
  const Vec3 vertex = sheet.vertices[40], next = sheet.vertices[41];
  for (const Vec3& start : {vertex, Vec3(0.5 * vertex + 0.5 * next),
                            Vec3(0.4 * vertex + 0.4 * next + 0.2 * sheet.vertices[50])}) {
    Bench bench(sheet);
    const Vec3 felt = bench.move_hand(start);
    CHECK(felt.allFinite());
    CHECK(bench.state.position.allFinite());
    CHECK(bench.force_on_particles().z() < 0.0);

    // and it comes free when the hand leaves
    for (int i = 1; i <= 30; ++i) bench.move_hand(start + Vec3(0, 0, 2e-4 * i), 11);
    CHECK(bench.move_hand(start + Vec3(0, 0, 0.006), 50) == Vec3::Zero());
  }
}

TEST_CASE("degenerate triangles under the tool leave everything finite") {
  const Soup soup = make_degenerate_soup(300);
  Bench bench({soup.x, soup.triangles}, {.radius = 0.02, .stiffness = 3e7});
  Dice dice(34);
  for (int i = 0; i < 300; ++i) {
    bench.state.placed = i % 3 != 0;
    const Vec3 felt = bench.move_hand(pick_point(soup, soup.x, dice), 3);
    REQUIRE(felt.allFinite());
    REQUIRE(bench.state.position.allFinite());
    REQUIRE(bench.state.residual.allFinite());
  }
}

TEST_CASE("a narrow dent four radii deep keeps the tool finite and outside") {  // T6
  const double r = 0.001;
  for (const double width : {0.7, 1.0, 1.1, 1.5}) {
    CAPTURE(width);
    Bench bench(make_pit(width * r, 4.0 * r, 24, 16), {.radius = r, .stiffness = 3e7});
    bench.move_hand({1e-4, 5e-5, 1.5 * r});
    Vec3 felt = Vec3::Zero();
    for (int i = 1; i <= 200; ++i) {
      felt = bench.move_hand({1e-4, 5e-5, 1.5 * r - 6.5 * r * i / 200.0}, 11);
      REQUIRE(felt.allFinite());
    }
    felt = bench.move_hand({1e-4, 5e-5, -5.0 * r}, 5000);
    const Vec3& p = bench.state.position;
    const double beside = std::hypot(p.x(), p.y());

    CHECK(beside < width * r);
    CHECK(p.z() > -4.0 * r - 0.3 * (width * r - beside));
    CHECK(felt.z() > 0.0);
    CHECK((bench.force_on_particles() + felt + bench.state.residual).norm() < 1e-12);
    // what so small a floor cannot bear at the barrier's full force stays with the tool, which
    // stands a thousandth of its radius off
    const double distance = find_closest_point(bench.tree, bench.mesh.vertices, p)->distance;
    CHECK(distance >= 0.999e-3 * r);
    if (distance > 1.001e-3 * r) CHECK(bench.state.residual.norm() < 1e-9);
  }
}

TEST_CASE("with no room for all pushes the ones written and the residual still add up") {
  Bench bench(make_ball());
  bench.move_hand({0, 0, 0.030});
  bench.load = Load(4);

  const Vec3 felt = bench.move_hand({0, 0, 0.025});

  CHECK(bench.load.push_count == 4);
  CHECK((bench.force_on_particles() + felt + bench.state.residual).norm() < 1e-12);
}

TEST_CASE("the same moves give the same bits") {
  Bench a(make_ball()), b(make_ball());
  Dice dice(35);
  for (int i = 0; i < 200; ++i) {
    const Vec3 hand = Vec3(0, 0, 0.027) + dice.vector(0.002);
    REQUIRE(a.move_hand(hand) == b.move_hand(hand));
    REQUIRE(a.state.position == b.state.position);
  }
}

TEST_CASE("candidates are all triangles in reach of the path, with their areas at rest") {
  Bench bench(make_ball());
  const Vec3 from(0, 0, 0.030), to(0.004, 0, 0.022);

  find_candidates(bench.tree, bench.mesh.vertices, bench.tool, from, to, bench.areas,
                  bench.candidates);

  std::vector<bool> listed(bench.mesh.triangles.size());
  for (int i = 0; i < bench.candidates.count; ++i) {
    const int t = bench.candidates.triangles[static_cast<std::size_t>(i)];
    listed[static_cast<std::size_t>(t)] = true;
    CHECK(bench.candidates.areas[static_cast<std::size_t>(i)] ==
          bench.areas[static_cast<std::size_t>(t)]);
  }
  for (std::size_t t = 0; t < listed.size(); ++t) {
    const Triangle& k = bench.mesh.triangles[t];
    for (int i = 0; i <= 50; ++i) {
      const Vec3 p = from + (i / 50.0) * (to - from);
      const double distance =
          find_closest_on_triangle(p, bench.corner(k, 0), bench.corner(k, 1), bench.corner(k, 2))
              .distance;
      if (distance <= bench.tool.radius + kCandidateMargin) REQUIRE(listed[t]);
    }
  }
}

TEST_CASE(
    "candidates chosen from the leaves near a path are those found, whatever else is in them") {
  Bench bench(make_ball());
  Candidates chosen = bench.candidates;
  std::vector<int> leaves(bench.mesh.triangles.size());
  Dice dice(36);
  int most = 0, least = static_cast<int>(leaves.size());
  for (int i = 0; i < 100; ++i) {
    const Vec3 from = Vec3(0, 0, 0.025) + dice.vector(0.008), to = from + dice.vector(0.004);
    find_candidates(bench.tree, bench.mesh.vertices, bench.tool, from, to, bench.areas,
                    bench.candidates);

    const double reach = bench.tool.radius + kCandidateMargin + dice.number(0.0, 0.004);
    const int found = find_leaves_near_segment(bench.tree, from, to, reach, leaves);
    choose_candidates(bench.tree, bench.mesh.vertices, {bench.tool, {}, from, to}, from, to,
                      bench.areas, std::span(leaves).first(static_cast<std::size_t>(found)),
                      chosen);

    REQUIRE(found >= chosen.count);
    REQUIRE(chosen.count == bench.candidates.count);
    REQUIRE(std::equal(chosen.triangles.begin(), chosen.triangles.begin() + chosen.count,
                       bench.candidates.triangles.begin()));
    REQUIRE(std::equal(chosen.areas.begin(), chosen.areas.begin() + chosen.count,
                       bench.candidates.areas.begin()));
    most = std::max(most, chosen.count);
    least = std::min(least, chosen.count);
  }
  CHECK(most > least);
  CHECK(find_leaves_near_segment(bench.tree, Vec3(0, 0, 1), Vec3(0, 0, 2), 0.1, leaves) == 0);
  const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  CHECK(find_leaves_near_segment(bench.tree, nowhere, Vec3(0, 0, 2), 0.1, leaves) == 0);
}
