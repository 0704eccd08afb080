// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/loop.h"

#include <pybind11/native_enum.h>

#include <algorithm>

#include "bindings.h"
#include "border.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_loop_options(py::module_& m) {
  py::native_enum<FaultResponse>(
      m, "FaultResponse", "enum.Enum",
      "What becomes of a run of which a device fails, or gives no force any more. The force of "
      "that device is zero from then on; the other instruments know nothing of it.")
      .value("go_on", FaultResponse::go_on, "To its end, and counts the ticks that nobody felt.")
      .value("pause", FaultResponse::pause,
             "It rests until resume(), and again where the fault is still there then.")
      .value("end", FaultResponse::end)
      .finalize();
  const LoopOptions usual;
  py::class_<LoopOptions> options(m, "LoopOptions", "How the live loop runs.");
  options
      .def(py::init([](double duration, bool realtime, int cpu, double spin,
                       const SafetyLimits& safety, FaultResponse on_fault,
                       const std::vector<SafetyLimits>& device_safety, bool measures_costs) {
             return LoopOptions{duration, realtime, cpu,           spin,
                                safety,   on_fault, device_safety, measures_costs};
           }),
           py::kw_only(), "duration"_a = usual.duration, "realtime"_a = usual.realtime,
           "cpu"_a = usual.cpu, "spin"_a = usual.spin, "safety"_a = usual.safety,
           "on_fault"_a = usual.on_fault, "device_safety"_a = py::tuple(),
           "measures_costs"_a = usual.measures_costs)
      .def_readwrite("duration", &LoopOptions::duration, "[s] 0 runs until stop().")
      .def_readwrite("realtime", &LoopOptions::realtime, "Ask for SCHED_FIFO and locked memory.")
      .def_readwrite("cpu", &LoopOptions::cpu, "Pin the thread to this core, -1 for none.")
      .def_readwrite("spin", &LoopOptions::spin, "[s] spun instead of slept before every tick.")
      .def_readwrite("safety", &LoopOptions::safety, "What the device may be sent.")
      .def_readwrite("on_fault", &LoopOptions::on_fault,
                     "What becomes of the run where a device fails.")
      .def_readwrite("device_safety", &LoopOptions::device_safety,
                     "What each device may be sent, in the order of the instruments; where empty, "
                     "safety for all. Copied when read and when set.")
      .def_readwrite("measures_costs", &LoopOptions::measures_costs,
                     "Of every body, instrument and pair: LoopReport.part_costs.");
  def_value(options, &LoopOptions::duration, &LoopOptions::realtime, &LoopOptions::cpu,
            &LoopOptions::spin, &LoopOptions::safety, &LoopOptions::on_fault,
            &LoopOptions::device_safety, &LoopOptions::measures_costs);
  def_repr(options, {"duration", "realtime", "cpu", "spin", "safety", "on_fault", "device_safety",
                     "measures_costs"});
}

