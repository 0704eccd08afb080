// SPDX-License-Identifier: GPL-3.0-or-later
// What the device's own law is worth: how stiff a spring may be that the host answers late, on the
// chip's image, with the law that the driver sends and without. How stiff at most is searched in
// tests/core/arm/test_local_law.cpp.
#include <doctest/doctest.h>

#include "core/arm/law_bench.h"
#include "palpate/simavr/emulated_core.h"
#include "sim_bench.h"

using namespace palpate;

namespace {

using Bench = LawBench<EmulatedCore>;

/// How a swing grows or fades in a second, `delay` [s] being that of the link, there and back.
double find_growth(double stiffness, double delay, bool law) {
  const EmulatedCoreOptions options{.link_delay = 0.5 * delay};
  return Bench(law, image(options.baud), Bench::plant(), options).find_growth(stiffness);
}

void check_calm(double delay) {
  CAPTURE(delay);
  // of what that search finds without
  const double stiffness = 1.5 * (delay < 1.5e-3 ? 82.0 : 73.0);
  CHECK(find_growth(stiffness, delay, false) > 1.2);
  CHECK(find_growth(stiffness, delay, true) < 0.95);
}

}  // namespace

TEST_CASE("a spring 1.5 times too stiff to come late calms on the chip with the driver's law" *
          doctest::test_suite("landing")) {
  check_calm(2e-3);
}

TEST_CASE("a spring 1.5 times too stiff to come 1 ms late calms on the chip too" *
          doctest::test_suite("verify")) {
  check_calm(1e-3);
}
