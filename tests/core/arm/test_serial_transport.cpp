// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include "core/tick/press_scene.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/loop/loop.h"

#ifdef PALPATE_SERIAL

using namespace palpate;

// Through a real terminal of this machine, so function only: its latency is the machine's.

TEST_CASE("the driver runs a device behind a pseudo terminal as it would behind a serial port") {
  PtyDevice device;
  SerialTransport transport(device.path());
  SerialDevice driver(transport);

  driver.open(20.0);
  CHECK(driver.calibration().upper_length == doctest::Approx(0.15));
  bool energised = false;
  const double begun = transport.now(0.0);
  for (double time = 0.0; time < 20.0 && !energised; time = transport.now(0.0) - begun) {
    CHECK(driver.read(time).position.allFinite());
    driver.write({});
    if (driver.take_status()) energised = driver.status().mode == DeviceMode::ramp;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }

  CHECK(energised);
  CHECK(driver.status().reports > 10);
  CHECK(transport.name() == device.path());
  CHECK_FALSE(transport.latency_note().empty());
}

TEST_CASE("a live loop ticks with the reports of a device that is a port away") {
  const Scene scene = testing::press_scene();
  for (bool paced : {true, false}) {
    PtyDevice arm;
    SerialTransport transport(arm.path());
    SerialDevice driver(transport);
    driver.open(20.0);
    FaultyDevice without_pace(driver, {});  // hands samples on, not when they come
    HapticDevice& device = paced ? static_cast<HapticDevice&>(driver) : without_pace;
    CHECK(device.report_rate() == (paced ? 1000.0 : 0.0));

    Loop loop(scene, device, {.duration = 0.5});
    loop.start();
    REQUIRE(loop.wait(60.0));

    const LoopReport report = loop.report();
    driver.take_status();
    std::printf("%s: %ld ticks, %ld of them without their report; round trip %.2f ms, p99 %.2f\n",
                paced ? "by the device's clock" : "by our own clock", report.ticks,
                report.unpaced_ticks, 1e3 * driver.status().round_trip_median,
                1e3 * driver.status().round_trip_p99);
    CHECK(report.ticks > 0);
    // a machine that is busy for 20 ms is a silent host, for which the device cuts its motors
    const bool silent = report.fault_reason.find("motors off: host silent") == 0;
    CHECK_MESSAGE((report.fault == DeviceFault::none || silent), report.fault_reason);
    // all of them, on a machine that is not busy
    if (paced) CHECK(report.unpaced_ticks < report.ticks);
    if (!paced) CHECK(report.unpaced_ticks == 0);
  }
}

TEST_CASE("a host that was stopped for seconds comes back to its device") {
  PtyDevice arm;
  SerialTransport transport(arm.path());
  SerialDevice driver(transport);
  driver.open(20.0);

  for (double time : {0.0, 1.5, 4.0, 4.2}) {  // after 1.5 s of silence a device would be gone
    CAPTURE(time);
    while (!driver.wait_for_report(read_clock() + 1000000)) REQUIRE_FALSE(driver.failed());
    driver.read(time);
    driver.take_status();

    CHECK_FALSE(driver.failed());
    CHECK(driver.status().link == LinkState::ready);
  }
}

TEST_CASE(
    "a port that says nothing is waited for no longer than asked, one that closed not at all") {
  auto device = std::make_unique<PtyDevice>();
  SerialTransport transport(device->path());
  const std::int64_t latest = read_clock() + 2000000;
  CHECK_FALSE(transport.wait(latest));  // nobody has greeted it
  CHECK(read_clock() >= latest);

  device.reset();
  std::array<std::uint8_t, 64> bytes;
  transport.wait(read_clock() + 2000000);
  transport.read(0.0, bytes);
  CHECK_FALSE(transport.is_open());
  CHECK_FALSE(transport.wait(read_clock() + 1000000000));
}

TEST_CASE("a port whose other end goes away is closed for good, without an exception") {
  auto device = std::make_unique<PtyDevice>();
  SerialTransport transport(device->path());
  std::array<std::uint8_t, 64> bytes;
  transport.read(0.0, bytes);
  CHECK(transport.is_open());

  device.reset();
  for (int i = 0; i < 100 && transport.is_open(); ++i) {
    transport.read(0.0, bytes);
    transport.write(0.0, std::span(bytes).first(8));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  CHECK_FALSE(transport.is_open());
  CHECK(transport.read(0.0, bytes) == 0);
}

TEST_CASE("a port that is not there is refused by its name") {
  CHECK_THROWS_WITH_AS(SerialTransport("/dev/no-such-port"),
                       "/dev/no-such-port: No such file or directory, expected a serial port that "
                       "takes 1000000 bit/s",
                       DeviceError);
  CHECK_THROWS_AS(SerialTransport("/dev/null"), DeviceError);
}

TEST_CASE("looking for ports finds files, or nothing where there are none") {
  for (const SerialPort& port : find_serial_ports()) CHECK(port.path.starts_with("/dev/tty"));
}

#endif