void bind_snapshot(py::module_& m) {
  py::class_<BodySnapshot> body(m, "BodySnapshot", "A body as a reader sees it.");
  def_view(body, "position", &BodySnapshot::position,
           "[m] of the vertices of the surface, shape (n, 3); a view.");
  body.def_readonly("substeps", &BodySnapshot::substeps, "Of that tick.")
      .def_readonly("safeguard", &BodySnapshot::safeguard, "Of that tick.");
  def_view(body, "torn", &BodySnapshot::torn,
           "[-] Of each vertex, 0 where all is whole to 1 where something bears nothing any more, "
           "shape (n,); empty of a body that does not tear; a view.");
  def_value(body, &BodySnapshot::position, &BodySnapshot::substeps, &BodySnapshot::safeguard,
            &BodySnapshot::torn);
  def_repr(body, {"substeps", "safeguard"});

  py::class_<RigidSnapshot> rigid(m, "RigidSnapshot", "A rigid body as a reader sees it.");
  def_vector(rigid, "position", &RigidSnapshot::position, "[m] of its frame.");
  rigid.def_property_readonly(
      "orientation",
      [](const py::object& self) {
        return view_one(self.cast<RigidSnapshot&>().orientation, self);
      },
      "[-] Of its frame: unit quaternion (x, y, z, w), shape (4,); a view.");
  def_value(rigid, &RigidSnapshot::position, &RigidSnapshot::orientation);
  def_repr(rigid, {"position", "orientation"});

  py::class_<InstrumentSnapshot> instrument(m, "InstrumentSnapshot",
                                            "An instrument and its device as a reader sees them.");
  instrument.def_readonly("sample", &InstrumentSnapshot::sample, "What the device said.");
  def_vector(instrument, "tool_position", &InstrumentSnapshot::tool_position, "[m]");
  instrument.def_property_readonly(
      "tool_orientation",
      [](const py::object& self) {
        return view_one(self.cast<InstrumentSnapshot&>().tool_orientation, self);
      },
      "[-] Of the tool's frame: unit quaternion (x, y, z, w), shape (4,); a view.");
  def_vector(instrument, "force", &InstrumentSnapshot::force,
             "[N] on the hand; none while the motors are not on.");
  instrument.def_readonly("touching", &InstrumentSnapshot::touching, "Any contact in force.")
      .def_readonly("jaw_angle", &InstrumentSnapshot::jaw_angle,
                    "[rad] by which each of its jaws is open.")
      .def_readonly("pinch", &InstrumentSnapshot::pinch, "[N] that each of them presses with.")
      .def_readonly("pad_pressure", &InstrumentSnapshot::pad_pressure, "[Pa] of that.")
      .def_readonly("turn_limited", &InstrumentSnapshot::turn_limited,
                    "Tissue keeps it from turning as its hand does.")
      .def_readonly("motors", &InstrumentSnapshot::motors, "Of the device.")
      .def_readonly("interventions", &InstrumentSnapshot::interventions,
                    "Of the device's passivity controller, so far.")
      .def_readonly("stiffness_error", &InstrumentSnapshot::stiffness_error,
                    "[-] Part of the tissue's stiffness that the hand does not feel in this "
                    "contact; 0 where the device bears the instrument's own coupling.");
  def_vector(instrument, "carried", &InstrumentSnapshot::carried,
             "[N] on the tool, of what its jaws hold.");
  def_value(instrument, &InstrumentSnapshot::sample, &InstrumentSnapshot::tool_position,
            &InstrumentSnapshot::tool_orientation, &InstrumentSnapshot::force,
            &InstrumentSnapshot::touching, &InstrumentSnapshot::jaw_angle,
            &InstrumentSnapshot::pinch, &InstrumentSnapshot::pad_pressure,
            &InstrumentSnapshot::carried, &InstrumentSnapshot::turn_limited,
            &InstrumentSnapshot::motors, &InstrumentSnapshot::interventions,
            &InstrumentSnapshot::stiffness_error);
  def_repr(instrument, {"touching", "force", "tool_position", "motors", "interventions"});

  py::class_<Snapshot> snapshot(
      m, "Snapshot",
      "What a reader outside the haptic thread sees: the world as it was at most 8 ms ago.");
  snapshot.def_readonly("tick", &Snapshot::tick, "Number of the tick it shows.")
      .def_readonly("time", &Snapshot::time, "[s]");
  def_elements(snapshot, "bodies", &Snapshot::bodies, "As Scene.bodies, a tuple.");
  def_elements(snapshot, "rigid", &Snapshot::rigid, "As Scene.rigid, a tuple.");
  def_elements(snapshot, "instruments", &Snapshot::instruments, "As Scene.instruments, a tuple.");
  for (const char* name :
       {"sample", "tool_position", "force", "touching", "motors", "interventions"}) {
    snapshot.def_property_readonly(
        name,
        [name](const py::object& self) {
          return py::object(self.attr("instruments")[py::int_(0)].attr(name));
        },
        "Of the first instrument.");
  }
  snapshot.def_property_readonly(
      "task", [](const Snapshot& self) { return self.task; },
      "A TaskState, without steps where there is no task; a copy.");
  snapshot.def_readonly("cost", &Snapshot::cost, "[s] of the last tick.")
      .def_readonly("lateness", &Snapshot::lateness, "[s] of the last tick.")
      .def_readonly("missed_ticks", &Snapshot::missed_ticks, "Skipped so far.");
  def_value(snapshot, &Snapshot::tick, &Snapshot::time, &Snapshot::bodies, &Snapshot::rigid,
            &Snapshot::instruments, &Snapshot::cost, &Snapshot::lateness, &Snapshot::missed_ticks,
            &Snapshot::task);
  def_repr(snapshot, {"tick", "time", "instruments"});
}

