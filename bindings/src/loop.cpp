// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/loop.h"

#include <pybind11/native_enum.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bindings.h"
#include "border.h"
#include "interrupt.h"
#include "palpate/sim/device/mailbox_device.h"
#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/tick/surface_pointer.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_scripted_device(py::module_& m) {
  py::class_<KeyFrame> frame(m, "KeyFrame",
                             "One moment of a script; between key frames the hand moves smoothly "
                             "(minimum jerk), buttons hold from their frame on.");
  frame.def(py::init([](double time, const Vec3& position, std::uint8_t buttons) {
              return KeyFrame{time, position, buttons};
            }),
            "time"_a = 0.0, "position"_a = Vec3::Zero().eval(), "buttons"_a = 0);
  frame.def_readwrite("time", &KeyFrame::time, "[s], ascending.");
  def_vector(frame, "position", &KeyFrame::position, "[m]");
  frame.def_readwrite("buttons", &KeyFrame::buttons, "Bit 0: attach while held.");
  def_value(frame, &KeyFrame::time, &KeyFrame::position, &KeyFrame::buttons);
  def_repr(frame, {"time", "position", "buttons"});

  py::class_<ScriptedDevice, HapticDevice>(m, "ScriptedDevice",
                                           "A hand that follows a script, the same in every run.")
      .def(py::init<std::vector<KeyFrame>>(), "frames"_a,
           "Raises ValueError for no frames, times that do not ascend, or non-finite numbers.")
      .def("duration", &ScriptedDevice::duration, "[s]")
      .def_readonly("last_command", &ScriptedDevice::last_command, "The force it was last sent.");
}

void bind_mailbox_device(py::module_& m) {
  py::class_<MailboxDevice, HapticDevice>(
      m, "MailboxDevice",
      "A hand that another thread tells of as often as it can, and that takes the newest force "
      "from here; PythonDevice is one with a thread of its own. Outside of real time: what is felt "
      "is late by as long as that thread takes. Where no sample comes for 20 ms the force is taken "
      "back until one does; after a second the motors count as cut.")
      .def(py::init<const std::string&>(), "title"_a, "What it is called in reports.")
      .def("tell", &MailboxDevice::tell, "sample"_a,
           "The other thread: where the hand is now. time is filled in by read().")
      .def("take_command", &MailboxDevice::take_command, "The same thread: the newest force.")
      .def("fail", &MailboxDevice::fail, "reason"_a,
           "From any thread: the device is gone for good, and why; the first reason counts.");
}

void bind_surface_pointer(py::module_& m) {
  py::native_enum<PointerPath>(m, "PointerPath", "enum.Enum", "How a hand gets to its goal.")
      .value("along", PointerPath::along,
             "Over the surface at rest, at the depth that is asked for.")
      .value("around", PointerPath::around,
             "Straight, but around the organ: where it would come below it, along the surface.")
      .value("straight", PointerPath::straight, "Straight, the tissue it holds with it.")
      .finalize();

  py::class_<PointerTarget> target(m, "PointerTarget", "What a window wants of the hand.");
  target.def(py::init([](double time, const Vec3& goal, double depth, PointerPath path,
                         bool pressing, std::uint8_t buttons) {
               return PointerTarget{time, goal, depth, path, pressing, buttons};
             }),
             py::kw_only(), "time"_a = 0.0, "goal"_a = Vec3::Zero().eval(), "depth"_a = 0.0,
             "path"_a = PointerPath::along, "pressing"_a = false, "buttons"_a = 0);
  target.def_readwrite("time", &PointerTarget::time,
                       "[s] of the event that led to it, by the window's clock.");
  def_vector(target, "goal", &PointerTarget::goal,
             "[m], shape (3,), a point of the surface at rest, or beside it.");
  target
      .def_readwrite("depth", &PointerTarget::depth,
                     "[m] of the tip below the goal; negative above it.")
      .def_readwrite("path", &PointerTarget::path, "How the hand goes there.")
      .def_readwrite("pressing", &PointerTarget::pressing,
                     "A button is down: the hand presses for as long as it was.")
      .def_readwrite("buttons", &PointerTarget::buttons,
                     "Of the sample, once the tip has been where it began for a moment.");
  def_value(target, &PointerTarget::time, &PointerTarget::goal, &PointerTarget::depth,
            &PointerTarget::path, &PointerTarget::pressing, &PointerTarget::buttons);
  def_repr(target, {"time", "goal", "depth", "path", "pressing", "buttons"});

  py::class_<SurfacePointer, HapticDevice>(
      m, "SurfacePointer",
      "A hand that a window moves over a surface: post() from one thread, read() from the haptic "
      "thread, which moves the hand. How often the window finds time to post makes no difference "
      "to what is felt: the hand goes over the surface at rest at 250 mm/s at most and into it at "
      "50 mm/s, and a press that was over before it was heard of lasts as long as the window says.")
      .def(py::init([](const Scene& scene, int body, int instrument) {
             require_built(scene);
             require_index("body", body, scene.bodies.size());
             require_index("instrument", instrument, scene.instruments.size());
             return std::make_unique<SurfacePointer>(scene, body, instrument);
           }),
           "scene"_a, "body"_a = 0, "instrument"_a = 0,
           "The surface and the tool are those of a scene.")
      .def("post", &SurfacePointer::post, "target"_a,
           "One calling thread. Raises ValueError for a number that is not finite.");
}

}  // namespace

