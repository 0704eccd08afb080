// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way: a hand that holds the simulated arm, the chip's image, the wire, the driver, the
// tick, an organ of springs, and back, in virtual time.
//
// With PALPATE_CHARTS set to a folder the forces are left there for firmware/draw_charts.py.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "palpate/scenario/read.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/tick/tick.h"
#include "palpate/simavr/emulated_core.h"
#include "sim_bench.h"

using namespace palpate;

namespace {

constexpr double kTick = 1e-3;  // [s]

/// The surface above the organ's middle.
Vec3 find_top(const TissueModel& tissue) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& point : tissue.rest_position) middle += point;
  middle /= static_cast<double>(tissue.rest_position.size());
  Vec3 top = middle;
  for (const Vec3& point : tissue.rest_position) {
    if ((point - middle).head<2>().norm() < 0.005 && point.z() > top.z()) top = point;
  }
  return top;
}

/// Down on a point, 6 mm deep, a second's rest, and away.
ScriptedDevice press_on(const Vec3& point) {
  const auto at = [&](double time, double height) {
    KeyFrame frame;
    frame.time = time;
    frame.position = point + Vec3(0.0, 0.0, height);
    return frame;
  };
  return ScriptedDevice(
      {at(0.0, 0.03), at(0.8, 0.03), at(1.4, -0.006), at(2.2, -0.006), at(2.7, 0.03)});
}

/// Along the surface's normal: forces [N], and heights of the tip over where it first touches [m].
struct Forces {
  std::vector<double> time, ideal, commanded, applied, ideal_height, height;
};

/// What an ideal device gives at once.
void press_ideal(const Scene& scene, const Vec3& point, Forces& felt) {
  World world(scene);
  ScriptedDevice hand = press_on(point);
  for (int k = 0; k * kTick < hand.duration(); ++k) {
    const HapticSample sample = hand.read(k * kTick);
    felt.ideal.push_back(tick(scene, sample, kTick, world).force.z());
    felt.ideal_height.push_back((sample.position - point).z());
  }
  REQUIRE(world.alarm.kind == AlarmKind::none);
}

/// What the duties are worth at the tip, without what carries the arm.
Vec3 find_applied(const EmulatedCore& core) {
  const Vec3 torque = compute_motor_torque(core.plant(), core.drive(), Vec3::Zero());
  return compute_tip_force(find_arm(core.plant()), core.state().joints, torque);
}

void write_forces(const Forces& felt, const std::string& path) {
  std::ofstream out(path);
  out << "time,ideal,commanded,applied,ideal_height,height\n";
  for (std::size_t k = 0; k < felt.time.size(); ++k) {
    out << felt.time[k] << ',' << felt.ideal[k] << ',' << felt.commanded[k] << ','
        << felt.applied[k] << ',' << felt.ideal_height[k] << ',' << felt.height[k] << '\n';
  }
}

}  // namespace

TEST_CASE(
    "the gallbladder is pressed through driver, wire and image as an ideal device presses it" *
    doctest::test_suite("landing")) {
  const Scene scene = scenario::read(PALPATE_SPRINGS "/gallbladder.palpate").scene;
  const Vec3 point = find_top(scene.bodies[0].tissue);
  Forces felt;
  press_ideal(scene, point, felt);

  World world(scene);
  ScriptedDevice hand = press_on(point);
  EmulatedCore core(image(1000000));
  SerialDevice device(core, point);
  const auto hold = [&](double time) {
    const HapticSample wanted = hand.read(time);
    core.hold({wanted.position - point + Workspace{}.center, wanted.velocity, true});
  };
  core.state().joints =
      *find_joints(find_arm(core.plant()), Workspace{}.center + Vec3(0.0, 0.0, 0.03));
  hold(0.0);
  device.open();
  int faulted = 0;
  double local = 0.0;  // [N/m] the most that the device answered by itself
  for (std::size_t k = 0; k < felt.ideal.size(); ++k) {
    const double time = static_cast<double>(k) * kTick;
    hold(time);
    const HapticCommand command = tick(scene, device.read(time), kTick, world);
    device.write(command);
    device.take_status();
    faulted += device.status().mode == DeviceMode::faulted;
    local = std::max(local, device.status().local_stiffness);
    felt.time.push_back(time);
    felt.commanded.push_back(command.force.z());
    felt.applied.push_back(find_applied(core).z());
    felt.height.push_back((find_tip(core.plant(), core.state()) - Workspace{}.center).z());
  }

  CHECK(world.alarm.kind == AlarmKind::none);
  CHECK(faulted == 0);
  CHECK(device.status().mode == DeviceMode::run);
  CHECK(device.status().lost_reports == 0);
  CHECK(device.status().damaged_frames == 0);
  const auto mean = [&](const std::vector<double>& forces) {  // while the hand rests
    double sum = 0.0;
    for (int k = 1700; k < 2200; ++k) sum += forces[static_cast<std::size_t>(k)] / 500.0;
    return sum;
  };
  std::printf(
      "at rest on the gallbladder: ideal %.3f N, commanded %.3f N, applied %.3f N; "
      "local law up to %.0f N/m\n",
      mean(felt.ideal), mean(felt.commanded), mean(felt.applied), local);
  CHECK(mean(felt.ideal) > 0.1);
  CHECK(mean(felt.commanded) >
        0.5 * mean(felt.ideal));  // the hand gives way, an ideal one does not
  CHECK(mean(felt.commanded) <= 1.1 * mean(felt.ideal));
  CHECK(mean(felt.applied) == doctest::Approx(mean(felt.commanded)).epsilon(0.1));
  CHECK(std::abs(felt.commanded.back()) == 0.0);
  if (const char* folder = std::getenv("PALPATE_CHARTS")) {
    write_forces(felt, std::string(folder) + "/tissue_loop.csv");
  }
}
