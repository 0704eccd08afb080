// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include "bindings.h"
#include "border.h"
#include "options.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/membrane.h"
#include "value.h"

namespace palpate::bindings {

namespace {

/// (t, 3, 3), a copy.
py::array_t<double> copy_matrices(const std::vector<Mat3>& matrices) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(matrices.size()), py::ssize_t{3}, py::ssize_t{3}});
  auto entries = array.mutable_unchecked<3>();
  for (py::ssize_t t = 0; t < entries.shape(0); ++t) {
    for (py::ssize_t i = 0; i < 3; ++i) {
      for (py::ssize_t j = 0; j < 3; ++j)
        entries(t, i, j) = matrices[static_cast<std::size_t>(t)](i, j);
    }
  }
  return array;
}

void bind_fit(py::module_& m) {
  m.attr("SMALLEST_ANGLE") = kSmallestAngle;
  m.def(
      "compute_membrane_stiffnesses",
      [](const SurfaceMesh& mesh, const Material& material) {
        validate(mesh);
        return copy_matrices(compute_membrane_stiffnesses(mesh, material));
      },
      "mesh"_a, "material"_a,
      "[N/m] (t, 3, 3) the second derivative of every triangle's energy, as a wall of the material "
      "under plane stress, in the lengths of its three sides. Raises ValueError without a wall "
      "thickness and for a triangle below SMALLEST_ANGLE [degree].");
  py::class_<MembraneFit> fit(m, "MembraneFit",
                              "How a surface model at rest compares with a membrane of its "
                              "material.");
  fit.def(py::init<>());
  fit.def_readwrite("young_modulus", &MembraneFit::young_modulus,
                    "[Pa] of the isotropic membrane nearest to the model as a whole.")
      .def_readwrite("poisson_ratio", &MembraneFit::poisson_ratio, "[-] of the same.")
      .def_readwrite("least", &MembraneFit::least,
                     "[-] of the material's stiffness, in the softest strain anywhere.")
      .def_readwrite("most", &MembraneFit::most, "[-] in the stiffest.")
      .def_readwrite("error", &MembraneFit::error,
                     "[-] root mean square over area of |C_model - C| / |C|.")
      .def_readwrite("worst_triangle", &MembraneFit::worst_triangle,
                     "Where |C_model - C| is largest.");
  def_value(fit, &MembraneFit::young_modulus, &MembraneFit::poisson_ratio, &MembraneFit::least,
            &MembraneFit::most, &MembraneFit::error, &MembraneFit::worst_triangle);
  def_repr(fit, {"young_modulus", "poisson_ratio", "least", "most", "error", "worst_triangle"});
  m.def(
      "compare_with_membrane",
      [](const TissueModel& model, const Material& material, const Numbers& stiffness_scale) {
        validate(model);
        auto scale = copy_numbers(stiffness_scale, "stiffness_scale");
        if (!scale.empty()) {
          require_count("stiffness_scale", scale.size(), model.rest_position.size());
        }
        return compare_with_membrane(model, material, scale);
      },
      "model"_a, "material"_a, "stiffness_scale"_a = py::tuple(),
      "Measures springs, bonds, angles and stretch-bend terms against a membrane of the material, "
      "whose modulus stiffness_scale, empty or one per particle, multiplies locally. Raises "
      "ValueError as compute_membrane_stiffnesses does, and for a model without triangles.");
  m.def("describe", py::overload_cast<const MembraneFit&>(&describe), "fit"_a,
        "One line for people.");
}

void bind_membrane_builders(py::module_& m) {
  py::native_enum<SpringRule>(m, "SpringRule", "enum.Enum",
                              "How a spring's constant follows from the two triangles at it.")
      .value("van_gelder", SpringRule::van_gelder, "k = E h sum A/L².")
      .value("lloyd", SpringRule::lloyd,
             "Nearest to the finite element's stiffness matrix, in squares.")
      .finalize();
  using Options = Chosen<SurfaceOptions>;
  m.def(
      "build_membrane_springs",
      [](const SurfaceMesh& mesh, const Material& material, SpringRule rule,
         const Options& options) {
        return build_membrane_springs(mesh, material, rule,
                                      fit_mask(options, mesh.vertices.size()));
      },
      "mesh"_a, "material"_a, "rule"_a = SpringRule::van_gelder, "options"_a = Options(),
      py::call_guard<py::gil_scoped_release>(),
      "The mass-spring model of a wall of the material. Raises ValueError as build_mass_spring "
      "does, without a wall thickness, and for triangles below SMALLEST_ANGLE.");
  m.def(
      "build_membrane_molecular",
      [](const SurfaceMesh& mesh, const Material& material, double bend_stiffness,
         AngleLaw angle_law, const Options& options) {
        return build_membrane_molecular(mesh, material, bend_stiffness, angle_law,
                                        fit_mask(options, mesh.vertices.size()));
      },
      "mesh"_a, "material"_a, "bend_stiffness"_a = 0.0, "angle_law"_a = AngleLaw::gradient,
      "options"_a = Options(), py::call_guard<py::gil_scoped_release>(),
      "The molecular model of a wall of the material: at rest exactly the finite element of "
      "plane stress, whatever bend_stiffness [J] is; under AngleLaw.eq10 the nearest to it. "
      "Raises ValueError as build_membrane_springs does.");
  m.def(
      "build_shell",
      [](const SurfaceMesh& mesh, const Material& material, const Options& options) {
        return build_shell(mesh, material, fit_mask(options, mesh.vertices.size()));
      },
      "mesh"_a, "material"_a, "options"_a = Options(), py::call_guard<py::gil_scoped_release>(),
      "A wall of triangular prisms, which stretches and bends as its material does. Vertex i of "
      "the surface is particle i, on the outer face; particle n + i lies below it on the inner "
      "face. Raises ValueError as build_membrane_molecular does, and where the wall is too thick "
      "for the surface.");
  m.def(
      "convert_to_eq10",
      [](const Angles& angles) {
        require_count("angles.bond_share", angles.bond_share.size(), angles.corners.size());
        return convert_to_eq10(angles);
      },
      "angles"_a,
      "The constants of Eq 10 nearest to those under AngleLaw.gradient, row by row, in the sum of "
      "squares of the stiffness at rest.");
  m.def(
      "compute_eq10_residuals",
      [](const Angles& angles) {
        require_count("angles.bond_share", angles.bond_share.size(), angles.corners.size());
        return own(compute_eq10_residuals(angles));
      },
      "angles"_a,
      "[-] per row, shape (a,): |S_eq10 - S| / |S| of the slopes at rest after convert_to_eq10.");
}

}  // namespace

void bind_membrane(py::module_& m) {
  bind_fit(m);
  bind_membrane_builders(m);
}

}  // namespace palpate::bindings