void bind_devices(py::module_& m) {
  py::native_enum<MotorState>(m, "MotorState", "enum.Enum",
                              "Whether a device makes the hand feel the force that it is sent.")
      .value("on", MotorState::on, "Or coming on.")
      .value("silent", MotorState::silent,
             "It has not been heard for some ticks: the force is taken back until it is.")
      .value("off", MotorState::off, "Not on yet, or switched off on purpose.")
      .value("cut", MotorState::cut,
             "They were on: it took them off, was reset, fell silent or is gone.")
      .finalize();
  py::class_<HapticDevice> device(
      m, "HapticDevice",
      "A haptic device, real or simulated. read and write belong to the haptic thread, which "
      "Python never enters: to write a device in Python, hand its driver to a PythonDevice.");
  refuse_overrides(device);
  device
      .def(
          "read",
          [](HapticDevice& self, double time) {
            // a simulated device lives through all of it at once
            if (!(std::abs(time) <= 24 * 3600.0)) {
              refuse("time [s]", write_text(time), "within a day of the run's begin");
            }
            return self.read(time);
          },
          "time"_a,
          "The hand at time [s] since the run began; devices with a clock of their own may ignore "
          "it.")
      .def("write", &HapticDevice::write, "command"_a,
           "The force the device shall make the hand feel.")
      .def("end", &HapticDevice::end,
           "A run is over: motors off, until the next write. The live loop calls it at its end.")
      .def("rest", &HapticDevice::rest, "seconds"_a,
           "The run is paused and its time stands still: no force, and so many [s] of the world's "
           "time have passed since the last call.")
      .def("motors", &HapticDevice::motors, "Whether the hand feels what is written now.")
      .def("explain_fault", &HapticDevice::explain_fault,
           "Why the motors are cut, or the device has failed, and what to do; empty where it "
           "cannot tell.")
      .def("name", &HapticDevice::name, "What it is called in reports.")
      .def("failed", &HapticDevice::failed,
           "True once the device is gone for good: what it says and is told no longer counts.")
      .def("report_rate", &HapticDevice::report_rate,
           "[Hz] of the reports that can be waited for, 0 where the device has no clock of its "
           "own. Where it is that of the ticks, the live loop ticks when a report has come.")
      .def(
          "wait_for_report",
          [](HapticDevice& self, std::int64_t latest) {
            return wait_in_pieces(
                latest, [&self](std::int64_t until) { return self.wait_for_report(until); });
          },
          "latest"_a,
          "Waits for a report that read has not seen, until latest [ns of the monotonic clock] "
          "at most. False if none came.");
  bind_safe_device(m);
  bind_scripted_device(m);
  bind_mailbox_device(m);
  bind_surface_pointer(m);
  py::class_<PointerDevice, HapticDevice>(
      m, "PointerDevice",
      "A hand that a window moves: set() from one thread, read() from the haptic thread. Between "
      "two positions the hand glides, never faster than 1 m/s; the first is taken at once.")
      .def(py::init<>(), "A hand that is nowhere yet.")
      .def("set", &PointerDevice::set, "sample"_a,
           "One calling thread; time and velocity are filled in by read().")
      .def("take_command", &PointerDevice::take_command,
           "The newest force, for the same thread as set().");
  py::class_<ReplayDevice, HapticDevice>(
      m, "ReplayDevice",
      "A hand read back from a record, one sample per call, whatever the time; the last one stays.")
      .def(
          py::init([](const py::object& samples) {
            return std::make_unique<ReplayDevice>(copy_rows<HapticSample>(samples, "samples"));
          }),
          "samples"_a,
          "Takes a structured array as of Record.hand or a list of HapticSample. Raises ValueError "
          "for no samples.")
      .def("finished", &ReplayDevice::finished, "Whether every sample has been read.")
      .def_readonly("last_command", &ReplayDevice::last_command, "The force it was last sent.");
}

