// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/loop.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/loop/private/loop_impl.h"
#include "palpate/sim/tick/private/device_coupling.h"

namespace palpate {
namespace {

constexpr double kSnapshotInterval = 8e-3;  // [s] twice as often as a screen wants one
constexpr double kHashInterval = 1.0;       // [s]

const LoopOptions& validated(const LoopOptions& options) {
  if (!(options.duration >= 0.0) || !std::isfinite(options.duration)) {
    refuse("loop: duration [s]", write_text(options.duration), "0 or more");
  }
  if (!(options.spin >= 0.0 && options.spin <= 1.0)) {
    refuse("loop: spin [s]", write_text(options.spin), "0 to 1");
  }
  if (options.cpu < -1) refuse("loop: cpu", write_text(options.cpu), "a core, or -1");
  return options;
}

const Task* validated(const Task* task, std::size_t instruments) {
  if (task && task->tool_radii.size() != instruments) {
    refuse("loop: task", write_text("one for ", task->tool_radii.size(), " instruments"),
           write_text("one that build_task made for the scene, which has ", instruments));
  }
  return task;
}

long ticks_in(double seconds, double rate) {
  return std::max(1L, static_cast<long>(std::llround(std::min(seconds * rate, 9e15))));
}
double to_seconds(std::int64_t nanoseconds) noexcept { return 1e-9 * double(nanoseconds); }

std::vector<HapticDevice*> list_devices(
    const std::vector<std::unique_ptr<DeviceChannel>>& channels) {
  std::vector<HapticDevice*> devices;
  for (const auto& channel : channels) devices.push_back(&channel->safe());
  return devices;
}

}  // namespace

Loop::Impl::Impl(const Scene& scene_in, std::span<HapticDevice* const> devices,
                 const LoopOptions& options_in, TickLog* log_in, const Task* task_in)
    : scene(scene_in),
      task(validated(task_in, scene.instruments.size())),
      options(validated(options_in)),
      log(log_in),
      dt(1.0 / scene.rate),
      snapshot_ticks(ticks_in(kSnapshotInterval, scene.rate)),
      hash_ticks(ticks_in(kHashInterval, scene.rate)),
      world(scene),
      channels(open_channels(scene, devices, options, log)),
      pace(list_devices(channels), scene.rate, std::llround(1e9 * options.spin)),
      samples(channels.size()),
      commands(channels.size()),
      rows(channels.size()),
      held(channels.size(), 0),
      follows(channels.size(), false),
      progress(task ? std::optional<Progress>(*task) : std::nullopt),
      safeguards(world.bodies.size(), Safeguard::none),
      snapshots(PendingSnapshot(world, progress ? progress->state : TaskState())),
      reader(world) {
  if (scene.exchange_rate > 0.0) tissue = std::make_unique<TissueWorker>(scene);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    DeviceCoupling& device = world.instruments[i].device;
    device.passive_stiffness = channels[i]->passive_stiffness();
    device.delay = 1e-6 * channels[i]->delay_us();
    if (!limits_coupling(scene.instruments[i], world.instruments[i])) device = {};
    if (tissue) tissue->set_passive_stiffness(i, device.passive_stiffness);
  }
  for (const SoftState& body : world.bodies) {
    if (!tissue) trees.push_back(std::make_unique<TreeBuilder>(body));
  }
  if (options.measures_costs) part_costs = std::make_unique<CostHistograms>(world);
  world.measures_costs = options.measures_costs;
}

