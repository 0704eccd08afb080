// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tree/soups.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/packed/simd_targets.h"
#include "skip.h"
#include "tool_bench.h"

using namespace palpate;

namespace {

constexpr double kRadius = 0.0012, kStiffness = 3e7;

/// A jaw's worth, aslant in the tool's frame, and a second that goes on from its end.
Tool make_chain() {
  return {
      .radius = kRadius,
      .stiffness = kStiffness,
      .capsules = {{{0.0, 0.0, 0.0}, {0.010, 0.0, 0.0}}, {{0.010, 0.0, 0.0}, {0.018, 0.004, 0.0}}}};
}

Quaternion turn_by(Dice& dice) {
  const Vec3 axis = dice.vector(1.0).normalized();
  return Quaternion(Eigen::AngleAxisd(dice.vector(3.0).x(), axis));
}

/// [m] Between a segment and a triangle, over a fine grid of both: from above.
double sample_distance(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b,
                       const Vec3& c) {
  double least = 1.0;
  for (int k = 0; k <= 400; ++k) {
    const Vec3 p = from + (to - from) * (k / 400.0);
    least = std::min(least, find_closest_on_triangle(p, a, b, c).distance);
  }
  return least;
}

}  // namespace

TEST_CASE("a capsule along a plane is a ball about its axis: f = k_A A d/z by hand") {
  const Tool tool{.radius = 0.002, .stiffness = 2e7, .capsules = {{{-0.01, 0, 0}, {0.01, 0, 0}}}};
  const Vec3 a(-0.001, -0.001, 0.0), b(0.001, -0.001, 0.0), c(0.0, 0.001, 0.0);
  Contact contact;

  // 1 mm deep: z = 1/2, A = 2e-6 m²
  REQUIRE(
      find_capsule_contact(tool, 2e-6, {-0.01, 0.0, 0.001}, {0.01, 0.0, 0.001}, a, b, c, contact));

  CHECK(contact.distance == doctest::Approx(0.001).epsilon(1e-12));
  CHECK(contact.force == doctest::Approx(2e7 * 2e-6 * 0.001 / 0.5).epsilon(1e-12));
  CHECK(contact.stiffness == doctest::Approx(2e7 * 2e-6 / 0.25).epsilon(1e-12));
  CHECK((contact.direction - Vec3::UnitZ()).norm() < 1e-12);
}

TEST_CASE("a capsule of no length is a ball, and one from its two ends is the same") {
  Dice dice(81);
  const Tool tool{.radius = 0.003, .stiffness = kStiffness};
  int touched = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = dice.vector(0.002), a = dice.vector(0.004), b = dice.vector(0.004),
               c = dice.vector(0.004), q = p + dice.vector(0.004);
    Contact ball, capsule, there, back;
    const bool touches = find_contact(tool, 1e-6, p, a, b, c, ball);
    REQUIRE(find_capsule_contact(tool, 1e-6, p, p, a, b, c, capsule) == touches);
    if (touches) CHECK(capsule.force == doctest::Approx(ball.force).epsilon(1e-9));
    const bool found = find_capsule_contact(tool, 1e-6, p, q, a, b, c, there);
    REQUIRE(find_capsule_contact(tool, 1e-6, q, p, a, b, c, back) == found);
    // one that crosses the triangle has no closest points
    if (!found || !(sample_distance(p, q, a, b, c) > 3e-5)) continue;
    ++touched;
    CHECK(there.force == doctest::Approx(back.force).epsilon(1e-6));
    CHECK(there.distance < sample_distance(p, q, a, b, c) + 1e-9);
  }
  CHECK(touched > 50);
}

TEST_CASE("capsules in lanes are those of the law, one by one, on every vector target") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  Dice dice(82);
  const Tool tool{.radius = 0.003, .stiffness = kStiffness};
  constexpr int kCount = 1003;
  std::vector<std::array<Vec3, 5>> rows;
  for (int i = 0; i < kCount; ++i) {
    const Vec3 a = dice.vector(0.004), from = dice.vector(0.004);
    const Vec3 to = i % 20 == 0 ? from : Vec3(from + dice.vector(0.005));
    rows.push_back({a, a + dice.vector(0.002), a + dice.vector(0.002), from, to});
    // parallel to an edge
    if (i % 20 == 1) rows.back()[4] = from + 3.0 * (rows.back()[1] - a);
  }
  for (const std::string& target : simd_targets()) {
    CAPTURE(target);
    ContactLanes lanes(kCount, target, 1);
    lanes.count = kCount;
    for (std::size_t lane = 0; lane < lanes.rest_area.size(); ++lane) {
      const auto& row = rows[std::min<std::size_t>(lane, kCount - 1)];
      for (std::size_t k = 0; k < 9; ++k) {
        lanes.corners[k][lane] = row[k / 3][static_cast<Eigen::Index>(k % 3)];
      }
      for (std::size_t k = 0; k < 6; ++k) {
        lanes.axis[k][lane] = row[3 + k / 3][static_cast<Eigen::Index>(k % 3)];
      }
      lanes.rest_area[lane] = 2e-6;
    }
    lanes.find_capsules(lanes, tool.radius, tool.stiffness);
    int contacts = 0;
    for (std::size_t t = 0; t < kCount; ++t) {
      CAPTURE(t);
      const auto& [a, b, c, from, to] = rows[t];
      Contact expected;
      if (!find_capsule_contact(tool, 2e-6, from, to, a, b, c, expected)) expected.force = 0.0;
      CHECK(std::abs(lanes.force[t] - expected.force) <=
            1e-8 * (kStiffness * 2e-6 * tool.radius + expected.force));
      if (!(expected.force > 1e-6)) continue;
      ++contacts;
      CHECK(lanes.distance[t] == doctest::Approx(expected.distance).epsilon(1e-8));
    }
    CHECK(contacts > 150);
  }
}

