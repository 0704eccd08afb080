// SPDX-License-Identifier: BSD-3-Clause
// What the driver lets the device answer by itself: how stiff it is, how much of it, in the frame.
//
// With PALPATE_CHARTS set to a folder the largest stiffnesses with the law and without are searched
// and left there for firmware/draw_charts.py.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/arm/device_bench.h"
#include "core/arm/law_bench.h"
#include "palpate/sim/arm/private/local_law.h"

using namespace palpate;

namespace {

/// What the device adds for joints `away` [rad] from `counts`, by PROTOCOL.md, [N m].
Vec3 obey(const Calibration& calibration, const palpate_command& command, const Vec3& away) {
  const auto& k = command.stiffness;
  const Mat3 stiffness{{double(k[0]), double(k[1]), double(k[2])},
                       {double(k[1]), double(k[3]), double(k[4])},
                       {double(k[2]), double(k[4]), double(k[5])}};
  Vec3 counts, full;
  for (int j = 0; j < 3; ++j) {
    counts[j] = 16.0 * away[j] / calibration.joints[static_cast<std::size_t>(j)].scale;
    full[j] = calibration.torque_full[j] / 32767.0;
  }
  return (std::ldexp(1.0, -4 - command.shift) * -(stiffness * counts)).cwiseProduct(full);
}

const Mat3 kStiffness{{3.0, 0.4, -0.2}, {0.4, 5.0, 0.7}, {-0.2, 0.7, 2.0}};  // [N m/rad]
const std::array<std::uint16_t, 6> kCounts = {500, 512, 530, 512, 512, 512};

/// How a swing grows or fades in a second, `delay` [s] being that of the link, there and back.
double find_growth(double stiffness, double delay, bool law) {
  using Bench = LawBench<NativeCore>;
  return Bench(law, Bench::plant(), NativeCoreOptions{.link_delay = 0.5 * delay})
      .find_growth(stiffness);
}

/// [N/m] above which a swing grows, by halving.
double find_stiffness_max(double delay, bool law) {
  double least = 10.0, most = 1500.0;
  for (int i = 0; i < 8; ++i) {
    const double middle = std::sqrt(least * most);
    (find_growth(middle, delay, law) > 1.0 ? most : least) = middle;
  }
  return std::sqrt(least * most);
}

}  // namespace

TEST_CASE("a spring's stiffness is found from the forces it gave, and is 0 where nothing moves") {
  StiffnessWatch watch;
  const Mat3 spring{{250.0, 30.0, 0.0}, {30.0, 120.0, -20.0}, {0.0, -20.0, 60.0}};  // [N/m]
  const auto at = [](int k) {
    return Vec3(1e-3 * std::sin(0.3 * k), 2e-3 * std::cos(0.2 * k), 1e-3 * std::cos(0.35 * k));
  };
  Mat3 found = Mat3::Zero();
  for (int k = 0; k < 60; ++k) {
    found = watch.add(at(k), -spring * at(k));
    if (k == 0) CHECK(found.isZero(0.0));
  }
  CHECK((found - spring).norm() < 0.01 * spring.norm());

  for (int k = 0; k < 300; ++k) found = watch.add(at(60), -spring * at(60));
  CHECK(found.norm() < 1.0);
  CHECK(watch.add(at(61), Vec3::Zero()).isZero(0.0));
}

TEST_CASE("in directions that the hand has not moved there is no stiffness to tell of") {
  StiffnessWatch watch;
  const Vec3 direction = Vec3(1.0, 2.0, -0.5).normalized();
  Mat3 found = Mat3::Zero();
  for (int k = 0; k < 40; ++k) {
    const Vec3 at = 1e-3 * std::sin(0.1 * k) * direction;
    found = watch.add(at, Vec3(-250.0 * at));
  }

  CHECK(direction.dot(found * direction) == doctest::Approx(250.0).epsilon(0.02));
  CHECK((found - 250.0 * direction * direction.transpose()).norm() < 5.0);
}

TEST_CASE("a force that falls as the hand goes against it has no stiffness to answer") {
  StiffnessWatch watch;
  for (int k = 0; k < 40; ++k) {
    const double depth = 1e-4 * k;
    const Mat3 found = watch.add(Vec3(0.0, 0.0, -depth), Vec3(0.0, 0.0, 1.0 - 100.0 * depth));
    CHECK(choose_local_stiffness(found, 3e-3, 0.3).norm() < 1e-9);
  }
}