void Loop::Impl::run() noexcept {
  world.follows_all = task && watches_sight(*task);
  realtime = enter_realtime(options.realtime, options.cpu);
  running.store(true, std::memory_order_release);
  ready.store(true, std::memory_order_release);
  ready.notify_all();
  run_ticks();
  for (const auto& channel : channels) channel->end();
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
  std::int64_t late_since = 0;  // [ns] due time of the first tick that was skipped
  for (std::int64_t index = 0; index < end;) {
    const std::int64_t due = pace.wait(index);
    if (stopping.load(std::memory_order_acquire)) break;
    if (pausing.load(std::memory_order_acquire)) {
      rest(index);
      late_since = pace.due(index);
      continue;
    }
    const std::int64_t since = skipped > 0 ? late_since : due;
    lateness = std::max<std::int64_t>(0, read_clock() - since);
    run_tick(index, skipped);

    const std::int64_t now = read_clock();
    late_since = pace.due(index + 1);
    for (skipped = 0, ++index; index < end && pace.due(index) < now; ++index) {
      ++skipped;
    }
    missed.fetch_add(skipped, std::memory_order_relaxed);
    if (outcome.load(std::memory_order_relaxed) != Outcome::running) break;
    if (!has_fault()) continue;
    if (options.on_fault == FaultResponse::end) break;
    if (options.on_fault == FaultResponse::pause) pausing.store(true, std::memory_order_release);
  }
  end_task();
  const long done = ticks.load(std::memory_order_relaxed);
  if (skipped > 0) tell(done, EventKind::missed_ticks, static_cast<std::int32_t>(skipped));
  if (lost_ticks > 0) tell(done, EventKind::record_gap, static_cast<std::int32_t>(lost_ticks));
  if (log && done > 0 && done % hash_ticks != 0) log_hash(done - 1);
  if (done > 0) publish();
}

/// Keeps the devices at rest before tick `index`, which is then due one period after the pause, so
/// that nothing that follows is late for it.
void Loop::Impl::rest(std::int64_t index) noexcept {
  const std::int64_t begun = read_clock();
  rest_devices();
  if (world.tick_count > 0) publish();
  resting.store(true, std::memory_order_release);
  while (pausing.load(std::memory_order_acquire) && !stopping.load(std::memory_order_acquire)) {
    wait_until(read_clock() + pace.period(), 0);
    rest_devices();  // again and again: a device may take silence for a fault
    notice_devices(world.tick_count);
  }
  const std::int64_t now = read_clock();
  resting.store(false, std::memory_order_release);
  tell(world.tick_count, EventKind::paused, 0, to_seconds(now - begun));
  pace.begin(index);
}

void Loop::Impl::rest_devices() noexcept {
  for (const auto& channel : channels) channel->safe().rest(dt);
}

void Loop::Impl::run_tick(std::int64_t index, long skipped) noexcept {
  const std::int64_t begun = read_clock(), had = read_thread_clock();
  const long number = world.tick_count;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    held[i] = count_held(world.instruments[i].tool);
    samples[i] = channels[i]->safe().read(double(index) * dt);
  }
  if (tissue) {
    tissue->tick(samples, world, commands, log);
  } else {
    tick(scene, samples, dt, world, commands);
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    channels[i]->safe().set_tool(world.instruments[i].tool.position);
    channels[i]->safe().write(commands[i]);
  }
  spent = read_clock() - begun;

  if (skipped > 0) tell(number, EventKind::missed_ticks, static_cast<std::int32_t>(skipped));
  notice_holds(number);
  notice_safeguards(number);
  notice_alarm(number);
  notice_devices(number);
  notice_couplings(number);
  judge_tick();
  for (std::size_t i = 0; i < channels.size(); ++i) {
    channels[i]->count_force(world.instruments[i]);
  }
  keep();
  latenesses.add(lateness);
  costs.add(spent);
  if (part_costs && !tissue && !world.alarm) part_costs->add(world.costs);
  ticks.store(number + 1, std::memory_order_relaxed);
  if (number % snapshot_ticks == 0) publish();
  serve_trees();
  const std::int64_t of_processor = read_thread_clock() - had;
  processor.add(of_processor);
  if (of_processor > pace.period()) slow.fetch_add(1, std::memory_order_relaxed);
}

void Loop::Impl::judge_tick() noexcept {
  if (!progress) return;
  judge(*task, world, samples, commands, dt, *progress);
  for (int e = 0; log && e < progress->event_count; ++e) {
    log->push(progress->events[static_cast<std::size_t>(e)]);
  }
  outcome.store(progress->state.outcome, std::memory_order_relaxed);
}

/// What the judge has not decided ended from outside.
void Loop::Impl::end_task() noexcept {
  if (!progress || progress->state.outcome != Outcome::running) return;
  TaskState& state = progress->state;
  state.outcome = has_fault() ? Outcome::device_fault : Outcome::left;
  outcome.store(state.outcome, std::memory_order_relaxed);
  const long last = std::max(0L, world.tick_count - 1);
  tell(last, static_cast<EventKind>(TaskEvent::task_ended),
       static_cast<std::int32_t>(state.outcome), state.time);
}

