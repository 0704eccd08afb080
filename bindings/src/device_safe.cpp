// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include <algorithm>
#include <cmath>

#include "bindings.h"
#include "interrupt.h"
#include "palpate/sim/device/conformance.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/loop/loop.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_limits(py::module_& m) {
  const SafetyLimits usual;
  py::class_<SafetyLimits> limits(
      m, "SafetyLimits",
      "What a device may be sent. The defaults suit a device that nothing can hurt; a real one is "
      "given its own, as find_safety_limits does for the low-cost arm.");
  limits.def(
      py::init([](double force_max, double force_continuous, double heat_time, double slew_max,
                  double ramp_time, double start_force_max, double velocity_max, double brake,
                  double energy_max, double damping_max) {
        return SafetyLimits{force_max,       force_continuous, heat_time, slew_max,   ramp_time,
                            start_force_max, velocity_max,     brake,     energy_max, damping_max};
      }),
      py::kw_only(), "force_max"_a = usual.force_max, "force_continuous"_a = usual.force_continuous,
      "heat_time"_a = usual.heat_time, "slew_max"_a = usual.slew_max,
      "ramp_time"_a = usual.ramp_time, "start_force_max"_a = usual.start_force_max,
      "velocity_max"_a = usual.velocity_max, "brake"_a = usual.brake,
      "energy_max"_a = usual.energy_max, "damping_max"_a = usual.damping_max);
  limits.def_readwrite("force_max", &SafetyLimits::force_max, "[N] norm, at any moment.")
      .def_readwrite("force_continuous", &SafetyLimits::force_continuous,
                     "[N] root mean square that the motors stand for ever.")
      .def_readwrite("heat_time", &SafetyLimits::heat_time, "[s] in which they warm up.")
      .def_readwrite("slew_max", &SafetyLimits::slew_max, "[N/s]")
      .def_readwrite("ramp_time", &SafetyLimits::ramp_time,
                     "[s] from the first command, or the first after a rest, to full force.")
      .def_readwrite("start_force_max", &SafetyLimits::start_force_max,
                     "[N] no force at all before one as small as this was asked for.")
      .def_readwrite("velocity_max", &SafetyLimits::velocity_max,
                     "[m/s] of the hand; beyond it forces only brake.")
      .def_readwrite("brake", &SafetyLimits::brake, "[N·s/m] on what is faster.")
      .def_readwrite("energy_max", &SafetyLimits::energy_max,
                     "[J] the hand may be given more than it gave; then damping.")
      .def_readwrite("damping_max", &SafetyLimits::damping_max,
                     "[N·s/m] that the passivity controller may add.");
  def_value(limits, &SafetyLimits::force_max, &SafetyLimits::force_continuous,
            &SafetyLimits::heat_time, &SafetyLimits::slew_max, &SafetyLimits::ramp_time,
            &SafetyLimits::start_force_max, &SafetyLimits::velocity_max, &SafetyLimits::brake,
            &SafetyLimits::energy_max, &SafetyLimits::damping_max);
  def_repr(limits, {"force_max", "force_continuous", "heat_time", "slew_max", "ramp_time",
                    "start_force_max", "velocity_max", "brake", "energy_max", "damping_max"});
}

std::vector<DeviceCheck> check_device(HapticDevice& device, const ConformanceOptions& options) {
  Interrupt interrupt;
  std::vector<DeviceCheck> checks;
  {
    const py::gil_scoped_release released;
    checks = check_conformance(device, options, [&interrupt] { return interrupt.came(); });
  }
  interrupt.rethrow();
  return checks;
}

/// Piece by piece, as many ticks in all as in one.
void run_loop(DeviceLoop& loop, double seconds) {
  constexpr double kTick = 1e-3;  // [s]
  if (!(seconds > 0.0 && seconds <= 24 * 3600.0)) {
    loop.run(seconds);
    return;
  }
  long left = std::max(1L, std::lround(seconds / kTick));
  run_in_pieces([&] {
    const long piece = std::min(left, 5L);
    loop.run(kTick * double(piece));
    return (left -= piece) == 0;
  });
}