TEST_CASE("no more is answered by the device than the loop is too late for, nor than it bears") {
  const double late = 3e-3, damping = 0.3;  // 70 N/m may come that late

  CHECK(choose_local_stiffness(69.0, late, damping) == 0.0);
  const double some = choose_local_stiffness(150.0, late, damping);
  // the rule is met: each part takes of the damping what it is late by
  CHECK(some * 0.95e-3 + (150.0 - some) * late == doctest::Approx(0.7 * damping));
  CHECK(choose_local_stiffness(1e4, late, damping) == doctest::Approx(0.7 * damping / 0.95e-3));
  CHECK(choose_local_stiffness(0.0, late, damping) == 0.0);
  CHECK(choose_local_stiffness(500.0, 0.0, damping) == 0.0);  // no round trip was measured yet
}

TEST_CASE("the device gets the law it is meant to, within a thousandth, by its own scales") {
  Calibration calibration;
  for (double sign : {1.0, -1.0}) {
    for (auto& joint : calibration.joints) joint.scale = sign * 0.0023;
    palpate_command command{};
    add_law(calibration, kStiffness, kCounts, command);

    REQUIRE(command.has_law);
    CHECK(command.shift <= 8);
    CHECK(command.rest[2] == 530 * 16);
    const Vec3 away(0.01, -0.02, 0.005);
    const Vec3 wanted = -kStiffness * away;
    CHECK((obey(calibration, command, away) - wanted).norm() < 1e-3 * wanted.norm());
  }
}

TEST_CASE("a law beyond the frame's numbers becomes softer, not another; none is sent for none") {
  const Calibration calibration;
  palpate_command command{};
  add_law(calibration, 1e4 * kStiffness, kCounts, command);
  REQUIRE(command.has_law);
  const Vec3 away(1e-4, 0.0, 0.0);
  const Vec3 found = obey(calibration, command, away), wanted = -kStiffness * away;
  CHECK(found.norm() < 1e4 * wanted.norm());
  CHECK(found.normalized().dot(wanted.normalized()) > 0.999);

  palpate_command none{};
  add_law(calibration, Mat3::Zero(), kCounts, none);
  CHECK_FALSE(none.has_law);
}

TEST_CASE("a spring 1.5 times too stiff to come late calms with the driver's law: 1 and 2 ms") {
  for (double delay : {1e-3, 2e-3}) {
    CAPTURE(delay);
    const double stiffness = 1.5 * (delay < 1.5e-3 ? 82.0 : 73.0);  // of what is found below
    CHECK(find_growth(stiffness, delay, false) > 1.2);
    CHECK(find_growth(stiffness, delay, true) < 0.8);
  }
}

TEST_CASE("search of the largest stiffness with and without the law" *
          doctest::skip(std::getenv("PALPATE_CHARTS") == nullptr)) {
  std::ofstream out(std::string(std::getenv("PALPATE_CHARTS")) + "/local_law.csv");
  out << "delay,torque,law\n";
  for (double delay : {0.0, 1e-3, 2e-3, 3e-3, 5e-3}) {
    const double torque = find_stiffness_max(delay, false), law = find_stiffness_max(delay, true);
    std::printf("link %.0f ms late: %.0f N/m without the law, %.0f N/m with it, %.1f times\n",
                1e3 * delay, torque, law, law / torque);
    out << delay << ',' << torque << ',' << law << '\n';
  }
}

TEST_CASE("a soft contact, a constant force and a saturated one are left to the host") {
  DeviceBench bench(clamped_plant());
  bench.start();
  const auto run = [&](double stiffness, double most) {
    bench.bolt(Workspace{}.center);
    bench.core.hold({Workspace{}.center, Vec3(0.0, 0.0, -0.01), true});
    double local = 0.0;
    bench.run(0.3, [&](const HapticSample& sample) {
      local = std::max(local, bench.status().local_stiffness);
      const double depth = Workspace{}.center.z() - sample.position.z();
      return Vec3(0.0, 0.0, std::min(most, 0.1 + stiffness * std::max(0.0, depth)));
    });
    return local;
  };

  CHECK(run(20.0, 1.0) == 0.0);
  CHECK(run(0.0, 1.0) == 0.0);
  CHECK(run(5e4, 50.0) < 500.0);
  CHECK(run(400.0, 1.5) > 50.0);
}
