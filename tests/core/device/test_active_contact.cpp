// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "palpate/sim/device/safe_device.h"

using namespace palpate;

namespace {

constexpr double kDt = 1e-3;          // [s]
constexpr double kMass = 0.1;         // [kg] of hand and stylus
constexpr double kHold = 100.0;       // [N/m] by which the hand keeps its place
constexpr double kGrip = 0.5;         // [N·s/m] of a light hand
constexpr double kStiffness = 200.0;  // [N/m] of the contact

/// A hand that keeps its place by spring and damper and is moved by what it is sent.
struct HeldHand : HapticDevice {
  HapticSample read(double time) noexcept override {
    constexpr int kSteps = 50;
    constexpr double kStep = kDt / kSteps;
    double &x = hand.position.z(), &v = hand.velocity.z();
    for (int k = 0; k < kSteps; ++k) {
      v += kStep / kMass * (felt.z() - kHold * x - kGrip * v);
      x += kStep * v;
    }
    hand.time = time;
    return hand;
  }
  void write(const HapticCommand& command) noexcept override { felt = command.force; }
  std::string name() const override { return "held hand"; }
  /// [J] of its motion and its spring.
  double energy() const noexcept {
    return 0.5 * kMass * hand.velocity.squaredNorm() + 0.5 * kHold * hand.position.squaredNorm();
  }

  HapticSample hand;
  Vec3 felt = Vec3::Zero();
};

/// [J] of the hand, tick by tick, beyond what it begins with: pushed by a spring that also pushes
/// along with it, by `drive` [N·s/m].
struct Given {
  std::vector<double> energy;
  std::size_t begins = 0;  // tick in which the controller first acts; how many there are for none
};
Given give(double drive, double energy_max, double seconds) {
  HeldHand hand;
  hand.hand.velocity.z() = -0.02;
  SafeDevice safe(hand, {.force_max = 20.0,
                         .force_continuous = 20.0,
                         .slew_max = 1e5,
                         .ramp_time = 1e-3,
                         .start_force_max = 1.0,
                         .velocity_max = 50.0,
                         .energy_max = energy_max});
  const double before = hand.energy();
  Given given;
  for (int k = 0; k < std::lround(seconds / kDt); ++k) {
    const HapticSample sample = safe.read(k * kDt);
    given.energy.push_back(hand.energy() - before);
    safe.write({.force = drive * sample.velocity - kStiffness * sample.position});
    if (safe.damped_count() == 0) ++given.begins;
  }
  return given;
}

}  // namespace

TEST_CASE("a contact that makes energy is stopped: 50 ms on, the hand has what it may be given") {
  const double most = SafetyLimits{}.energy_max;
  for (const double drive : {1.0, 1.5, 2.0}) {
    CAPTURE(drive);
    const Given wild = give(drive, 1e6, 2.0), tame = give(drive, most, 2.0);
    const std::size_t stops = tame.begins + 50;

    CHECK(wild.begins == wild.energy.size());
    CHECK(wild.energy.back() > 50.0 * most);
    REQUIRE(stops < 1000);
    const double then = *std::max_element(tame.energy.begin(), tame.energy.begin() + long(stops));
    const double later = *std::max_element(tame.energy.begin() + long(stops), tame.energy.end());
    CHECK(then < 1.1 * most);
    CHECK(later < 1.1 * most);
  }
}

TEST_CASE("beyond the controller's damping it makes energy on, more slowly") {
  const double most = SafetyLimits{}.energy_max;
  const double drive = kGrip + 1.3 * SafetyLimits{}.damping_max;
  const Given wild = give(drive, 1e6, 0.4), tame = give(drive, most, 0.4);

  CHECK(tame.energy.back() > 3.0 * most);
  CHECK(tame.energy.back() < 0.5 * wild.energy.back());
}

namespace {

/// A hand that follows its own way, whatever it is sent, and declares what it is told to.
struct Follower : HapticDevice {
  explicit Follower(const DeviceDynamics& declared_in) : declared(declared_in) {}
  HapticSample read(double time) noexcept override {
    hand.time = time;
    return hand;
  }
  void write(const HapticCommand&) noexcept override {}
  std::string name() const override { return "follower"; }
  DeviceDynamics dynamics() const noexcept override { return declared; }

