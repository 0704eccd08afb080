// SPDX-License-Identifier: BSD-3-Clause
// How host and device come to speak of one session, on links that are slow for a while.
#include <doctest/doctest.h>

#include <deque>
#include <vector>

#include "core/arm/plants.h"
#include "firmware/board/host.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/arm/simulated_arm.h"

using namespace palpate;

namespace {

/// The device a port away, each way `delay` [s] late until `until` [s] of the device's life.
struct LateTransport : Transport {
  LateTransport(double delay_in, double until_in) : delay(delay_in), until(until_in) {}

  struct Parcel {
    double due;
    std::vector<std::uint8_t> bytes;
  };

  double pass(double time) noexcept {
    if (time < last) base += last;
    last = time;
    return base + time;
  }
  double arrival(double clock, double before) const noexcept {
    return std::max(before, clock < until ? std::min(clock + delay, until) : clock);
  }
  void deliver(double clock) noexcept {
    for (; !down.empty() && down.front().due <= clock; down.pop_front()) {
      core.write(down.front().due, down.front().bytes);
    }
    std::array<std::uint8_t, 512> bytes;
    const std::size_t count = core.read(clock, bytes);
    if (count == 0) return;
    up.push_back({arrival(clock, up.empty() ? 0.0 : up.back().due),
                  std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + long(count))});
  }

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override {
    const double clock = pass(time);
    deliver(clock);
    if (up.empty() || up.front().due > clock || up.front().bytes.size() > bytes.size()) return 0;
    const std::size_t count = up.front().bytes.size();
    std::copy_n(up.front().bytes.begin(), count, bytes.begin());
    up.pop_front();
    return count;
  }
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override {
    const double clock = pass(time);
    down.push_back({arrival(clock, down.empty() ? 0.0 : down.back().due),
                    std::vector<std::uint8_t>(bytes.begin(), bytes.end())});
    if (bytes[1] == PALPATE_HELLO) hellos.push_back(clock);
  }
  bool is_open() const noexcept override { return true; }
  std::string name() const override { return "late core"; }

  NativeCore core;
  const double delay, until;
  std::deque<Parcel> down, up;
  std::vector<double> hellos;  ///< [s] when they were said
  double base = 0.0, last = 0.0;
};

DeviceMode run(SerialDevice& device, double from, double to) {
  for (double time = from; time < to; time += 1e-3) {
    device.read(time);
    device.write({});
  }
  device.take_status();
  return device.status().mode;
}

}  // namespace

TEST_CASE("a greeting that is answered late, once, leaves a device that can be switched on") {
  for (double delay : {12e-3, 25e-3, 30e-3, 60e-3}) {
    LateTransport transport(delay, 2.5);
    SerialDevice device(transport);
    device.open();

    CHECK(run(device, 0.0, 4.0) == DeviceMode::run);
  }
}

TEST_CASE("HELLO is said again after 50 ms, as the page has it, and not before") {
  LateTransport transport(60e-3, 2.5);
  SerialDevice device(transport);
  device.open();

  REQUIRE(transport.hellos.size() >= 2);
  for (std::size_t k = 1; k < transport.hellos.size(); ++k) {
    CHECK(transport.hellos[k] - transport.hellos[k - 1] >= 50e-3 - 1e-9);
  }
}

TEST_CASE("twelve of twelve runs that end as they should leave no fault behind") {
  for (int round = 0; round < 12; ++round) {
    LateTransport transport(0.0, 0.0);
    SerialDevice device(transport);
    device.open();
    REQUIRE(run(device, 0.0, 0.7 + 0.0137 * round) == DeviceMode::run);

    device.end();
    transport.deliver(transport.base + 0.9);  // the record is read: nobody speaks
    SerialDevice next(transport);
    next.open();

    next.take_status();
    CHECK(next.status().first_fault == 15);
    CHECK(next.status().mode == DeviceMode::idle);
  }
}

TEST_CASE("a session that another host has taken over is greeted again, and comes back") {
  LateTransport transport(0.0, 0.0);
  SerialDevice device(transport);
  device.open();
  REQUIRE(run(device, 0.0, 1.0) == DeviceMode::run);
  // HELLO of another host, on the same wire; its INFO is lost
  palpate_hello hello{200, PALPATE_PROTOCOL_VERSION, 99};
  std::uint8_t body[PALPATE_BODY_MAX], wire[PALPATE_WIRE_MAX];
  const std::uint8_t count = palpate_encode_frame(body, palpate_write_hello(&hello, body), wire);
  transport.core.write(transport.base + 1.0, std::span(wire).first(count));
  transport.core.advance(transport.base + 1.002);

  CHECK(run(device, 1.003, 2.5) == DeviceMode::run);
}
