// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "palpate/sim/model/build_solid.h"
#include "scenes/grasped.h"

// G1 to G6: what two jaws hold, through the tick the hand feels [contact: jaws], on walls of
// springs by the hard law, on a wall of prisms, and on solids by their near field.

using namespace palpate;
using scenes::GraspingHand;

namespace {

constexpr double kFriction = 0.5;

/// [N] Every jaw presses with it, the layer between them included.
struct Sliding {
  double least = 1e9, most = 0.0;  // [-] what sticks carries, over 2 mu N
  double vector = 0.0;             // [-] the same as a vector, at most
  double share = 0.0;              // [-] of the pinch that is on what lies between both pads
};

/// Drawn out by 8 mm; while it slides, from 4 mm on.
Sliding draw_out(const Scene& scene, double mu) {
  GraspingHand hand(scene);
  hand.close();
  hand.wait(0.2);
  hand.go(0.004, 0.2);
  Sliding sliding;
  hand.after_tick = [&] {
    const ToolState& tool = hand.tool();
    double most = 0.0;  // mu N of all anchors, N what lies between the pads has of friction
    for (int k = 0; k < tool.anchor_count; ++k) {
      most += mu * tool.anchors[static_cast<std::size_t>(k)].pressed;
    }
    if (!(most > 0.0)) return;
    CHECK(most < 2.0 * mu * tool.pinch * (1.0 + 1e-9));
    sliding.least = std::min(sliding.least, tool.held_load / most);
    sliding.most = std::max(sliding.most, tool.held_load / most);
    sliding.vector = std::max(sliding.vector, tool.carried.norm() / most);
    sliding.share = std::max(sliding.share, most / (2.0 * mu * tool.pinch));
  };
  hand.go(0.004, 0.2);
  CHECK_FALSE(hand.world().alarm);
  return sliding;
}

struct Hold {
  double mean = 0.0;   // [N]
  double swing = 0.0;  // [N] from peak to peak
  double drift = 0.0;  // [m] of the tool
};

/// What is felt of a hold over so long [s], once it has come to rest.
Hold measure_hold(GraspingHand& hand, double time) {
  const Vec3 from = hand.tool().position;
  double low = 1e9, high = 0.0, sum = 0.0;
  hand.after_tick = [&] {
    const double force = hand.force().norm();
    low = std::min(low, force);
    high = std::max(high, force);
    sum += force;
  };
  hand.wait(time);
  hand.after_tick = {};
  return {sum / (time * 1e3), high - low, (hand.tool().position - from).norm()};
}

/// [-] The largest step of the force from a tick to the next while it is let go, over the force.
double let_go(GraspingHand& hand) {
  const double held = hand.force().norm();
  Vec3 last = hand.force();
  double worst = 0.0;
  hand.after_tick = [&] {
    worst = std::max(worst, (hand.force() - last).norm());
    last = hand.force();
  };
  hand.open();
  hand.wait(0.15);
  hand.after_tick = {};
  return worst / held;
}

/// What slips carries at the most, over mu times what presses it, and N as part of the pinch.
void check_slip(double grip, double mu, int rounds, double least) {
  CAPTURE(grip);
  CAPTURE(mu);
  CAPTURE(rounds);
  const Scene scene =
      scenes::make_grasped_slab(scenes::make_grasper(mu, grip), 1000.0, 3e7, 1000.0, rounds);
  const Sliding sliding = draw_out(scene, mu);
  MESSAGE("N ", grip, ", mu ", mu, ": ", sliding.least, " to ", sliding.most, ", as a vector ",
          sliding.vector, ", of the pinch ", sliding.share);
  CHECK(sliding.share > least);
  CHECK(sliding.most < 1.0 + 1e-9);
  CHECK(sliding.most > least);
}

constexpr int kRound = 4;  // pieces of the half circle at the rim of a slab

}  // namespace

TEST_CASE("G1: jaws slip at 2 mu N within 3 %") { check_slip(1.0, 0.5, kRound, 0.97); }

