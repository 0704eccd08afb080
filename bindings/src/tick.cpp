// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/tick.h"

#include <pybind11/stl.h>

#include "bindings.h"
#include "border.h"
#include "rows.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

template <>
py::dtype row_dtype<HapticSample>() {
  return RowType<HapticSample>()
      .field("time", &HapticSample::time)
      .field("position", &HapticSample::position)
      .field("orientation", &HapticSample::orientation)
      .field("velocity", &HapticSample::velocity)
      .field("buttons", &HapticSample::buttons)
      .field("grip", &HapticSample::grip)
      .dtype();
}

namespace {

void bind_sample(py::module_& m) {
  const HapticSample still;
  py::class_<HapticSample> sample(m, "HapticSample",
                                  "What a device says of the hand: six degrees of freedom in.");
  sample.def(
      py::init([](double time, const Vec3& position, const Eigen::Vector4d& orientation,
                  const Vec3& velocity, std::uint8_t buttons, double grip) {
        return HapticSample{time, position, to_quaternion(orientation), velocity, buttons, grip};
      }),
      py::kw_only(), "time"_a = still.time, "position"_a = still.position,
      "orientation"_a = Eigen::Vector4d(still.orientation.coeffs()), "velocity"_a = still.velocity,
      "buttons"_a = still.buttons, "grip"_a = still.grip);
  sample.def_readwrite("time", &HapticSample::time, "[s] since the run began.");
  def_vector(sample, "position", &HapticSample::position, "[m]");
  sample.def_property(
      "orientation",
      [](const py::object& self) { return view_one(self.cast<HapticSample&>().orientation, self); },
      [](HapticSample& self, const Eigen::Vector4d& xyzw) {
        self.orientation = to_quaternion(xyzw);
      },
      "[-] Unit quaternion (x, y, z, w), shape (4,); a view.");
  def_vector(sample, "velocity", &HapticSample::velocity, "[m/s]");
  sample
      .def_readwrite("buttons", &HapticSample::buttons,
                     "Bit 0: attach while held; of a tool with jaws, close them.")
      .def_readwrite("grip", &HapticSample::grip,
                     "[rad] by which a grip axis has closed each jaw, 0: open.");
  sample.attr("dtype") = row_dtype<HapticSample>();
  def_value(sample, &HapticSample::time, &HapticSample::position, &HapticSample::orientation,
            &HapticSample::velocity, &HapticSample::buttons, &HapticSample::grip);
  def_repr(sample, {"time", "position", "orientation", "velocity", "buttons", "grip"});
  m.attr("ATTACH_BUTTON") = kAttachButton;

  py::class_<HapticCommand> command(
      m, "HapticCommand",
      "What the device shall make the hand feel: three degrees of freedom out.");
  command.def(py::init([](const Vec3& force) { return HapticCommand{force}; }),
              "force"_a = Vec3::Zero().eval());
  def_vector(command, "force", &HapticCommand::force, "[N]");
  def_value(command, &HapticCommand::force);
  def_repr(command, {"force"});
}

void bind_surface(py::module_& m) {
  m.def(
      "surface_position",
      [](const py::object& body) {
        const std::span<const Vec3> surface = surface_position(body.cast<const SoftState&>());
        // shown read-only, so nothing is written through it
        return read_only(view_entries(const_cast<Vec3*>(surface.data()), surface.size(), body));
      },
      "body"_a,
      "[m] The vertices of the surface, shape (n, 3): the skin's, or the particles where there is "
      "none; a view, "
      "read-only.");
}

void bind_tick_functions(py::module_& m) {
  m.def(
      "tick",
      [](const Scene& scene, const HapticSample& sample, double dt, World& world) {
        require_positive("dt", dt);
        require_fit(scene, world);
        require_count("sample", 1, scene.instruments.size());
        const py::gil_scoped_release released;
        return tick(scene, sample, dt, world);
      },
      "scene"_a, "sample"_a, "dt"_a, "world"_a,
      "One haptic tick of dt [s]: from where the hand is to the force it must feel, the mean over "
      "the substeps. The live loop, the replay of a record and the tests all call this function.");
  m.def(
      "tick",
      [](const Scene& scene, const std::vector<HapticSample>& samples, double dt, World& world) {
        require_positive("dt", dt);
        require_fit(scene, world);
        require_count("samples", samples.size(), scene.instruments.size());
        std::vector<HapticCommand> commands(samples.size());
        const py::gil_scoped_release released;
        tick(scene, samples, dt, world, commands);
        return commands;
      },
      "scene"_a, "samples"_a, "dt"_a, "world"_a,
      "One haptic tick with a sample and a command for each instrument.");
  m.def(
      "compute_felt",
      [](const HapticCommand& command, const World& world, int instrument) {
        require_index("instrument", instrument, world.instruments.size());
        return compute_felt(command, world, static_cast<std::size_t>(instrument));
      },
      "command"_a, "world"_a, "instrument"_a = 0,
      "What a record keeps of a tick, lateness left at 0; command is that of the instrument.");
  m.def(
      "measure_costs",
      [](const Scene& scene, const std::vector<HapticSample>& samples) {
        require_built(scene);
        const py::gil_scoped_release released;
        return measure_costs(scene, samples);
      },
      "scene"_a, "samples"_a,
      "Runs a scene as fast as the machine can, in the calling thread, from rest through samples: "
      "for every tick one of each instrument. An alarm ends it. Raises ValueError for samples that "
      "are not some of each instrument.");
  m.def("compute_hash", &compute_hash, "world"_a,
        "128 bits over positions, velocities and the tool: equal worlds, equal hashes.");
  m.def(
      "place_tool",
      [](const AabbTree& tree, const Numbers& x, const Vec3& hand_position, double radius,
         ToolState& tool) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        return place_tool(tree, xs, hand_position, radius, tool);
      },
      "tree"_a, "x"_a, "hand_position"_a, "radius"_a, "tool"_a,
      "Puts a tool that is nowhere yet where the hand is, and returns whether it is in the scene. "
      "A hand that begins inside the tissue has no tool until it has come out, and as far as three "
      "quarters of the tool's radius [m].");
  m.def(
      "has_room",
      [](const AabbTree& tree, const Numbers& x, const Vec3& hand_position, double radius) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        return has_room(tree, xs, hand_position, radius);
      },
      "tree"_a, "x"_a, "hand_position"_a, "radius"_a, "Whether place_tool would put a tool there.");
  m.def(
      "has_room",
      [](const AabbTree& tree, const Numbers& x, const Vec3& hand_position, const Tool& tool,
         const Eigen::Vector4d& orientation, double jaw_angle) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        return has_room(tree, xs, hand_position, tool, to_quaternion(orientation), jaw_angle);
      },
      "tree"_a, "x"_a, "hand_position"_a, "tool"_a, "orientation"_a, "jaw_angle"_a = 0.0,
      "The same for a tool of any shape that is held so, with jaws open by jaw_angle [rad].");
  m.def(
      "compute_winding_number",
      [](const Integers& triangles, const Numbers& x, const Vec3& p) {
        const auto rows = copy_index_rows<3>(triangles, "triangles");
        const auto xs = points(x, "x");
        require_triangles(rows, xs.size());
        return compute_winding_number(rows, xs, p);
      },
      "triangles"_a, "x"_a, "p"_a,
      "[-] How often the surface goes round p: 1 inside of a closed surface, 0 outside, and for an "
      "open one the share of all directions from p that it covers.");
}

}  // namespace

void bind_tick(py::module_& m) {
  bind_sample(m);
  bind_log(m);
  bind_costs(m);
  bind_scene(m);
  bind_surface(m);
  bind_tick_functions(m);
  bind_devices(m);
  bind_arm(m);
  bind_plant(m);
  bind_serial(m);
  bind_task(m);
  bind_multirate(m);
  bind_loop(m);
}

}  // namespace palpate::bindings
