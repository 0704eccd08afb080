// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "palpate/sim/device/safe_device.h"

using namespace palpate;

namespace {

constexpr double kDt = 1e-3;
constexpr double kStep = 1e-3;  // [rad] of a count

double quantise(double value) { return kStep * std::round(value / kStep); }

/// What difference of two readings says, root mean square of its error over the last half.
struct Errors {
  double window = 0.0, difference = 0.0;
};

Errors errors_at(double speed) {
  VelocityWindow window(kStep);
  Errors errors;
  double last = 0.0;
  const int ticks = 2000;
  for (int k = 0; k < ticks; ++k) {
    const double value = quantise(speed * k * kDt);
    const double found = window.add(k * kDt, value);
    if (k >= ticks / 2) {
      errors.window += std::pow(found - speed, 2) / (ticks / 2);
      errors.difference += std::pow((value - last) / kDt - speed, 2) / (ticks / 2);
    }
    last = value;
  }
  return {std::sqrt(errors.window), std::sqrt(errors.difference)};
}

}  // namespace

TEST_CASE("a steady motion known exactly has its speed from the second reading on") {
  VelocityWindow window(0.0);

  CHECK(window.add(0.0, 1.0) == 0.0);
  for (int k = 1; k < 50; ++k) {
    CHECK(window.add(k * kDt, 1.0 + 0.3 * k * kDt) == doctest::Approx(0.3));
  }
  CHECK(window.length() == 16);
}

TEST_CASE("in steps, the window has a fraction of the error that the last two readings have") {
  for (const double speed : {0.05, 0.2, 0.7, 2.3}) {
    const Errors errors = errors_at(speed);

    CHECK(errors.window < 0.35 * errors.difference);
    CHECK(errors.window < 0.08);  // [rad/s]; one step per tick is 1 rad/s
  }
}

TEST_CASE("rest is rest: a reading that flickers by one step has no speed to speak of") {
  VelocityWindow window(kStep);
  double largest = 0.0;

  for (int k = 0; k < 200; ++k) {
    const double found = window.add(k * kDt, kStep * (k % 2));
    if (k > 20) largest = std::max(largest, std::abs(found));
  }

  CHECK(largest <= kStep / (15.0 * kDt) * 1.001);
}

TEST_CASE("a sudden start shortens the window, so it is seen within two readings") {
  VelocityWindow window(kStep);
  for (int k = 0; k < 100; ++k) window.add(k * kDt, 0.0);
  CHECK(window.length() == 16);

  window.add(0.100, 5 * kStep);
  window.add(0.101, 10 * kStep);
  const double found = window.add(0.102, 15 * kStep);

  CHECK(found == doctest::Approx(5.0).epsilon(0.25));  // [rad/s]
  CHECK(window.length() <= 4);
}

TEST_CASE("where the motion is noise beyond the step, so is the speed: it cannot know") {
  VelocityWindow window(kStep);
  double largest = 0.0;

  for (int k = 0; k < 200; ++k) {
    largest = std::max(largest, std::abs(window.add(k * kDt, 5 * kStep * (k % 2))));
  }

  CHECK(largest > 3.0);  // [rad/s]
}

TEST_CASE("missing readings change nothing, a time twice is ignored, an earlier one starts again") {
  VelocityWindow window(kStep);

  for (int k = 0; k < 60; ++k) {
    if (k % 3 == 1) continue;
    window.add(k * kDt, k * kDt);
  }
  CHECK(window.speed() == doctest::Approx(1.0));
  const double last = 59 * kDt;
  CHECK(window.add(last, 17.0) == doctest::Approx(1.0));
  CHECK(window.add(0.0, 3.0) == 0.0);
  CHECK(window.add(0.001, 3.002) == doctest::Approx(2.0));

  window.clear();
  CHECK(window.add(1.0, 3.0) == 0.0);
}

TEST_CASE("a window that cannot be is refused") {
  CHECK_THROWS_AS(VelocityWindow(-1.0), std::invalid_argument);
  CHECK_THROWS_AS(VelocityWindow(std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(VelocityWindow(1.0, 1), std::invalid_argument);
  CHECK_THROWS_AS(VelocityWindow(1.0, 33), std::invalid_argument);
}
