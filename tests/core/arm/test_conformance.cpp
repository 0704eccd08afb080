// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "calls.h"
#include "core/arm/device_bench.h"
#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/device/conformance.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/device/simulated_devices.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

std::vector<KeyFrame> stroke() {
  return {{0.0, {0, 0, 0}}, {0.5, {0.03, 0, 0}}, {1.0, {0, 0.02, 0}}, {2.0, {0, 0, 0.01}}};
}

/// What a device failed to keep.
std::vector<std::string> find_broken(HapticDevice& device) {
  std::vector<std::string> broken;
  for (const DeviceCheck& check : check_conformance(device)) {
    if (!check.passed) broken.push_back(check.name + " (" + check.detail + ")");
  }
  return broken;
}

/// A device with one defect.
struct Defective : HapticDevice {
  explicit Defective(std::function<void(HapticSample&)> spoil_in) : spoil(std::move(spoil_in)) {}
  HapticSample read(double time) noexcept override {
    HapticSample sample = hand.read(time);
    spoil(sample);
    return sample;
  }
  void write(const HapticCommand&) noexcept override {}
  std::string name() const override { return "defective"; }
  ScriptedDevice hand{stroke()};
  std::function<void(HapticSample&)> spoil;
};

bool fails(const std::string& name, std::function<void(HapticSample&)> spoil) {
  Defective device(std::move(spoil));
  const auto broken = find_broken(device);
  return std::any_of(broken.begin(), broken.end(),
                     [&](const std::string& b) { return b.starts_with(name); });
}

}  // namespace

TEST_CASE("every device that is simulated keeps what a device owes") {
  const std::vector<std::string> nothing;
  ScriptedDevice script(stroke());
  CHECK(find_broken(script) == nothing);
  PointerDevice pointer;
  pointer.set({.position = {0.01, 0.0, 0.0}});
  CHECK(find_broken(pointer) == nothing);
  SafeDevice safe(script);
  CHECK(find_broken(safe) == nothing);
  FaultyDevice faultless(script, {});
  CHECK(find_broken(faultless) == nothing);

  ScriptedDevice hand(stroke());
  SimulatedArm arm(hand);
  arm.open();
  CHECK(find_broken(arm) == nothing);

  DeviceBench bench;
  bench.core.hold({Workspace{}.center, Vec3::Zero(), true});
  bench.device.open();
  CHECK(find_broken(bench.device) == nothing);

  NativeCore core;
  FaultyTransport lossy(core, {.drop = 0.02, .corrupt = 0.02, .reorder = 0.02, .seed = 4});
  SerialDevice over_lossy(lossy);
  core.hold({Workspace{}.center, Vec3::Zero(), true});
  over_lossy.open();
  CHECK(find_broken(over_lossy) == nothing);
}

TEST_CASE("a replay is a device too, but goes by its record's time and not by ours") {
  std::vector<HapticSample> samples(2001);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].time = 1e-3 * double(i);
  ReplayDevice replay(samples);

  CHECK(find_broken(replay) == std::vector<std::string>{});
}

TEST_CASE("each defect is found by the check that is meant for it") {
  CHECK(fails("every number", [](HapticSample& s) { s.grip = std::nan(""); }));
  CHECK(fails("a sample carries", [](HapticSample& s) { s.time += 0.5; }));
  CHECK(fails("the orientation", [](HapticSample& s) { s.orientation.w() = 2.0; }));
  CHECK(fails("the hand never jumps",
              [n = 0](HapticSample& s) mutable { s.position.x() += ++n == 500 ? 0.02 : 0.0; }));
  CHECK(fails("the velocity is", [](HapticSample& s) { s.velocity.z() = 0.5; }));
  CHECK(fails("forces leave", [n = 0](HapticSample& s) mutable {
    if (++n > 1500) s.position.y() = std::numeric_limits<double>::infinity();
  }));
  ScriptedDevice inner(stroke());
  FaultyDevice unplugged(inner, {.unplug_at = 0.5});
  CHECK_FALSE(find_broken(unplugged).empty());
}

TEST_CASE("options that cannot be are refused") {
  ScriptedDevice script(stroke());
  CHECK_THROWS_AS(check_conformance(script, {.duration = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(check_conformance(script, {.rate = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(check_conformance(script, {.force = std::nan("")}), std::invalid_argument);
}

TEST_CASE("the driver, the firmware and the arm run without memory or locks once they are open") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  ScriptedDevice hand(stroke());
  SimulatedArm arm(hand);
  arm.open();
  SafeDevice safe(arm);
  const Calls before = count_calls_of_this_thread();

  double local = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const HapticSample sample = safe.read(1e-3 * k);
    safe.write({.force = Vec3(0.0, 0.0, 0.2) - 200.0 * sample.position});
    if (arm.driver().take_status()) {
      local = std::max(local, arm.driver().status().local_stiffness);
    }
  }

  const Calls after = count_calls_of_this_thread();
  CHECK(after.allocations == before.allocations);
  CHECK(after.locks == before.locks);
  CHECK(local > 0.0);  // the local law was at work too
}