namespace {

void bind_options(py::module_& m) {
  py::native_enum<FaultResponse>(
      m, "FaultResponse", "enum.Enum",
      "What becomes of a run whose device fails, or gives no force any more.")
      .value("go_on", FaultResponse::go_on, "To its end, and counts the ticks that nobody felt.")
      .value("pause", FaultResponse::pause,
             "It rests until resume(), and again where the fault is still there then.")
      .value("end", FaultResponse::end)
      .finalize();
  const LoopOptions usual;
  py::class_<LoopOptions> options(m, "LoopOptions", "How the live loop runs.");
  options
      .def(py::init([](double duration, bool realtime, int cpu, double spin,
                       const SafetyLimits& safety, FaultResponse on_fault) {
             return LoopOptions{duration, realtime, cpu, spin, safety, on_fault};
           }),
           py::kw_only(), "duration"_a = usual.duration, "realtime"_a = usual.realtime,
           "cpu"_a = usual.cpu, "spin"_a = usual.spin, "safety"_a = usual.safety,
           "on_fault"_a = usual.on_fault)
      .def_readwrite("duration", &LoopOptions::duration, "[s] 0 runs until stop().")
      .def_readwrite("realtime", &LoopOptions::realtime, "Ask for SCHED_FIFO and locked memory.")
      .def_readwrite("cpu", &LoopOptions::cpu, "Pin the thread to this core, -1 for none.")
      .def_readwrite("spin", &LoopOptions::spin, "[s] spun instead of slept before every tick.")
      .def_readwrite("safety", &LoopOptions::safety, "What the device may be sent.")
      .def_readwrite("on_fault", &LoopOptions::on_fault,
                     "What becomes of the run where the device fails.");
  def_value(options, &LoopOptions::duration, &LoopOptions::realtime, &LoopOptions::cpu,
            &LoopOptions::spin, &LoopOptions::safety, &LoopOptions::on_fault);
  def_repr(options, {"duration", "realtime", "cpu", "spin", "safety", "on_fault"});
}

void bind_snapshot(py::module_& m) {
  py::class_<BodySnapshot> body(m, "BodySnapshot", "A body as a reader sees it.");
  def_view(body, "position", &BodySnapshot::position,
           "[m] of the vertices of the surface, shape (n, 3); a view.");
  body.def_readonly("substeps", &BodySnapshot::substeps, "Of that tick.");
  def_value(body, &BodySnapshot::position, &BodySnapshot::substeps);
  def_repr(body, {"substeps"});

  py::class_<Snapshot> snapshot(
      m, "Snapshot",
      "What a reader outside the haptic thread sees: the world as it was at most 8 ms ago.");
  snapshot.def_readonly("tick", &Snapshot::tick, "Number of the tick it shows.")
      .def_readonly("time", &Snapshot::time, "[s]");
  def_elements(snapshot, "bodies", &Snapshot::bodies, "As Scene.bodies, a tuple.");
  snapshot.def_readonly("sample", &Snapshot::sample, "What the device said.");
  def_vector(snapshot, "tool_position", &Snapshot::tool_position, "[m]");
  def_vector(snapshot, "force", &Snapshot::force,
             "[N] on the hand; none while the motors are not on.");
  snapshot.def_readonly("touching", &Snapshot::touching, "Any contact in force.")
      .def_readonly("motors", &Snapshot::motors, "Of the device.")
      .def_readonly("cost", &Snapshot::cost, "[s] of the last tick.")
      .def_readonly("lateness", &Snapshot::lateness, "[s] of the last tick.")
      .def_readonly("missed_ticks", &Snapshot::missed_ticks, "Skipped so far.");
  def_value(snapshot, &Snapshot::tick, &Snapshot::time, &Snapshot::bodies, &Snapshot::sample,
            &Snapshot::tool_position, &Snapshot::force, &Snapshot::touching, &Snapshot::motors,
            &Snapshot::cost, &Snapshot::lateness, &Snapshot::missed_ticks);
  def_repr(snapshot, {"tick", "time", "touching", "force", "tool_position"});
}

void bind_report(py::module_& m) {
  py::class_<Percentiles> percentiles(m, "Percentiles",
                                      "[s] Right within 0.4 %, the largest exactly.");
  percentiles.def_readonly("median", &Percentiles::median, "[s] Half of them are shorter.")
      .def_readonly("p99", &Percentiles::p99, "[s] 99 % of them are shorter.")
      .def_readonly("p99_9", &Percentiles::p99_9, "[s] 99.9 % of them are shorter.")
      .def_readonly("max", &Percentiles::max, "[s] The longest.");
  def_value(percentiles, &Percentiles::median, &Percentiles::p99, &Percentiles::p99_9,
            &Percentiles::max);
  def_repr(percentiles, {"median", "p99", "p99_9", "max"});

  py::class_<LoopReport> report(m, "LoopReport", "What a run of the loop cost.");
  report.def_readonly("ticks", &LoopReport::ticks, "How many were run.")
      .def_readonly("missed_ticks", &LoopReport::missed_ticks,
                    "Skipped because an earlier tick was still at work.")
      .def_readonly("unpaced_ticks", &LoopReport::unpaced_ticks,
                    "Went without the report of a device that has its own pace.")
      .def_readonly("lateness", &LoopReport::lateness, "Start of a tick behind its due time.")
      .def_readonly("cost", &LoopReport::cost, "Of the tick itself, device included.")
      .def_readonly("realtime", &LoopReport::realtime, "Granted.")
      .def_readonly("realtime_note", &LoopReport::realtime_note, "Why not, in words.")
      .def_readonly("alarm", &LoopReport::alarm, "What ended the run; false for nothing.")
      .def_readonly("fault", &LoopReport::fault,
                    "Of the device, now or when the run ended; none for none.")
      .def_readonly("fault_reason", &LoopReport::fault_reason, "In words.")
      .def_readonly("record_gaps", &LoopReport::record_gaps, "Ticks the log had no room for.")
      .def_readonly("unrendered_ticks", &LoopReport::unrendered_ticks,
                    "The device's motors were not on: their force counts nowhere else here.")
      .def_readonly("peak_force", &LoopReport::peak_force, "[N] The largest that was sent.")
      .def_readonly("touch_ticks", &LoopReport::touch_ticks, "Touching or attached.")
      .def_readonly("touch_force", &LoopReport::touch_force,
                    "[N] The mean of what was sent in them.");
  def_value(report, &LoopReport::ticks, &LoopReport::missed_ticks, &LoopReport::unpaced_ticks,
            &LoopReport::lateness, &LoopReport::cost, &LoopReport::realtime,
            &LoopReport::realtime_note, &LoopReport::alarm, &LoopReport::fault,
            &LoopReport::fault_reason, &LoopReport::record_gaps, &LoopReport::unrendered_ticks,
            &LoopReport::peak_force, &LoopReport::touch_ticks, &LoopReport::touch_force);
  def_repr(report, {"ticks", "missed_ticks", "unpaced_ticks", "lateness", "cost", "realtime",
                    "realtime_note", "alarm", "fault", "fault_reason", "record_gaps",
                    "unrendered_ticks", "peak_force", "touch_ticks", "touch_force"});
}

/// Waits in short pieces, so that Ctrl-C is heard.
bool wait(Loop& loop, double timeout) {
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
  py::class_<Loop>(m, "Loop", py::release_gil_before_calling_cpp_dtor(),
                   "The live 1 kHz loop: a thread that waits, reads, ticks, writes. Python's lock "
                   "is never taken by it. As a context manager it starts, and stops at the end.\n\n"
                   "Leave the scene, the device and the log alone while it runs, except for what "
                   "is made for another thread: PointerDevice.set, TickLog.take.")
      .def(py::init([](const Scene& scene, HapticDevice& device, const LoopOptions& options,
                       TickLog* log) {
             require_built(scene);
             return std::make_unique<Loop>(scene, device, options, log);
           }),
           "scene"_a, "device"_a, "options"_a = LoopOptions(), "log"_a = py::none(),
           py::keep_alive<1, 2>(), py::keep_alive<1, 3>(), py::keep_alive<1, 5>(),
           "A loop over a scene that build_scene made; log takes what every tick did.")
      .def("start", &Loop::start, Release(),
           "Raises RuntimeError the second time: a loop runs once.")
      .def("stop", &Loop::stop, Release(), "Asks and waits; the device gets a zero force last.")
      .def("wait", &wait, "timeout"_a, "[s] True once the run has ended.")
      .def("running", &Loop::running, "Whether the thread runs.")
      .def(
          "pause", &Loop::pause,
          "From any thread; followed within a tick. While it is paused the device gets zero forces "
          "and the time of the run stands still: what would have been due is neither missed nor "
          "made up. The force then fades in as at the start.")
      .def("resume", &Loop::resume, "Goes on where pause stopped.")
      .def("paused", &Loop::paused, "The last command has gone out, a zero force after it.")
      .def("take_snapshot", &Loop::take_snapshot,
           "For one reader thread: True if something newer than last time was taken.")
      .def(
          "snapshot", [](const Loop& self) { return Snapshot(self.snapshot()); },
          "A copy of the snapshot last taken.")
      .def("report", &Loop::report, "Costs so far; while running, of the ticks finished by now.")
      .def(
          "__enter__",
          [](Loop& self) -> Loop& {
            const py::gil_scoped_release released;
            self.start();
            return self;
          },
          py::return_value_policy::reference)
      .def("__exit__", [](Loop& self, const py::args&) {
        const py::gil_scoped_release released;
        self.stop();
      });
}

}  // namespace

void bind_loop(py::module_& m) {
  bind_options(m);
  bind_snapshot(m);
  bind_report(m);
  bind_loop_class(m);
}

}  // namespace palpate::bindings