  DeviceDynamics declared;
  HapticSample hand;
};

struct Strike {
  double given = 0.0;     // [J] by the observer, when it is over
  double distance = 0.0;  // [m²/s] integral of v² over time
  long damped = 0;
};

constexpr double kSpring = 1000.0;  // [N/m]

/// 8 mm into a spring that pushes along as well, by `drive` [N·s/m], and back in 50 ms.
Strike strike(const DeviceDynamics& declared, double drive = 0.0, double energy_max = 1.0) {
  constexpr double kDeep = 8e-3, kTime = 0.05, kWait = 0.1;
  Follower hand(declared);
  SafeDevice safe(
      hand,
      {.force_max = 20.0, .force_continuous = 20.0, .ramp_time = 1e-3, .energy_max = energy_max});
  Strike struck;
  for (int k = 0; k <= std::lround((kWait + kTime) / kDt); ++k) {
    const double phase = 2.0 * M_PI * std::max(0.0, k * kDt - kWait) / kTime;
    hand.hand.position.z() = -0.5 * kDeep * (1.0 - std::cos(phase));
    hand.hand.velocity.z() = -0.5 * kDeep * std::sin(phase) * 2.0 * M_PI / kTime;
    const HapticSample sample = safe.read(k * kDt);
    struck.given = safe.given_energy();
    struck.distance += kDt * sample.velocity.squaredNorm();
    safe.write({.force = drive * sample.velocity - kSpring * sample.position});
  }
  struck.damped = safe.damped_count();
  return struck;
}

}  // namespace

TEST_CASE("a held spring gives K T/2 times the integral of v², which a device may take up") {
  const Strike undeclared = strike({});
  const double held = 0.5 * kSpring * kDt * undeclared.distance;
  // of what went in and came out again a twentieth is forgotten meanwhile
  const double forgotten = 0.05 * 0.5 * kSpring * 64e-6;
  CHECK(std::abs(undeclared.given - held) < forgotten);

  // K T of it at most would be taken up, which is all that the force of the next tick was late by
  for (const double damping : {0.1, 0.3}) {
    CAPTURE(damping);
    CHECK(undeclared.given - strike({.damping = damping}).given ==
          doctest::Approx(damping * undeclared.distance).epsilon(0.05));
  }
  const double late = kSpring * kDt * undeclared.distance;
  for (const DeviceDynamics& calm :
       {DeviceDynamics{.damping = 10.0}, DeviceDynamics{.position_source = true}}) {
    CHECK(undeclared.given - strike(calm).given == doctest::Approx(late).epsilon(0.05));
  }
}

TEST_CASE("no strike of a hand that no force moves is damped, however fast") {
  const double most = SafetyLimits{}.energy_max;
  CHECK(strike({}, 0.0, most).damped > 0);
  CHECK(strike({.position_source = true}, 0.0, most).damped == 0);
}

TEST_CASE("an active contact's energy is observed at a position-controlled device") {
  const double most = SafetyLimits{}.energy_max;
  const Strike even = strike({.position_source = true});
  for (const double drive : {1.0, 1.5}) {
    CAPTURE(drive);
    const Strike active = strike({.position_source = true}, drive);
    CHECK(active.given - even.given == doctest::Approx(drive * even.distance).epsilon(0.1));
    CHECK(strike({.position_source = true}, drive, most).damped > 0);
  }
}

namespace {

/// What the observer has counted, second by second, of a hand that presses a spring and stays.
struct Held {
  std::vector<double> given;  // [J]
  long damped = 0;
};

/// `deep` [m] into a spring in a second, `seconds` there, moved along it against `drag` [N·s/m] by
/// 20 mm to and fro, and out in 0.3 s.
Held hold(double deep, double seconds, double drag, const DeviceDynamics& declared = {}) {
  Follower hand(declared);
  SafeDevice safe(hand, {.ramp_time = 1e-3});
  Held held;
  const double end = 2.0 + seconds;
  for (int k = 0; k <= std::lround((end + 0.5) / kDt); ++k) {
    const double t = k * kDt;
    const double in = std::clamp(t - 1.0, 0.0, 1.0), out = std::clamp((t - end) / 0.3, 0.0, 1.0);
    const bool rests = t > 2.0 && t < end;
    const double phase = 2.0 * M_PI * (t - 2.0);
    hand.hand.position.z() = -deep * (in - out);
    hand.hand.position.x() = rests ? 0.01 * std::sin(phase) : 0.0;
    hand.hand.velocity.x() = rests ? 0.01 * 2.0 * M_PI * std::cos(phase) : 0.0;
    hand.hand.velocity.z() = -deep * (t > 1.0 && t < 2.0) + deep / 0.3 * (t > end && out < 1.0);
    const HapticSample sample = safe.read(t);
    if (k % 1000 == 999) held.given.push_back(safe.given_energy());
    const double pressed = std::max(0.0, -sample.position.z());
    const double along = pressed > 0.0 ? -drag * sample.velocity.x() : 0.0;
    safe.write({.force = {along, 0.0, 200.0 * pressed}});
  }
  held.damped = safe.damped_count();
  return held;
}

}  // namespace

