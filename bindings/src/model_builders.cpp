// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "options.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/definiteness.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_builder_options(py::module_& m) {
  const SurfaceOptions usual;
  using Options = Chosen<SurfaceOptions>;
  py::class_<Options> options(
      m, "SurfaceOptions", "What a designer may choose about a surface model beside its material.");
  options.def(
      py::init([](std::optional<double> home_stiffness, const Numbers& stiffness_scale,
                  const Integers& fixed, double pressure, double drag, DampingLaw damping_law) {
        Options made{{home_stiffness,
                      copy_numbers(stiffness_scale, "stiffness_scale"),
                      {},
                      pressure,
                      drag,
                      damping_law},
                     {}};
        set_fixed(made, fixed);
        return made;
      }),
      py::kw_only(), "home_stiffness"_a = usual.home_stiffness, "stiffness_scale"_a = py::tuple(),
      "fixed"_a = py::tuple(), "pressure"_a = usual.pressure, "drag"_a = usual.drag,
      "damping_law"_a = usual.damping_law);
  options.def_readwrite("home_stiffness", &SurfaceOptions::home_stiffness,
                        "[N/m³] pull home per area; None: default_home_stiffness.");
  options.def_property(
      "stiffness_scale",
      [](const Options& self) { return read_only(own(std::vector<double>(self.stiffness_scale))); },
      [](Options& self, const Numbers& value) {
        self.stiffness_scale = copy_numbers(value, "stiffness_scale");
      },
      "[-] per vertex, shape (n,), positive, empty for 1 everywhere; a link takes the mean of its "
      "ends. Reads "
      "as a read-only copy: assign a new array to change it.");
  options.def_property(
      "fixed", [](const Options& self) { return read_only(own(std::vector<int>(self.fixed))); },
      [](Options& self, const Integers& value) { set_fixed(self, value); },
      "Vertices held at rest: indices, shape (k,), or a mask, one boolean per vertex, which is "
      "turned into the indices of its true rows. Reads as a read-only copy: assign a new array to "
      "change it.");
  options.def_readwrite("pressure", &SurfaceOptions::pressure, "[Pa]")
      .def_readwrite("drag", &SurfaceOptions::drag, "[1/s]")
      .def_readwrite("damping_law", &SurfaceOptions::damping_law, "How links are damped.");
  def_value(options, &Options::home_stiffness, &Options::stiffness_scale, &Options::fixed,
            &Options::pressure, &Options::drag, &Options::damping_law, &Options::mask_size);
  def_repr(options,
           {"home_stiffness", "stiffness_scale", "fixed", "pressure", "drag", "damping_law"});
}

void bind_molecular_constants(py::module_& m) {
  const MolecularConstants usual;
  py::class_<MolecularConstants> constants(
      m, "MolecularConstants",
      "Constants of the molecular model, the same at every bond and corner (Eq 8, 9, 11).");
  constants.def(
      py::init([](double bond_stiffness, double bend_stiffness, double stretch_coupling,
                  AngleLaw angle_law) {
        return MolecularConstants{bond_stiffness, bend_stiffness, stretch_coupling, angle_law};
      }),
      py::kw_only(), "bond_stiffness"_a = usual.bond_stiffness,
      "bend_stiffness"_a = usual.bend_stiffness, "stretch_coupling"_a = usual.stretch_coupling,
      "angle_law"_a = usual.angle_law);
  constants
      .def_readwrite("bond_stiffness", &MolecularConstants::bond_stiffness,
                     "[N/m] K_b of a bond inside the surface; a border bond gets half.")
      .def_readwrite("bend_stiffness", &MolecularConstants::bend_stiffness,
                     "[J] K_theta per corner; [N] under AngleLaw.eq10.")
      .def_readwrite("stretch_coupling", &MolecularConstants::stretch_coupling,
                     "[N] K_btheta per corner; may be negative.")
      .def_readwrite("angle_law", &MolecularConstants::angle_law, "How angles push back.");
  def_value(constants, &MolecularConstants::bond_stiffness, &MolecularConstants::bend_stiffness,
            &MolecularConstants::stretch_coupling, &MolecularConstants::angle_law);
  def_repr(constants, {"bond_stiffness", "bend_stiffness", "stretch_coupling", "angle_law"});
}

