// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "tool_bench.h"

using namespace palpate;

TEST_CASE("attaching to nothing does nothing") {
  Bench bench(make_ball());
  bench.move_hand({0, 0, 0.040});

  CHECK_FALSE(
      attach_tool(bench.load, bench.mesh.triangles, bench.mesh.vertices, 400.0, bench.state));
  CHECK(bench.state.hold_count == 0);
}

TEST_CASE("at the moment of attaching nothing changes, and the shares sum to the stiffness") {
  Bench bench(make_ball());
  bench.move_hand({0, 0, 0.030});
  const Vec3 hand(0.001, 0, 0.026);
  const Vec3 before = bench.move_hand(hand, 300);
  const int contacts = bench.load.push_count;

  REQUIRE(attach_tool(bench.load, bench.mesh.triangles, bench.mesh.vertices, 400.0, bench.state));
  const Vec3 after = bench.balance(hand);

  double sum = 0.0;
  for (int i = 0; i < bench.state.hold_count; ++i) {
    sum += bench.state.holds[static_cast<std::size_t>(i)].stiffness;
  }
  CHECK(bench.state.hold_count == contacts);
  CHECK(sum == doctest::Approx(400.0));
  CHECK((after - before).norm() < 1e-9);
  for (const Push& push : bench.load.pushes().subspan(static_cast<std::size_t>(contacts))) {
    CHECK(push.force.norm() < 1e-9);
  }
  // attaching once more changes nothing
  CHECK(attach_tool(bench.load, bench.mesh.triangles, bench.mesh.vertices, 900.0, bench.state));
  CHECK(bench.state.hold_count == contacts);
}

TEST_CASE("pulling on a held patch follows the two springs in series, and releasing ends it") {
  Bench bench(make_ball());
  bench.move_hand({0, 0, 0.030});
  bench.move_hand({0, 0, 0.0275}, 300);
  REQUIRE(attach_tool(bench.load, bench.mesh.triangles, bench.mesh.vertices, 400.0, bench.state));
  const Vec3 held = bench.state.position;
  const Vec3 hand = held + Vec3(0.002, 0.001, 0.006);

  const Vec3 felt = bench.move_hand(hand, 300);

  // 500 N/m of the hand and 400 N/m of the patch: 500 x 400 / 900 = 222.2 N/m
  CHECK_FALSE(bench.state.touching);
  CHECK((felt - (-500.0 * 400.0 / 900.0) * (hand - held)).norm() < 1e-9);
  CHECK((bench.force_on_particles() + felt).norm() < 1e-9);
  CHECK(felt.z() < 0.0);

  release_tool(bench.state);
  CHECK(bench.move_hand(hand) == Vec3::Zero());
  CHECK(bench.load.push_count == 0);
}

TEST_CASE("a pull beyond the limit of the hand's spring is limited and still balances") {
  Bench bench(make_ball());
  bench.move_hand({0, 0, 0.030});
  bench.move_hand({0, 0, 0.0275}, 300);
  attach_tool(bench.load, bench.mesh.triangles, bench.mesh.vertices, 400.0, bench.state);

  const Vec3 felt = bench.move_hand({0, 0, 0.100}, 300);

  CHECK(felt.norm() == doctest::Approx(bench.coupling.force_max));
  CHECK((bench.force_on_particles() + felt).norm() < 1e-9);
}

TEST_CASE("a hand whose spring is at its limit within microns feels the patch, and not the limit") {
  for (const double way : {1e-5, 1e-4, 1e-3}) {
    Bench bench(make_ball());
    bench.coupling.stiffness = 1e6;  // 5 N at 5 um
    bench.move_hand({0, 0, 0.030});
    bench.move_hand({0, 0, 0.0275}, 300);
    attach_tool(bench.load, bench.mesh.triangles, bench.mesh.vertices, 400.0, bench.state);
    const Vec3 hand(0.0, 0.0, 0.0275 + way);

    const Vec3 at_once = bench.move_hand(hand);
    const Vec3 at_rest = bench.move_hand(hand, 3000);

    CHECK(at_rest.norm() < 1.0);
    CHECK((at_once - at_rest).norm() < 0.05);
  }
}