/// Has the trees of bodies rebuilt where that is worth it.
void Loop::Impl::serve_trees() noexcept {
  for (std::size_t b = 0; b < trees.size(); ++b) {
    if (trees[b]->will_ask(world, b)) catch_up(scene.bodies[b], world.bodies[b]);
    const auto told = trees[b]->serve(b, world);
    if (told && log) log->push(*told);
  }
}

/// Leaves the tick in the log, and once a second the world's hash.
void Loop::Impl::keep() noexcept {
  if (!log) return;
  const long number = world.tick_count - 1;
  const auto lateness_us = static_cast<std::uint16_t>(
      std::min<std::int64_t>(lateness / 1000, std::numeric_limits<std::uint16_t>::max()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = {number, samples[i], compute_felt(commands[i], world, i)};
    rows[i].felt.lateness_us = lateness_us;
    if (channels[i]->motors() != MotorState::on) rows[i].felt.touched |= kNotRendered;
  }
  if (!log->push(rows)) {
    ++lost_ticks;
  } else if (lost_ticks > 0) {
    tell(number, EventKind::record_gap, static_cast<std::int32_t>(lost_ticks));
    lost_ticks = 0;
  }
  if ((number + 1) % hash_ticks == 0) log_hash(number);
}

bool Loop::Impl::has_fault() const noexcept {
  return std::ranges::any_of(
      channels, [](const auto& channel) { return channel->fault() != DeviceFault::none; });
}

void Loop::Impl::publish() noexcept {
  note_world(world, samples, snapshots.back());
  Snapshot& snapshot = snapshots.back().seen;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    snapshot.instruments[i].force = channels[i]->safe().sent().force;
    snapshot.instruments[i].motors = channels[i]->motors();
    snapshot.instruments[i].interventions = channels[i]->interventions();
    snapshot.instruments[i].stiffness_error = find_stiffness_error(world.instruments[i].device);
  }
  snapshot.cost = to_seconds(spent);
  snapshot.lateness = to_seconds(lateness);
  snapshot.missed_ticks = missed.load(std::memory_order_relaxed);
  if (progress) snapshot.task = progress->state;
  snapshots.publish();
}

Loop::Loop(const Scene& scene, std::span<HapticDevice* const> devices, const LoopOptions& options,
           TickLog* log, const Task* task)
    : impl_(std::make_unique<Impl>(scene, devices, options, log, task)) {}
Loop::Loop(const Scene& scene, HapticDevice& device, const LoopOptions& options, TickLog* log,
           const Task* task)
    : Loop(scene, std::array{&device}, options, log, task) {}
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
  report.slow_ticks = impl_->slow.load(std::memory_order_relaxed);
  report.safeguarded_ticks = impl_->safeguarded.load(std::memory_order_relaxed);
  report.unpaced_ticks = impl_->pace.unpaced();
  report.lateness = percentiles_of(impl_->latenesses);
  report.cost = percentiles_of(impl_->costs);
  report.processor = percentiles_of(impl_->processor);
  if (impl_->part_costs) report.part_costs = impl_->part_costs->summarise();
  if (const TissueWorker* tissue = impl_->tissue.get()) {
    report.exchanges = tissue->exchanges();
    report.late_exchanges = tissue->late_exchanges();
    report.exchange_cost = percentiles_of(tissue->costs());
  }
  if (impl_->ready.load(std::memory_order_acquire)) {
    report.realtime = impl_->realtime.scheduled;
    report.realtime_note = impl_->realtime.note;
  }
  if (impl_->has_alarm.load(std::memory_order_acquire)) {
    report.alarm = impl_->alarm;
    report.alarm_body = impl_->alarm_body;
  }
  if (impl_->has_averted.load(std::memory_order_acquire)) {
    report.averted = impl_->averted;
    report.averted_body = impl_->averted_body;
  }
  for (const auto& channel : impl_->channels) report.devices.push_back(channel->report());
  sum_devices(report);
  report.outcome = impl_->outcome.load(std::memory_order_relaxed);
  report.record_gaps = impl_->log ? impl_->log->gap_count() : 0;
  return report;
}

}  // namespace palpate
