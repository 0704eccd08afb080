// SPDX-License-Identifier: GPL-3.0-or-later
// What the device's own law is worth: how stiff a spring may be that the host answers late, on the
// chip's image, with the law that the driver sends and without.
//
// With PALPATE_CHARTS set to a folder the largest stiffnesses are searched and left there for
// firmware/draw_charts.py.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "core/haptics/law_bench.h"
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

/// [N/m] above which a swing grows, by halving.
double find_stiffness_max(double delay, bool law) {
  double least = 20.0, most = 1500.0;
  for (int i = 0; i < 7; ++i) {
    const double middle = std::sqrt(least * most);
    (find_growth(middle, delay, law) > 1.0 ? most : least) = middle;
  }
  return std::sqrt(least * most);
}

}  // namespace

TEST_CASE("a spring 1.5 times too stiff to come late calms on the chip with the driver's law") {
  for (double delay : {1e-3, 2e-3}) {
    CAPTURE(delay);
    // of what the search below finds without
    const double stiffness = 1.5 * (delay < 1.5e-3 ? 82.0 : 73.0);
    CHECK(find_growth(stiffness, delay, false) > 1.2);
    CHECK(find_growth(stiffness, delay, true) < 0.95);
  }
}

TEST_CASE("search of the largest stiffness with and without the law" *
          doctest::skip(std::getenv("PALPATE_CHARTS") == nullptr)) {
  std::ofstream out(std::string(std::getenv("PALPATE_CHARTS")) + "/local_law.csv");
  out << "delay,torque,law\n";
  for (double delay : {0.0, 1e-3, 2e-3, 3e-3, 5e-3}) {
    const double torque = find_stiffness_max(delay, false), law = find_stiffness_max(delay, true);
    std::printf("link %.0f ms late: %.0f N/m as a torque, %.0f N/m with the law, %.1f times\n",
                1e3 * delay, torque, law, law / torque);
    out << delay << ',' << torque << ',' << law << '\n';
  }
}
