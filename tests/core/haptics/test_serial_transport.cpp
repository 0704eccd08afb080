// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "palpate/sim/base/error.h"
#include "palpate/sim/haptics/serial_device.h"
#include "palpate/sim/haptics/serial_transport.h"

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
