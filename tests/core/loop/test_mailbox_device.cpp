// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "calls.h"
#include "core/tick/press_scene.h"
#include "palpate/sim/device/mailbox_device.h"
#include "palpate/sim/loop/loop.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

HapticSample hand_at(const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
  HapticSample sample;
  sample.position = position;
  sample.velocity = velocity;
  return sample;
}

/// Fails right behind a write, before the loop asks what its motors do.
class BrokenByWrite : public HapticDevice {
 public:
  HapticSample read(double time) noexcept override {
    HapticSample sample = hand_at({0, 0, 0.05});
    sample.time = time;
    return sample;
  }
  void write(const HapticCommand&) noexcept override { failed_ = ++writes_ >= 20; }
  std::string name() const override { return "box"; }
  bool failed() const noexcept override { return failed_; }
  MotorState motors() const noexcept override { return failed_ ? MotorState::cut : MotorState::on; }
  std::string explain_fault() const override { return failed_ ? "box: the cable burnt" : ""; }

 private:
  int writes_ = 0;
  std::atomic<bool> failed_{false};
};

}  // namespace

TEST_CASE("a device that fails between two questions of the loop has failed, not cut its motors") {
  const Scene scene = testing::press_scene();
  BrokenByWrite device;
  Loop loop(scene, device, {.on_fault = FaultResponse::end});
  loop.start();
  REQUIRE(loop.wait(60.0));

  CHECK(loop.report().fault == DeviceFault::device_failed);
  CHECK(loop.report().fault_reason == "box: the cable burnt");
}

TEST_CASE("a mailbox hands over the newest sample and the newest force") {
  MailboxDevice device("box");
  device.tell(hand_at({1, 0, 0}));
  device.tell(hand_at({2, 0, 0}));
  const HapticSample sample = device.read(0.5);
  device.write({.force = {0, 0, 1}});
  device.write({.force = {0, 0, 3}});

  CHECK(sample.position == Vec3(2, 0, 0));
  CHECK(sample.time == 0.5);
  CHECK(device.take_command().force == Vec3(0, 0, 3));
  CHECK(device.name() == "box");
}

TEST_CASE("between two samples the hand goes on as it went, for 3 ms") {
  MailboxDevice device("box");
  device.tell(hand_at({0, 0, 0}, {0.1, 0, 0}));
  CHECK(device.read(1.0).position == Vec3::Zero());
  CHECK(device.read(1.002).position.x() == doctest::Approx(0.2e-3));
  CHECK(device.read(1.002).velocity.x() == 0.1);
  CHECK(device.read(1.01).position.x() == doctest::Approx(0.3e-3));
  CHECK(device.read(1.01).velocity.x() == 0.0);
}

TEST_CASE(
    "a driver that tells nothing has no force after 20 ms, and its motors cut after a second") {
  MailboxDevice device("box");
  device.read(0.0);
  CHECK(device.motors() == MotorState::off);
  device.tell(hand_at({0, 0, 0}));
  device.read(0.001);
  CHECK(device.motors() == MotorState::on);
  device.read(0.02);
  CHECK(device.motors() == MotorState::on);
  device.read(0.03);
  CHECK(device.motors() == MotorState::silent);
  CHECK(device.explain_fault().empty());
  device.read(1.1);
  CHECK(device.motors() == MotorState::cut);
  CHECK(device.explain_fault() == "box: has told nothing for a second");
  for (int k = 0; k < 100; ++k) device.rest(0.1);
  CHECK(device.motors() == MotorState::cut);
  device.tell(hand_at({0, 0, 0}));
  device.rest(0.1);
  CHECK(device.motors() == MotorState::on);
  device.read(1.101);
  CHECK(device.motors() == MotorState::on);
  CHECK_FALSE(device.failed());
}

TEST_CASE("a driver that fails ends the run with its own words, of which the first count") {
  const Scene scene = testing::press_scene();
  MailboxDevice device("box");
  device.tell(hand_at({0, 0, 0.05}));
  Loop loop(scene, device, {.on_fault = FaultResponse::end});
  loop.start();
  while (loop.report().ticks < 5) {
    device.tell(hand_at({0, 0, 0.05}));  // on a slow machine it would else be silent by then
    std::this_thread::yield();
  }

  device.fail("the cable burnt");
  device.fail("and so did the rest");
  REQUIRE(loop.wait(60.0));

  CHECK(loop.report().fault == DeviceFault::device_failed);
  CHECK(loop.report().fault_reason == "box: the cable burnt");
}

TEST_CASE("a driver in another thread feels the tissue, and the loop's takes no lock for it") {
  const Scene scene = testing::press_scene();
  MailboxDevice device("box");
  device.tell(hand_at({0.001, 0.002, 0.033}));
  TickLog log;
  Loop loop(scene, device, {.safety = {.ramp_time = 0.01}}, &log);
  loop.start();
  Vec3 force = Vec3::Zero();
  // 20 mm/s by the ticks of the run: as fast as this thread is, it would tear the tissue
  for (long ticks = 0; force.norm() < 0.05 && ticks < 20000; ticks = loop.report().ticks) {
    const double height = std::max(0.018, 0.033 - 2e-5 * double(ticks));
    device.tell(hand_at({0.001, 0.002, height}));
    force = device.take_command().force;
    std::this_thread::yield();
  }
  loop.stop();

  CHECK_FALSE(loop.report().alarm);
  CHECK(force.z() > 0.04);
  CHECK(loop.report().peak_force >= force.norm());
}

TEST_CASE("reading a mailbox allocates nothing and takes no lock") {
  SKIP_UNLESS(calls_are_counted(), "calls cannot be counted under a sanitizer");
  MailboxDevice device("box");
  device.tell(hand_at({0, 0, 0}));
  const Calls first = count_calls_of_this_thread();
  for (int k = 0; k < 2000; ++k) {
    device.read(1e-3 * k);
    device.write({});
    if (device.motors() == MotorState::on) device.rest(1e-3);
  }
  const Calls last = count_calls_of_this_thread();

  CHECK(last.allocations == first.allocations);
  CHECK(last.locks == first.locks);
}