// What a hand had put in was forgotten within a second, and what it got back of it was damped.
TEST_CASE("a hand that has pressed for long gets back what it put in") {
  for (const double seconds : {0.0, 1.0, 5.0}) {
    CAPTURE(seconds);
    for (const bool ideal : {false, true}) {
      const Held held = hold(10e-3, seconds, 0.0, {.position_source = ideal});  // 10 mJ

      CHECK(held.damped == 0);
      CHECK(held.given.back() <= SafetyLimits{}.energy_max);
    }
  }
}

TEST_CASE("what stroked tissue swallows is forgotten but for what its force gives back at most") {
  const Held held = hold(10e-3, 8.0, 1.0);  // 20 mW swallowed on the mean

  // by hand: 2 N from 10 mm deep and 10 mm aside, where without forgetting it would be 10 + 160 mJ
  CHECK(held.given[8] >= -0.02 * std::sqrt(2.0));
  CHECK(held.given[8] <= -0.01);
  CHECK(held.damped == 0);
}

namespace {

constexpr double kBall = 60e-3;  // [m]

/// What draws the hand to its tool, which a ball around the origin holds outside: 500 N/m and no
/// more than 3 N, along the shortest way out.
struct Drawn {
  Vec3 tool, force;
};
Drawn draw(const Vec3& hand) {
  const double deep = std::max(0.0, kBall - hand.norm());
  const Vec3 out = hand.normalized();
  return {hand + deep * out, std::min(500.0 * deep, 3.0) * out};
}

/// A hand that goes in on one side, half round the middle, which is no work, waits there for so
/// many seconds and comes out on the other side.
Held lead_through(double waits) {
  constexpr double kTime = 0.4, kAround = 10e-3, kOutside = kBall + 5e-3;
  Follower hand({.position_source = true});
  SafeDevice safe(hand, {.force_max = 5.0, .force_continuous = 5.0, .ramp_time = 1e-3});
  Held led;
  Vec3 before = Vec3(0.0, 0.0, kOutside);
  for (int k = 0; k <= std::lround((1.0 + 3.0 * kTime + waits) / kDt); ++k) {
    const auto past = [&](double start) {
      return std::clamp((k * kDt - 1.0 - start) / kTime, 0.0, 1.0);
    };
    const double inside = past(0.0) - past(2.0 * kTime + waits), turn = M_PI * past(kTime);
    const double radius = kOutside + (kAround - kOutside) * inside;
    hand.hand.position = radius * Vec3(std::sin(turn), 0.0, std::cos(turn));
    hand.hand.velocity = (hand.hand.position - before) / kDt;
    before = hand.hand.position;
    const HapticSample sample = safe.read(k * kDt);
    led.given.push_back(safe.given_energy());
    const Drawn drawn = draw(sample.position);
    safe.set_tool(drawn.tool);
    safe.write({.force = drawn.force});
  }
  led.damped = safe.damped_count();
  return led;
}

}  // namespace

// What it had put in was forgotten as far as it would not get back where it came in.
TEST_CASE("a hand led through a body that holds its tool gets back what it put in, on any side") {
  // 3 N over 50 mm, but for the 6 mm in which the spring comes to that
  const double put_in = 3.0 * 50e-3 - 0.5 * 3.0 * 6e-3;
  for (const double waits : {0.0, 0.5, 3.0}) {
    CAPTURE(waits);
    const Held led = lead_through(waits);

    CHECK(led.damped == 0);
    const double least = *std::min_element(led.given.begin(), led.given.end());
    CHECK(least == doctest::Approx(-put_in).epsilon(0.01));
    CHECK(led.given.back() <= SafetyLimits{}.energy_max);
  }
}

TEST_CASE("a tool at no place is passed over") {
  Follower hand({.position_source = true});
  SafeDevice safe(hand);
  safe.set_tool(Vec3::Constant(std::nan("")));
  safe.read(0.0);
  safe.write({.force = Vec3(0.0, 0.0, 0.5)});
  hand.hand.position.z() = -1e-3;
  safe.read(1.0);
  safe.read(2.0);

  CHECK(std::isfinite(safe.given_energy()));
}
