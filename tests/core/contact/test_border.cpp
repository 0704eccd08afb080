// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tree/soups.h"
#include "palpate/sim/contact/private/list_contacts.h"
#include "palpate/sim/contact/private/touched_surface.h"
#include "palpate/sim/packed/simd_targets.h"
#include "skip.h"
#include "tool_bench.h"

using namespace palpate;

namespace {

constexpr double kSize = 0.04, kRadius = 0.003;

/// A stiff open sheet in z = 0 from the origin to (40 mm, 40 mm), which may be touched all around.
Bench make_open() {
  Bench bench(scenes::make_sheet(9, 9, kSize), {.radius = kRadius});
  bench.candidates.border = find_border(bench.mesh.triangles);
  return bench;
}

/// The hand goes straight to `to` [m] in steps of `step` [m], a tick each; what it feels there.
Vec3 go(Bench& bench, Vec3& hand, const Vec3& to, double step) {
  const Vec3 from = hand;
  const int ticks = static_cast<int>(std::ceil((to - from).norm() / step));
  Vec3 felt = Vec3::Zero();
  for (int i = 1; i <= ticks; ++i) {
    hand = from + (to - from) * (static_cast<double>(i) / ticks);
    felt = bench.move_hand(hand);
  }
  return felt;
}

}  // namespace

TEST_CASE("the border of an open surface is its edges of one triangle; a closed one has none") {
  const SurfaceMesh sheet = scenes::make_sheet(4, 3, 0.03);
  const std::vector<unsigned char> border = find_border(sheet.triangles);

  int edges = 0;
  for (std::size_t t = 0; t < border.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((border[t] >> k & 1) == 0) continue;
      ++edges;
      const Vec3& a = sheet.vertices[static_cast<std::size_t>(sheet.triangles[t][(k + 1) % 3])];
      const Vec3& b = sheet.vertices[static_cast<std::size_t>(sheet.triangles[t][(k + 2) % 3])];
      const Vec3 middle = 0.5 * (a + b);
      const double x = std::min(middle.x(), 0.03 - middle.x());
      const double y = std::min(middle.y(), 0.03 - middle.y());
      CHECK(std::min(x, y) == doctest::Approx(0.0).epsilon(1e-12));
    }
  }

  CHECK(edges == 10);
  CHECK(find_border(make_ball().triangles).empty());
}