TEST_CASE("G1: jaws of every grip slip at 2 mu N within 3 %" * doctest::test_suite("landing")) {
  for (const double grip : {0.2, 1.0, 5.0}) {
    for (const double mu : {0.3, 0.5}) check_slip(grip, mu, kRound, 0.97);
  }
}

TEST_CASE("G1: walls of prisms and solids slip at 2 mu N within 3 %" *
          doctest::test_suite("landing")) {
  const Tool pinch = scenes::make_grasper(kFriction, 1.0);
  const Tool gentle = scenes::make_grasper(kFriction, 0.1);
  const std::array held{scenes::make_grasped_wall(pinch, 1000.0),
                        scenes::make_grasped_block(gentle, 1000.0, build_solid),
                        scenes::make_grasped_block(gentle, 1000.0, build_linear_solid)};
  for (const Scene& scene : held) {
    const Sliding sliding = draw_out(scene, kFriction);
    MESSAGE(sliding.least, " to ", sliding.most, ", as a vector ", sliding.vector,
            ", of the pinch ", sliding.share);
    CHECK(sliding.share > 0.97);
    CHECK(sliding.most > 0.97);
    CHECK(sliding.most < 1.0 + 1e-9);
  }
}

// At a rim of two right angles triangles are seen edge-on, where a contact fades: jaws that pinch
// hard chatter about it, and what slips keeps the least that it has been pressed with.
TEST_CASE("G1: about a rim with sharp edges they reach nine tenths of it" *
          doctest::test_suite("landing")) {
  for (const double mu : {0.3, 0.5}) check_slip(5.0, mu, 1, 0.9);
}

namespace {

/// A hand of each stiffness draws what it holds out by `way` [m].
void check_hold(const Scene& scene, double way, double least) {
  const double coupling = scene.instruments[0].coupling.stiffness;
  CAPTURE(coupling);
  GraspingHand hand(scene);
  hand.close();
  hand.wait(0.2);
  hand.go(way, 0.15);
  hand.wait(0.5);
  const Hold hold = measure_hold(hand, 1.0);
  MESSAGE("K ", coupling, ": ", hold.mean, " N, peak to peak ", 100.0 * hold.swing / hold.mean,
          " %, drift ", 1e6 * hold.drift, " um");
  CHECK(hold.mean > least);
  CHECK(hold.swing < 0.01 * hold.mean);
  CHECK(hold.drift < 1e-5);
  CHECK(hand.tool().pinches);
}

void check_release(double coupling) {
  CAPTURE(coupling);
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kFriction, 1.0), coupling);
  GraspingHand hand(scene);
  hand.close();
  hand.wait(0.2);
  hand.go(0.004, 0.2);
  hand.wait(0.1);
  const double step = let_go(hand);
  MESSAGE("K ", coupling, ": ", 100.0 * step, " %");
  CHECK(step < 0.1);
  CHECK(hand.tool().anchor_count == 0);
  CHECK(hand.tool().pinch == 0.0);
  CHECK_FALSE(hand.world().alarm);
}

void check_again(int times) {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kFriction, 1.0), 500.0);
  GraspingHand hand(scene), other(scene);
  std::vector<double> pinches;
  for (int i = 0; i < times; ++i) {
    for (GraspingHand* each : {&hand, &other}) {
      each->close();
      each->wait(0.12);
      each->go(0.001, 0.02);
      each->wait(0.05);
    }
    pinches.push_back(hand.tool().pinch);
    CHECK(hand.tool().anchor_count > 10);
    for (GraspingHand* each : {&hand, &other}) {
      each->open();
      each->go(-0.001, 0.12);
    }
    CHECK(hand.tool().anchor_count == 0);
  }
  CHECK(*std::ranges::max_element(pinches) < 1.01 * pinches.front());
  CHECK(*std::ranges::min_element(pinches) > 0.99 * pinches.front());
  CHECK(compute_hash(hand.world()) == compute_hash(other.world()));
  CHECK_FALSE(hand.world().alarm);
}

