// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include <algorithm>

#include "bindings.h"
#include "interrupt.h"
#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/error.h"
#include "value.h"

namespace palpate::bindings {

namespace {

using Release = py::call_guard<py::gil_scoped_release>;

/// A simulated device lives up to `time` [s] in pieces, so that Ctrl-C is heard and no time lasts
/// for ever.
void live_until(NativeCore& core, double time) {
  constexpr double kMost = 24 * 3600.0;  // [s] in one call
  constexpr double kPiece = 0.005;       // [s]
  if (!(time - core.time() <= kMost)) {
    refuse("time [s]", write_text(time), write_text("at most a day after ", core.time()));
  }
  if (!(time > core.time() + kPiece)) return;
  run_in_pieces([&core, time] {
    core.read(std::min(time, core.time() + kPiece), {});
    return core.time() >= time;
  });
}

void live_until(Transport& transport, double time) {
  if (auto* core = dynamic_cast<NativeCore*>(&transport)) live_until(*core, time);
}

/// `call`, handed what tells it to stop.
template <class Call>
void run_until_stopped(Call call) {
  Interrupt interrupt;
  try {
    const py::gil_scoped_release released;
    call([&interrupt] { return interrupt.came(); });
  } catch (const DeviceError&) {
    interrupt.rethrow();
    throw;
  }
  interrupt.rethrow();
}

void bind_transports(py::module_& m) {
  py::class_<Transport> transport(m, "Transport", "Bytes to a device and back, real or simulated.");
  refuse_overrides(transport);
  transport
      .def(
          "read",
          [](Transport& self, double time) {
            live_until(self, time);
            std::array<std::uint8_t, 4096> bytes;
            const std::size_t count = self.read(time, bytes);
            return py::bytes(reinterpret_cast<const char*>(bytes.data()), count);
          },
          "time"_a, "What has come by time [s] since the run began.")
      .def(
          "write",
          [](Transport& self, double time, const py::bytes& bytes) {
            live_until(self, time);
            const std::string_view all = bytes;
            self.write(time, {reinterpret_cast<const std::uint8_t*>(all.data()), all.size()});
          },
          "time"_a, "bytes"_a, "Sends bytes at time [s].")
      .def("is_open", &Transport::is_open, "False for good once the other end is gone.")
      .def("can_wait", &Transport::can_wait,
           "True if wait can: something of the machine's own tells that bytes have come.")
      .def(
          "wait",
          [](Transport& self, std::int64_t latest) {
            return wait_in_pieces(latest, [&self](std::int64_t until) { return self.wait(until); });
          },
          "latest"_a,
          "Until bytes have come, or latest [ns of the monotonic clock]. False if none have.")
      .def("now", &Transport::now, "time"_a, "[s] of the clock that arrivals are told by.")
      .def("name", &Transport::name, "What it is called in messages.");

  const NativeCoreOptions usual;
  py::class_<NativeCoreOptions> options(m, "NativeCoreOptions",
                                        "How the simulated wire and the clocks at its ends are.");
  options
      .def(py::init([](double baud, double link_delay, double report_delay, double drift,
                       bool calibrated, bool damaged) {
             return NativeCoreOptions{baud, link_delay, report_delay, drift, calibrated, damaged};
           }),
           py::kw_only(), "baud"_a = usual.baud, "link_delay"_a = usual.link_delay,
           "report_delay"_a = usual.report_delay, "drift"_a = usual.drift,
           "calibrated"_a = usual.calibrated, "damaged"_a = usual.damaged)
      .def_readwrite("baud", &NativeCoreOptions::baud, "[bit/s]")
      .def_readwrite("link_delay", &NativeCoreOptions::link_delay,
                     "[s] of what joins wire and host, each way.")
      .def_readwrite("report_delay", &NativeCoreOptions::report_delay,
                     "[s] from a tick's samples to the first byte of its report.")
      .def_readwrite("drift", &NativeCoreOptions::drift,
                     "[-] By how much the device's clock is fast.")
      .def_readwrite("calibrated", &NativeCoreOptions::calibrated,
                     "Its EEPROM holds what find_calibration says of the plant.")
      .def_readwrite("damaged", &NativeCoreOptions::damaged,
                     "A byte of that has changed since it was stored.");
  def_value(options, &NativeCoreOptions::baud, &NativeCoreOptions::link_delay,
            &NativeCoreOptions::report_delay, &NativeCoreOptions::drift,
            &NativeCoreOptions::calibrated, &NativeCoreOptions::damaged);
  def_repr(options, {"baud", "link_delay", "report_delay", "drift", "calibrated", "damaged"});

  py::class_<NativeCore, Transport>(
      m, "NativeCore",
      "The firmware's own C code, compiled for this machine, on a simulated arm at the far end of "
      "a simulated wire. The same in every run; no clock but the time it is given.")
      .def(py::init<const Plant&, const NativeCoreOptions&>(), "plant"_a = Plant(),
           "options"_a = usual, "Raises ValueError.")
      .def(
          "advance",
          [](NativeCore& self, double time) {
            live_until(self, time);
            self.advance(time);
          },
          "time"_a,
          "Lives on up to time [s] although nobody reads; what it says is then lost. Ctrl-C ends "
          "it. Raises ValueError for more than a day in one call.")
      .def("time", &NativeCore::time, "[s] of the run, up to which it has lived.")
      .def("hold", &NativeCore::hold, "hand"_a, "Whether and where to a hand moves the stylus.")
      .def("press_buttons", &NativeCore::press_buttons, "buttons"_a,
           "The stylus' buttons: bit 0 attaches.")
      .def("press_stop", &NativeCore::press_stop, "pressed"_a, "The emergency stop.")
      .def("cut_sensor", &NativeCore::cut_sensor, "joint"_a, "cut"_a,
           "Its wire is off: the reading is at the rail.")
      .def("pull_cable", &NativeCore::pull_cable, "From then on nothing goes either way.")
      .def("reset", &NativeCore::reset, "As if its power had failed for a moment.")
      .def("plant", &NativeCore::plant, "The arm that is simulated.")
      .def("state", py::overload_cast<>(&NativeCore::state),
           py::return_value_policy::reference_internal, "The arm as it really is.")
      .def("drive", &NativeCore::drive, "What the motors get.")
      .def("motor_force", &NativeCore::motor_force,
           "[N] shape (3,), of the motors at the tip, without the arm's own weight.");
}

void bind_ports(py::module_& m) {
  py::class_<SerialPort> port(m, "SerialPort",
                              "A serial port of this machine, as far as the system knows it.");
  port.def_readonly("path", &SerialPort::path, "To open.")
      .def_readonly("product", &SerialPort::product,
                    "What it calls itself; empty where it does not say.")
      .def_readonly("driver", &SerialPort::driver, "Of the system.")
      .def_readonly("latency_timer", &SerialPort::latency_timer,
                    "[ms] that the adapter may keep bytes back; -1 where it has none.")
      .def_readonly("permitted", &SerialPort::permitted, "This user may open it.");
  def_value(port, &SerialPort::path, &SerialPort::product, &SerialPort::driver,
            &SerialPort::latency_timer, &SerialPort::permitted);
  def_repr(port, {"path", "product", "driver", "latency_timer", "permitted"});
  m.def("find_serial_ports", &find_serial_ports,
        "The USB serial adapters of this machine, by path.");
  py::class_<SerialTransport, Transport>(
      m, "SerialTransport",
      "A serial port, or the far end of a PtyDevice. Bytes are told by the machine's own clock. "
      "What keeps bytes back is switched off as far as the system and the adapter let it.")
      .def(py::init<const std::string&, int>(), "path"_a, "baud"_a = 1000000,
           "Raises DeviceError where the port cannot be opened or does not know the rate.")
      .def("latency_note", &SerialTransport::latency_note,
           "What was done about latency, and what could not be, in words.");
  py::class_<PtyDevice>(m, "PtyDevice", py::release_gil_before_calling_cpp_dtor(),
                        "A simulated device behind a pseudo terminal: a file that any program can "
                        "open as if it were the serial port of the real one.")
      .def(py::init<const Plant&, const NativeCoreOptions&>(), "plant"_a = Plant(),
           "options"_a = NativeCoreOptions(), "Raises DeviceError.")
      .def("path", &PtyDevice::path, "Of the file to open.")
      .def("press_buttons", &PtyDevice::press_buttons, "buttons"_a,
           "From any thread: bits 0 and 1.");
}

void bind_status(py::module_& m) {
  py::native_enum<LinkState>(m, "LinkState", "enum.Enum", "How far a host has come with a device.")
      .value("greeting", LinkState::greeting, "Asks who is there.")
      .value("loading", LinkState::loading, "Reads its calibration.")
      .value("uncalibrated", LinkState::uncalibrated, "Hears counts that mean nothing.")
      .value("ready", LinkState::ready, "Knows where the hand is.")
      .value("lost", LinkState::lost, "Gone for good: unplugged, silent or of another protocol.")
      .finalize();
  py::native_enum<DeviceMode>(m, "DeviceMode", "enum.Enum", "What a device does.")
      .value("boot", DeviceMode::boot)
      .value("idle", DeviceMode::idle)
      .value("ramp", DeviceMode::ramp)
      .value("run", DeviceMode::run)
      .value("faulted", DeviceMode::faulted)
      .finalize();
  py::class_<DeviceStatus> status(m, "DeviceStatus",
                                  "Everything there is to know of a device, as its driver left it "
                                  "for others some milliseconds ago.");
  status.def_readonly("link", &DeviceStatus::link, "How far the host has come with it.")
      .def_readonly("mode", &DeviceStatus::mode, "What it does.")
      .def_readonly("blank", &DeviceStatus::blank, "No calibration was ever stored in it.")
      .def_readonly("damaged", &DeviceStatus::damaged,
                    "The newest calibration in its EEPROM is not what was stored.")
      .def_readonly("degraded", &DeviceStatus::degraded,
                    "Reports are missing: the force is taken back.")
      .def_readonly("first_fault", &DeviceStatus::first_fault,
                    "Bit that cut the motors, 15 for none: see name_fault.")
      .def_readonly("faults", &DeviceStatus::faults, "Bits: whatever was noticed.")
      .def_readonly("buttons", &DeviceStatus::buttons, "Bits 0 and 1: pressed, by the last report.")
      .def_readonly("time", &DeviceStatus::time, "[s] of the last report, by the host's clock.")
      .def_readonly("counts", &DeviceStatus::counts, "Of the sensors.");
  def_vector(status, "joints", &DeviceStatus::joints, "[rad] yaw, elevation, forearm.");
  def_vector(status, "gimbal", &DeviceStatus::gimbal, "[rad]");
  def_vector(status, "tip", &DeviceStatus::tip, "[m] in the arm's frame.");
  def_vector(status, "force_commanded", &DeviceStatus::force_commanded, "[N]");
  def_vector(status, "force_applied", &DeviceStatus::force_applied,
             "[N] by the duties the motors really got.");
  status.def_readonly("duty", &DeviceStatus::duty, "-255 to 255.")
      .def_readonly("counters", &DeviceStatus::counters,
                    "Heat of three motors, then the device's own counts.")
      .def_readonly("reports", &DeviceStatus::reports, "From the device.")
      .def_readonly("lost_reports", &DeviceStatus::lost_reports,
                    "That its own count says are missing.")
      .def_readonly("damaged_frames", &DeviceStatus::damaged_frames,
                    "That failed their check, here.")
      .def_readonly("commands", &DeviceStatus::commands, "To the device.")
      .def_readonly("report_rate", &DeviceStatus::report_rate, "[Hz] over the last second.")
      .def_readonly("round_trip_median", &DeviceStatus::round_trip_median,
                    "[s] command to its acknowledgement.")
      .def_readonly("round_trip_p99", &DeviceStatus::round_trip_p99, "[s]")
      .def_readonly("round_trips", &DeviceStatus::round_trips,
                    "How many took 0 to 0.25 ms, to 0.5 ms ...; the last all longer ones.")
      .def_readonly("jitter_p99", &DeviceStatus::jitter_p99,
                    "[s] reports off the line through their times.")
      .def_readonly("clock_drift", &DeviceStatus::clock_drift,
                    "[-] By how much the device's clock is fast, 1e-6 for 1 ppm.")
      .def_readonly("local_stiffness", &DeviceStatus::local_stiffness,
                    "[N/m] along the force that it answers by itself.")
      .def_readonly("release", &DeviceStatus::release, "Of the firmware.")
      .def_readonly("serial_number", &DeviceStatus::serial_number, "Of the device.");
  def_value(status, &DeviceStatus::link, &DeviceStatus::mode, &DeviceStatus::blank,
            &DeviceStatus::damaged, &DeviceStatus::degraded, &DeviceStatus::first_fault,
            &DeviceStatus::faults, &DeviceStatus::buttons, &DeviceStatus::time,
            &DeviceStatus::counts, &DeviceStatus::joints, &DeviceStatus::gimbal, &DeviceStatus::tip,
            &DeviceStatus::force_commanded, &DeviceStatus::force_applied, &DeviceStatus::duty,
            &DeviceStatus::counters, &DeviceStatus::reports, &DeviceStatus::lost_reports,
            &DeviceStatus::damaged_frames, &DeviceStatus::commands, &DeviceStatus::report_rate,
            &DeviceStatus::round_trip_median, &DeviceStatus::round_trip_p99,
            &DeviceStatus::round_trips, &DeviceStatus::jitter_p99, &DeviceStatus::clock_drift,
            &DeviceStatus::local_stiffness, &DeviceStatus::release, &DeviceStatus::serial_number);
  def_repr(status, {"link", "mode", "first_fault", "tip", "report_rate"});
  m.def("name_fault", &name_fault, "fault"_a,
        "A fault's name in words, for instance \"host silent\"; \"none\" for no fault.");
  m.def("describe_status", &describe_status, "status"_a,
        "One sentence: what the device does, or what is wrong and what to do.");
}

void bind_drivers(py::module_& m) {
  py::class_<SerialDevice, HapticDevice>(
      m, "SerialDevice",
      "The driver of the low-cost device, at the other end of whatever transport.")
      .def(py::init<Transport&, const Vec3&>(), "transport"_a, "origin"_a = Vec3::Zero().eval(),
           py::keep_alive<1, 2>(), "The workspace's centre shall lie at origin [m] of the scene.")
      .def(
          "open",
          [](SerialDevice& self, double timeout) {
            run_until_stopped([&](const auto& stopped) { self.open(timeout, stopped); });
          },
          "timeout"_a = 3.0,
          "Greets the device, reads its calibration and waits for its first report; to be called "
          "before a run. Raises DeviceError in words where that does not come about within "
          "timeout [s].")
      .def("clear_fault", &SerialDevice::clear_fault,
           "From any thread: asks the device to forget its fault, if the cause is gone.")
      .def("enable", &SerialDevice::enable, "on"_a,
           "From any thread: motors on (as they are from the start) or off.")
      .def("take_status", &SerialDevice::take_status,
           "For one reader thread: True if something newer than last time was taken.")
      .def(
          "status", [](const SerialDevice& self) { return DeviceStatus(self.status()); },
          "A copy of the status last taken.")
      .def("calibration", &SerialDevice::calibration,
           "As it was read when the link was made. Raises DeviceError where there is none.")
      .def(
          "store",
          [](SerialDevice& self, const Calibration& calibration, double timeout) {
            run_until_stopped(
                [&](const auto& stopped) { self.store(calibration, timeout, stopped); });
          },
          "calibration"_a, "timeout"_a = 5.0,
          "Writes a calibration to the device, which keeps it; then the device is greeted again. "
          "Not while a run is on. Raises DeviceError in words, and ValueError for numbers it "
          "cannot hold.");
}

void bind_simulated_arm(py::module_& m) {
  py::class_<SimulatedArm, HapticDevice>(
      m, "SimulatedArm",
      "The low-cost device without its metal: a hand holds a simulated arm, whose firmware is the "
      "real one, and is felt through the real driver.")
      .def(py::init<HapticDevice&, const Vec3&, const Plant&, const NativeCoreOptions&>(), "hand"_a,
           "origin"_a = Vec3::Zero().eval(), "plant"_a = Plant(), "options"_a = NativeCoreOptions(),
           py::keep_alive<1, 2>(),
           "hand says where the hand wants to be, in the scene, whose place origin [m] is the "
           "middle of the arm's workspace. Raises ValueError.")
      .def("open", &SimulatedArm::open, Release(),
           "Puts the arm where the hand begins and makes the link. Raises DeviceError.")
      .def("widen", &SimulatedArm::widen, "wide"_a,
           "From any thread: whether the hand may leave the workspace and go to the joints' stops.")
      .def("press_stop", &SimulatedArm::press_stop, "pressed"_a,
           "From any thread: the emergency stop.")
      .def("cut_sensor", &SimulatedArm::cut_sensor, "joint"_a, "cut"_a,
           "From any thread: the wire of a sensor is off.")
      .def("pull_cable", &SimulatedArm::pull_cable, "From any thread, and for good.")
      .def("hand_force", &SimulatedArm::hand_force,
           "From any thread: [N] shape (3,), of the hand on the stylus, as a scale between them "
           "would say.")
      .def("core", &SimulatedArm::core, py::return_value_policy::reference_internal,
           "The simulated device.")
      .def("driver", &SimulatedArm::driver, py::return_value_policy::reference_internal,
           "Its driver.");
}

void bind_faults(py::module_& m) {
  const Faults none;
  py::class_<Faults> faults(m, "Faults",
                            "What goes wrong, and how often: shares of frames or samples, 0 to 1. "
                            "The same in every run.");
  faults
      .def(py::init([](double drop, double corrupt, double reorder, double delay, double stick_at,
                       double unplug_at, double cut_at, std::uint64_t seed) {
             return Faults{drop, corrupt, reorder, delay, stick_at, unplug_at, cut_at, seed};
           }),
           py::kw_only(), "drop"_a = none.drop, "corrupt"_a = none.corrupt,
           "reorder"_a = none.reorder, "delay"_a = none.delay, "stick_at"_a = none.stick_at,
           "unplug_at"_a = none.unplug_at, "cut_at"_a = none.cut_at, "seed"_a = none.seed)
      .def_readwrite("drop", &Faults::drop, "[-] Lost.")
      .def_readwrite("corrupt", &Faults::corrupt,
                     "[-] Changed: a bit of a frame, a number of a sample.")
      .def_readwrite("reorder", &Faults::reorder, "[-] Comes after the one that follows it.")
      .def_readwrite("delay", &Faults::delay, "[s] each way.")
      .def_readwrite("stick_at", &Faults::stick_at, "[s] from then on the same again.")
      .def_readwrite("unplug_at", &Faults::unplug_at, "[s] from then on nothing.")
      .def_readwrite("cut_at", &Faults::cut_at,
                     "[s] from then on a device moves but its motors are off; a transport knows of "
                     "none.")
      .def_readwrite("seed", &Faults::seed, "Of what goes wrong, and when.");
  def_value(faults, &Faults::drop, &Faults::corrupt, &Faults::reorder, &Faults::delay,
            &Faults::stick_at, &Faults::unplug_at, &Faults::cut_at, &Faults::seed);
  def_repr(faults,
           {"drop", "corrupt", "reorder", "delay", "stick_at", "unplug_at", "cut_at", "seed"});
  m.def("validate", py::overload_cast<const Faults&>(&validate), "faults"_a,
        "Raises ValueError naming the field, what it got and what was expected.");
  py::class_<FaultyDevice, HapticDevice>(m, "FaultyDevice", "A device to which faults happen.")
      .def(py::init<HapticDevice&, const Faults&>(), "device"_a, "faults"_a, py::keep_alive<1, 2>(),
           "Raises ValueError.");
  py::class_<FaultyTransport, Transport>(
      m, "FaultyTransport", "A transport on which faults happen to whole frames, both ways.")
      .def(py::init<Transport&, const Faults&>(), "transport"_a, "faults"_a, py::keep_alive<1, 2>(),
           "Raises ValueError.");
}

}  // namespace

void bind_serial(py::module_& m) {
  bind_transports(m);
  bind_ports(m);
  bind_status(m);
  bind_drivers(m);
  bind_simulated_arm(m);
  bind_faults(m);
}

}  // namespace palpate::bindings
