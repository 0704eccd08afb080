// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {

template <>
py::dtype row_dtype<Push>() {
  return RowType<Push>()
      .field("triangle", &Push::triangle)
      .field("weights", &Push::weights)
      .field("force", &Push::force)
      .dtype();
}

namespace {

void bind_state(py::module_& m) {
  py::class_<State> state(m, "State", "Everything about a tissue that changes from step to step.");
  state.def(py::init<const TissueModel&>(), "model"_a, "The tissue at rest, at time zero.");
  state.def_readwrite("time", &State::time, "[s]");
  def_view(state, "position", &State::position,
           "Particle positions [m], shape (n, 3); a view, so writing moves the particles.");
  def_view(state, "velocity", &State::velocity, "[m/s], shape (n, 3); a view.");
  def_view(state, "force", &State::force,
           "[N] of the last evaluation, loads included, shape (n, 3); a view.");
  def_view(state, "internal", &State::internal,
           "[-] or [m]: what laws with a memory keep, law by law, shape (k,); empty "
           "without one; a view.");
  def_value(state, &State::time, &State::position, &State::velocity, &State::force,
            &State::internal);
  def_summary(state, [](const State& self) {
    return write_text(self.position.size(), " particles at ", self.time, " s");
  });
}

void bind_load(py::module_& m) {
  py::class_<Push> push(m, "Push", "A force on a point of a triangle.");
  push.def(py::init([](int triangle, const Vec3& weights, const Vec3& force) {
             return Push{triangle, weights, force};
           }),
           "triangle"_a = 0, "weights"_a = Vec3::Zero().eval(), "force"_a = Vec3::Zero().eval());
  push.def_readwrite("triangle", &Push::triangle, "Row of the surface.");
  def_vector(push, "weights", &Push::weights, "[-] Barycentric, sum 1.");
  def_vector(push, "force", &Push::force, "[N]");
  push.attr("dtype") = row_dtype<Push>();
  def_value(push, &Push::triangle, &Push::weights, &Push::force);
  def_repr(push, {"triangle", "weights", "force"});

  py::class_<Load> load(m, "Load",
                        "What the surroundings do to a tissue during one step. Pushes have a fixed "
                        "capacity, so the haptic thread never allocates.");
  load.def(py::init([](int capacity) { return Load(to_count(capacity, "capacity")); }),
           "capacity"_a = 0, "Room for so many pushes.");
  def_vector(load, "gravity", &Load::gravity, "[m/s²]");
  def_fixed_rows(
      load, "storage", &Load::storage,
      "All pushes there is room for, a structured array of shape (capacity,); a view, read-only.");
  load.def_readonly("push_count", &Load::push_count, "How many of them are in force.");
  load.def(
          "pushes",
          [](const py::object& self) {
            const auto rows = self.cast<const Load&>().pushes();
            return read_only(view_rows(rows.data(), rows.size(), self));
          },
          "The pushes in force, a structured array (triangle, weights, force) of shape "
          "(push_count,); a view, read-only.")
      .def("clear", &Load::clear, "No pushes any more.")
      .def("add", &Load::add, "push"_a, "False, and nothing added, when the capacity is used up.");
  def_value(load, &Load::gravity, &Load::storage, &Load::push_count);
  def_repr(load, {"push_count", "gravity"});
}

void bind_energy(py::module_& m) {
  py::class_<Energy> energy(m, "Energy", "[J] each. AngleLaw.eq10 has no energy and counts 0.");
  energy.def(py::init<>())
      .def_readwrite("kinetic", &Energy::kinetic, "[J] Of all particles.")
      .def_readwrite("links", &Energy::links, "[J] Springs and bonds, Eq 8.")
      .def_readwrite("angles", &Energy::angles, "[J] Eq 9 and Eq 11.")
      .def_readwrite("prisms", &Energy::prisms, "[J] Transverse shear of walls.")
      .def_readwrite("volumes", &Energy::volumes, "[J] Of tetrahedra.")
      .def_readwrite("strain", &Energy::strain, "[J] Of linear, corotated and neo-Hookean solids.")
      .def_readwrite("home", &Energy::home, "[J] Of the pull to where particles rest.")
      .def_readwrite("gravity", &Energy::gravity, "[J] Relative to the origin.")
      .def_readwrite("pressure", &Energy::pressure,
                     "[J] -p V; its gradient is the pressure force on closed surfaces.")
      .def("total", &Energy::total, "[J] All of them.")
      .def("elastic", &Energy::elastic,
           "[J] What is stored in the tissue itself: all but kinetic, gravity and pressure.");
  def_value(energy, &Energy::kinetic, &Energy::links, &Energy::angles, &Energy::prisms,
            &Energy::volumes, &Energy::strain, &Energy::home, &Energy::gravity, &Energy::pressure);
  def_repr(energy, {"kinetic", "links", "angles", "prisms", "volumes", "strain", "home", "gravity",
                    "pressure"});
  m.def("count_internal", &count_internal, "model"_a,
        "How many internal variables a state of the model has.");
  m.def(
      "compute_energy",
      [](const TissueModel& model, const Vec3& gravity, const State& state) {
        require_fit(model, state);
        return compute_energy(model, gravity, state);
      },
      "model"_a, "gravity"_a, "state"_a, "[J] What a tissue holds, by kind.");
}

void bind_tangent(py::module_& m) {
  py::native_enum<Projection>(m, "Projection", "enum.Enum",
                              "Which stiffness an implicit step is given.")
      .value("none", Projection::none, "The exact derivative.")
      .value("positive_semidefinite", Projection::positive_semidefinite,
             "Tensions and the 3x3 length Hessians clamped at 0.")
      .finalize();
  m.def(
      "compute_stiffness",
      [](const TissueModel& model, const Numbers& x, Projection projection) {
        const auto xs = points(x, "x");
        require_count("x", xs.size(), model.rest_position.size());
        return compute_stiffness(model, xs, projection);
      },
      "model"_a, "x"_a, "projection"_a,
      "K = -df/dx at positions x [N/m], (3n, 3n), springs, bonds, angles, prisms, volumes, "
      "solids of every law and home; pressure and pushes are left out. Rows and columns of fixed "
      "particles are "
      "zero.");
  m.def(
      "compute_damping",
      [](const TissueModel& model, const Numbers& x) {
        const auto xs = points(x, "x");
        require_count("x", xs.size(), model.rest_position.size());
        return compute_damping(model, xs);
      },
      "model"_a, "x"_a,
      "C = -df/dv at positions x [N·s/m], (3n, 3n), links, prisms, solids and drag. "
      "Fixed as above.");
}

void bind_integrators(py::module_& m) {
  py::native_enum<Integrator>(m, "Integrator", "enum.Enum",
                              "How a step goes from one moment to the next.")
      .value("explicit_euler", Integrator::explicit_euler,
             "x with the old velocity; never stable without damping.")
      .value("symplectic_euler", Integrator::symplectic_euler,
             "v first, x with the new v: what Eq 4-5 of the paper really is.")
      .value("midpoint", Integrator::midpoint, "Explicit midpoint, second order.")
      .value("runge_kutta_4", Integrator::runge_kutta_4)
      .value("symplectic_euler_implicit_damping", Integrator::symplectic_euler_implicit_damping,
             "Symplectic Euler, damped by the velocity it steps to.")
      .value("implicit_euler_linear", Integrator::implicit_euler_linear,
             "One Newton step with the projected tangent.")
      .value("implicit_euler", Integrator::implicit_euler, "Newton until the residual is small.")
      .value("implicit_midpoint", Integrator::implicit_midpoint)
      .value("xpbd", Integrator::xpbd,
             "Extended position-based dynamics: constraints one after the other.")
      .value("projective_dynamics", Integrator::projective_dynamics,
             "Local steps and one constant matrix.")
      .finalize();
  m.def("find_integrator", &find_integrator, "name"_a,
        "'symplectic_euler' -> Integrator.symplectic_euler; None for an unknown name.");
  m.def("integrator_name", &integrator_name, "integrator"_a, "Integrator.midpoint -> 'midpoint'.");
  m.def("is_implicit", &is_implicit, "integrator"_a,
        "Whether it solves for the state that it steps to (ImplicitStepper).");
}

void require_step(const TissueModel& model, const Load& load, double dt, const State& state) {
  require_positive("dt", dt);
  require_fit(model, state);
  require_pushes(load.pushes(), model.triangles.size());
}

void require_explicit(Integrator integrator) {
  if (is_implicit(integrator)) {
    refuse("integrator", std::string(integrator_name(integrator)),
           "an explicit one; ImplicitStepper takes the others");
  }
}

void bind_step(py::module_& m) {
  m.def(
      "step",
      [](const TissueModel& model, const Load& load, double dt, State& state) {
        require_step(model, load, dt, state);
        const py::gil_scoped_release released;
        step(model, load, dt, state);
      },
      "model"_a, "load"_a, "dt"_a, "state"_a,
      "Advances state in place by dt [s] with symplectic Euler, which must stay below "
      "stable_step(model).");
  m.def(
      "step",
      [](const TissueModel& model, const Load& load, double dt, Integrator integrator,
         State& state) {
        require_step(model, load, dt, state);
        require_explicit(integrator);
        const py::gil_scoped_release released;
        step(model, load, dt, integrator, state);
      },
      "model"_a, "load"_a, "dt"_a, "integrator"_a, "state"_a,
      "The same with any explicit integrator.");

  // the stepper keeps a pointer to its model; the model is kept beside it for the border's checks
  struct Stepper {
    const TissueModel& model;
    ImplicitStepper stepper;
  };
  py::class_<Stepper>(m, "ImplicitStepper",
                      "Steps with an implicit integrator; owns the sparse factorisation.")
      .def(py::init([](const TissueModel& model, Integrator integrator, int iterations) {
             return Stepper{model, ImplicitStepper(model, integrator, iterations)};
           }),
           "model"_a, "integrator"_a, "iterations"_a = 0, py::keep_alive<1, 2>(),
           "Steps this model, which it keeps. Iterations are how often xpbd goes over all "
           "constraints in a step, and projective_dynamics solves with its matrix: up to 1000, 0 "
           "for the usual 5 and 10. The others take 0 alone.")
      .def(
          "step",
          [](Stepper& self, const Load& load, double dt, State& state) {
            require_step(self.model, load, dt, state);
            const py::gil_scoped_release released;
            return self.stepper.step(load, dt, state);
          },
          "load"_a, "dt"_a, "state"_a,
          "Advances state by dt [s]; returns the iterations used, or 0 where no solution "
          "was found: positions and time are then as they were.");
}

void bind_stable_step(py::module_& m) {
  py::class_<Spectrum> spectrum(
      m, "Spectrum",
      "Largest eigenvalues at rest, fixed particles left out, with a coupling [N/m] holding the "
      "particle it hurts most.");
  spectrum.def(py::init([](double stiffness, double damping) {
                 return Spectrum{stiffness, damping};
               }),
               py::kw_only(), "stiffness"_a = 0.0, "damping"_a = 0.0);
  spectrum.def_readwrite("stiffness", &Spectrum::stiffness, "[1/s²] of M⁻¹K")
      .def_readwrite("damping", &Spectrum::damping, "[1/s] of M⁻¹C");
  def_value(spectrum, &Spectrum::stiffness, &Spectrum::damping);
  def_repr(spectrum, {"stiffness", "damping"});
  m.def("estimate_spectrum", &estimate_spectrum, "model"_a, "coupling"_a = 0.0,
        py::call_guard<py::gil_scoped_release>(), "The largest eigenvalues at rest.");
  m.def("stable_step", py::overload_cast<const TissueModel&, double>(&stable_step), "model"_a,
        "coupling"_a = 0.0, py::call_guard<py::gil_scoped_release>(),
        "[s] A step at which symplectic Euler is stable at rest, with a margin; coupling [N/m] is "
        "the stiffness that a tool may add at any one particle. Lies between 0.6 and 1.0 of the "
        "exact limit.");
  m.def("stable_step", py::overload_cast<const TissueModel&, Integrator>(&stable_step), "model"_a,
        "integrator"_a, py::call_guard<py::gil_scoped_release>(),
        "[s] The same for any integrator: infinite for an implicit one, and 0 where no step is "
        "stable, because something swings that nothing damps: explicit Euler and the explicit "
        "midpoint rule feed it energy at any step.");
  m.def("has_packed_form", &has_packed_form, "model"_a,
        "Whether a tissue can be packed, where there is vector code: all can but linear, "
        "corotated and neo-Hookean solids.");
  m.def("simd_targets", &simd_targets,
        "The vector targets this machine can run ('AVX3', 'AVX2', 'SSE4', ...), the best first; "
        "empty where Palpate was built without vector code.");
}

}  // namespace

void bind_dynamics(py::module_& m) {
  bind_state(m);
  bind_load(m);
  bind_forces(m);
  bind_response(m);
  bind_energy(m);
  bind_tangent(m);
  bind_integrators(m);
  bind_step(m);
  bind_stable_step(m);
  bind_guard(m);
}

}  // namespace palpate::bindings
