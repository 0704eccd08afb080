// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/device/device.h"

#include <pybind11/native_enum.h>

#include <cmath>

#include "bindings.h"
#include "border.h"
#include "interrupt.h"
#include "palpate/sim/device/fulcrum_device.h"
#include "palpate/sim/device/mailbox_device.h"
#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/tick/surface_pointer.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_device_dynamics(py::module_& m) {
  py::class_<DeviceDynamics> dynamics(
      m, "DeviceDynamics",
      "What a device declares of itself, from which follows how stiff what is felt through it may "
      "be.");
  dynamics
      .def(py::init([](double damping, double delay, bool position_source) {
             return DeviceDynamics{damping, delay, position_source};
           }),
           py::kw_only(), "damping"_a = 0.0, "delay"_a = 0.0, "position_source"_a = false)
      .def_readwrite("damping", &DeviceDynamics::damping,
                     "[N·s/m] The least that the hand always feels of it; 0: none declared.")
      .def_readwrite("delay", &DeviceDynamics::delay,
                     "[s] From a hand to the force that answers it, holding not included.")
      .def_readwrite("position_source", &DeviceDynamics::position_source,
                     "No force moves its hand: a script, a record, a mouse.");
  def_value(dynamics, &DeviceDynamics::damping, &DeviceDynamics::delay,
            &DeviceDynamics::position_source);
  def_repr(dynamics, {"damping", "delay", "position_source"});
  m.def("find_passive_stiffness", &find_passive_stiffness, "dynamics"_a, "period"_a,
        "[N/m] Up to which a spring that is told every period [s] calms the hand, b / (T/2 + d) "
        "[Colgate97]; 0 where no damping is declared.\n\nArgs:\n"
        "    dynamics: What the device declares.\n"
        "    period: [s] From one force to the next.");
  m.attr("COUPLING_SHARE") = kCouplingShare;
  m.def("fit_coupling", &fit_coupling, "coupling"_a, "passive"_a, "tissue"_a,
        "[N/m] The hand's spring before a tissue, with a device that bears less than the "
        "instrument's own: never softer than is passive, as stiff as lets nine tenths of the "
        "tissue be felt, and no stiffer than leaves what is felt, k K / (k + K), passive.\n\n"
        "Args:\n"
        "    coupling: [N/m] The instrument's own.\n"
        "    passive: [N/m] That the device keeps passive.\n"
        "    tissue: [N/m] Of the tissue, to the tool.");
}

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