/// Of a body that is grasped, drawn out [m], and held for some seconds after it has settled.
Hold hold_for(GraspingHand& hand, double drawn, double settles, double seconds) {
  hand.close();
  hand.wait(0.2);
  hand.go(drawn, 0.1);
  hand.wait(settles);
  const Hold hold = measure_hold(hand, seconds);
  MESSAGE("drift ", 1e9 * hold.drift, " nm, ", 1e6 * hold.swing, " uN");
  return hold;
}

}  // namespace

TEST_CASE("G2: a held grasp comes to rest for every hand" * doctest::test_suite("verify")) {
  const Tool tool = scenes::make_grasper(kFriction, 1.0);
  for (const double coupling : {200.0, 500.0, 1000.0}) {
    check_hold(scenes::make_grasped_slab(tool, coupling), 0.003, 0.2);
    check_hold(scenes::make_grasped_wall(tool, coupling), 0.002, 0.2);
  }
}

TEST_CASE("G2: and so does one of a solid" * doctest::test_suite("landing")) {
  const Tool tool = scenes::make_grasper(kFriction, 0.1);
  for (const double coupling : {200.0, 500.0, 1000.0}) {
    check_hold(scenes::make_grasped_block(tool, coupling, build_solid), 0.001, 0.02);
    check_hold(scenes::make_grasped_block(tool, coupling, build_linear_solid), 0.001, 0.02);
  }
}

TEST_CASE("G2: a grasp that is held for a minute keeps its load" * doctest::test_suite("verify")) {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kFriction, 1.0), 500.0);
  GraspingHand hand(scene);
  const Hold hold = hold_for(hand, 0.002, 1.0, 60.0);
  CHECK(hold.drift < 1e-6);
  CHECK(hold.swing < 500.0 * 1e-6);  // K times the most drift
}

TEST_CASE("G2: so do a wall of prisms and a solid, within 10 um and 1 mN" *
          doctest::test_suite("verify")) {
  const Tool pinch = scenes::make_grasper(kFriction, 1.0);
  const Tool gentle = scenes::make_grasper(kFriction, 0.1);
  const std::array held{scenes::make_grasped_wall(pinch, 500.0),
                        scenes::make_grasped_block(gentle, 500.0, build_solid)};
  for (const Scene& scene : held) {
    GraspingHand hand(scene);
    const Hold hold = hold_for(hand, 0.0015, 1.0, 60.0);
    CHECK(hand.tool().pinches);
    CHECK(hold.drift < 1e-5);
    CHECK(hold.swing < 1e-3);
    CHECK_FALSE(hand.world().alarm);
  }
}

TEST_CASE("G2: walls and a solid creep in jaws by less than 1 um in 10 s" *
          doctest::test_suite("verify")) {
  const Tool pinch = scenes::make_grasper(kFriction, 1.0);
  const Tool gentle = scenes::make_grasper(kFriction, 0.1);
  const std::array held{scenes::make_grasped_slab(pinch, 500.0),
                        scenes::make_grasped_wall(pinch, 500.0),
                        scenes::make_grasped_block(gentle, 500.0, build_solid)};
  for (const Scene& scene : held) {
    GraspingHand hand(scene);
    const Hold hold = hold_for(hand, 0.0015, 1.0, 10.0);
    CHECK(hand.tool().pinches);
    CHECK(hold.drift < 1e-6);
  }
}

// Triangles that lie flat under a jaw used to be pushed at one end or the other by turns.
TEST_CASE("G2: springs in jaws come to rest") {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kFriction, 1.0), 500.0);
  GraspingHand hand(scene);
  const Hold hold = hold_for(hand, 0.002, 0.5, 0.2);
  CHECK(hold.drift < 1e-8);
  CHECK(hold.swing < 1e-5);
}

TEST_CASE("G3: what is let go steps by no more than a tenth of its load") { check_release(500.0); }

