// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "bindings.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/tick/world.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {
namespace {

template <class Class, class Of>
void def_orientation(Class& cls, Quaternion Of::*member, const char* doc) {
  cls.def_property_readonly(
      "orientation",
      [member](const py::object& self) {
        return view_one(self.cast<typename Class::type&>().*member, self);
      },
      doc);
}

RigidBody make_rigid(const Numbers& sphere_centres, const Numbers& sphere_radii, double mass,
                     const Vec3& inertia, const Vec3& position, const Eigen::Vector4d& orientation,
                     const SurfaceMesh& mesh, double friction, double stiffness,
                     double contact_stiffness) {
  RigidBody made;
  made.sphere_centres = copy_points(sphere_centres, "sphere_centres");
  made.sphere_radii = copy_numbers(sphere_radii, "sphere_radii");
  made.mass = mass;
  made.inertia = inertia;
  made.position = position;
  made.orientation = Quaternion(orientation.data());
  made.mesh = mesh;
  made.friction = friction;
  made.stiffness = stiffness;
  made.contact_stiffness = contact_stiffness;
  return made;
}

void bind_rigid_body(py::module_& m) {
  const RigidBody usual;
  py::class_<RigidBody> body(
      m, "RigidBody",
      "What moves and keeps its shape, a stone for one. Instruments touch its mesh; tissues, "
      "scenery and other rigid bodies its spheres, which lie in that.");
  body.def(py::init(&make_rigid), "sphere_centres"_a, "sphere_radii"_a, py::kw_only(),
           "mass"_a = usual.mass, "inertia"_a = usual.inertia, "position"_a = usual.position,
           "orientation"_a = Eigen::Vector4d(usual.orientation.coeffs()), "mesh"_a = usual.mesh,
           "friction"_a = usual.friction, "stiffness"_a = usual.stiffness,
           "contact_stiffness"_a = usual.contact_stiffness, "Copies what it is given.");
  body.def_readonly("mesh", &RigidBody::mesh,
                    "[m] in its own frame; build_scene makes that of the spheres if empty.");
  def_view(body, "sphere_centres", &RigidBody::sphere_centres,
           "[m] in its own frame, whose origin is its centre of mass, shape (k, 3); a view.");
  def_table(body, "sphere_radii", &RigidBody::sphere_radii, "[m] shape (k,); a view.");
  body.def_readwrite("mass", &RigidBody::mass, "[kg]");
  def_vector(body, "inertia", &RigidBody::inertia, "[kg m²] about the axes of its frame.");
  def_vector(body, "position", &RigidBody::position, "[m] of its frame, at the start.");
  def_orientation(
      body, &RigidBody::orientation,
      "[-] of its frame, at the start: unit quaternion (x, y, z, w), shape (4,); a view.");
  body.def_readwrite("friction", &RigidBody::friction,
                     "[-] Coulomb's coefficient on tissue, scenery and other rigid bodies; "
                     "instruments have their own.")
      .def_readwrite("stiffness", &RigidBody::stiffness, "[N/m³] of its spheres on tissue.")
      .def_readwrite("contact_stiffness", &RigidBody::contact_stiffness,
                     "[N/m] of each sphere on what is hard, and of instruments.");
  def_value(body, &RigidBody::sphere_centres, &RigidBody::sphere_radii, &RigidBody::mass,
            &RigidBody::inertia, &RigidBody::position, &RigidBody::orientation, &RigidBody::mesh,
            &RigidBody::friction, &RigidBody::stiffness, &RigidBody::contact_stiffness);
  def_repr(body, {"mass", "inertia", "position", "orientation", "friction"});
}

void bind_rigid_state(py::module_& m) {
  py::class_<RigidState> state(m, "RigidState",
                               "Where a rigid body is and how it moves, after every tick.");
  state.def(py::init<>());
  def_vector(state, "position", &RigidState::position, "[m] of its frame.");
  def_orientation(state, &RigidState::orientation,
                  "[-] of its frame: unit quaternion (x, y, z, w), shape (4,); a view.");
  def_vector(state, "velocity", &RigidState::velocity, "[m/s]");
  def_vector(state, "angular_velocity", &RigidState::angular_velocity, "[rad/s]");
  def_vector(state, "tissue_force", &RigidState::tissue_force,
             "[N] that all tissues push it with, mean of the last tick.");
  def_vector(state, "instrument_force", &RigidState::instrument_force,
             "[N] that all instruments push it with, mean of the last tick.");
  def_value(state, &RigidState::position, &RigidState::orientation, &RigidState::velocity,
            &RigidState::angular_velocity, &RigidState::tissue_force,
            &RigidState::instrument_force);
  def_repr(state, {"position", "orientation", "velocity", "angular_velocity"});
}

void bind_fluid(py::module_& m) {
  const Fluid usual;
  py::class_<Fluid> fluid(
      m, "Fluid", "What rigid bodies are in where nothing else is: water that irrigates, for one.");
  fluid.def(py::init([](double density, double viscosity) {
              return Fluid{density, viscosity};
            }),
            "density"_a = usual.density, "viscosity"_a = usual.viscosity);
  fluid.def_readwrite("density", &Fluid::density, "[kg/m³] of buoyancy and drag; 0: none.")
      .def_readwrite("viscosity", &Fluid::viscosity, "[Pa s] of drag.");
  def_value(fluid, &Fluid::density, &Fluid::viscosity);
  def_repr(fluid, {"density", "viscosity"});
}

void bind_scenery(py::module_& m) {
  py::class_<Scenery> scenery(m, "Scenery",
                              "What never moves, a bone or a table for one. Neither instruments "
                              "pass it, nor the bodies that it lists.");
  scenery.def(py::init([](const SurfaceMesh& mesh, const Integers& bodies, double friction) {
                return Scenery{mesh, copy_indices(bodies, "bodies"), friction};
              }),
              "mesh"_a, "bodies"_a = std::vector<int>(), py::kw_only(), "friction"_a = 0.0,
              "Copies its mesh.");
  scenery.def_readonly("mesh", &Scenery::mesh, "[m] in the scene's frame; read-only.");
  def_table(scenery, "bodies", &Scenery::bodies,
            "Of Scene.bodies: those that stop at it; others pass through. Shape (k,), a view.");
  scenery.def_readwrite("friction", &Scenery::friction,
                        "[-] Coulomb's coefficient of these on it; 0: they slide.");
  def_value(scenery, &Scenery::mesh, &Scenery::bodies, &Scenery::friction);
  def_summary(scenery, [](const Scenery& self) {
    return write_text(self.mesh.triangles.size(), " triangles");
  });

  py::class_<SceneryContact> contact(
      m, "SceneryContact", "How a body of a running scene stops at a scenery, after every tick.");
  contact.def(py::init<>());
  contact.def_readonly("scenery", &SceneryContact::scenery, "Of Scene.scenery.")
      .def_readonly("body", &SceneryContact::body, "Of Scene.bodies.")
      .def_readonly("near", &SceneryContact::near, "Some of their surfaces may come to touch.")
      .def_readonly("touching", &SceneryContact::touching,
                    "Vertices on it, in the body's last step.");
  def_vector(contact, "force", &SceneryContact::force, "[N] on the body, mean of the last tick.");
  def_value(contact, &SceneryContact::scenery, &SceneryContact::body, &SceneryContact::near,
            &SceneryContact::touching, &SceneryContact::force);
  def_repr(contact, {"scenery", "body", "near", "touching", "force"});
}

}  // namespace

void bind_rigid(py::module_& m) {
  bind_rigid_body(m);
  bind_rigid_state(m);
  bind_fluid(m);
  bind_scenery(m);
}

}  // namespace palpate::bindings