void bind_build_functions(py::module_& m) {
  m.def("default_home_stiffness", &default_home_stiffness, "mesh"_a, "material"_a,
        "[N/m³] home stiffness when none is given. 0 for a solid (no wall thickness); for hollow "
        "organs and sheets E h / d² with d a tenth of the bounding box's diagonal.");
  m.def(
      "compute_lumped_mass",
      [](const SurfaceMesh& mesh, const Material& material) {
        return own(compute_lumped_mass(mesh, material));
      },
      "mesh"_a, "material"_a,
      "[kg] per vertex, shape (n,), lumped by area: density x volume for a closed solid, density x "
      "wall "
      "thickness x area for hollow organs and open surfaces. Raises ValueError for an open surface "
      "without a wall thickness.");
  m.def("membrane_spring_stiffness", &membrane_spring_stiffness, "material"_a,
        "[N/m] of the springs that make a surface stretch like a membrane of the material and its "
        "wall thickness. Raises ValueError without one.");
  m.def(
      "build_mass_spring",
      [](const SurfaceMesh& mesh, const Material& material, double stiffness,
         const Chosen<SurfaceOptions>& options) {
        return build_mass_spring(mesh, material, stiffness,
                                 fit_mask(options, mesh.vertices.size()));
      },
      "mesh"_a, "material"_a, "stiffness"_a, "options"_a = Chosen<SurfaceOptions>(),
      py::call_guard<py::gil_scoped_release>(),
      "The mass-spring model of a surface: one spring of stiffness [N/m] (Eq 1) along every "
      "edge. Raises ValueError on an invalid mesh, material or option.");
  m.def(
      "build_molecular",
      [](const SurfaceMesh& mesh, const Material& material, const MolecularConstants& constants,
         const Chosen<SurfaceOptions>& options) {
        return build_molecular(mesh, material, constants, fit_mask(options, mesh.vertices.size()));
      },
      "mesh"_a, "material"_a, "constants"_a, "options"_a = Chosen<SurfaceOptions>(),
      py::call_guard<py::gil_scoped_release>(),
      "The molecular model of a surface: a bond along every edge, an angle and a stretch-bend "
      "term at every triangle corner. Raises ValueError as build_mass_spring does, and where "
      "the constants make a triangle indefinite, naming it and the admissible range.");
}

void require_row(const Angles& angles, int row) {
  const auto count = static_cast<int>(angles.corners.size());
  if (row < 0 || row >= count) {
    refuse("row", std::to_string(row), "0 to " + std::to_string(count - 1));
  }
  require_count("angles.bond_share", angles.bond_share.size(), angles.corners.size());
}

void bind_definiteness(py::module_& m) {
  m.def(
      "compute_rest_stiffness",
      [](const Angles& angles, int row) {
        require_row(angles, row);
        return compute_rest_stiffness(angles, row);
      },
      "angles"_a, "row"_a,
      "[N/m] (3, 3) second derivative, at rest, of the energy of one triangle in the lengths of "
      "its three sides.");
  m.def(
      "compute_rest_slopes",
      [](const Angles& angles, int row, AngleLaw law) {
        require_row(angles, row);
        return compute_rest_slopes(angles, row, law);
      },
      "angles"_a, "row"_a, "law"_a,
      "[N/m] (3, 3) what a change of each side's length at rest does to the tension of each side; "
      "under AngleLaw.eq10 not symmetric.");
  m.def("is_positive_definite", &is_positive_definite, "stiffness"_a,
        "True when all eigenvalues are positive by more than rounding.");
  py::class_<CouplingRange> range(
      m, "CouplingRange", "[N] K_btheta lies strictly between the two; either may be infinite.");
  range.def(py::init<double, double>(), "low"_a, "high"_a)
      .def_readwrite("low", &CouplingRange::low, "[N] K_btheta is larger.")
      .def_readwrite("high", &CouplingRange::high, "[N] K_btheta is smaller.");
  def_value(range, &CouplingRange::low, &CouplingRange::high);
  def_repr(range, {"low", "high"});
  m.def(
      "find_coupling_range",
      [](const Angles& angles, int row, const std::array<double, 3>& proportion) {
        require_row(angles, row);
        return find_coupling_range(angles, row, proportion);
      },
      "angles"_a, "row"_a, "proportion"_a,
      "The K_btheta for which a triangle is positive definite when its three stretch_coupling are "
      "K_btheta times proportion; None if no number helps.");
  m.def(
      "check_definiteness",
      [](const Angles& angles, AngleLaw law) {
        require_count("angles.bond_share", angles.bond_share.size(), angles.corners.size());
        check_definiteness(angles, law);
      },
      "angles"_a, "law"_a,
      "Raises ValueError on the first triangle that does not hold, with the numbers its "
      "stretch_coupling may have.");
  m.def("describe", py::overload_cast<const CouplingRange&>(&describe), "range"_a,
        "'-0.058 to 54 N', drawn in by a hair so that the numbers shown are themselves "
        "admissible.");
}

}  // namespace

void bind_builders(py::module_& m) {
  bind_builder_options(m);
  bind_molecular_constants(m);
  bind_build_functions(m);
  bind_definiteness(m);
}

}  // namespace palpate::bindings