void bind_report(py::module_& m) {
  py::class_<DeviceReport> device(m, "DeviceReport", "What one device gave of a run.");
  device.def_readonly("fault", &DeviceReport::fault, "Now or when the run ended; none for none.")
      .def_readonly("fault_reason", &DeviceReport::fault_reason, "In words.")
      .def_readonly("unrendered_ticks", &DeviceReport::unrendered_ticks,
                    "Its motors were not on: their force counts nowhere else here.")
      .def_readonly("peak_force", &DeviceReport::peak_force, "[N] The largest that was sent.")
      .def_readonly("touch_ticks", &DeviceReport::touch_ticks, "Touching or attached.")
      .def_readonly("touch_force", &DeviceReport::touch_force,
                    "[N] The mean of what was sent in them.")
      .def_readonly("damped_ticks", &DeviceReport::damped_ticks,
                    "In which its passivity controller had to act.")
      .def_readonly("interventions", &DeviceReport::interventions,
                    "Times that it began to, after 100 ms without.")
      .def_readonly("passive_stiffness", &DeviceReport::passive_stiffness,
                    "[N/m] Up to which a spring that is told at the rate of the run is passive "
                    "with the damping and the delay that the device declared at its start; 0 where "
                    "it declares none.")
      .def_readonly("follows_tissue_ticks", &DeviceReport::follows_tissue_ticks,
                    "Of an instrument whose coupling is stiffer than that: ticks in which the "
                    "hand's spring was as well, as the tissue asked.")
      .def_readonly("tissue_stiffness", &DeviceReport::tissue_stiffness,
                    "[N/m] Likewise: of the stiffest tissue that it touched, to the tool.")
      .def_readonly("stiffness_error", &DeviceReport::stiffness_error,
                    "[-] Likewise: the largest part of a tissue's stiffness that was not felt.");
  def_value(device, &DeviceReport::fault, &DeviceReport::fault_reason,
            &DeviceReport::unrendered_ticks, &DeviceReport::peak_force, &DeviceReport::touch_ticks,
            &DeviceReport::touch_force, &DeviceReport::damped_ticks, &DeviceReport::interventions,
            &DeviceReport::passive_stiffness, &DeviceReport::follows_tissue_ticks,
            &DeviceReport::tissue_stiffness, &DeviceReport::stiffness_error);
  def_repr(device, {"fault", "fault_reason", "unrendered_ticks", "peak_force", "touch_ticks",
                    "touch_force", "damped_ticks", "interventions", "passive_stiffness",
                    "follows_tissue_ticks", "tissue_stiffness", "stiffness_error"});

  py::class_<LoopReport> report(m, "LoopReport", "What a run of the loop cost.");
  report.def_readonly("ticks", &LoopReport::ticks, "How many were run.")
      .def_readonly("missed_ticks", &LoopReport::missed_ticks,
                    "Skipped because an earlier tick was still at work.")
      .def_readonly("slow_ticks", &LoopReport::slow_ticks,
                    "That took longer than a period of the processor's own time. Where ticks are "
                    "missed and these are none, the loop was kept waiting.")
      .def_readonly("unpaced_ticks", &LoopReport::unpaced_ticks,
                    "Went without the report of a device that has its own pace.")
      .def_readonly("lateness", &LoopReport::lateness,
                    "Start of a tick behind the first due time since the last one.")
      .def_readonly("cost", &LoopReport::cost, "Of the tick itself, device included.")
      .def_readonly("processor", &LoopReport::processor,
                    "Of the processor, for a tick and all that comes with it.")
      .def_readonly("part_costs", &LoopReport::part_costs,
                    "Of its parts; of no ticks unless LoopOptions.measures_costs.")
      .def_readonly("realtime", &LoopReport::realtime, "Granted.")
      .def_readonly("realtime_note", &LoopReport::realtime_note, "Why not, in words.")
      .def_readonly("alarm", &LoopReport::alarm, "What ended the run; false for nothing.")
      .def_readonly("alarm_body", &LoopReport::alarm_body,
                    "Whose tissue raised the alarm; -1 for what is of no body.")
      .def_readonly("safeguarded_ticks", &LoopReport::safeguarded_ticks,
                    "In which a body had a safeguard.")
      .def_readonly("averted", &LoopReport::averted,
                    "The first alarm that a safeguard averted; false for none.")
      .def_readonly("averted_body", &LoopReport::averted_body,
                    "Whose tissue that was; -1 without one.")
      .def_readonly("fault", &LoopReport::fault,
                    "Of the first device that has one, now or when the run ended.")
      .def_readonly("fault_reason", &LoopReport::fault_reason, "In words.")
      .def_readonly("outcome", &LoopReport::outcome,
                    "Of the task; running while it is, and for none. A run that ended before it "
                    "was decided was left, or its device failed.")
      .def_readonly("record_gaps", &LoopReport::record_gaps, "Ticks the log had no room for.")
      .def_readonly("unrendered_ticks", &LoopReport::unrendered_ticks,
                    "The motors were not on: their force counts nowhere else here. Sum of all "
                    "devices.")
      .def_readonly("peak_force", &LoopReport::peak_force,
                    "[N] The largest that was sent, of all devices.")
      .def_readonly("touch_ticks", &LoopReport::touch_ticks,
                    "Touching or attached, the sum of all instruments.")
      .def_readonly("touch_force", &LoopReport::touch_force,
                    "[N] The mean of what was sent in them.")
      .def_readonly("damped_ticks", &LoopReport::damped_ticks,
                    "In which a passivity controller had to act, the sum of all devices.")
      .def_readonly("interventions", &LoopReport::interventions,
                    "Times that one began to, after 100 ms without; the sum of all devices.")
      .def_readonly("exchanges", &LoopReport::exchanges,
                    "With the tissue of a scene with an exchange_rate; else none.")
      .def_readonly("late_exchanges", &LoopReport::late_exchanges,
                    "Of them, because the tissue was still at work when they were due.")
      .def_readonly("exchange_cost", &LoopReport::exchange_cost, "Of the tissue, for one.");
  def_elements(report, "devices", &LoopReport::devices,
               "A DeviceReport each, in the order of the instruments, a tuple.");
  def_value(report, &LoopReport::ticks, &LoopReport::missed_ticks, &LoopReport::slow_ticks,
            &LoopReport::unpaced_ticks, &LoopReport::lateness, &LoopReport::cost,
            &LoopReport::processor, &LoopReport::part_costs, &LoopReport::realtime,
            &LoopReport::realtime_note, &LoopReport::alarm, &LoopReport::alarm_body,
            &LoopReport::safeguarded_ticks, &LoopReport::averted, &LoopReport::averted_body,
            &LoopReport::fault, &LoopReport::fault_reason, &LoopReport::record_gaps,
            &LoopReport::unrendered_ticks, &LoopReport::peak_force, &LoopReport::touch_ticks,
            &LoopReport::touch_force, &LoopReport::devices, &LoopReport::damped_ticks,
            &LoopReport::interventions, &LoopReport::exchanges, &LoopReport::late_exchanges,
            &LoopReport::exchange_cost, &LoopReport::outcome);
  def_repr(report, {"ticks",         "missed_ticks",      "unpaced_ticks", "lateness",
                    "cost",          "part_costs",        "realtime",      "realtime_note",
                    "slow_ticks",    "processor",         "alarm",         "alarm_body",
                    "fault",         "fault_reason",      "record_gaps",   "unrendered_ticks",
                    "peak_force",    "touch_ticks",       "touch_force",   "damped_ticks",
                    "interventions", "devices",           "exchanges",     "late_exchanges",
                    "exchange_cost", "safeguarded_ticks", "averted",       "averted_body"});
}

