// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "palpate/sim/arm/private/clock_fit.h"

using namespace palpate;

TEST_CASE("a device whose clock is 100 ppm fast is found to be so, through a jitter of 0.3 ms") {
  ClockFit fit;
  double worst = 0.0;

  for (int k = 0; k < 20000; ++k) {
    const double jitter = 0.3e-3 * std::sin(12.9898 * k);
    const double late = fit.add(static_cast<std::uint16_t>(k), 5.0 + 1e-3 * k / 1.0001 + jitter);
    if (k > 1000) worst = std::max(worst, std::abs(late - jitter));
  }

  CHECK(std::abs(fit.drift() - 100e-6) < 10e-6);
  CHECK(worst < 0.05e-3);
}

TEST_CASE("ticks that wrap and reports that are missing are counted on") {
  ClockFit fit;

  fit.add(65530, 0.0);
  fit.add(65535, 0.005);
  CHECK(fit.gap() == 5);
  fit.add(4, 0.010);

  CHECK(fit.gap() == 5);
  CHECK(fit.device_time() == doctest::Approx(0.010));
}

TEST_CASE("a report that is late is as late as it is, whatever came before") {
  ClockFit fit;
  for (int k = 0; k < 500; ++k) fit.add(static_cast<std::uint16_t>(k), 1e-3 * k);

  CHECK(fit.add(500, 0.500 + 7e-3) == doctest::Approx(7e-3));
}

TEST_CASE("a new run of the host moves its clock and not the device's") {
  ClockFit fit;
  for (int k = 0; k < 500; ++k) fit.add(static_cast<std::uint16_t>(k), 1e-3 * k);
  fit.restart();
  double worst = 0.0;

  for (int k = 500; k < 900; ++k) {
    worst = std::max(worst, std::abs(fit.add(static_cast<std::uint16_t>(k), 1e-3 * (k - 500))));
  }

  CHECK(worst < 1e-9);
  CHECK(fit.device_time() == doctest::Approx(0.899));
}
