// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/collision/private/barrier.h"

using namespace palpate;

namespace {

constexpr Barrier kBarrier{4e-4, 5e6, 0.3};

}  // namespace

TEST_CASE("a barrier pushes with the pressures worked out by hand") {
  // 5e6 (4e-4 - 2e-4) / 0.5, at the floor 5e6 3.6e-4 / 0.1, on the surface 5e6 4e-4 / 0.1
  CHECK(compute_pressure(kBarrier, 2e-4) == doctest::Approx(2000.0));
  CHECK(compute_pressure(kBarrier, 4e-5) == doctest::Approx(18000.0));
  CHECK(compute_pressure(kBarrier, 0.0) == doctest::Approx(38000.0));
  CHECK(compute_pressure(kBarrier, -4e-4) == doctest::Approx(238000.0));
  CHECK(compute_pressure(kBarrier, 4e-4) == 0.0);
  CHECK(compute_pressure(kBarrier, 1.0) == 0.0);
}

TEST_CASE("the pressure of a barrier is minus the slope of its energy, and its slope that of it") {
  constexpr double kStep = 1e-9;
  for (const double gap : {-3e-4, 1e-5, 3.9e-5, 4.1e-5, 1e-4, 2.5e-4, 3.99e-4}) {
    CAPTURE(gap);
    const double above = compute_barrier_energy(kBarrier, gap + kStep);
    const double below = compute_barrier_energy(kBarrier, gap - kStep);
    CHECK((below - above) / (2.0 * kStep) ==
          doctest::Approx(compute_pressure(kBarrier, gap)).epsilon(1e-5));
    const double more = compute_pressure(kBarrier, gap - kStep);
    const double less = compute_pressure(kBarrier, gap + kStep);
    CHECK((more - less) / (2.0 * kStep) ==
          doctest::Approx(compute_slope(kBarrier, gap)).epsilon(1e-5));
  }
  CHECK(compute_barrier_energy(kBarrier, 4e-4) == 0.0);
  CHECK(compute_slope(kBarrier, 4e-4) == 0.0);
}
