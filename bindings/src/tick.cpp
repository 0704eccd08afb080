// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/tick.h"

#include <pybind11/native_enum.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/tick/place_tool.h"
#include "rows.h"
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

Quaternion to_quaternion(const Eigen::Vector4d& xyzw) {
  return Quaternion(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
}

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
  sample.def_readwrite("buttons", &HapticSample::buttons, "Bit 0: attach while held.")
      .def_readwrite("grip", &HapticSample::grip, "[rad]");
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

void bind_scene_fields(py::class_<Scene>& scene) {
  scene.def_property(
      "tissue", [](Scene& self) -> TissueModel& { return self.tissue; },
      [](Scene& self, const TissueModel& value) {
        // a second tissue would take the memory away under the views of the first
        if (!self.tissue.rest_position.empty()) {
          refuse("scene.tissue", "a scene that has its tissue", "a new Scene for another one");
        }
        self.tissue = value;
      },
      "The tissue; assigned, and copied, once.");
  scene.def_readwrite("tool", &Scene::tool, "The tip of the instrument.")
      .def_readwrite("coupling", &Scene::coupling, "The hand's spring.")
      .def_readwrite("hold_stiffness", &Scene::hold_stiffness,
                     "[N/m] between tool and patch while attached.");
  def_vector(scene, "gravity", &Scene::gravity, "[m/s²]");
  scene.def_readwrite("rate", &Scene::rate, "[Hz]")
      .def_readwrite("substeps", &Scene::substeps,
                     "Tissue steps per tick without contact; build_scene chooses when 0.")
      .def_readwrite("substeps_max", &Scene::substeps_max,
                     "Contact may raise them to this; build_scene chooses when 0.")
      .def_readwrite("force_error", &Scene::force_error,
                     "[N] by which the force may be wrong so that what is at rest may sleep, under "
                     "the packed kernel; 0: all of the tissue moves in every substep.")
      .def_readwrite("kernel", &Scene::kernel,
                     "Which form of the tissue's laws a tick runs; packed is reference where "
                     "there is no vector code for this machine.")
      .def_readwrite("simd_target", &Scene::simd_target,
                     "Of the packed kernel: one of simd_targets(), empty for the best.");
  def_table(scene, "rest_areas", &Scene::rest_areas,
            "[m²] per triangle, shape (t,), filled in by build_scene; a view, read-only.");
  scene
      .def_readonly("spectrum_stiffness", &Scene::spectrum_stiffness,
                    "[1/s²] largest eigenvalue of M⁻¹K at rest, filled in by build_scene.")
      .def_readonly("spectrum_damping", &Scene::spectrum_damping,
                    "[1/s] of M⁻¹C, filled in by build_scene.")
      .def_property_readonly(
          "response",
          // Python knows no const; everything of a Response is read-only
          [](const Scene& self) { return std::const_pointer_cast<Response>(self.response); },
          "Under the response kernel, filled in by build_scene; else None.");
}

/// What it is made of, and whether build_scene has filled in what follows from that.
void def_scene_pickle(py::class_<Scene>& scene) {
  scene.def(py::pickle(
      [](const Scene& self) {
        const bool built =
            self.rest_areas.size() == self.tissue.triangles.size() && self.substeps > 0;
        return py::make_tuple(self.tissue, self.tool, self.coupling, self.hold_stiffness,
                              self.gravity, self.rate, self.substeps, self.substeps_max,
                              self.force_error, self.kernel, self.simd_target, built);
      },
      [](const py::tuple& packed) {
        if (packed.size() != 12) {
          refuse("pickle", std::to_string(packed.size()) + " members", "12, as this version has");
        }
        Scene made;
        made.tissue = packed[0].cast<TissueModel>();
        made.tool = packed[1].cast<Tool>();
        made.coupling = packed[2].cast<Coupling>();
        made.hold_stiffness = packed[3].cast<double>();
        made.gravity = packed[4].cast<Vec3>();
        made.rate = packed[5].cast<double>();
        made.substeps = packed[6].cast<int>();
        made.substeps_max = packed[7].cast<int>();
        made.force_error = packed[8].cast<double>();
        made.kernel = packed[9].cast<Kernel>();
        made.simd_target = packed[10].cast<std::string>();
        return packed[11].cast<bool>() ? build_scene(std::move(made)) : made;
      }));
}

std::string describe_scene(const Scene& scene) {
  const char* kernels[] = {"reference", "packed", "response"};
  return write_text(
      scene.tissue.rest_position.size(), " particles, ", scene.tissue.triangles.size(),
      " triangles, tool of ", 1e3 * scene.tool.radius, " mm, ", scene.rate, " Hz, ",
      kernels[static_cast<int>(scene.kernel)], " kernel, ",
      scene.substeps > 0 ? write_text(scene.substeps, " substeps") : std::string("not built"));
}

void bind_scene(py::module_& m) {
  py::native_enum<Kernel>(m, "Kernel", "enum.Enum", "Which form of the tissue's laws a tick runs.")
      .value("reference", Kernel::reference, "Double, plain, one particle after the other.")
      .value("packed", Kernel::packed, "Float, in vector code.")
      .value("response", Kernel::response,
             "Of a linear solid: quasi-static, from its precomputed response.")
      .finalize();
  const Scene usual;
  py::class_<Scene> scene(m, "Scene",
                          "A tissue, a tool, and how the hand is coupled to it: all that a tick "
                          "needs and never changes.");
  scene.def(py::init([](const TissueModel* tissue, const Tool& tool, const Coupling& coupling,
                        double hold_stiffness, const Vec3& gravity, double rate, int substeps,
                        int substeps_max, double force_error, Kernel kernel,
                        const std::string& simd_target) {
              Scene made;
              if (tissue) made.tissue = *tissue;
              made.tool = tool;
              made.coupling = coupling;
              made.hold_stiffness = hold_stiffness;
              made.gravity = gravity;
              made.rate = rate;
              made.substeps = substeps;
              made.substeps_max = substeps_max;
              made.force_error = force_error;
              made.kernel = kernel;
              made.simd_target = simd_target;
              return made;
            }),
            py::kw_only(), "tissue"_a = py::none(), "tool"_a = usual.tool,
            "coupling"_a = usual.coupling, "hold_stiffness"_a = usual.hold_stiffness,
            "gravity"_a = usual.gravity, "rate"_a = usual.rate, "substeps"_a = usual.substeps,
            "substeps_max"_a = usual.substeps_max, "force_error"_a = usual.force_error,
            "kernel"_a = usual.kernel, "simd_target"_a = usual.simd_target,
            "Copies its parts. build_scene makes it ready for ticks.");
  bind_scene_fields(scene);
  def_copy(scene);
  def_scene_pickle(scene);
  def_summary(scene, &describe_scene);
  m.def("build_scene", &build_scene, "scene"_a, py::call_guard<py::gil_scoped_release>(),
        "Checks a scene once and fills in what is derived from it. Raises ValueError naming the "
        "field, what it got and what was expected.");
}

void bind_world(py::module_& m) {
  py::class_<World> world(m, "World",
                          "A running scene. Everything a tick needs is allocated here, once.");
  world.def(py::init([](const Scene& scene) {
              require_built(scene);
              const py::gil_scoped_release released;
              return World(scene);
            }),
            "scene"_a, "The scene at rest.");
  world.def_readonly("tissue", &World::tissue, "The tissue after the last tick; read-only.")
      .def_readonly("tree", &World::tree, "The boxes around its surface; read-only.")
      .def_readonly("candidates", &World::candidates,
                    "What the tool may touch in this tick; read-only.")
      .def_readonly("tool", &World::tool, "Where the tool is; read-only.")
      .def_readonly("load", &World::load, "What the tool does to the tissue; read-only.")
      .def_readonly("guard", &World::guard, "The memory of the alarm; read-only.")
      .def_readonly("alarm", &World::alarm,
                    "The first alarm; from then on the force is zero and the tissue stands still.")
      .def_readonly("tick_count", &World::tick_count, "How many ticks have been run.")
      .def_readonly("substeps", &World::substeps, "Of the last tick.")
      .def_readonly("attach_pressed", &World::attach_pressed,
                    "Whether the attach button was, in the last tick.")
      .def_readonly("release_ticks", &World::release_ticks,
                    "Left until a hold that fades is gone; 0 when none does.");
  def_vector(world, "hand", &World::hand,
             "[m] where the tool is drawn to: the hand, unless that jumped.");
  def_view(world, "skin", &World::skin,
           "[m] the vertices of the skin, shape (n, 3), after every tick; empty where there is "
           "none; a view.");
  def_copy(world);
  def_summary(world, [](const World& self) {
    return write_text("tick ", self.tick_count, ", ", self.tissue.position.size(), " particles, ",
                      self.substeps, " substeps, ",
                      self.alarm           ? "stopped by an alarm"
                      : self.tool.touching ? "touching"
                                           : "not touching");
  });
}

void bind_surface(py::module_& m) {
  m.def(
      "surface_position",
      [](const py::object& world) {
        const std::span<const Vec3> surface = surface_position(world.cast<const World&>());
        // shown read-only, so nothing is written through it
        return read_only(view_entries(const_cast<Vec3*>(surface.data()), surface.size(), world));
      },
      "world"_a,
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
        const py::gil_scoped_release released;
        return tick(scene, sample, dt, world);
      },
      "scene"_a, "sample"_a, "dt"_a, "world"_a,
      "One haptic tick of dt [s]: from where the hand is to the force it must feel, the mean over "
      "the substeps. The live loop, the replay of a record and the tests all call this function.");
  m.def("compute_felt", &compute_felt, "command"_a, "world"_a,
        "What a record keeps of a tick, lateness left at 0.");
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
  bind_scene(m);
  bind_world(m);
  bind_surface(m);
  bind_tick_functions(m);
  bind_devices(m);
  bind_arm(m);
  bind_plant(m);
  bind_serial(m);
  bind_loop(m);
}

}  // namespace palpate::bindings