void bind_conformance(py::module_& m) {
  py::class_<DeviceCheck> check(m, "DeviceCheck",
                                "One thing a device owes, and whether it keeps it.");
  check.def_readonly("name", &DeviceCheck::name, "What is owed, as a sentence.")
      .def_readonly("passed", &DeviceCheck::passed, "Whether the device keeps it.")
      .def_readonly("detail", &DeviceCheck::detail, "What was found.");
  def_value(check, &DeviceCheck::name, &DeviceCheck::passed, &DeviceCheck::detail);
  def_repr(check, {"name", "passed", "detail"});
  const ConformanceOptions usual;
  py::class_<ConformanceOptions> options(m, "ConformanceOptions", "How a device is checked.");
  options
      .def(py::init([](double duration, double rate, double force, bool live) {
             return ConformanceOptions{duration, rate, force, live};
           }),
           py::kw_only(), "duration"_a = usual.duration, "rate"_a = usual.rate,
           "force"_a = usual.force, "live"_a = usual.live)
      .def_readwrite("duration", &ConformanceOptions::duration,
                     "[s] of each part; a real hand should move the device meanwhile.")
      .def_readwrite("rate", &ConformanceOptions::rate, "[Hz]")
      .def_readwrite("force", &ConformanceOptions::force, "[N] of the pushes.")
      .def_readwrite("live", &ConformanceOptions::live,
                     "Wait for the clock between ticks, as a device in real time needs.");
  def_value(options, &ConformanceOptions::duration, &ConformanceOptions::rate,
            &ConformanceOptions::force, &ConformanceOptions::live);
  def_repr(options, {"duration", "rate", "force", "live"});
  m.def("check_conformance", &check_device, "device"_a, "options"_a = usual,
        "What any HapticDevice has to keep, ours or another maker's, before a person holds it. The "
        "device is pushed gently. Raises ValueError; Ctrl-C ends it.");
}

void bind_device_loop(py::module_& m) {
  using Release = py::call_guard<py::gil_scoped_release>;
  py::class_<DeviceTask> task(m, "DeviceTask",
                              "What the hand shall feel where there is no tissue: a force, and a "
                              "spring to a place.");
  task.def(py::init([](const Vec3& force, double stiffness, const Vec3& rest) {
             return DeviceTask{force, stiffness, rest};
           }),
           py::kw_only(), "force"_a = Vec3::Zero().eval(), "stiffness"_a = 0.0,
           "rest"_a = Vec3::Zero().eval());
  def_vector(task, "force", &DeviceTask::force, "[N]");
  task.def_readwrite("stiffness", &DeviceTask::stiffness, "[N/m] 0 for no spring.");
  def_vector(task, "rest", &DeviceTask::rest, "[m] where the spring draws to.");
  def_value(task, &DeviceTask::force, &DeviceTask::stiffness, &DeviceTask::rest);
  def_repr(task, {"force", "stiffness", "rest"});
  m.def("validate", py::overload_cast<const DeviceTask&>(&validate), "task"_a,
        "Raises ValueError naming the field, what it got and what was expected.");
  py::class_<DeviceLoop>(m, "DeviceLoop", py::release_gil_before_calling_cpp_dtor(),
                         "Keeps a device company at 1 kHz without a tissue: F = force + stiffness "
                         "(rest - x), through a SafeDevice. Either in a thread of its own, by the "
                         "clock; or, for a simulated device, as fast as the machine can.")
      .def(py::init<HapticDevice&, const SafetyLimits&>(), "device"_a, "limits"_a = SafetyLimits{},
           py::keep_alive<1, 2>(), "Raises ValueError as SafeDevice does.")
      .def("start", &DeviceLoop::start, Release(),
           "Raises RuntimeError while it runs; may be started again once stopped.")
      .def("stop", &DeviceLoop::stop, Release(),
           "Asks and waits; the device gets a zero force last.")
      .def("running", &DeviceLoop::running, "Whether its own thread runs.")
      .def("run", &run_loop, "seconds"_a,
           "Ticks for so many [s] in this thread, without waiting; Ctrl-C ends it. Raises "
           "RuntimeError while the "
           "loop's own thread runs, ValueError for no time or more than a day.")
      .def("set_task", &DeviceLoop::set_task, "task"_a,
           "One calling thread: felt from the next tick on. Raises ValueError.")
      .def("fall_silent", &DeviceLoop::fall_silent, "seconds"_a,
           "From any thread: the device hears nothing for so many [s], as if the host had died.")
      .def("time", &DeviceLoop::time, "[s] that the loop has run.")
      .def("missed_ticks", &DeviceLoop::missed_ticks, "Skipped so far.")
      .def("fault", &DeviceLoop::fault, "The first fault; none for none.");
}

}  // namespace

