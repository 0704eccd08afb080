// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "palpate/sim/base/private/duration_histogram.h"
#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/loop/loop.h"
#include "palpate/sim/loop/private/device_channel.h"
#include "palpate/sim/loop/private/pace.h"
#include "palpate/sim/loop/private/pending_snapshot.h"
#include "palpate/sim/loop/private/tissue_worker.h"
#include "palpate/sim/loop/private/tree_builder.h"
#include "palpate/sim/tick/private/cost_histograms.h"
#include "palpate/sim/tick/private/follow_tissue.h"

namespace palpate {

/// What follows a tool: places that it is fastened to, or that both its jaws stick to.
inline int count_held(const ToolState& tool) noexcept {
  return tool.hold_count > 0 ? tool.hold_count : tool.pinches ? tool.anchor_count : 0;
}

/// What a loop holds: loop.cpp runs it, notices.cpp tells the log what it comes upon.
struct Loop::Impl {
  Impl(const Scene& scene_in, std::span<HapticDevice* const> devices, const LoopOptions& options_in,
       TickLog* log_in, const Task* task_in);

  void run() noexcept;
  void run_ticks() noexcept;
  void run_tick(std::int64_t index, long skipped) noexcept;
  void rest(std::int64_t index) noexcept;
  void keep() noexcept;
  void rest_devices() noexcept;
  void notice_holds(long number) noexcept;
  void notice_alarm(long number) noexcept;
  void notice_safeguards(long number) noexcept;
  void notice_devices(long number) noexcept;
  void notice_couplings(long number) noexcept;
  void judge_tick() noexcept;
  void end_task() noexcept;
  bool has_fault() const noexcept;
  void publish() noexcept;
  void serve_trees() noexcept;
  void log_hash(long number) noexcept {
    if (tissue) return tissue->ask_for_hash();
    catch_up(scene, world);
    log->push(StateHash{number, compute_hash(world)});
  }
  void tell(long number, EventKind kind, std::int32_t index, double value = 0.0,
            std::int32_t source = 0) noexcept {
    if (log) log->push(Event{number, kind, index, value, source});
  }

  const Scene& scene;
  const Task* const task;
  const LoopOptions options;
  TickLog* const log;
  const double dt;  // [s]
  const long snapshot_ticks, hash_ticks;

  // the haptic thread's own while it runs
  World world;
  std::unique_ptr<TissueWorker> tissue;                  // null where it ticks in this thread
  std::vector<std::unique_ptr<TreeBuilder>> trees;       // per body, in the same case
  std::vector<std::unique_ptr<DeviceChannel>> channels;  // per instrument
  Pace pace;
  std::vector<HapticSample> samples;    // per instrument, of the last tick, as what follows
  std::vector<HapticCommand> commands;  // [N]
  std::vector<TickLog::Tick> rows;
  std::vector<int> held;                 // triangles, before the tick
  std::vector<char> follows;             // as DeviceCoupling::follows_tissue, that were told
  std::optional<Progress> progress;      // of the task, where there is one
  std::vector<Safeguard> safeguards;     // per body, that were told
  std::int64_t lateness = 0, spent = 0;  // [ns] of the last tick
  long lost_ticks = 0;                   // had no room in the log, not yet told

  // written by the haptic thread before `ready`, constant after it
  Realtime realtime;
  std::atomic<bool> ready{false};

  // between the threads
  Latest<PendingSnapshot> snapshots;
  SnapshotReader reader;  // the reader's own
  DurationHistogram latenesses, costs, processor;
  std::unique_ptr<CostHistograms> part_costs;  // null unless they are measured
  std::atomic<long> ticks{0}, missed{0}, slow{0}, safeguarded{0};
  Alarm alarm;  // constant once has_alarm is set
  int alarm_body = -1;
  std::atomic<bool> has_alarm{false};
  std::atomic<Outcome> outcome{Outcome::running};
  Alarm averted;  // constant once has_averted is set
  int averted_body = -1;
  std::atomic<bool> has_averted{false};
  std::atomic<bool> stopping{false}, running{false};
  std::atomic<bool> pausing{false}, resting{false};  // asked for by others, done by this thread
  std::mutex ending;
  std::condition_variable ended;
  bool has_ended = false;

  std::thread thread;
};

}  // namespace palpate
