// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/base/types.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/task/task.h"
#include "palpate/sim/tick/costs.h"
#include "palpate/sim/tick/tick.h"
#include "palpate/sim/tick/tick_log.h"

namespace palpate {

/// A body as a reader sees it.
struct BodySnapshot {
  Vec3Array position;  ///< [m] of the vertices of the surface
  int substeps = 0;
  Safeguard safeguard = Safeguard::none;  ///< of that tick
  /// [-] of each vertex, 0 where all is whole to 1 where something bears nothing any more
  /// [contact: tear]; empty of a body that does not tear
  std::vector<float> torn;
};

/// A rigid body as a reader sees it.
struct RigidSnapshot {
  Vec3 position = Vec3::Zero();                     ///< [m] of its frame
  Quaternion orientation = Quaternion::Identity();  ///< unit, of its frame
};
static_assert(alignof(RigidSnapshot) == 8);

/// An instrument and its device as a reader sees them.
struct InstrumentSnapshot {
  HapticSample sample;
  Vec3 tool_position = Vec3::Zero();                     ///< [m]
  Quaternion tool_orientation = Quaternion::Identity();  ///< unit, of the tool's frame
  Vec3 force = Vec3::Zero();  ///< [N] on the hand; none while the motors are not on
  bool touching = false;
  double jaw_angle = 0.0;              ///< [rad] by which each of its jaws is open
  double pinch = 0.0;                  ///< [N] that each of them presses with
  double pad_pressure = 0.0;           ///< [Pa] of that
  Vec3 carried = Vec3::Zero();         ///< [N] on the tool, of what its jaws hold
  bool turn_limited = false;           ///< tissue keeps it from turning as its hand does
  MotorState motors = MotorState::on;  ///< of the device
  long interventions = 0;              ///< of its passivity controller, so far
  /// [-] part of the tissue's stiffness that the hand does not feel in this contact; 0 where the
  /// device bears the instrument's own coupling
  double stiffness_error = 0.0;
};
static_assert(alignof(InstrumentSnapshot) == 8);

/// What a reader outside the haptic thread sees: the world as it was at most 8 ms ago.
struct Snapshot {
  long tick = 0;
  double time = 0.0;                            ///< [s]
  std::vector<BodySnapshot> bodies;             ///< as Scene::bodies
  std::vector<RigidSnapshot> rigid;             ///< as Scene::rigid
  std::vector<InstrumentSnapshot> instruments;  ///< as Scene::instruments
  double cost = 0.0;                            ///< [s] of the last tick
  double lateness = 0.0;                        ///< [s] of the last tick
  long missed_ticks = 0;
  TaskState task;  ///< without steps where there is no task
};
static_assert(alignof(Snapshot) == 8);

/// What becomes of a run of which a device fails, or gives no force any more. The force of that
/// device is zero from then on and its hand stays where it was last known; the other instruments
/// know nothing of it.
enum class FaultResponse {
  go_on,  ///< to its end, and counts the ticks that nobody felt
  pause,  ///< it rests until resume(), and again where the fault is still there then
  end,
};

struct LoopOptions {
  double duration = 0.0;  ///< [s] 0 runs until stop()
  bool realtime = true;   ///< ask for SCHED_FIFO and locked memory
  int cpu = -1;           ///< pin the thread to this core, -1 for none
  double spin = 150e-6;   ///< [s] spun instead of slept before every tick
  SafetyLimits safety = {};
  FaultResponse on_fault = FaultResponse::go_on;
  /// What each device may be sent, in the order of the instruments; where empty, `safety` for all.
  std::vector<SafetyLimits> device_safety = {};
  bool measures_costs = false;  ///< of every body, instrument and pair: LoopReport::part_costs
};

/// What one device gave of a run.
struct DeviceReport {
  DeviceFault fault = DeviceFault::none;  ///< now, or when the run ended
  std::string fault_reason;               ///< in words
  long unrendered_ticks = 0;  ///< its motors were not on: their force counts nowhere below
  double peak_force = 0.0;    ///< [N] largest that was sent
  long touch_ticks = 0;       ///< touching or attached
  double touch_force = 0.0;   ///< [N] mean of what was sent in them
  long damped_ticks = 0;      ///< in which its passivity controller had to act
  long interventions = 0;     ///< times that it began to, after 100 ms without
  /// [N/m] Up to which a spring that is told at the rate of the run is passive with the damping and
  /// the delay that the device declared at its start; 0 where it declares none.
  double passive_stiffness = 0.0;
  // where that is less than the instrument's coupling; else 0
  long follows_tissue_ticks = 0;  ///< the hand's spring was stiffer, as the tissue asked
  double tissue_stiffness = 0.0;  ///< [N/m] of the stiffest that it touched, to the tool
  double stiffness_error = 0.0;   ///< [-] largest part of a tissue's stiffness that was not felt
};
static_assert(alignof(DeviceReport) == 8);

/// What a run of the loop cost.
struct LoopReport {
  long ticks = 0;
  long missed_ticks = 0;  ///< skipped because an earlier tick was still at work
  /// That took longer than a period of the processor's own time. Where ticks are missed and these
  /// are none, the loop was kept waiting, by the machine or by a device; where they are many, and
  /// `processor` is near a period in the median, the scene is too heavy. A virtual machine that its
  /// host keeps waiting may count that as its processor's time.
  long slow_ticks = 0;
  long unpaced_ticks = 0;     ///< went without the report of a device that has its own pace
  Percentiles lateness;       ///< start of a tick behind the first due time since the last one
  Percentiles cost;           ///< of the tick itself, device included
  Percentiles processor;      ///< of the processor, for a tick and all that comes with it
  SceneCosts part_costs;      ///< of its parts; empty unless LoopOptions::measures_costs
  bool realtime = false;      ///< granted
  std::string realtime_note;  ///< why not, in words
  Alarm alarm;
  int alarm_body = -1;                    ///< whose tissue raised it; -1 for what is of no body
  long safeguarded_ticks = 0;             ///< in which a body had a safeguard
  Alarm averted;                          ///< the first alarm that a safeguard averted
  int averted_body = -1;                  ///< whose; -1 without one
  DeviceFault fault = DeviceFault::none;  ///< of the first device that has one
  std::string fault_reason;               ///< in words
  long record_gaps = 0;                   ///< ticks the log had no room for
  /// Of the task; `running` while it is, and for none. A run that ended before it was decided was
  /// left, or its device failed.
  Outcome outcome = Outcome::running;
  // of all devices together
  long unrendered_ticks = 0;          ///< sum
  double peak_force = 0.0;            ///< [N] largest
  long touch_ticks = 0;               ///< sum
  double touch_force = 0.0;           ///< [N] mean over these
  long damped_ticks = 0;              ///< sum
  long interventions = 0;             ///< sum
  std::vector<DeviceReport> devices;  ///< in the order of the instruments