/// The devices of a loop, as Python owns them; let go of under its lock.
class HeldDevices {
 public:
  explicit HeldDevices(py::tuple devices) : devices_(std::move(devices)) {}
  HeldDevices(const HeldDevices&) = delete;
  HeldDevices& operator=(const HeldDevices&) = delete;
  ~HeldDevices() {
    const py::gil_scoped_acquire acquired;
    devices_.release().dec_ref();
  }
  std::vector<HapticDevice*> list() const {
    std::vector<HapticDevice*> devices;
    for (const py::handle device : devices_) {
      if (!py::isinstance<HapticDevice>(device)) {
        throw py::type_error("devices[" + std::to_string(devices.size()) + "]: got " +
                             py::repr(device).cast<std::string>() + ", expected a HapticDevice");
      }
      devices.push_back(device.cast<HapticDevice*>());
    }
    return devices;
  }

 private:
  py::tuple devices_;
};

/// A loop with its devices, which outlive it: a list of Python may lose them while it runs.
class HeldLoop : private HeldDevices, public Loop {
 public:
  HeldLoop(const Scene& scene, py::tuple devices, const LoopOptions& options, TickLog* log,
           const Task* task)
      : HeldDevices(std::move(devices)),
        Loop(checked(scene), list(), options, log, checked(task, scene)) {}

 private:
  static const Scene& checked(const Scene& scene) {
    require_built(scene);
    return scene;
  }
  static const Task* checked(const Task* task, const Scene& scene) {
    if (task) require_fit(*task, scene);
    return task;
  }
};

/// Waits in short pieces, so that Ctrl-C is heard.
bool wait(HeldLoop& loop, double timeout) {
  constexpr double kPiece = 0.05;  // [s]
  for (double left = timeout;; left -= kPiece) {
    {
      const py::gil_scoped_release released;
      if (loop.wait(std::clamp(left, 0.0, kPiece))) return true;
    }
    if (!(left > kPiece)) return false;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

void bind_loop_class(py::module_& m) {
  using Release = py::call_guard<py::gil_scoped_release>;
  py::class_<HeldLoop>(
      m, "Loop", py::release_gil_before_calling_cpp_dtor(),
      "The live 1 kHz loop: a thread that waits, reads, ticks, writes. Python's lock "
      "is never taken by it. As a context manager it starts, and stops at the end.\n\n"
      "Leave the scene, the devices and the log alone while it runs, except for what "
      "is made for another thread: PointerDevice.set, TickLog.take.")
      .def(py::init([](const Scene& scene, HapticDevice& device, const LoopOptions& options,
                       TickLog* log, const Task* task) {
             return std::make_unique<HeldLoop>(
                 scene, py::make_tuple(py::cast(&device, py::return_value_policy::reference)),
                 options, log, task);
           }),
           "scene"_a, "device"_a, "options"_a = LoopOptions(), "log"_a = py::none(),
           "task"_a = py::none(), py::keep_alive<1, 2>(), py::keep_alive<1, 3>(),
           py::keep_alive<1, 5>(), py::keep_alive<1, 6>(),
           "A loop over a scene that build_scene made; log takes what every tick did; a task, of "
           "build_task with that scene, is judged in every tick, and ends the run when it is "
           "decided.")
      .def(py::init([](const Scene& scene, const py::sequence& devices, const LoopOptions& options,
                       TickLog* log, const Task* task) {
             return std::make_unique<HeldLoop>(scene, py::tuple(devices), options, log, task);
           }),
           "scene"_a, "devices"_a, "options"_a = LoopOptions(), "log"_a = py::none(),
           "task"_a = py::none(), py::keep_alive<1, 2>(), py::keep_alive<1, 5>(),
           py::keep_alive<1, 6>(),
           "The same with one device for each instrument, in their order. Raises ValueError for "
           "another number of them, or one that is there twice.")
      .def("start", &Loop::start, Release(),
           "Raises RuntimeError the second time: a loop runs once.")
      .def("stop", &Loop::stop, Release(), "Asks and waits; every device gets a zero force last.")
      .def("wait", &wait, "timeout"_a, "[s] True once the run has ended.")
      .def("running", &Loop::running, "Whether the thread runs.")
      .def(
          "pause", &Loop::pause,
          "From any thread; followed within a tick. While it is paused devices get zero forces and "
          "the time of the run stands still: what would have been due is neither missed nor made "
          "up. The force then fades in as at the start.")
      .def("resume", &Loop::resume, "Goes on where pause stopped.")
      .def("paused", &Loop::paused, "The last command has gone out, a zero force after it.")
      .def("take_snapshot", &Loop::take_snapshot,
           "For one reader thread: True if something newer than last time was taken.")
      .def(
          "snapshot", [](const HeldLoop& self) { return Snapshot(self.snapshot()); },
          "A copy of the snapshot last taken.")
      .def("report", &Loop::report, "Costs so far; while running, of the ticks finished by now.")
      .def(
          "__enter__",
          [](HeldLoop& self) -> HeldLoop& {
            const py::gil_scoped_release released;
            self.start();
            return self;
          },
          py::return_value_policy::reference)
      .def("__exit__", [](HeldLoop& self, const py::args&) {
        const py::gil_scoped_release released;
        self.stop();
      });
}

}  // namespace

void bind_loop(py::module_& m) {
  bind_loop_options(m);
  bind_snapshot(m);
  bind_report(m);
  bind_loop_class(m);
}

}  // namespace palpate::bindings
