// SPDX-License-Identifier: BSD-3-Clause
// What watches for leaping and stuck sensors must leave a hand alone that strokes fast, as in a
// palpation: sideways, to and from the body, in circles, and about the arm's own axis, where only
// the yaw moves while the other two joints push.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/arm/device_bench.h"

using namespace palpate;

namespace {

enum class Stroke { side, fore, diagonal, circle, arc };

/// [m] off the middle of the stroke, `angle` through it.
Vec3 find_way(Stroke stroke, double reach, double angle) {
  switch (stroke) {
    case Stroke::side:
      return {reach * std::sin(angle), 0.0, 0.0};
    case Stroke::fore:
      return {0.0, 0.5 * reach * std::sin(angle), 0.0};
    case Stroke::diagonal:
      return Vec3(0.7, 0.4, 0.0) * reach * std::sin(angle);
    case Stroke::circle:
      return {reach * std::cos(angle), 0.5 * reach * std::sin(angle), 0.0};
    case Stroke::arc:
      break;
  }
  const double radius = -Workspace{}.center.y();
  const double yaw = reach / radius * std::sin(angle);
  return {radius * std::sin(yaw), radius * (1.0 - std::cos(yaw)), 0.0};
}

/// [N] of a flat organ of 150 N/m with friction, whose surface lies in the middle of the workspace.
Vec3 push_back(const HapticSample& hand) {
  const double depth = Workspace{}.center.z() - hand.position.z();
  if (depth <= 0.0) return Vec3::Zero();
  const double press = 150.0 * depth;
  const Vec3 slip(hand.velocity.x(), hand.velocity.y(), 0.0);
  return Vec3(0.0, 0.0, press) - 0.3 * press * slip / (slip.norm() + 0.01);
}

/// Every way of stroking, at three speeds, for so many milliseconds each.
void check_strokes(int milliseconds) {
  constexpr double kReach = 0.05;  // [m]
  for (Stroke stroke :
       {Stroke::side, Stroke::fore, Stroke::diagonal, Stroke::circle, Stroke::arc}) {
    for (double speed : {0.2, 0.5, 1.0}) {
      Plant plant;
      plant.noise = 0.3;
      DeviceBench bench(plant);
      bench.start();
      double fastest = 0.0, strongest = 0.0;
      int pushed = 0;
      for (int k = 0; k < milliseconds; ++k) {
        const double rate = speed / kReach, angle = 1e-3 * rate * k;
        // no hand repeats its stroke to the millimetre
        const Vec3 press(0.0, 0.0, -0.012 + 1e-3 * std::sin(5.7e-3 * k));
        bench.core.hold({Workspace{}.center + press + find_way(stroke, kReach, angle),
                         1e3 * (find_way(stroke, kReach, angle + 1e-3 * rate) -
                                find_way(stroke, kReach, angle)),
                         true});
        bench.run(1e-3, push_back);
        fastest = std::max(fastest, bench.sample.velocity.norm());
        strongest = std::max(strongest, bench.core.motor_force().norm());
        pushed += bench.core.drive().duty.cwiseAbs().maxCoeff() >= 64.0;
      }

      std::printf("stroke %d at %.1f m/s: %.2f m/s, %.1f N, %d of %d ms above duty 64, %s\n",
                  static_cast<int>(stroke), speed, fastest, strongest, pushed, milliseconds,
                  describe_status(bench.status()).c_str());
      CHECK(bench.status().mode == DeviceMode::run);
      CHECK(bench.status().faults == 0);
      CHECK(fastest > 0.7 * (stroke == Stroke::fore ? 0.5 : 1.0) * speed);
    }
  }
}

}  // namespace

TEST_CASE("fast strokes over an organ are no leaps and no stuck sensor") { check_strokes(4000); }

TEST_CASE("fast strokes over an organ are no leaps and no stuck sensor for 20 s each" *
          doctest::test_suite("verify")) {
  check_strokes(20000);
}