TEST_CASE("what is beyond a border edge is pushed off it, by hand") {
  const Tool tool{.radius = 0.002, .stiffness = 2e7};
  const Shape ball{tool, {}};
  const Vec3 a(-0.001, 0.0, 0.0), b(0.001, 0.0, 0.0), c(0.0, 0.002, 0.0);
  Contact contact;

  // a border along a and b; 1 mm off it at every angle around it: z = 1/2, A = 2e-6 m²
  for (const double degrees : {100.0, 150.0, 180.0, 210.0, 260.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 out(0.0, std::cos(angle), std::sin(angle));
    REQUIRE(find_shape_contact(ball, 2e-6, 0.001 * out, a, b, c, contact, {1.0, 4}));
    CHECK((contact.direction - out).norm() < 1e-12);
    const double share = std::min(1.0, std::max(out.z(), -out.y()) / kFullFacing);
    CHECK(contact.force == doctest::Approx(share * 2e7 * 2e-6 * 0.001 / 0.5).epsilon(1e-9));
  }
  // without a border what is behind is not touched
  CHECK_FALSE(find_shape_contact(ball, 2e-6, {0.0, -0.001, -1e-5}, a, b, c, contact));
  // behind an open surface it is as in front
  REQUIRE(find_shape_contact(ball, 2e-6, {0.0, 5e-4, -0.001}, a, b, c, contact, {-1.0, 4}));
  CHECK((contact.direction + Vec3::UnitZ()).norm() < 1e-12);
  CHECK_FALSE(find_shape_contact(ball, 2e-6, {0.0, 5e-4, 0.001}, a, b, c, contact, {-1.0, 4}));
}

TEST_CASE("behind an open surface a tool feels what it feels in front, mirrored") {
  Bench front = make_open(), behind = make_open();
  Vec3 above(0.021, 0.018, 0.006), below(0.021, 0.018, -0.006);
  front.move_hand(above);
  behind.move_hand(below);

  const Vec3 up = go(front, above, {0.022, 0.018, -0.004}, 5e-4);
  const Vec3 down = go(behind, below, {0.022, 0.018, 0.004}, 5e-4);

  CHECK(up.z() > 0.5);
  CHECK((up - Vec3(down.x(), down.y(), -down.z())).norm() < 1e-9 * up.norm());
  CHECK(front.state.position.z() > 0.0);
  CHECK(behind.state.position.z() < 0.0);
}

TEST_CASE("a ball rolls around a border and back: no jump, no energy, and not through") {
  Bench bench = make_open();
  Vec3 hand(-0.002, 0.019, 0.004), before = bench.move_hand(hand);
  constexpr double kStep = 5e-5;
  double work = 0.0, jump = 0.0, most = 0.0;
  const auto follow = [&](const Vec3& to) {
    const Vec3 from = hand;
    const int ticks = static_cast<int>(std::ceil((to - from).norm() / kStep));
    for (int i = 1; i <= ticks; ++i) {
      const Vec3 next = from + (to - from) * (static_cast<double>(i) / ticks);
      const Vec3 felt = bench.move_hand(next);
      work += 0.5 * (felt + before).dot(next - hand);
      jump = std::max(jump, (felt - before).norm());
      most = std::max(most, felt.norm());
      hand = next;
      before = felt;
    }
  };

  // pressed from above onto the sheet near its border, off it, around, from below, and back
  const Vec3 way[] = {{0.004, 0.019, 0.004},   {0.004, 0.019, 0.001},  {-0.002, 0.019, 0.001},
                      {-0.002, 0.019, -0.001}, {0.004, 0.019, -0.001}, {0.004, 0.019, -0.004}};
  for (const Vec3& to : way) follow(to);
  CHECK(bench.state.position.z() < 0.0);
  CHECK(bench.candidates.near.side == -1.0);
  for (auto to = std::rbegin(way); to != std::rend(way); ++to) follow(*to);

  CHECK(most > 0.5);
  CHECK(jump < 2.0 * bench.coupling.stiffness * kStep);
  // what the hand was given, of a path that ends where it began
  CHECK(work < 1e-3 * most * kRadius);
  CHECK(bench.state.position == hand);
  CHECK(bench.candidates.near.side == 1.0);
}

TEST_CASE("at a border vector code touches what the plain law touches") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  Bench plain = make_open(), fast = make_open();
  const int count = static_cast<int>(plain.mesh.triangles.size());
  fast.candidates.lanes = ContactLanes(count, "", 0);
  Dice dice(5);
  int touched = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = Vec3(0.0, 0.02, 0.0) + dice.vector(0.004);
    for (Bench* bench : {&plain, &fast}) {
      bench->candidates.near.side = 0.0;
      find_candidates(bench->tree, bench->mesh.vertices, bench->tool, p, p, bench->areas,
                      bench->candidates);
    }
    const auto look = [&](Bench& bench) {
      const TouchedSurface surface{&bench.candidates, bench.mesh.triangles, bench.mesh.vertices,
                                   &bench.load};
      bench.candidates.lanes.reach = -1.0;
      follow_side({bench.tool, {}}, surface, p);
      return list_contacts(bench.tool, surface, p);
    };
    const auto a = look(plain), b = look(fast);
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      ++touched;
      CHECK(a[k].triangle == b[k].triangle);
      CHECK((a[k].contact.direction - b[k].contact.direction).norm() < 1e-9);
      CHECK(b[k].contact.force == doctest::Approx(a[k].contact.force).epsilon(1e-9));
    }
  }
  CHECK(touched > 200);
}
