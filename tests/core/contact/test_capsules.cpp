// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tree/soups.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/list_contacts.h"
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

namespace {

Shape make_shape(const Tool& tool, const Vec3& from, const Vec3& to) {
  Shape shape{tool, {}};
  shape.axes.capsules[0] = {from, to};
  shape.axes.count = 1;
  return shape;
}

/// The largest steps by which the point that is pressed goes over a triangle of two millimetres, as
/// the axis above it goes from one place to another in a thousand steps.
struct Steps {
  double closest = 0.0, spread = 0.0;  // [-] of a weight
};

Steps turn_axis(const Capsule& first, const Capsule& last, const std::array<Vec3, 3>& corners) {
  const Tool tool{.radius = 0.0012, .stiffness = kStiffness};
  const auto& [a, b, c] = corners;
  Steps most;
  Vec3 closest, spread;
  for (int i = 0; i <= 1000; ++i) {
    const double part = 1e-3 * i;
    const Vec3 from = first.from + part * (last.from - first.from);
    const Vec3 to = first.to + part * (last.to - first.to);
    Contact contact;
    REQUIRE(find_capsule_contact(tool, 1e-6, from, to, a, b, c, contact));
    const Vec3 before = contact.weights;
    spread_contact(make_shape(tool, from, to), Vec3::Zero(), a, b, c, contact);
    CHECK(contact.weights.sum() == doctest::Approx(1.0));
    CHECK(contact.weights.minCoeff() >= 0.0);
    if (i > 0) {
      most.closest = std::max(most.closest, (before - closest).cwiseAbs().maxCoeff());
      most.spread = std::max(most.spread, (contact.weights - spread).cwiseAbs().maxCoeff());
    }
    closest = before;
    spread = contact.weights;
  }
  return most;
}

}  // namespace

// The closest point of a triangle goes from end to end of it where a jaw turns past parallel, and
// what is pushed there by turns never comes to rest.
TEST_CASE("where a jaw presses on a triangle does not jump as they turn past parallel") {
  const std::array<Vec3, 3> corners = {Vec3(0, 0, 0), Vec3(0.002, 0, 0), Vec3(0, 0.002, 0)};
  const Vec3 from(-0.01, 0.0005, 0.0009), to(0.01, 0.0005, 0.0009);
  const Vec3 up(0, 0, 0.0005), aside(0, 0.002, 0), beside(0, -0.0009, 0);
  const Steps tilts = turn_axis({from + up, to - up}, {from - up, to + up}, corners);
  CHECK(tilts.closest > 0.5);
  CHECK(tilts.spread < 0.01);
  // in the triangle's plane, beside the edge that it is parallel to on the way
  const Steps turns = turn_axis({from + beside - aside, to + beside + aside},
                                {from + beside + aside, to + beside - aside}, corners);
  CHECK(turns.closest > 0.5);
  CHECK(turns.spread < 0.01);
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
    ContactLanes jaws = lanes;
    jaws.find_jaws(jaws, tool.radius, tool.stiffness);
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
      CHECK(jaws.force[t] == lanes.force[t]);
      spread_contact(make_shape(tool, from, to), Vec3::Zero(), a, b, c, expected);
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(jaws.weights[k][t] - expected.weights[static_cast<Eigen::Index>(k)]) < 1e-6);
      }
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

TEST_CASE(
    "triangles out of reach are left out of lanes until the tool may reach them, to the bit") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const Tool tool = make_chain();
  Bench bench(make_ball(4), tool), fresh(make_ball(4), tool);
  const int count = static_cast<int>(bench.mesh.triangles.size());
  for (Bench* each : {&bench, &fresh}) each->candidates.lanes = ContactLanes(count, "", 2);
  Dice dice(8);
  int touched = 0, left_out = 0;
  for (int way = 0; way < 40; ++way) {
    const Quaternion turn = turn_by(dice);
    const Shape shape{tool, Axes(tool, turn)};
    const Vec3 from = 0.0255 * dice.vector(1.0).normalized(), step = dice.vector(2e-4);
    ContactLanes& lanes = bench.candidates.lanes;
    lanes.reach = -1.0;
    // out to more than a radius, in which lanes are filled again several times
    for (int k = 0; k < 15; ++k) {
      const Vec3 p = from + k * step;
      for (Bench* each : {&bench, &fresh}) {
        find_candidates(each->tree, each->mesh.vertices, tool, p, p, each->areas, each->candidates,
                        turn);
      }
      const auto on = [&](Bench& its) {
        return TouchedSurface{&its.candidates, its.mesh.triangles, its.mesh.vertices, &its.load};
      };
      std::vector<TriangleContact> seen;
      for_each_closest(shape, on(bench), p, [&](int t, const Contact& contact) {
        seen.push_back({t, contact});
      });
      const auto all = list_contacts(tool, on(fresh), p, turn);
      REQUIRE(seen.size() == all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(seen[i].triangle == all[i].triangle);
        CHECK(seen[i].contact.force == all[i].contact.force);
        CHECK(seen[i].contact.direction == all[i].contact.direction);
      }
      touched += static_cast<int>(all.size());
      left_out += bench.candidates.count - lanes.count;
    }
  }
  CHECK(touched > 1000);
  CHECK(left_out > 1000);
}