TEST_CASE("T8: candidates of capsules are all that brute force finds on their way, each once") {
  const SurfaceMesh mesh = make_ball();
  const AabbTree tree(mesh.vertices, mesh.triangles);
  const std::vector<double> areas(mesh.triangles.size(), 1e-6);
  const Tool tool = make_chain();
  Candidates candidates(static_cast<int>(mesh.triangles.size()), 2);
  Dice dice(83);
  long found_in_all = 0;
  for (int pose = 0; pose < 1000; ++pose) {
    const Vec3 from = dice.vector(1.0).normalized() * 0.032, to = from + dice.vector(0.002);
    const Quaternion orientation = turn_by(dice);

    find_candidates(tree, mesh.vertices, tool, from, to, areas, candidates, orientation);

    const auto begin = candidates.triangles.begin(), end = begin + candidates.count;
    REQUIRE(std::is_sorted(begin, end));
    REQUIRE(std::adjacent_find(begin, end) == end);
    found_in_all += candidates.count;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [i, j, k] = mesh.triangles[t];
      const Vec3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
      bool touched = false;
      for (const Vec3& p : {from, Vec3(0.5 * (from + to)), to}) {
        for (const Capsule& capsule : tool.capsules) {
          Contact contact;
          touched = touched || find_capsule_contact(tool, 1e-6, p + orientation * capsule.from,
                                                    p + orientation * capsule.to, a, b, c, contact);
        }
      }
      if (touched) REQUIRE(std::binary_search(begin, end, static_cast<int>(t)));
    }
  }
  CHECK(found_in_all > 1000);
}

TEST_CASE("T9: forces and torque on the particles balance those on a chain of capsules") {
  Bench bench(make_ball(), make_chain());
  bench.candidates = Candidates(static_cast<int>(bench.mesh.triangles.size()), 2);
  Dice dice(84);
  int touched = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 out = dice.vector(1.0).normalized();
    bench.state.placed = false;
    // flat on the ball
    bench.state.orientation = Quaternion::FromTwoVectors(Vec3::UnitZ(), out);
    const Vec3 back = bench.state.orientation * Vec3(-0.009, -0.001, 0.0);
    bench.move_hand(0.032 * out + back);
    const Vec3 felt = bench.move_hand(0.0245 * out + back, 200);
    Vec3 torque;
    const Vec3 force = bench.force_on_particles(&torque);
    REQUIRE((force + felt + bench.state.residual).norm() < 1e-12);
    CHECK(bench.state.residual.norm() < 1e-6);
    const Vec3 about = torque - bench.state.position.cross(force);
    CHECK((about + bench.state.torque).norm() < 1e-12);
    touched += felt.norm() > 0.01;
  }
  CHECK(touched == 20);
}

TEST_CASE("a triangle at the joint of two capsules is pushed once") {
  const Vec3 a(-0.002, -0.002, 0.0), b(0.002, -0.002, 0.0), c(0.0, 0.002, 0.0);
  const Tool one{.radius = 0.002, .stiffness = 2e7, .capsules = {{{-0.01, 0, 0}, {0.01, 0, 0}}}};
  Tool two = one;
  two.capsules = {{{-0.01, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0.01, 0, 0}}};
  const Vec3 p(0.0, 0.0, 0.001);
  Contact whole, parts;

  REQUIRE(find_shape_contact({one, Axes(one, Quaternion::Identity())}, 1e-6, p, a, b, c, whole));
  REQUIRE(find_shape_contact({two, Axes(two, Quaternion::Identity())}, 1e-6, p, a, b, c, parts));

  CHECK(parts.force == doctest::Approx(whole.force).epsilon(1e-9));
}

TEST_CASE("T5: capsules a tenth of a millimetre over a plane feel exactly nothing") {
  Bench bench(scenes::make_sheet(33, 33, 0.024), make_chain());
  bench.candidates = Candidates(static_cast<int>(bench.mesh.triangles.size()), 2);
  for (int i = 0; i < 200; ++i) {
    const Vec3 hand(0.001 + 2e-5 * i, 0.01, kRadius + 1e-4);
    REQUIRE(bench.move_hand(hand) == Vec3::Zero());
    REQUIRE(bench.state.position == hand);
    REQUIRE(bench.candidates.count > 0);
  }
}

TEST_CASE("T6: capsules pressed four radii into a narrow dent stay finite and outside") {
  // two walls 2.5 mm apart at the top that meet 10 mm below
  SurfaceMesh mesh;
  mesh.vertices = {{-0.00125, -0.02, 0.0}, {0.0, -0.02, -0.010}, {0.00125, -0.02, 0.0},
                   {-0.00125, 0.02, 0.0},  {0.0, 0.02, -0.010},  {0.00125, 0.02, 0.0}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  Bench bench(mesh, {.radius = 0.001, .capsules = {{{0, -0.005, 0}, {0, 0.005, 0}}}});
  bench.candidates = Candidates(4, 1);
  bench.move_hand({0.0, 0.0, 0.002});
  for (int i = 0; i < 600; ++i) {
    const Vec3 felt = bench.move_hand({1e-4, 0.0, 0.002 - 1e-5 * i});
    REQUIRE(felt.allFinite());
    REQUIRE(bench.state.position.allFinite());
  }
  CHECK(bench.state.position.z() > -0.010);
  CHECK(std::abs(bench.state.position.x()) < 0.00125);
}
