// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "palpate/sim/device/fulcrum_device.h"
#include "palpate/sim/device/simulated_devices.h"

// A device that is the handle of an instrument through a trocar [contact: trocar].

using namespace palpate;

namespace {

const Fulcrum kFulcrum{Vec3(0.01, -0.02, 0.20), 0.32};

Vec3 handle_at(double outside, double x, double y) {
  return kFulcrum.trocar + outside * Vec3(x, y, 1.0).normalized();
}

/// A device that is put somewhere, and remembers what it was sent.
struct Held : HapticDevice {
  HapticSample sample;
  HapticCommand sent;
  HapticSample read(double) noexcept override { return sample; }
  void write(const HapticCommand& command) noexcept override { sent = command; }
  std::string name() const override { return "held"; }
};

}  // namespace

TEST_CASE("handle, trocar and tip lie on one line, a shaft apart") {
  const Vec3 handle = handle_at(0.12, 0.3, -0.2), tip = compute_fulcrum_tip(kFulcrum, handle);
  CHECK((tip - handle).norm() == doctest::Approx(0.32).epsilon(1e-12));
  CHECK((tip - kFulcrum.trocar).cross(handle - kFulcrum.trocar).norm() < 1e-15);
  CHECK((tip - kFulcrum.trocar).dot(handle - kFulcrum.trocar) < 0.0);
  CHECK((compute_fulcrum_handle(kFulcrum, tip) - handle).norm() < 1e-15);
}

TEST_CASE("to the right goes the tip when the handle goes to the left, by the leverage") {
  const Vec3 before = compute_fulcrum_tip(kFulcrum, handle_at(0.16, 0.0, 0.0));
  const Vec3 after = compute_fulcrum_tip(kFulcrum, kFulcrum.trocar + Vec3(1e-6, 0.0, 0.16));
  CHECK((after - before).x() == doctest::Approx(-1e-6).epsilon(1e-6));  // 0.16 m on both sides
  const Vec3 deep = compute_fulcrum_tip(kFulcrum, kFulcrum.trocar + Vec3(1e-6, 0.0, 0.08));
  CHECK((deep - kFulcrum.trocar).x() == doctest::Approx(-3e-6).epsilon(1e-6));
}

TEST_CASE("what the handle feels does the work that is done on the tip") {
  const double h = 1e-7;
  const Vec3 f(0.3, -0.7, 1.1);
  for (const double outside : {0.16, 0.20, 0.30}) {  // no leverage above 1
    const Vec3 handle = handle_at(outside, 0.2, -0.1), felt = carry_force(kFulcrum, handle, f);
    for (int k = 0; k < 3; ++k) {
      const Vec3 way = h * Vec3::Unit(k);
      const Vec3 moved =
          compute_fulcrum_tip(kFulcrum, handle + way) - compute_fulcrum_tip(kFulcrum, handle - way);
      CHECK(felt[k] == doctest::Approx(f.dot(moved) / (2.0 * h)).epsilon(1e-6));
    }
  }
}

TEST_CASE("across the shaft a handle is never stiffer than its tip") {
  const double stiffness = 1000.0, h = 1e-6;
  for (const double outside : {0.03, 0.08, 0.16, 0.30}) {
    const Vec3 handle = handle_at(outside, 0.0, 0.0), tip = compute_fulcrum_tip(kFulcrum, handle);
    const Vec3 there = handle + Vec3(h, 0.0, 0.0);
    const Vec3 pull = stiffness * (tip - compute_fulcrum_tip(kFulcrum, there));
    const double felt = -carry_force(kFulcrum, there, pull).x() / h;
    CHECK(felt <= stiffness * (1.0 + 1e-6));
    const double leverage = (0.32 - outside) / outside;
    CHECK(felt == doctest::Approx(stiffness * std::min(1.0, leverage * leverage)).epsilon(1e-4));
  }
}

TEST_CASE("T7: a circle across the shaft against a spring gives and takes no energy") {
  for (const double outside : {0.06, 0.20}) {
    const Vec3 rest = compute_fulcrum_tip(kFulcrum, handle_at(outside, 0.1, 0.0));
    double work = 0.0, most = 0.0;
    const auto place = [&](int i) {
      const double angle = 2.0 * std::numbers::pi * i / 4000;
      return handle_at(outside, 0.2 * std::cos(angle), 0.2 * std::sin(angle));
    };
    for (int i = 0; i < 4000; ++i) {
      const Vec3 from = place(i), to = place(i + 1);
      const Vec3 half =
          kFulcrum.trocar + outside * (from + to - 2.0 * kFulcrum.trocar).normalized();
      const Vec3 f = 500.0 * (rest - compute_fulcrum_tip(kFulcrum, half));
      work += carry_force(kFulcrum, half, f).dot(to - from);
      most = std::max(most, std::abs(work));
    }
    CHECK(std::abs(work) < 1e-6 * most);
  }
}

TEST_CASE("a handle that is drawn out too far keeps 5 mm of its shaft in the trocar") {
  const Vec3 tip = compute_fulcrum_tip(kFulcrum, handle_at(0.9, 0.0, 0.0));
  CHECK((tip - kFulcrum.trocar).norm() == doctest::Approx(0.005));
  CHECK(carry_force(kFulcrum, handle_at(0.9, 0.0, 0.0), Vec3(0, 0, 2)).norm() == 0.0);
  CHECK(compute_fulcrum_tip(kFulcrum, kFulcrum.trocar).allFinite());
}

TEST_CASE("a fulcrum device reads tips and writes to its handle") {
  Held held;
  FulcrumDevice device(held, kFulcrum);
  held.sample.position = handle_at(0.1, 0.1, 0.2);
  held.sample.velocity = Vec3(0.01, 0.02, -0.03);
  held.sample.buttons = 1;
  held.sample.grip = 0.2;
  const HapticSample said = device.read(0.0);
  CHECK((said.position - compute_fulcrum_tip(kFulcrum, held.sample.position)).norm() < 1e-15);
  const double h = 1e-6;
  const Vec3 later = compute_fulcrum_tip(kFulcrum, held.sample.position + h * held.sample.velocity);
  CHECK((said.velocity - (later - said.position) / h).norm() < 1e-6);
  CHECK(said.buttons == 1);
  CHECK(said.grip == 0.2);
  device.write({Vec3(1.0, 0.0, 0.0)});
  const Vec3 wanted = carry_force(kFulcrum, held.sample.position, Vec3(1.0, 0.0, 0.0));
  CHECK((held.sent.force - wanted).norm() == 0.0);
}

TEST_CASE("a fulcrum without a length or a place is refused") {
  Held held;
  CHECK_THROWS_WITH_AS(FulcrumDevice(held, {Vec3::Zero(), 0.0}),
                       "fulcrum: length [m]: got 0, expected a positive number",
                       std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(FulcrumDevice(held, {Vec3(0, nan, 0), 0.3}), std::invalid_argument);
}
