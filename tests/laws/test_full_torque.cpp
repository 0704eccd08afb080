// SPDX-License-Identifier: BSD-3-Clause
// The same contact under two rules, on the firmware's code and the simulated arm: the force of the
// tissue, as here, and full torque from touch to release, as [BulutDandil22] drove its motors.
//
// With PALPATE_CHARTS set to a folder both are left there for firmware/draw_charts.py.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/arm/device_bench.h"

using namespace palpate;

namespace {

constexpr double kTick = 1e-3;        // [s]
constexpr double kStiffness = 200.0;  // [N/m] of the tissue's surface

struct Contact {
  double energy = 0.0;     ///< [J] that the motors gave to the hand, all in all
  double overshoot = 0.0;  ///< [m] out of the tissue again while the hand presses
  double cycle = 0.0;      ///< [m] from peak to peak in the last half second of rest
};

/// A hand comes down on a level surface, wants to be 6 mm deep for a second, and leaves.
template <class Rule>
Contact touch(const char* name, Rule rule) {
  DeviceBench bench;
  const Vec3 above = Workspace{}.center + Vec3(0.0, 0.0, 0.02);
  bench.core.state().joints = *find_joints(find_arm(bench.core.plant()), above);
  bench.core.hold({above, Vec3::Zero(), true});
  bench.start();

  std::ofstream out;
  if (const char* folder = std::getenv("PALPATE_CHARTS")) {
    out.open(std::string(folder) + "/contact_" + name + ".csv");
    out << "time,height,force,energy\n";
  }
  Contact contact;
  double lowest = 1.0, highest = -1.0;
  Vec3 before = find_tip(bench.core.plant(), bench.core.state());
  for (int ms = 0; ms < 2000; ++ms) {
    const double wanted = ms < 400    ? 0.02 - 0.026 * ms / 400.0
                          : ms < 1400 ? -0.006
                                      : std::min(0.02, -0.006 + 0.05e-3 * (ms - 1400));
    bench.core.hold({Workspace{}.center + Vec3(0.0, 0.0, wanted), Vec3::Zero(), true});
    bench.run(kTick, [&](const HapticSample& sample) {
      return Vec3(0.0, 0.0, rule(Workspace{}.center.z() - sample.position.z()));
    });
    const Vec3 tip = find_tip(bench.core.plant(), bench.core.state());
    const Vec3 force = bench.core.motor_force();
    // the arm's own weight is carried by the motors too, and gives and takes nothing in a cycle
    contact.energy += force.dot(tip - before);
    before = tip;
    const double height = tip.z() - Workspace{}.center.z();
    if (ms >= 500 && ms < 1400) contact.overshoot = std::max(contact.overshoot, height);
    if (ms >= 900 && ms < 1400) {
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    if (out) out << 1e-3 * ms << ',' << height << ',' << force.z() << ',' << contact.energy << '\n';
  }
  contact.cycle = highest - lowest;
  std::printf("%s: the motors gave %.2f mJ, %.2f mm out of the tissue, %.2f mm from peak to peak\n",
              name, 1e3 * contact.energy, 1e3 * contact.overshoot, 1e3 * contact.cycle);
  return contact;
}

}  // namespace

TEST_CASE("full torque on contact drives the hand in a limit cycle, the tissue's force does not") {
  const Contact ours =
      touch("tissue_force", [](double depth) { return std::max(0.0, kStiffness * depth); });
  const Contact full = touch("full_torque", [](double depth) { return depth > 0.0 ? 10.0 : 0.0; });

  CHECK(ours.energy < 1e-3);
  CHECK(ours.overshoot == 0.0);
  CHECK(ours.cycle < 0.1e-3);
  CHECK(full.energy > 5e-3);
  CHECK(full.overshoot > 0.1e-3);
  CHECK(full.cycle > 0.5e-3);
}
