// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/tick/press_scene.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/flicks.h"

// How an instrument of capsules is turned [contact: trocar].

using namespace palpate;
using scenes::hand_at;

namespace {

const Vec3 kTrocar(0.02, -0.03, 0.20);

Scene make_scene(bool with_trocar) {
  Scene scene = testing::press_scene();
  scene.instruments[0].tool.capsules = {{{0, 0, 0}, {0, 0, 0.02}}};
  if (with_trocar) scene.instruments[0].trocar = kTrocar;
  return build_scene(std::move(scene));
}

}  // namespace

TEST_CASE("T7: the shaft passes the trocar, wherever the tip is and however the hand is turned") {
  const Scene scene = make_scene(true);
  World world(scene);
  for (int i = 0; i < 300; ++i) {
    const double angle = 0.02 * i;
    HapticSample sample = hand_at({0.04 * std::cos(angle), 0.04 * std::sin(angle), 0.05});
    sample.orientation = Quaternion(Eigen::AngleAxisd(0.3 * angle, Vec3(1, 2, 3).normalized()));
    const Vec3 tip = i == 0 ? sample.position : world.instruments[0].tool.position;
    tick(scene, sample, 1e-3, world);
    const Vec3 away = kTrocar - tip, axis = world.instruments[0].tool.orientation * Vec3::UnitZ();
    REQUIRE(away.cross(axis).norm() < 1e-12 * away.norm());
    REQUIRE(away.dot(axis) > 0.0);
  }
}

TEST_CASE("about its shaft an instrument is turned by the hand") {
  const Scene scene = make_scene(true);
  World still(scene), turned(scene);
  HapticSample sample = hand_at({0.0, 0.0, 0.05});
  tick(scene, sample, 1e-3, still);
  sample.orientation = Quaternion(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  tick(scene, sample, 1e-3, turned);
  const Quaternion& before = still.instruments[0].tool.orientation;
  const Quaternion& after = turned.instruments[0].tool.orientation;
  CHECK(before.angularDistance(after) == doctest::Approx(0.7).epsilon(1e-9));
}

TEST_CASE("without a trocar the instrument is held as the device is, and a ball is never turned") {
  HapticSample sample = hand_at({0.0, 0.0, 0.05});
  sample.orientation = Quaternion(Eigen::AngleAxisd(0.4, Vec3::UnitX()));
  const Scene scene = make_scene(false), ball = testing::press_scene();
  World world(scene), other(ball);
  tick(scene, sample, 1e-3, world);
  tick(ball, sample, 1e-3, other);
  CHECK(world.instruments[0].tool.orientation.angularDistance(sample.orientation) < 1e-12);
  CHECK(other.instruments[0].tool.orientation.coeffs() == Quaternion::Identity().coeffs());
}

TEST_CASE("a tip at its trocar is turned no further") {
  const Scene scene = make_scene(true);
  World world(scene);
  tick(scene, hand_at(kTrocar - Vec3(0, 0, 0.01)), 1e-3, world);
  const Quaternion before = world.instruments[0].tool.orientation;
  for (int i = 0; i < 20; ++i) {
    tick(scene, hand_at(kTrocar + Vec3(1e-3 * std::sin(i), 1e-3 * std::cos(i), 0)), 1e-3, world);
  }
  CHECK(world.instruments[0].tool.position.isApprox(
      kTrocar + Vec3(1e-3 * std::sin(19), 1e-3 * std::cos(19), 0)));
  CHECK(before.angularDistance(world.instruments[0].tool.orientation) < 0.2);
}

TEST_CASE("where tissue bears no more, an instrument turns against it the slower, and gives way") {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  constexpr double kDt = 1e-3, kMost = 3.0 * kDt;  // [rad] in a tick
  constexpr double kBearable = 0.1;                // [N], 2 mN m about the far end at 20 mm
  const Vec3 tip(0.0, 0.0, 0.05);
  for (const bool with_trocar : {false, true}) {
    CAPTURE(with_trocar);
    Instrument instrument = make_scene(with_trocar).instruments[0];
    ToolState state;
    state.position = tip;
    turn_tool(instrument, Quaternion::Identity(), kDt, kNone, state);
    state.placed = true;
    const Quaternion start = state.orientation;
    const Vec3 shaft = start * Vec3::UnitZ();
    // [rad] by which a hand that has rolled by 0.5 rad turns it against so much of `torque` [N m]
    const auto turn = [&](double torque, double bearable) {
      ToolState turned = state;
      turned.torque = -torque * shaft;
      const Quaternion hand(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
      turn_tool(instrument, hand, kDt, bearable, turned);
      const Eigen::AngleAxisd by(turned.orientation * start.conjugate());
      CHECK(by.axis().cross(shaft).norm() * by.angle() < 1e-9);
      // said where tissue is what limits it
      CHECK(turned.turn_limited == (torque > 0.0 && bearable == kBearable));
      return by.angle() * by.axis().dot(shaft);
    };
    const double free = turn(0.0, kNone);
    CHECK(free > kMost);
    CHECK(turn(0.0, kBearable) == free);
    CHECK(turn(1e-3, kNone) == free);
    CHECK(turn(1e-3, kBearable) == doctest::Approx(0.5 * kMost).epsilon(1e-6));
    CHECK(turn(2e-3, kBearable) == doctest::Approx(0.0).scale(kMost).epsilon(1e-6));
    CHECK(turn(3e-3, kBearable) == doctest::Approx(-0.5 * kMost).epsilon(1e-6));
    CHECK(turn(9e-3, kBearable) == doctest::Approx(-kMost).epsilon(1e-6));
    CHECK(turn(-1e-3, kBearable) == doctest::Approx(free));
  }
}

TEST_CASE("an instrument that is pressed hard turns at 3 rad/s at the most, and that is said") {
  constexpr double kDt = 1e-3, kMost = 3.0 * kDt;
  const Instrument instrument = make_scene(false).instruments[0];
  const Quaternion hand(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
  const auto turn = [&](double torque, const Quaternion& to) {
    ToolState state;
    state.placed = true;
    state.torque = Vec3(torque, 0.0, 0.0);
    turn_tool(instrument, to, kDt, std::numeric_limits<double>::infinity(), state);
    return std::pair(state.orientation.angularDistance(Quaternion::Identity()), state.turn_limited);
  };
  const auto [free, of_free] = turn(0.0, hand);
  const auto [pressed, of_pressed] = turn(0.03, hand);
  CHECK(free > kMost);
  CHECK_FALSE(of_free);
  CHECK(pressed == doctest::Approx(kMost));
  CHECK(of_pressed);
  CHECK_FALSE(turn(0.03, Quaternion(Eigen::AngleAxisd(0.5 * kMost, Vec3::UnitX()))).second);
}
