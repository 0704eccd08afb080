// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/tick/world.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {
namespace {

void bind_kernel(py::module_& m) {
  py::native_enum<Kernel>(m, "Kernel", "enum.Enum", "Which form of the tissue's laws a tick runs.")
      .value("reference", Kernel::reference, "Double, plain, one particle after the other.")
      .value("packed", Kernel::packed, "Float, in vector code.")
      .value("response", Kernel::response,
             "Of a linear solid: quasi-static, from its precomputed response.")
      .value("automatic", Kernel::automatic,
             "build_scene chooses the fastest of these that the body's integrator has.")
      .finalize();
}

void bind_body_fields(py::class_<SoftBody>& body) {
  body.def_property(
      "tissue", [](SoftBody& self) -> TissueModel& { return self.tissue; },
      [](SoftBody& self, const TissueModel& value) {
        // a second tissue would take the memory away under the views of the first
        if (!self.tissue.rest_position.empty()) {
          refuse("soft body: tissue", "one that has its tissue", "a new SoftBody for another one");
        }
        self.tissue = value;
      },
      "The tissue; assigned, and copied, once.");
  body.def_readwrite("substeps", &SoftBody::substeps,
                     "Steps per tick without contact; build_scene chooses when 0.")
      .def_readwrite("substeps_max", &SoftBody::substeps_max,
                     "Contact may raise them to this; build_scene chooses when 0.")
      .def_readwrite("force_error", &SoftBody::force_error,
                     "[N] by which the force may be wrong so that what is at rest may sleep, under "
                     "the packed kernel; 0: the tissue moves until it is at rest to the last bit.")
      .def_readwrite("kernel", &SoftBody::kernel,
                     "Which form of the tissue's laws a tick runs; packed is reference where "
                     "there is no vector code for this machine.")
      .def_readwrite("integrator", &SoftBody::integrator,
                     "How a step goes from one moment to the next; any but symplectic_euler under "
                     "the reference kernel only. An implicit one allocates in every step, and what "
                     "cannot be solved is an alarm.")
      .def_readwrite("iterations", &SoftBody::iterations,
                     "Of xpbd and projective_dynamics in every step; build_scene chooses when 0, "
                     "and refuses any for another integrator.")
      .def_readwrite("simd_target", &SoftBody::simd_target,
                     "Of the packed kernel: one of simd_targets(), empty for the best.")
      .def_readwrite("contact_modulus", &SoftBody::contact_modulus,
                     "[Pa] E / (1 - nu²) of a solid organ: balls are felt as on such tissue, "
                     "whatever the size of its triangles; 0: by the hard law alone.")
      .def_readwrite("contact_facets", &SoftBody::contact_facets,
                     "Of a solid with a contact_modulus: a ball feels how curved the facets under "
                     "it are; else as curved as vertices are on the mean.")
      .def_readwrite("tied_holds", &SoftBody::tied_holds,
                     "Of a body with a contact_modulus: what a tool holds gives way as tissue does "
                     "under it; else as the mesh does where it is fastened.")
      .def_readwrite("tear_stretch", &SoftBody::tear_stretch,
                     "[-] What an instrument holds tears where it is longer than so many times its "
                     "length at rest for 5 ms, and its force fades over 50 ms [contact: tear]. 0: "
                     "nothing tears; else 1.01 to 10, of springs and bonds.")
      .def_readwrite("may_fold", &SoftBody::may_fold,
                     "Parts of its surface may touch others of it: build_scene adds a BodyPair of "
                     "it with itself.")
      .def_readwrite("weightless", &SoftBody::weightless,
                     "Gravity does not act on it: its rest shape is the one that it has under its "
                     "weight, as of an organ that was scanned as it lies.")
      .def_property(
          "far_compliance",
          [](const SoftBody& self) {
            return read_only(own(std::vector<Symmetric>(self.far_compliance)));
          },
          [](SoftBody& self, const Numbers& value) {
            self.far_compliance = copy_tensors(value, "far_compliance");
          },
          "[m/N] per vertex of the surface, shape (n, 6): how much more the body gives "
          "way than a half space, solved on a finer mesh than this; empty: that of this "
          "mesh, found by build_scene. Reads as a read-only copy: assign a new array to "
          "change it.");
  def_table(body, "rest_areas", &SoftBody::rest_areas,
            "[m²] per triangle, shape (t,), filled in by build_scene; a view, read-only.");
  body.def_readonly("spectrum_stiffness", &SoftBody::spectrum_stiffness,
                    "[1/s²] largest eigenvalue of M⁻¹K at rest, filled in by build_scene.")
      .def_readonly("spectrum_damping", &SoftBody::spectrum_damping,
                    "[1/s] of M⁻¹C, filled in by build_scene.")
      .def_readonly("least_damping_time", &SoftBody::least_damping_time,
                    "[s] of C over K, filled in by build_scene for an integrator that needs it.")
      .def_readonly("damped_limit", &SoftBody::damped_limit,
                    "[s] the step up to which symplectic Euler with implicit damping is stable at "
                    "rest, filled in by build_scene for that integrator; else 0.")
      .def_property_readonly(
          "response",
          // Python knows no const; everything of a Response is read-only
          [](const SoftBody& self) { return std::const_pointer_cast<Response>(self.response); },
          "Under the response kernel, filled in by build_scene; else None.")
      .def_property_readonly(
          "near_field",
          [](const SoftBody& self) { return std::const_pointer_cast<NearField>(self.near_field); },
          "With a contact_modulus, filled in by build_scene; else None.");
}

std::string describe_body(const SoftBody& body) {
  const char* kernels[] = {"reference", "packed", "response", "automatic"};
  return write_text(
      body.tissue.rest_position.size(), " particles, ", body.tissue.triangles.size(),
      " triangles, ", kernels[static_cast<int>(body.kernel)], " kernel, ",
      body.substeps > 0 ? write_text(body.substeps, " substeps") : std::string("not built"));
}

void bind_body(py::module_& m) {
  const SoftBody usual;
  py::class_<SoftBody> body(m, "SoftBody", "A tissue and how it is moved.");
  body.def(py::init([](const TissueModel* tissue, int substeps, int substeps_max,
                       double force_error, Kernel kernel, Integrator integrator,
                       const std::string& simd_target, double contact_modulus, int iterations,
                       const Numbers& far_compliance, bool contact_facets, bool tied_holds,
                       bool may_fold, bool weightless, double tear_stretch) {
             SoftBody made;
             if (tissue) made.tissue = *tissue;
             made.substeps = substeps;
             made.substeps_max = substeps_max;
             made.force_error = force_error;
             made.kernel = kernel;
             made.integrator = integrator;
             made.simd_target = simd_target;
             made.contact_modulus = contact_modulus;
             made.iterations = iterations;
             made.far_compliance = copy_tensors(far_compliance, "far_compliance");
             made.contact_facets = contact_facets;
             made.tied_holds = tied_holds;
             made.may_fold = may_fold;
             made.weightless = weightless;
             made.tear_stretch = tear_stretch;
             return made;
           }),
           py::kw_only(), "tissue"_a = py::none(), "substeps"_a = usual.substeps,
           "substeps_max"_a = usual.substeps_max, "force_error"_a = usual.force_error,
           "kernel"_a = usual.kernel, "integrator"_a = usual.integrator,
           "simd_target"_a = usual.simd_target, "contact_modulus"_a = usual.contact_modulus,
           "iterations"_a = usual.iterations, "far_compliance"_a = py::tuple(),
           "contact_facets"_a = usual.contact_facets, "tied_holds"_a = usual.tied_holds,
           "may_fold"_a = usual.may_fold, "weightless"_a = usual.weightless,
           "tear_stretch"_a = usual.tear_stretch, "Copies its tissue.");
  bind_body_fields(body);
  def_value(body, &SoftBody::tissue, &SoftBody::substeps, &SoftBody::substeps_max,
            &SoftBody::force_error, &SoftBody::kernel, &SoftBody::integrator,
            &SoftBody::simd_target, &SoftBody::contact_modulus, &SoftBody::iterations,
            &SoftBody::far_compliance, &SoftBody::contact_facets, &SoftBody::tied_holds,
            &SoftBody::may_fold, &SoftBody::weightless, &SoftBody::tear_stretch);
  def_summary(body, &describe_body);
}

void bind_body_pair(py::module_& m) {
  const BodyPair usual;
  py::class_<BodyPair> pair(m, "BodyPair",
                            "Two bodies that may touch, or one that touches itself where it folds, "
                            "and the barrier between their surfaces. Bodies in no common pair pass "
                            "through each other.");
  pair.def(py::init([](int first, int second, double thickness, double stiffness, double damping,
                       double friction) {
             return BodyPair{first, second, thickness, stiffness, damping, friction};
           }),
           "first"_a = usual.first, "second"_a = usual.second, py::kw_only(),
           "thickness"_a = usual.thickness, "stiffness"_a = usual.stiffness,
           "damping"_a = usual.damping, "friction"_a = usual.friction);
  pair.def_readonly("first", &BodyPair::first, "Of Scene.bodies.")
      .def_readonly("second", &BodyPair::second, "Another one; the same for a body that may fold.")
      .def_readonly("thickness", &BodyPair::thickness,
                    "[m] nearer than this, surfaces push each other; build_scene chooses 0.3 to "
                    "0.5 mm when 0.")
      .def_readonly("stiffness", &BodyPair::stiffness,
                    "[N/m³] the pressure over the depth in that thickness; build_scene chooses "
                    "E / (3 thickness) when 0, E of the stiffer body.")
      .def_readonly("damping", &BodyPair::damping,
                    "[-] of critical, of the vertices that touch; 0 to 1.")
      .def_readonly("friction", &BodyPair::friction,
                    "[-] Coulomb's coefficient between the surfaces; 0: they slide.");
  def_value(pair, &BodyPair::first, &BodyPair::second, &BodyPair::thickness, &BodyPair::stiffness,
            &BodyPair::damping, &BodyPair::friction);
  def_repr(pair, {"first", "second", "thickness", "stiffness", "damping", "friction"});
}

void bind_instrument(py::module_& m) {
  const Instrument usual;
  py::class_<Instrument> instrument(m, "Instrument",
                                    "A tool, and how the hand that moves it is coupled to it.");
  instrument.def(
      py::init([](const Tool& tool, const Coupling& coupling, double hold_stiffness,
                  const std::optional<Vec3>& trocar, const std::vector<double>& pair_friction) {
        return Instrument{tool, coupling, hold_stiffness, trocar, pair_friction};
      }),
      py::kw_only(), "tool"_a = usual.tool, "coupling"_a = usual.coupling,
      "hold_stiffness"_a = usual.hold_stiffness, "trocar"_a = py::none(),
      "pair_friction"_a = usual.pair_friction);
  instrument.def_readwrite("tool", &Instrument::tool, "The tip.")
      .def_readwrite("coupling", &Instrument::coupling, "The hand's spring.")
      .def_readwrite("hold_stiffness", &Instrument::hold_stiffness,
                     "[N/m] between tool and patch while attached.")
      .def_property(
          "trocar", [](const Instrument& self) { return self.trocar; },
          [](Instrument& self, const std::optional<Vec3>& trocar) { self.trocar = trocar; },
          "[m] shape (3,): where the shaft, which goes along the tool's z to the hand, passes the "
          "abdominal wall: z points there from the tool's position, and only the roll is the "
          "device's. None: the device turns the tool. A copy.")
      .def_readwrite("pair_friction", &Instrument::pair_friction,
                     "[-] Coulomb's coefficient of the tool with each surface of the scene: "
                     "bodies, then scenery, then rigid bodies, in place of tool.friction; empty: "
                     "that with all. Where that is 0, nothing rubs. Assign the whole list.");
  def_value(instrument, &Instrument::tool, &Instrument::coupling, &Instrument::hold_stiffness,
            &Instrument::trocar, &Instrument::pair_friction);
  def_repr(instrument, {"tool", "coupling", "hold_stiffness", "trocar", "pair_friction"});
}

/// What it is made of, and whether build_scene has filled in what follows from that.
void def_scene_pickle(py::class_<Scene>& scene) {
  scene.def(py::pickle(
      [](const Scene& self) {
        return py::make_tuple(self.bodies, self.instruments, self.gravity, self.rate,
                              is_built(self), self.rigid, self.scenery, self.exchange_rate,
                              self.body_pairs, self.fluid);
      },
      [](const py::tuple& packed) {
        if (packed.size() != 10) {
          refuse("pickle", std::to_string(packed.size()) + " members", "10, as this version has");
        }
        Scene made;
        made.bodies = packed[0].cast<std::vector<SoftBody>>();
        made.instruments = packed[1].cast<std::vector<Instrument>>();
        made.gravity = packed[2].cast<Vec3>();
        made.rate = packed[3].cast<double>();
        made.rigid = packed[5].cast<std::vector<RigidBody>>();
        made.scenery = packed[6].cast<std::vector<Scenery>>();
        made.exchange_rate = packed[7].cast<double>();
        made.body_pairs = packed[8].cast<std::vector<BodyPair>>();
        made.fluid = packed[9].cast<Fluid>();
        return packed[4].cast<bool>() ? build_scene(std::move(made)) : made;
      }));
}

std::string describe_scene(const Scene& scene) {
  std::string text;
  for (const SoftBody& body : scene.bodies) text += describe_body(body) + ", ";
  for (const Instrument& instrument : scene.instruments) {
    text += write_text("tool of ", 1e3 * instrument.tool.radius, " mm, ");
  }
  return text + write_text(scene.rate, " Hz");
}

void bind_scene_type(py::module_& m) {
  const Scene usual;
  py::class_<Scene> scene(m, "Scene",
                          "Tissues and the instruments that touch them: all that a tick needs and "
                          "never changes. Each instrument has a hand of its own.");
  scene.def(py::init([](std::vector<SoftBody> bodies, std::vector<Instrument> instruments,
                        const Vec3& gravity, double rate, std::vector<RigidBody> rigid,
                        std::vector<Scenery> scenery, double exchange_rate,
                        std::vector<BodyPair> body_pairs, const Fluid& fluid) {
              Scene made;
              made.rigid = std::move(rigid);
              made.scenery = std::move(scenery);
              made.bodies = std::move(bodies);
              made.instruments = std::move(instruments);
              made.gravity = gravity;
              made.rate = rate;
              made.exchange_rate = exchange_rate;
              made.body_pairs = std::move(body_pairs);
              made.fluid = fluid;
              return made;
            }),
            py::kw_only(), "bodies"_a = usual.bodies, "instruments"_a = usual.instruments,
            "gravity"_a = usual.gravity, "rate"_a = usual.rate, "rigid"_a = usual.rigid,
            "scenery"_a = usual.scenery, "exchange_rate"_a = usual.exchange_rate,
            "body_pairs"_a = usual.body_pairs, "fluid"_a = usual.fluid,
            "Copies its parts: one body and one instrument unless others are given. build_scene "
            "makes it ready for ticks.");
  def_elements(scene, "bodies", &Scene::bodies, "The tissues, a tuple.");
  def_elements(scene, "rigid", &Scene::rigid, "What moves and keeps its shape, a tuple.");
  def_elements(scene, "scenery", &Scene::scenery, "What never moves, a tuple.");
  def_elements(scene, "instruments", &Scene::instruments, "A tuple; each has a hand of its own.");
  def_elements(scene, "body_pairs", &Scene::body_pairs,
               "Which bodies may touch each other, a tuple; each pair once.");
  scene.def_readwrite("fluid", &Scene::fluid, "What the rigid bodies are in.");
  def_vector(scene, "gravity", &Scene::gravity, "[m/s²]");
  scene.def_readwrite("rate", &Scene::rate, "[Hz]")
      .def_readwrite("exchange_rate", &Scene::exchange_rate,
                     "[Hz] 0: the live loop ticks the tissue with the hands. Else the tissue ticks "
                     "in a thread of its own, is told where the hands are so often, and is felt "
                     "between by its local stiffness. tick() knows nothing of it.");
  def_copy(scene);
  def_scene_pickle(scene);
  def_summary(scene, &describe_scene);
  m.def("make_scene", &make_scene, "tissue"_a,
        "A scene of one tissue, which is copied, and one instrument with the usual values.");
  m.def("build_scene", &build_scene, "scene"_a, py::call_guard<py::gil_scoped_release>(),
        "Checks a scene once and fills in what is derived from it. Raises ValueError naming the "
        "field, what it got and what was expected.");
}

}  // namespace

void bind_scene(py::module_& m) {
  bind_kernel(m);
  bind_body(m);
  bind_body_pair(m);
  bind_rigid(m);
  bind_instrument(m);
  bind_scene_type(m);
  bind_world(m);
}

}  // namespace palpate::bindings
