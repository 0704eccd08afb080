// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "palpate/sim/grasp/private/jaws.h"
#include "scenes/grasped.h"

// Jaws that open in tissue, and hinges that resist [contact: jaws].

using namespace palpate;

namespace {

constexpr double kGrip = 8.0, kFriction = 0.8;  // of meshes/scenarios/stomach_two_graspers.json

/// A hand that presses the face of the slab with closed jaws, which open along y.
struct PressingHand {
  explicit PressingHand(const Scene& pressed) : scene(pressed), world(pressed) {
    sample.position = Vec3(0.015, 0.0, 0.012);
    sample.buttons = kAttachButton;
  }

  /// [N] The largest force on the way.
  double go(double way, int ticks) {
    double largest = 0.0;
    for (int i = 0; i < ticks; ++i) {
      sample.position.z() += way / ticks;
      force = tick(scene, sample, 1e-3, world).force;
      largest = std::max(largest, force.norm());
    }
    return largest;
  }
  const ToolState& tool() const { return world.instruments[0].tool; }

  const Scene& scene;
  World world;
  HapticSample sample;
  Vec3 force = Vec3::Zero();
};

}  // namespace

// With all of the closing force they press either side with 3.2 N, and come out with 2 N.
TEST_CASE("jaws that open in the dent they have pressed come out of it") {
  const Scene scene =
      scenes::make_grasped_slab(scenes::make_grasper(kFriction, kGrip), 1000.0, 1e6, 100.0);
  PressingHand hand(scene);
  hand.go(-0.020, 250);
  hand.sample.buttons = 0;
  hand.go(0.0, 300);
  MESSAGE("opened to ", hand.tool().jaw_angle, " rad, pressing with ", hand.tool().pinch, " N");
  CHECK(hand.tool().pinch < 0.2 * kGrip);
  const double largest = hand.go(0.030, 300);
  hand.go(0.0, 100);
  MESSAGE("drawn out with ", largest, " N at most");
  CHECK(hand.tool().jaw_angle == scene.instruments[0].tool.jaws->open);
  CHECK(hand.force.norm() == 0.0);
  CHECK(largest < 0.2 * kGrip);
  CHECK_FALSE(hand.world.alarm);
}

// By hand, mu 0.8 and 0.1 of smooth metal: an eighth of all force, and of the pads' as much as the
// other one presses.
TEST_CASE("pads hold what lies between them, and backs slide as smooth metal") {
  const Tool tool = scenes::make_grasper(kFriction, kGrip);
  const auto grip = [&](double first, double second, double layer, int jaw, double opens) {
    const std::array<Pressed, 2> pressed = {Pressed{.pad = first}, Pressed{.pad = second}};
    return find_grip(tool.friction, pressed, layer, jaw, opens);
  };
  CHECK(grip(2.0, 2.0, 0.0, 0, 1.0) == doctest::Approx(1.0));
  CHECK(grip(2.0, 1.0, 0.0, 0, 1.0) == doctest::Approx(0.125 + 0.875 * 0.5));
  CHECK(grip(2.0, 1.0, 0.0, 1, 1.0) == doctest::Approx(1.0));
  CHECK(grip(2.0, 0.0, 0.0, 0, 1.0) == doctest::Approx(0.125));
  CHECK(grip(2.0, 1.0, 1.0, 0, 1.0) == doctest::Approx(0.125 + 0.875 * 2.0 / 3.0));
  CHECK(grip(2.0, 2.0, 0.0, 0, -1.0) == doctest::Approx(0.125));
  CHECK(grip(2.0, 2.0, 0.0, 1, 0.0) == doctest::Approx(0.125 + 0.875 * 0.5));
  CHECK(grip(0.0, 0.0, 0.0, 0, -1.0) == doctest::Approx(0.125));
  CHECK(find_grip(0.05, {Pressed{}, Pressed{}}, 0.0, 0, -1.0) == 1.0);
}

// By hand: what pushes them open with twice what they close with opens them by 20 rad/s.
TEST_CASE("the hinges of jaws that close resist what pushes them open, and not their closing") {
  const Tool tool = scenes::make_grasper(kFriction, kGrip);
  const Coupling coupling{.stiffness = 1e12, .force_max = 1e9};
  const std::array<Triangle, 1> triangles = {{{0, 1, 2}}};
  const OpenJaws jaws(tool, Quaternion::Identity(), 0.3);
  const Vec3 tip = jaws.to_scene(0, tool.capsules[0].from), way = jaws.move(0, tip);
  const double most = 2.0 * kGrip * measure_arm(tool);
  for (const double part : {2.0, 1.5, 0.5}) {
    CAPTURE(part);
    // an anchor that slips far up along the way of the tip
    const Vec3 far = tip + 0.1 * way.normalized();
    const std::vector<Vec3> x = {far, far + 0.002 * way.normalized(), far + Vec3(0, 0, 0.002)};
    Load load(8);
    Candidates first(1, 1), second(1, 1);
    const TouchedSurface surface{&first, triangles, x, &load};
    TouchedSurface other = surface;
    other.candidates = &second;
    ToolState state(0, 0, 4);
    state.placed = true;
    state.grip_limit = kGrip;
    state.jaw_angle = 0.3;
    state.anchor_count = 2;
    state.anchors[0] = {.triangle = 0, .body = 0, .jaw = 0, .weights = Vec3::UnitX()};
    state.anchors[0].place = tool.capsules[0].from;
    state.anchors[0].pressed = part * most / way.norm() / kFriction;
    state.anchors[0].stiffness = 1e9;
    // one that sticks, without strength: Newton's step is for what is held
    state.anchors[1] = state.anchors[0];
    state.anchors[1].stiffness = 1e-12;
    constexpr double dt = 5e-5;
    balance_jaws(tool, coupling, Vec3::Zero(), {{{&surface, 1}, {&other, 1}}}, dt, state);
    const double turned = part > 1.0 ? (part - 1.0) * kHingeRate * dt : -kMostTurn;
    CHECK(state.jaw_angle == doctest::Approx(0.3 + turned).epsilon(1e-6));
  }
}
