// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "palpate/sim/base/private/duration_histogram.h"
#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/loop/private/pace.h"
#include "palpate/sim/loop/private/pending_snapshot.h"
#include "palpate/sim/loop/private/tree_builder.h"
#include "palpate/sim/tick/private/follow_tissue.h"

namespace palpate {
namespace {

constexpr double kSnapshotInterval = 8e-3;  // [s] twice as often as a screen wants one
constexpr double kHashInterval = 1.0;       // [s]

const Scene& with_one_instrument(const Scene& scene) {
  if (scene.instruments.size() == 1) return scene;
  throw std::invalid_argument("loop: scene.instruments: got " +
                              std::to_string(scene.instruments.size()) +
                              ", expected one, as there is one device");
}

const LoopOptions& validated(const LoopOptions& options) {
  const auto refuse = [](const std::string& field, double found, const std::string& expected) {
    throw std::invalid_argument("loop: " + field + ": got " + std::to_string(found) +
                                ", expected " + expected);
  };
  if (!(options.duration >= 0.0) || !std::isfinite(options.duration)) {
    refuse("duration [s]", options.duration, "0 or more");
  }
  if (!(options.spin >= 0.0 && options.spin <= 1.0)) refuse("spin [s]", options.spin, "0 to 1");
  if (options.cpu < -1) refuse("cpu", options.cpu, "a core, or -1");
  return options;
}

long ticks_in(double seconds, double rate) {
  return std::max(1L, static_cast<long>(std::llround(std::min(seconds * rate, 9e15))));
}
double to_seconds(std::int64_t nanoseconds) noexcept { return 1e-9 * double(nanoseconds); }

Percentiles percentiles_of(const DurationHistogram& d) {
  return {1e-9 * d.percentile(0.5), 1e-9 * d.percentile(0.99), 1e-9 * d.percentile(0.999),
          to_seconds(d.largest())};
}

}  // namespace

struct Loop::Impl {
  Impl(const Scene& scene_in, HapticDevice& device_in, const LoopOptions& options_in,
       TickLog* log_in)
      : scene(with_one_instrument(scene_in)),
        device(device_in),
        options(validated(options_in)),
        log(log_in),
        dt(1.0 / scene.rate),
        snapshot_ticks(ticks_in(kSnapshotInterval, scene.rate)),
        hash_ticks(ticks_in(kHashInterval, scene.rate)),
        world(scene),
        safe(device, options.safety),
        pace(safe, scene.rate, std::llround(1e9 * options.spin)),
        snapshots(PendingSnapshot(world)),
        reader(world) {
    for (const SoftState& body : world.bodies) {
      trees.push_back(std::make_unique<TreeBuilder>(body));
    }
  }

  void run() noexcept;
  void run_ticks() noexcept;
  void run_tick(std::int64_t index, long skipped) noexcept;
  void rest(std::int64_t index) noexcept;
  void keep(const HapticCommand& command) noexcept;
  void notice_alarm(long number) noexcept;
  void notice_device(long number) noexcept;
  void count_force() noexcept;
  void publish() noexcept;
  void serve_trees() noexcept;
  void log_hash(long number) noexcept {
    catch_up(scene, world);
    log->push(StateHash{number, compute_hash(world)});
  }
  void tell(long number, EventKind kind, std::int32_t index, double value = 0.0) noexcept {
    if (log) log->push(Event{number, kind, index, value});
  }

  const Scene& scene;
  HapticDevice& device;
  const LoopOptions options;
  TickLog* const log;
  const double dt;  // [s]
  const long snapshot_ticks, hash_ticks;

  // the haptic thread's own while it runs
  World world;
  std::vector<std::unique_ptr<TreeBuilder>> trees;  // per body
  SafeDevice safe;
  Pace pace;
  HapticSample sample;
  std::int64_t lateness = 0, spent = 0;  // [ns] of the last tick
  long lost_ticks = 0;                   // had no room in the log, not yet told
  MotorState motors = MotorState::on;    // as it was told last
  double touch_force_sum = 0.0;          // [N]