TEST_CASE("G3: so it does for soft and stiff hands" * doctest::test_suite("landing")) {
  for (const double coupling : {200.0, 1000.0}) check_release(coupling);
}

TEST_CASE("G4: jaws that close on nothing press with nothing, and stop where they meet") {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kFriction, 5.0), 500.0);
  GraspingHand hand(scene);
  hand.go(0.04, 0.1);
  hand.close();
  hand.after_tick = [&] { CHECK(hand.force().norm() == 0.0); };
  hand.wait(0.1);
  CHECK(hand.tool().jaw_angle == 0.0);
  CHECK(hand.tool().pinch == 0.0);
  CHECK_FALSE(hand.tool().has_hold());
}

TEST_CASE("G6: what grasps again holds as much as the first time, with the same bits") {
  check_again(2);
}

TEST_CASE("G6: and again" * doctest::test_suite("verify")) { check_again(100); }

TEST_CASE("G6: and a thousand times" * doctest::test_suite("verify")) { check_again(1000); }

TEST_CASE("T9: what jaws do to tissue is what the hand feels, and its torque the tool's") {
  const Scene scene = scenes::make_grasped_slab(scenes::make_grasper(kFriction, 1.0), 500.0);
  GraspingHand hand(scene);
  hand.close();
  hand.wait(0.2);
  hand.go(0.002, 0.1);
  hand.wait(0.4);
  const World& world = hand.world();
  const ToolState& tool = hand.tool();
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  for (const Push& push : world.pair(0, 0).load.pushes()) {
    const Triangle& t = scene.bodies[0].tissue.triangles[std::size_t(push.triangle)];
    sum += push.force;
    torque -= (compute_point(t, push.weights, world.bodies[0].tissue.position) - tool.position)
                  .cross(push.force);
  }
  const Vec3 felt = 500.0 * (tool.position - world.instruments[0].hand);
  CHECK((sum + felt + tool.residual).norm() < 1e-9);
  CHECK(tool.residual.norm() < 1e-3);
  CHECK((torque - tool.torque).norm() < 1e-4);
}

namespace {

// tetrahedra of 5 mm under jaws of 1.2 mm chatter in the third digit
void check_body(const std::string& name, const Scene& scene, double swing, double part) {
  CAPTURE(name);
  GraspingHand hand(scene);
  hand.close();
  hand.wait(0.25);
  hand.go(0.001, 0.1);
  hand.wait(0.3);
  CHECK(hand.tool().pinches);
  const Hold hold = measure_hold(hand, 0.3);
  MESSAGE(name, ": ", hold.mean, " N, pinch ", hand.tool().pinch, " N, peak to peak ",
          1e3 * hold.swing, " mN, drift ", 1e6 * hold.drift, " um");
  CHECK(hold.swing < swing);
  CHECK(hand.tool().held_load <= 2.0 * kFriction * hand.tool().pinch * (1.0 + 1e-9));
  const double load = hand.tool().held_load;
  const double step = let_go(hand) * hold.mean;
  MESSAGE(name, ": step of ", 1e3 * step, " mN of ", 1e3 * load, " mN held");
  CHECK(step < part * load);
  CHECK(hand.tool().anchor_count == 0);
  CHECK_FALSE(hand.world().alarm);
}

}  // namespace

// a wall that the pinch has buckled snaps back as the jaws open
TEST_CASE("a wall of prisms is held, and let go") {
  check_body("prisms", scenes::make_grasped_wall(scenes::make_grasper(kFriction, 1.0), 500.0), 1e-4,
             0.1);
}

TEST_CASE("solids are held by their near field, and let go" * doctest::test_suite("landing")) {
  const Tool tool = scenes::make_grasper(kFriction, 0.1);
  check_body("solid", scenes::make_grasped_block(tool, 500.0, build_solid), 5e-3, 0.3);
  check_body("linear solid", scenes::make_grasped_block(tool, 500.0, build_linear_solid), 1e-3,
             0.2);
}
