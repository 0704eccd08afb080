// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/device_channel.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/tick/private/device_coupling.h"

namespace palpate {
namespace {

/// Ticks without damping after which the next is another intervention [stability: passivity].
constexpr std::int64_t kCalmTicks = 100;

std::int32_t measure_delay(const DeviceDynamics& dynamics, double period) noexcept {
  return static_cast<std::int32_t>(
      std::lround(1e6 * std::clamp(0.5 * period + dynamics.delay, 0.0, 1e3)));
}

}  // namespace

DeviceChannel::DeviceChannel(HapticDevice& device, const SafetyLimits& limits, double period)
    : device_(device),
      safe_(device, limits),
      passive_stiffness_(find_passive_stiffness(device.dynamics(), period)),
      delay_us_(measure_delay(device.dynamics(), period)) {}

void DeviceChannel::notice(std::int64_t tick, int instrument, TickLog* log) noexcept {
  const auto tell = [&](EventKind kind, std::int32_t index, double value) noexcept {
    if (log) log->push(Event{tick, kind, index, value, instrument});
  };
  const MotorState now = safe_.motors();
  if (now != motors_) {
    const bool on = now == MotorState::on;
    tell(on ? EventKind::motors_on : EventKind::motors_off, on ? 0 : static_cast<std::int32_t>(now),
         0.0);
    motors_ = now;
  }
  DeviceFault found = safe_.fault();
  // a device that has failed since it was last written to has its motors cut as well
  if (found == DeviceFault::none && now == MotorState::cut) {
    found = safe_.failed() ? DeviceFault::device_failed : DeviceFault::motors_cut;
  }
  if (found == fault_.load(std::memory_order_relaxed)) return;
  fault_value_.store(safe_.fault_value(), std::memory_order_relaxed);
  fault_.store(found, std::memory_order_release);
  if (found == DeviceFault::none) return;
  tell(EventKind::fault, static_cast<std::int32_t>(found), safe_.fault_value());
}

void DeviceChannel::notice_damping(std::int64_t tick, int instrument, TickLog* log) noexcept {
  const long count = safe_.damped_count();
  if (count == damped_.load(std::memory_order_relaxed)) return;
  damped_.store(count, std::memory_order_relaxed);
  const bool begins = last_damped_ < 0 || tick - last_damped_ > kCalmTicks;
  last_damped_ = tick;
  if (!begins) return;
  interventions_.fetch_add(1, std::memory_order_relaxed);
  if (log) {
    log->push(Event{tick, EventKind::passivity, 0, safe_.given_energy(), instrument});
  }
}

namespace {

void raise_to(double value, std::atomic<double>& largest) noexcept {
  if (value > largest.load(std::memory_order_relaxed)) {
    largest.store(value, std::memory_order_relaxed);
  }
}

}  // namespace

void DeviceChannel::count_force(const InstrumentState& instrument) noexcept {
  if (motors_ != MotorState::on) {
    unrendered_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  const double size = safe_.sent().force.norm();
  raise_to(size, peak_force_);
  const ToolState& tool = instrument.tool;
  if (!tool.touching && !tool.has_hold()) return;
  const DeviceCoupling& coupling = instrument.device;
  if (coupling.follows_tissue) follows_tissue_.fetch_add(1, std::memory_order_relaxed);
  raise_to(coupling.tissue, tissue_stiffness_);
  raise_to(find_stiffness_error(coupling), stiffness_error_);
  const long count = touch_ticks_.fetch_add(1, std::memory_order_relaxed) + 1;
  touch_force_sum_ += size;
  touch_force_.store(touch_force_sum_ / double(count), std::memory_order_relaxed);
}

void DeviceChannel::end() noexcept {
  device_.write(HapticCommand{});
  device_.end();
}

DeviceReport DeviceChannel::report() const {
  DeviceReport report;
  report.fault = fault();
  report.fault_reason =
      describe_fault(report.fault, fault_value_.load(std::memory_order_relaxed), device_);
  report.unrendered_ticks = unrendered_.load(std::memory_order_relaxed);
  report.peak_force = peak_force_.load(std::memory_order_relaxed);
  report.touch_ticks = touch_ticks_.load(std::memory_order_relaxed);
  report.touch_force = touch_force_.load(std::memory_order_relaxed);
  report.damped_ticks = damped_.load(std::memory_order_relaxed);
  report.interventions = interventions();
  report.passive_stiffness = passive_stiffness_;
  report.follows_tissue_ticks = follows_tissue_.load(std::memory_order_relaxed);
  report.tissue_stiffness = tissue_stiffness_.load(std::memory_order_relaxed);
  report.stiffness_error = stiffness_error_.load(std::memory_order_relaxed);
  return report;
}

std::vector<std::unique_ptr<DeviceChannel>> open_channels(const Scene& scene,
                                                          std::span<HapticDevice* const> devices,
                                                          const LoopOptions& options,
                                                          const TickLog* log) {
  const auto require_each = [&](const char* name, std::size_t count) {
    if (count == scene.instruments.size()) return;
    refuse(name, write_text(count),
           write_text(scene.instruments.size(), ", one for each instrument of the scene"));
  };
  require_each("loop: devices", devices.size());
  if (!options.device_safety.empty()) {
    require_each("loop: device_safety", options.device_safety.size());
  }
  if (log) require_each("loop: log.instruments", static_cast<std::size_t>(log->instruments()));
  std::vector<std::unique_ptr<DeviceChannel>> channels;
  for (auto at = devices.begin(); at != devices.end(); ++at) {
    const auto i = static_cast<std::size_t>(at - devices.begin());
    if (!*at || std::find(devices.begin(), at, *at) != at) {
      refuse(write_text("loop: devices[", i, "]"),
             *at ? "a device that drives another instrument" : "none", "one of its own");
    }
    const SafetyLimits& limits =
        options.device_safety.empty() ? options.safety : options.device_safety[i];
    channels.push_back(std::make_unique<DeviceChannel>(**at, limits, 1.0 / scene.rate));
  }
  return channels;
}

void sum_devices(LoopReport& report) {
  double touch_force_sum = 0.0;
  for (const DeviceReport& device : report.devices) {
    report.unrendered_ticks += device.unrendered_ticks;
    report.peak_force = std::max(report.peak_force, device.peak_force);
    report.touch_ticks += device.touch_ticks;
    report.damped_ticks += device.damped_ticks;
    report.interventions += device.interventions;
    touch_force_sum += device.touch_force * double(device.touch_ticks);
  }
  // one device alone says its mean itself, to the bit
  report.touch_force = report.devices.size() == 1 ? report.devices[0].touch_force
                       : report.touch_ticks > 0   ? touch_force_sum / double(report.touch_ticks)
                                                  : 0.0;
  const auto failed = std::ranges::find_if(
      report.devices, [](const DeviceReport& d) { return d.fault != DeviceFault::none; });
  const DeviceReport& told = failed == report.devices.end() ? report.devices[0] : *failed;
  report.fault = told.fault;
  report.fault_reason = told.fault_reason;
}

}  // namespace palpate