void bind_fulcrum_device(py::module_& m) {
  py::class_<Fulcrum> fulcrum(
      m, "Fulcrum",
      "A shaft through a trocar: where its tip is when its handle is held, and the other way "
      "round.");
  fulcrum.def(py::init([](const Vec3& trocar, double length) {
                return Fulcrum{trocar, length};
              }),
              "trocar"_a = Vec3::Zero().eval(), "length"_a = 0.0);
  def_vector(fulcrum, "trocar", &Fulcrum::trocar, "[m] where the shaft passes the abdominal wall.");
  fulcrum.def_readwrite("length", &Fulcrum::length, "[m] from the tip to the handle, positive.");
  def_value(fulcrum, &Fulcrum::trocar, &Fulcrum::length);
  def_repr(fulcrum, {"trocar", "length"});
  m.def("compute_fulcrum_tip", &compute_fulcrum_tip, "fulcrum"_a, "handle"_a,
        "[m] The tip of a shaft whose handle is there, shape (3,); never nearer than 5 mm to the "
        "trocar, on the side away from the handle.\n\nArgs:\n"
        "    fulcrum: Trocar and length of the shaft.\n"
        "    handle: [m] shape (3,).");
  m.def("compute_fulcrum_handle", &compute_fulcrum_handle, "fulcrum"_a, "tip"_a,
        "[m] The handle of a shaft whose tip is there, shape (3,); likewise.\n\nArgs:\n"
        "    fulcrum: Trocar and length of the shaft.\n"
        "    tip: [m] shape (3,).");
  m.def("carry_force", &carry_force, "fulcrum"_a, "handle"_a, "f"_a,
        "[N] On the handle of what pushes the tip by f, shape (3,), by virtual work. Across the "
        "shaft no more of it is felt than leaves the handle as stiff as the tip is.\n\nArgs:\n"
        "    fulcrum: Trocar and length of the shaft.\n"
        "    handle: [m] shape (3,), where it is.\n"
        "    f: [N] shape (3,).");
  py::class_<FulcrumDevice, HapticDevice>(
      m, "FulcrumDevice",
      "Stands between a device that is the handle of an instrument and what wants to know of its "
      "tip.")
      .def(py::init<HapticDevice&, const Fulcrum&>(), "handle"_a, "fulcrum"_a,
           py::keep_alive<1, 2>(),
           "Raises ValueError for a trocar that is not finite or a length that is not positive.");
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
                         bool pressing, std::uint8_t buttons, const Eigen::Vector4d& xyzw,
                         int rigid, const Vec3& rigid_position, const Eigen::Vector4d& rigid_xyzw) {
               return PointerTarget{time,
                                    goal,
                                    depth,
                                    path,
                                    pressing,
                                    buttons,
                                    Quaternion(xyzw),
                                    rigid,
                                    rigid_position,
                                    Quaternion(rigid_xyzw)};
             }),
             py::kw_only(), "time"_a = 0.0, "goal"_a = Vec3::Zero().eval(), "depth"_a = 0.0,
             "path"_a = PointerPath::along, "pressing"_a = false, "buttons"_a = 0,
             "orientation"_a = Eigen::Vector4d(0.0, 0.0, 0.0, 1.0), "rigid"_a = -1,
             "rigid_position"_a = Vec3::Zero().eval(),
             "rigid_orientation"_a = Eigen::Vector4d(0.0, 0.0, 0.0, 1.0));
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
  target.def_property(
      "orientation",
      [](const py::object& self) {
        return view_one(self.cast<PointerTarget&>().orientation, self);
      },
      [](PointerTarget& self, const Eigen::Vector4d& xyzw) { self.orientation = Quaternion(xyzw); },
      "[-] Of the sample, at 3 rad/s at most: unit quaternion (x, y, z, w), shape (4,); a view.");
  target.def_readwrite("rigid", &PointerTarget::rigid,
                       "The rigid body that the goal is of, and where it is now; -1: of none.");
  def_vector(target, "rigid_position", &PointerTarget::rigid_position,
             "[m] of its frame, shape (3,).");
  target.def_property(
      "rigid_orientation",
      [](const py::object& self) {
        return view_one(self.cast<PointerTarget&>().rigid_orientation, self);
      },
      [](PointerTarget& self, const Eigen::Vector4d& xyzw) {
        self.rigid_orientation = Quaternion(xyzw);
      },
      "[-] Of its frame: unit quaternion (x, y, z, w), shape (4,); a view.");
  def_value(target, &PointerTarget::time, &PointerTarget::goal, &PointerTarget::depth,
            &PointerTarget::path, &PointerTarget::pressing, &PointerTarget::buttons,
            &PointerTarget::orientation, &PointerTarget::rigid, &PointerTarget::rigid_position,
            &PointerTarget::rigid_orientation);
  def_repr(target,
           {"time", "goal", "depth", "path", "pressing", "buttons", "orientation", "rigid"});

  py::class_<SurfacePointer, HapticDevice>(
      m, "SurfacePointer",
      "A hand that a window moves over a surface: post() from one thread, read() from the haptic "
      "thread, which moves the hand. How often the window finds time to post makes no difference "
      "to what is felt: the hand goes over the surfaces of bodies and scenery at rest, and of the "
      "rigid body that a target names, at 250 mm/s at most and into them at 50 mm/s, and a press "
      "that was over before it was heard of lasts as long as the window says.")
      .def(py::init([](const Scene& scene, int body, int instrument) {
             require_built(scene);
             require_index("body", body, scene.bodies.size());
             require_index("instrument", instrument, scene.instruments.size());
             return std::make_unique<SurfacePointer>(scene, body, instrument);
           }),
           "scene"_a, "body"_a = 0, "instrument"_a = 0,
           "Surfaces and tool are those of a scene; the hand begins over a body.")
      .def("post", &SurfacePointer::post, "target"_a,
           "One calling thread. Raises ValueError for a number that is not finite, an orientation "
           "not of norm 1 and a rigid body that the scene does not have.");
}

