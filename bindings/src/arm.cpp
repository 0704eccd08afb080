// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/arm/kinematics.h"
#include "palpate/sim/device/safe_device.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_arm_struct(py::module_& m) {
  const Arm usual;
  py::class_<Arm> arm(
      m, "Arm",
      "The arm of the low-cost device: two links in a plane that yaws about the upright axis, all "
      "three motors on the ground. Joints [rad]: yaw, positive to the right; elevation of the "
      "upper link; the forearm's own angle from straight down. Frame: x to the right, y away from "
      "the user, z up.");
  arm.def(py::init([](double upper_length, double forearm_length, double upper_weight,
                      double forearm_weight, const Vec3& joint_min, const Vec3& joint_max,
                      double bend_max) {
            return Arm{upper_length, forearm_length, upper_weight, forearm_weight,
                       joint_min,    joint_max,      bend_max};
          }),
          py::kw_only(), "upper_length"_a = usual.upper_length,
          "forearm_length"_a = usual.forearm_length, "upper_weight"_a = usual.upper_weight,
          "forearm_weight"_a = usual.forearm_weight, "joint_min"_a = usual.joint_min,
          "joint_max"_a = usual.joint_max, "bend_max"_a = usual.bend_max);
  arm.def_readwrite("upper_length", &Arm::upper_length, "[m]")
      .def_readwrite("forearm_length", &Arm::forearm_length, "[m]")
      .def_readwrite("upper_weight", &Arm::upper_weight,
                     "[N·m] that carries the arm when the upper link is level.")
      .def_readwrite("forearm_weight", &Arm::forearm_weight,
                     "[N·m] that carries it when the forearm is level.");
  def_vector(arm, "joint_min", &Arm::joint_min, "[rad]");
  def_vector(arm, "joint_max", &Arm::joint_max, "[rad]");
  arm.def_readwrite("bend_max", &Arm::bend_max,
                    "[rad] between upper link and forearm, 0 at a right angle.");
  def_value(arm, &Arm::upper_length, &Arm::forearm_length, &Arm::upper_weight, &Arm::forearm_weight,
            &Arm::joint_min, &Arm::joint_max, &Arm::bend_max);
  def_repr(arm, {"upper_length", "forearm_length", "upper_weight", "forearm_weight", "joint_min",
                 "joint_max", "bend_max"});

  const Workspace box;
  py::class_<Workspace> workspace(m, "Workspace", "A box that lies within the workspace.");
  workspace.def(py::init([](const Vec3& center, const Vec3& size) {
                  return Workspace{center, size};
                }),
                "center"_a = box.center, "size"_a = box.size);
  def_vector(workspace, "center", &Workspace::center, "[m] in the arm's frame.");
  def_vector(workspace, "size", &Workspace::size, "[m]");
  def_value(workspace, &Workspace::center, &Workspace::size);
  def_repr(workspace, {"center", "size"});
}

void bind_kinematics(py::module_& m) {
  m.def("validate", py::overload_cast<const Arm&>(&validate), "arm"_a,
        "Raises ValueError naming the field, what it got and what was expected.");
  m.def("compute_tip", &compute_tip, "arm"_a, "joints"_a, "Where the tip is [m], shape (3,).");
  m.def(
      "compute_stylus",
      [](const Vec3& joints, const Vec3& gimbal) {
        return Eigen::Vector4d(compute_stylus(joints, gimbal).coeffs());
      },
      "joints"_a, "gimbal"_a,
      "[-] How the stylus is held, a quaternion (x, y, z, w), shape (4,): three gimbal angles "
      "[rad] (yaw, pitch, "
      "roll) after yaw and forearm.");
  m.def("compute_jacobian", &compute_jacobian, "arm"_a, "joints"_a,
        "How the tip moves with the joints [m/rad], shape (3, 3), one column per joint.");
  m.def("find_joints", &find_joints, "arm"_a, "tip"_a,
        "The joints [rad], shape (3,), that bring the tip to a place [m]; None where it is out of "
        "reach or on the yaw "
        "axis. They may lie beyond the joints' limits: is_within tells.");
  m.def("is_within", &is_within, "arm"_a, "joints"_a,
        "Whether every joint is within its limits, and the links are bent enough to push every "
        "way.");
  m.def("compute_edge_fade", &compute_edge_fade, "arm"_a, "joints"_a,
        "[-] 1 in the workspace, fading to 0 over the last 3 degrees before its edge, 0 beyond.");
  m.def("compute_weight_torque", &compute_weight_torque, "arm"_a, "joints"_a,
        "The torques [N·m], shape (3,), that hold the arm up against its weight.");
  m.def("compute_torque", &compute_torque, "arm"_a, "joints"_a, "force"_a, "torque_max"_a,
        "The torques [N·m], shape (3,), that let the hand feel a force [N] while the arm's weight "
        "is carried, "
        "none beyond torque_max. Too large a force loses length, never direction.");
  m.def("compute_tip_force", &compute_tip_force, "arm"_a, "joints"_a, "torque"_a,
        "The inverse: what the hand feels of torques [N·m] when the arm rests. Needs a bent arm.");
}

void bind_velocity_window(py::module_& m) {
  py::class_<VelocityWindow> window(
      m, "VelocityWindow",
      "The speed of something that is known in steps, from a window that adapts itself: as many "
      "of the last readings as one straight line passes within a step of.");
  window
      .def(py::init<double, int>(), "step"_a, "longest"_a = 16,
           "step is how far apart two neighbouring readings are, in their unit; longest from 2 "
           "readings to LONGEST. Raises ValueError.")
      .def("add", &VelocityWindow::add, "time"_a, "value"_a,
           "Takes a reading at time [s] and returns its speed, per second; 0 for the first. The "
           "same "
           "time again is ignored, an earlier one starts again.")
      .def("speed", &VelocityWindow::speed,
           "[1/s] times the unit of the readings: the speed last found.")
      .def("length", &VelocityWindow::length, "How many readings the last speed came from.")
      .def("clear", &VelocityWindow::clear, "Forgets all readings.");
  window.attr("LONGEST") = VelocityWindow::kLongest;
  def_copy(window);
}

}  // namespace

void bind_arm(py::module_& m) {
  bind_arm_struct(m);
  bind_kinematics(m);
  bind_velocity_window(m);
}

}  // namespace palpate::bindings