  // written by the haptic thread before `ready`, constant after it
  Realtime realtime;
  std::atomic<bool> ready{false};

  // between the threads
  Latest<PendingSnapshot> snapshots;
  SnapshotReader reader;  // the reader's own
  DurationHistogram latenesses, costs;
  std::atomic<long> ticks{0}, missed{0};
  std::atomic<long> unrendered{0}, touch_ticks{0};
  std::atomic<double> peak_force{0.0}, touch_force{0.0};  // [N]
  std::atomic<DeviceFault> fault{DeviceFault::none};
  std::atomic<double> fault_value{0.0};
  Alarm alarm;  // constant once has_alarm is set
  std::atomic<bool> has_alarm{false};
  std::atomic<bool> stopping{false}, running{false};
  std::atomic<bool> pausing{false}, resting{false};  // asked for by others, done by this thread
  std::mutex ending;
  std::condition_variable ended;
  bool has_ended = false;

  std::thread thread;
};

void Loop::Impl::run() noexcept {
  world.follows_all = false;
  realtime = enter_realtime(options.realtime, options.cpu);
  running.store(true, std::memory_order_release);
  ready.store(true, std::memory_order_release);
  ready.notify_all();
  run_ticks();
  device.write(HapticCommand{});  // past the wrapper, whose slew limit would let the force linger
  device.end();
  leave_realtime(realtime);

  const std::lock_guard guard(ending);
  running.store(false, std::memory_order_release);
  has_ended = true;
  ended.notify_all();
}

/// A due time that passes while an earlier tick is still at work is skipped, so the thread never
/// hurries after the clock and always comes to sleep.
void Loop::Impl::run_ticks() noexcept {
  const std::int64_t end = options.duration > 0.0 ? ticks_in(options.duration, scene.rate)
                                                  : std::numeric_limits<std::int64_t>::max();
  pace.begin(0);
  long skipped = 0;
  for (std::int64_t index = 0; index < end;) {
    const std::int64_t due = pace.wait(index);
    if (stopping.load(std::memory_order_acquire)) break;
    if (pausing.load(std::memory_order_acquire)) {
      rest(index);
      continue;
    }
    lateness = std::max<std::int64_t>(0, read_clock() - due);
    run_tick(index, skipped);

    const std::int64_t now = read_clock();
    for (skipped = 0, ++index; index < end && pace.due(index) < now; ++index) {
      ++skipped;
    }
    missed.fetch_add(skipped, std::memory_order_relaxed);
    if (fault.load(std::memory_order_relaxed) == DeviceFault::none) continue;
    if (options.on_fault == FaultResponse::end) break;
    if (options.on_fault == FaultResponse::pause) pausing.store(true, std::memory_order_release);
  }
  const long done = ticks.load(std::memory_order_relaxed);
  if (skipped > 0) tell(done, EventKind::missed_ticks, static_cast<std::int32_t>(skipped));
  if (lost_ticks > 0) tell(done, EventKind::record_gap, static_cast<std::int32_t>(lost_ticks));
  if (log && done > 0 && done % hash_ticks != 0) log_hash(done - 1);
  if (done > 0) publish();
}

/// Keeps the device at rest before tick `index`, which is then due one period after the pause, so
/// that nothing that follows is late for it.
void Loop::Impl::rest(std::int64_t index) noexcept {
  const std::int64_t begun = read_clock();
  safe.rest(dt);
  if (world.tick_count > 0) publish();
  resting.store(true, std::memory_order_release);
  while (pausing.load(std::memory_order_acquire) && !stopping.load(std::memory_order_acquire)) {
    wait_until(read_clock() + pace.period(), 0);
    safe.rest(dt);  // again and again: a device may take silence for a fault
    notice_device(world.tick_count);
  }
  const std::int64_t now = read_clock();
  resting.store(false, std::memory_order_release);
  tell(world.tick_count, EventKind::paused, 0, to_seconds(now - begun));
  pace.begin(index);
}

void Loop::Impl::run_tick(std::int64_t index, long skipped) noexcept {
  const std::int64_t begun = read_clock();
  const long number = world.tick_count;
  const int held = world.instruments[0].tool.hold_count;

  sample = safe.read(double(index) * dt);
  const HapticCommand command = tick(scene, sample, dt, world);
  safe.write(command);
  spent = read_clock() - begun;

  if (skipped > 0) tell(number, EventKind::missed_ticks, static_cast<std::int32_t>(skipped));
  if (held == 0 && world.instruments[0].tool.hold_count > 0) {
    tell(number, EventKind::attached, world.instruments[0].tool.hold_count);
  } else if (held > 0 && world.instruments[0].tool.hold_count == 0) {
    tell(number, EventKind::released, held);
  }
  notice_alarm(number);
  notice_device(number);
  count_force();
  keep(command);
  latenesses.add(lateness);
  costs.add(spent);
  ticks.store(number + 1, std::memory_order_relaxed);
  if (number % snapshot_ticks == 0) publish();
  serve_trees();
}

/// Has the trees of bodies rebuilt where that is worth it.
void Loop::Impl::serve_trees() noexcept {
  for (std::size_t b = 0; b < trees.size(); ++b) {
    if (trees[b]->will_ask(world, b)) catch_up(scene.bodies[b], world.bodies[b]);
    const auto told = trees[b]->serve(b, world);
    // no answer depends on it, and an event has no room for the number of the body
    if (told && trees.size() == 1) tell(told->tick, told->kind, told->index, told->value);
  }
}

/// Leaves the tick in the log, and once a second the world's hash.
void Loop::Impl::keep(const HapticCommand& command) noexcept {
  if (!log) return;
  const long number = world.tick_count - 1;
  TickLog::Tick entry{number, sample, compute_felt(command, world)};
  entry.felt.lateness_us = static_cast<std::uint16_t>(
      std::min<std::int64_t>(lateness / 1000, std::numeric_limits<std::uint16_t>::max()));
  if (motors != MotorState::on) entry.felt.touched |= kNotRendered;
  if (!log->push(entry)) {
    ++lost_ticks;
  } else if (lost_ticks > 0) {
    tell(number, EventKind::record_gap, static_cast<std::int32_t>(lost_ticks));
    lost_ticks = 0;
  }
  if ((number + 1) % hash_ticks == 0) log_hash(number);
}

void Loop::Impl::notice_alarm(long number) noexcept {
  if (world.alarm && !has_alarm.load(std::memory_order_relaxed)) {
    alarm = world.alarm;
    has_alarm.store(true, std::memory_order_release);
    tell(number, EventKind::alarm, static_cast<std::int32_t>(alarm.kind), alarm.value);
  }
}

/// Whether the device still gives its force, and what became of it where it does not.
void Loop::Impl::notice_device(long number) noexcept {
  const MotorState now = safe.motors();
  if (now != motors) {
    const bool on = now == MotorState::on;
    tell(number, on ? EventKind::motors_on : EventKind::motors_off,
         on ? 0 : static_cast<std::int32_t>(now));
    motors = now;
  }
  DeviceFault found = safe.fault();
  // a device that has failed since it was last written to has its motors cut as well
  if (found == DeviceFault::none && now == MotorState::cut) {
    found = safe.failed() ? DeviceFault::device_failed : DeviceFault::motors_cut;
  }
  if (found == fault.load(std::memory_order_relaxed)) return;
  fault_value.store(safe.fault_value(), std::memory_order_relaxed);
  fault.store(found, std::memory_order_release);
  if (found == DeviceFault::none) return;
  tell(number, EventKind::fault, static_cast<std::int32_t>(found), safe.fault_value());
}

/// What the hand really felt of this tick.
void Loop::Impl::count_force() noexcept {
  if (motors != MotorState::on) {
    unrendered.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  const double size = safe.sent().force.norm();
  if (size > peak_force.load(std::memory_order_relaxed)) {
    peak_force.store(size, std::memory_order_relaxed);
  }
  if (!world.instruments[0].tool.touching && world.instruments[0].tool.hold_count == 0) return;
  const long count = touch_ticks.fetch_add(1, std::memory_order_relaxed) + 1;
  touch_force_sum += size;
  touch_force.store(touch_force_sum / double(count), std::memory_order_relaxed);
}

void Loop::Impl::publish() noexcept {
  note_world(world, sample, snapshots.back());
  Snapshot& snapshot = snapshots.back().seen;
  snapshot.force = safe.sent().force;
  snapshot.motors = motors;
  snapshot.cost = to_seconds(spent);
  snapshot.lateness = to_seconds(lateness);
  snapshot.missed_ticks = missed.load(std::memory_order_relaxed);
  snapshots.publish();
}

Loop::Loop(const Scene& scene, HapticDevice& device, const LoopOptions& options, TickLog* log)
    : impl_(std::make_unique<Impl>(scene, device, options, log)) {}
Loop::~Loop() { stop(); }

void Loop::start() {
  if (impl_->thread.joinable() || impl_->has_ended) {
    throw std::logic_error("loop: got start() a second time, expected a loop to run once");
  }
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
  impl_->ready.wait(false, std::memory_order_acquire);
}

void Loop::stop() {
  impl_->stopping.store(true, std::memory_order_release);
  if (impl_->thread.joinable()) impl_->thread.join();
}

bool Loop::wait(double timeout) {
  // the far end of what the clock can count to
  const std::chrono::duration<double> patience(std::clamp(timeout, 0.0, 1e9));
  std::unique_lock lock(impl_->ending);
  return impl_->ended.wait_for(lock, patience, [this] { return impl_->has_ended; });
}

bool Loop::running() const noexcept { return impl_->running.load(std::memory_order_acquire); }
void Loop::pause() noexcept { impl_->pausing.store(true, std::memory_order_release); }
void Loop::resume() noexcept { impl_->pausing.store(false, std::memory_order_release); }
bool Loop::paused() const noexcept { return impl_->resting.load(std::memory_order_acquire); }
bool Loop::take_snapshot() {
  const bool taken = impl_->snapshots.take();
  if (taken) impl_->reader.read(impl_->scene, impl_->snapshots.front());
  return taken;
}
const Snapshot& Loop::snapshot() const noexcept { return impl_->reader.snapshot(); }

LoopReport Loop::report() const {
  LoopReport report;
  report.ticks = impl_->ticks.load(std::memory_order_relaxed);
  report.missed_ticks = impl_->missed.load(std::memory_order_relaxed);
  report.unpaced_ticks = impl_->pace.unpaced();
  report.lateness = percentiles_of(impl_->latenesses);
  report.cost = percentiles_of(impl_->costs);
  if (impl_->ready.load(std::memory_order_acquire)) {
    report.realtime = impl_->realtime.scheduled;
    report.realtime_note = impl_->realtime.note;
  }
  if (impl_->has_alarm.load(std::memory_order_acquire)) report.alarm = impl_->alarm;
  report.fault = impl_->fault.load(std::memory_order_acquire);
  report.fault_reason = describe_fault(
      report.fault, impl_->fault_value.load(std::memory_order_relaxed), impl_->device);
  report.unrendered_ticks = impl_->unrendered.load(std::memory_order_relaxed);
  report.peak_force = impl_->peak_force.load(std::memory_order_relaxed);
  report.touch_ticks = impl_->touch_ticks.load(std::memory_order_relaxed);
  report.touch_force = impl_->touch_force.load(std::memory_order_relaxed);
  report.record_gaps = impl_->log ? impl_->log->gap_count() : 0;
  return report;
}

}  // namespace palpate