void bind_scene_surfaces(py::module_& m) {
  py::native_enum<ScenePart>(m, "ScenePart", "enum.Enum", "What of a scene a surface is of.")
      .value("body", ScenePart::body, "Of Scene.bodies.")
      .value("scenery", ScenePart::scenery, "Of Scene.scenery.")
      .value("rigid", ScenePart::rigid, "Of Scene.rigid.")
      .finalize();

  py::class_<ScenePoint> point(m, "ScenePoint", "A point of a surface of a scene.");
  point.def_readonly("part", &ScenePoint::part, "What it is of.")
      .def_readonly("index", &ScenePoint::index, "Of that kind.")
      .def_readonly("triangle", &ScenePoint::triangle, "Row of its surface.")
      .def_readonly("distance", &ScenePoint::distance, "[m] from where the query began.");
  def_vector(point, "point", &ScenePoint::point, "[m] shape (3,).");
  def_vector(point, "normal", &ScenePoint::normal, "[-] Unit, smooth, outward, shape (3,).");
  def_value(point, &ScenePoint::part, &ScenePoint::index, &ScenePoint::triangle, &ScenePoint::point,
            &ScenePoint::normal, &ScenePoint::distance);
  def_repr(point, {"part", "index", "triangle", "point", "normal", "distance"});

  py::class_<SceneSurfaces>(m, "SceneSurfaces",
                            "All that a hand may meet in a scene: bodies and scenery at rest, and "
                            "rigid bodies where they "
                            "were placed last, at first where the scene has them.")
      .def(py::init([](const Scene& scene) {
             require_built(scene);
             return std::make_unique<SceneSurfaces>(scene);
           }),
           "scene"_a, "The scene need not outlive it.")
      .def(
          "place_rigid",
          [](SceneSurfaces& self, int index, const Vec3& position, const Eigen::Vector4d& xyzw) {
            require_index("index", index, self.rigid_count());
            require_finite("position", position);
            if (!(std::abs(xyzw.norm() - 1.0) < 1e-6)) {
              refuse("orientation", write_text("a quaternion of norm ", xyzw.norm()), "a unit one");
            }
            self.place_rigid(static_cast<std::size_t>(index), position, Quaternion(xyzw));
          },
          "index"_a, "position"_a, "orientation"_a,
          "Where a rigid body is now. Raises ValueError.\n\nArgs:\n"
          "    index: Of the scene's rigid bodies.\n"
          "    position: [m] shape (3,).\n"
          "    orientation: [-] a unit quaternion, shape (4,): x, y, z, w.")
      .def("rigid_count", &SceneSurfaces::rigid_count, "How many rigid bodies there are.")
      .def(
          "find_ray_hit",
          [](const SceneSurfaces& self, const Vec3& origin, const Vec3& direction) {
            require_finite("origin", origin);
            require_finite("direction", direction);
            if (direction.isZero(0.0)) refuse("direction", "(0, 0, 0)", "any other");
            return self.find_ray_hit(origin, direction);
          },
          "origin"_a, "direction"_a,
          "The first surface along a ray; None where the ray meets that from inside, as nothing "
          "behind it is in sight.")
      .def(
          "find_closest_point",
          [](const SceneSurfaces& self, const Vec3& p, int rigid) {
            require_finite("p", p);
            if (rigid != -1) require_index("rigid", rigid, self.rigid_count());
            return self.find_closest_point(p, rigid);
          },
          "p"_a, "rigid"_a = -1,
          "The nearest point of bodies, scenery and one rigid body, or none of them for -1.");
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
  bind_device_dynamics(m);
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
      .def("dynamics", &HapticDevice::dynamics,
           "What it declares of itself. Asked for at the start of a run, not while it is on.")
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
  bind_fulcrum_device(m);
  bind_mailbox_device(m);
  bind_scene_surfaces(m);
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

}  // namespace palpate::bindings