void bind_safe_device(py::module_& m) {
  bind_limits(m);
  py::native_enum<DeviceFault>(m, "DeviceFault", "enum.Enum",
                               "Why a device is sent no force any more.")
      .value("none", DeviceFault::none)
      .value("sample_not_finite", DeviceFault::sample_not_finite)
      .value("force_not_finite", DeviceFault::force_not_finite)
      .value("device_failed", DeviceFault::device_failed)
      .value("sample_out_of_reach", DeviceFault::sample_out_of_reach, "A hand beyond 10 m.")
      .value("sample_too_fast", DeviceFault::sample_too_fast, "A hand faster than 1000 m/s.")
      .value("motors_cut", DeviceFault::motors_cut,
             "MotorState.cut; of the live loop alone, for the motors may come back.")
      .finalize();
  py::class_<SafeDevice, HapticDevice>(
      m, "SafeDevice",
      "Stands between the tick and any device. What passes is finite, gives the hand no energy it "
      "did not put in, never pushes a hand that is too fast, is limited in norm, moment by moment "
      "and on the whole, fades in at the start, and changes no faster than the slew limit. The "
      "first fault latches.")
      .def(py::init<HapticDevice&, const SafetyLimits&>(), "device"_a, "limits"_a = SafetyLimits{},
           py::keep_alive<1, 2>(), "Raises ValueError for limits that are not positive.")
      .def("set_tool", &SafeDevice::set_tool, "position"_a,
           "Where the tool is that the force of the next command draws the hand to; until this is "
           "told, at the hand. By it is judged how much of what the hand put in it may get back. A "
           "place that is not finite is passed over.\n\nArgs:\n"
           "    position: [m] shape (3,).")
      .def("rest", &SafeDevice::rest, "seconds"_a = 0.0,
           "A zero force at once, past the slew limit; the next command fades in as the first one "
           "did. So many [s] have passed in a pause.")
      .def("fault", &SafeDevice::fault, "The first fault; none for none.")
      .def("fault_value", &SafeDevice::fault_value,
           "What the fault found: [m] or [m/s], 0 for a fault without a value.")
      .def("sent", &SafeDevice::sent,
           "What was really sent last; nothing while the motors are not on.")
      .def("limited_count", &SafeDevice::limited_count, "How often a limit had to act.")
      .def("damped_count", &SafeDevice::damped_count, "How often the passivity controller had to.")
      .def("given_energy", &SafeDevice::given_energy,
           "[J] that the hand has been given since it last felt nothing, fading within a second.")
      .def("heat", &SafeDevice::heat, "[-] Of what the motors stand for ever, 0 to 1.");
  m.def("describe_fault", &describe_fault, "fault"_a, "value"_a, "device"_a,
        "One sentence without a stop. value is what the fault found, [m] or [m/s] where it has "
        "one; what the motors are cut for, or why the device failed, the device says.");
  bind_conformance(m);
  bind_device_loop(m);
}

}  // namespace palpate::bindings