  // of a scene with an exchange_rate; else none
  long exchanges = 0;         ///< with the tissue
  long late_exchanges = 0;    ///< of them, because the tissue was still at work when they were due
  Percentiles exchange_cost;  ///< of the tissue, for one
};
static_assert(alignof(LoopReport) == 8);

/// The live 1 kHz loop: a thread that waits, reads, ticks, writes. Sleeps to an absolute time and
/// spins the rest; ticks that were missed are skipped and counted, never made up in a burst.
///
/// Each instrument has a device of its own. One that reports by its own clock at the ticks' rate
/// sets the pace, of several the first that has not failed: a tick begins when its report has come,
/// or half a period after that is due where none comes.
///
/// A device is asked where the hand is at the time the tick was due, so a script gives the same
/// hand in every run in which no tick is missed.
class Loop {
 public:
  /// `scene`, `task` and every device must outlive the loop; `log` may be null; its
  /// reader (session/record.h) is any one other thread. A task, of build_task with this scene, is
  /// judged in every tick, and the run ends when it is decided. Throws std::invalid_argument for
  /// another number of instruments in the scene, the log or the task than there are devices, for
  /// one device twice, and for options beyond their ranges.
  Loop(const Scene& scene, std::span<HapticDevice* const> devices, const LoopOptions& options = {},
       TickLog* log = nullptr, const Task* task = nullptr);
  /// The same for a scene of one instrument.
  Loop(const Scene& scene, HapticDevice& device, const LoopOptions& options = {},
       TickLog* log = nullptr, const Task* task = nullptr);
  Loop(Scene&&, std::span<HapticDevice* const>, const LoopOptions& = {}, TickLog* = nullptr,
       const Task* = nullptr) = delete;
  Loop(Scene&&, HapticDevice&, const LoopOptions& = {}, TickLog* = nullptr,
       const Task* = nullptr) = delete;
  ~Loop();  ///< stops and joins

  void start();               ///< throws std::logic_error the second time: a loop runs once
  void stop();                ///< asks and waits; every device gets a zero force last
  bool wait(double timeout);  ///< [s] true once the run has ended
  bool running() const noexcept;

  /// From any thread; followed within a tick. While it is paused devices get zero forces and
  /// the time of the run stands still: what would have been due is neither missed nor made up. The
  /// force then fades in as at the start. A run that ends while paused is over.
  void pause() noexcept;
  void resume() noexcept;
  bool paused() const noexcept;  ///< the last command has gone out, a zero force after it

  /// For one reader thread: true if something newer than last time was taken.
  bool take_snapshot();
  const Snapshot& snapshot() const noexcept;

  /// Costs so far; while running, of the ticks finished by now.
  LoopReport report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What the hand shall feel where there is no tissue: a force, and a spring to a place.
struct DeviceTask {
  Vec3 force = Vec3::Zero();  ///< [N]
  double stiffness = 0.0;     ///< [N/m] 0 for no spring
  Vec3 rest = Vec3::Zero();   ///< [m] where the spring draws to
};
static_assert(sizeof(DeviceTask) == 56 && alignof(DeviceTask) == 8);

/// Throws std::invalid_argument naming the field, what it got and what was expected.
void validate(const DeviceTask& task);

/// Keeps a device company at 1 kHz without a tissue, as its window, its test and its calibration
/// need it: F = force + stiffness (rest - x), sent through a SafeDevice. Either in a thread of its
/// own, by the clock; or, for a simulated device, as fast as the machine can, in the caller's.
class DeviceLoop {
 public:
  /// `device` must outlive the loop. Throws as SafeDevice does.
  explicit DeviceLoop(HapticDevice& device, const SafetyLimits& limits = {});
  ~DeviceLoop();  ///< stops and joins

  void start();  ///< throws std::logic_error while it runs; may be started again once stopped
  void stop();   ///< asks and waits; the device gets a zero force last
  bool running() const noexcept;
  /// Ticks for so many [s] in this thread, without waiting. Throws std::logic_error while the
  /// loop's own thread runs, std::invalid_argument for no time or more than a day.
  void run(double seconds);

  /// One calling thread: felt from the next tick on. Throws std::invalid_argument.
  void set_task(const DeviceTask& task);
  /// From any thread: the device hears nothing for so many [s], as if the host had died.
  void fall_silent(double seconds) noexcept;

  double time() const noexcept;  ///< [s] that the loop has run
  long missed_ticks() const noexcept;
  DeviceFault fault() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate
