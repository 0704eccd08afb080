// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "palpate/sim/arm/plant.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/build_solid.h"
#include "scenes/grasped.h"

// G3: what jaws let go springs back with no more energy than it had stored, and a hand that yields
// to what it feels feels it as evenly as one that stands still [contact: release].

using namespace palpate;
using scenes::GraspingHand;

namespace {

constexpr double kFriction = 0.5, kCoupling = 500.0;

/// [N] What is felt may step by from tick to tick however little was held: no hand tells less.
constexpr double kFloor = 0.01;

/// [N] By which a tick may step more under a hand that yields.
constexpr double kMoreInLoop = 0.05;

/// The hand of arm/plant.h, a mass on spring and damper, which stays where it wants to be but for
/// what it is pushed by. Out of the loop, the hand stays where it is whatever it feels.
class HoldingHand {
 public:
  explicit HoldingHand(GraspingHand& hand)
      : hand_(hand), wanted_(hand.sample().position - hand.force() / kHand.stiffness) {}

  /// One tick under the force [N] of the tick before, semi-implicit Euler in tenths of it.
  void step() {
    constexpr int kParts = 10;
    constexpr double kPart = 1e-3 / kParts;
    Vec3& x = hand_.sample().position;
    for (int i = 0; i < kParts; ++i) {
      const Vec3 pull = kHand.stiffness * (wanted_ - x) - kHand.damping * velocity_;
      velocity_ += kPart / kHand.mass * (pull + hand_.force());
      x += kPart * velocity_;
    }
    hand_.step();
  }

 private:
  static constexpr Hand kHand{};

  GraspingHand& hand_;
  Vec3 wanted_, velocity_ = Vec3::Zero();
};

struct Release {
  double load = 0.0;     // [N] felt before
  double step = 0.0;     // [N] from a tick to the next, at most
  double stored = 0.0;   // [J] in the body when it begins
  double kinetic = 0.0;  // [J] of the body, at most
};

Energy measure_energy(const Scene& scene, const World& world) {
  return compute_energy(scene.bodies[0].tissue, Vec3::Zero(), world.bodies[0].tissue);
}

/// Held, drawn out by `way` [m], and let go by a hand that yields, or by one that does not.
Release let_go(const Scene& scene, double way, bool yields) {
  GraspingHand hand(scene);
  const double at_rest = measure_energy(scene, World(scene)).elastic();
  hand.close();
  hand.wait(0.2);
  hand.go(way, 0.2);
  hand.wait(0.2);
  REQUIRE(hand.tool().pinches);
  Release release{.load = hand.force().norm(),
                  .stored = measure_energy(scene, hand.world()).elastic() - at_rest};
  Vec3 last = hand.force();
  hand.after_tick = [&] {
    release.step = std::max(release.step, (hand.force() - last).norm());
    release.kinetic = std::max(release.kinetic, measure_energy(scene, hand.world()).kinetic);
    last = hand.force();
  };
  hand.open();
  HoldingHand muscles(hand);
  for (int i = 0; i < 300; ++i) yields ? muscles.step() : void(hand.step());
  CHECK(hand.tool().anchor_count == 0);
  CHECK_FALSE(hand.world().alarm);
  return release;
}

void check_release(const std::string& name, const Scene& scene, double way) {
  CAPTURE(name);
  const Release open = let_go(scene, way, false), closed = let_go(scene, way, true);
  for (const Release& release : {open, closed}) {
    MESSAGE(name, ": load ", release.load, " N, step ", 1e3 * release.step, " mN, stored ",
            1e3 * release.stored, " mJ, kinetic ", 1e3 * release.kinetic, " mJ");
    CHECK(release.step < std::max(0.2 * release.load, 1.001 * kFloor));
    CHECK(release.stored > 0.0);
    CHECK(release.kinetic < release.stored);
  }
  CHECK(open.load == closed.load);
  CHECK(closed.step < open.step + kMoreInLoop);
}

}  // namespace

TEST_CASE("G3: what is let go moves with less than it had stored, in the loop as out of it") {
  check_release("springs",
                scenes::make_grasped_slab(scenes::make_grasper(kFriction, 1.0), kCoupling), 0.003);
}

TEST_CASE("G3: so do a wall of prisms and solids" * doctest::test_suite("landing")) {
  const Tool pinch = scenes::make_grasper(kFriction, 1.0);
  const Tool gentle = scenes::make_grasper(kFriction, 0.1);
  check_release("prisms", scenes::make_grasped_wall(pinch, kCoupling), 0.002);
  check_release("solid", scenes::make_grasped_block(gentle, kCoupling, build_solid), 0.001);
  check_release("linear solid", scenes::make_grasped_block(gentle, kCoupling, build_linear_solid),
                0.001);
}

// Loads that a hand feels, of a solid that bears them.
TEST_CASE("G3: so do solids that are drawn out by half a newton" * doctest::test_suite("landing")) {
  const Tool tool = scenes::make_parallel_grasper(kFriction, 0.3);
  check_release("bar", scenes::make_grasped_bar(tool, kCoupling, build_solid), 0.003);
  check_release("linear bar", scenes::make_grasped_bar(tool, kCoupling, build_linear_solid), 0.003);
}
