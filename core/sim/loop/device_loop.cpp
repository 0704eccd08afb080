// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/loop/private/pace.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;            // [s]
constexpr std::int64_t kSpin = 150000;    // [ns] spun instead of slept before every tick
constexpr double kLongest = 24 * 3600.0;  // [s]

}  // namespace

void validate(const DeviceTask& task) {
  if (!task.force.allFinite()) refuse("device task: force [N]", "not a number", "finite numbers");
  if (!task.rest.allFinite()) refuse("device task: rest [m]", "not a number", "finite numbers");
  if (!(task.stiffness >= 0.0) || !std::isfinite(task.stiffness)) {
    refuse("device task: stiffness [N/m]", write_text(task.stiffness), "0 or more");
  }
}

struct DeviceLoop::Impl {
  Impl(HapticDevice& device_in, const SafetyLimits& limits)
      : device(device_in), safe(device, limits) {}

  void run() noexcept;
  void run_tick() noexcept;
  void require_rest() const {
    if (running.load(std::memory_order_acquire)) {
      throw std::logic_error("device loop: runs already, expected it to be stopped");
    }
  }

  HapticDevice& device;

  // the loop's own while it runs
  SafeDevice safe;
  long tick = 0;
  long silent_until = 0;  // tick

  // between the threads
  Latest<DeviceTask> tasks;
  std::atomic<double> time{0.0}, silence{0.0};
  std::atomic<long> missed{0};
  std::atomic<DeviceFault> fault{DeviceFault::none};
  std::atomic<bool> running{false}, stopping{false};
  std::thread thread;
};

void DeviceLoop::Impl::run_tick() noexcept {
  const double now = kTick * double(tick);
  time.store(now, std::memory_order_relaxed);
  if (const double wanted = silence.exchange(0.0, std::memory_order_relaxed); wanted > 0.0) {
    silent_until = tick + std::lround(wanted / kTick);
  }
  ++tick;
  if (tick <= silent_until) return;
  tasks.take();
  const DeviceTask& task = tasks.front();
  const HapticSample sample = safe.read(now);
  safe.write({.force = task.force + task.stiffness * (task.rest - sample.position)});
  fault.store(safe.fault(), std::memory_order_relaxed);
}

/// As the live loop: a tick is due when the device's report has come, and what was due while an
/// earlier tick was at work is skipped, never made up.
void DeviceLoop::Impl::run() noexcept {
  const Realtime granted = enter_realtime(true, -1);
  Pace pace(safe, 1.0 / kTick, kSpin);
  pace.begin(tick);
  while (!stopping.load(std::memory_order_acquire)) {
    if (tick < silent_until) {  // reports that nobody reads would make every tick due
      wait_until(read_clock() + pace.period(), 0);
      run_tick();
      pace.begin(tick);
      continue;
    }
    pace.wait(tick);
    run_tick();
    for (const std::int64_t now = read_clock(); pace.due(tick) < now; ++tick) {
      missed.fetch_add(1, std::memory_order_relaxed);
    }
  }
  safe.rest();
  device.write(HapticCommand{});
  leave_realtime(granted);
}

DeviceLoop::DeviceLoop(HapticDevice& device, const SafetyLimits& limits)
    : impl_(std::make_unique<Impl>(device, limits)) {}
DeviceLoop::~DeviceLoop() { stop(); }

void DeviceLoop::start() {
  impl_->require_rest();
  impl_->stopping.store(false, std::memory_order_release);
  impl_->running.store(true, std::memory_order_release);
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

void DeviceLoop::stop() {
  impl_->stopping.store(true, std::memory_order_release);
  if (impl_->thread.joinable()) impl_->thread.join();
  impl_->running.store(false, std::memory_order_release);
}

bool DeviceLoop::running() const noexcept { return impl_->running.load(std::memory_order_acquire); }

void DeviceLoop::run(double seconds) {
  impl_->require_rest();
  if (!(seconds > 0.0 && seconds <= kLongest)) {
    refuse("device loop: seconds [s]", write_text(seconds), "more than 0, at most a day");
  }
  for (long k = std::max(1L, std::lround(seconds / kTick)); k > 0; --k) impl_->run_tick();
}

void DeviceLoop::set_task(const DeviceTask& task) {
  validate(task);
  impl_->tasks.back() = task;
  impl_->tasks.publish();
}

void DeviceLoop::fall_silent(double seconds) noexcept {
  impl_->silence.store(seconds, std::memory_order_relaxed);
}

double DeviceLoop::time() const noexcept { return impl_->time.load(std::memory_order_relaxed); }
long DeviceLoop::missed_ticks() const noexcept {
  return impl_->missed.load(std::memory_order_relaxed);
}
DeviceFault DeviceLoop::fault() const noexcept {
  return impl_->fault.load(std::memory_order_relaxed);
}

}  // namespace palpate
