// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include <cctype>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/model/material.h"
#include "palpate/sim/model/private/law_tables.h"
#include "palpate/sim/model/tissue_model.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_laws(py::module_& m) {
  py::native_enum<DampingLaw>(m, "DampingLaw", "enum.Enum",
                              "How the damping of a link acts on the relative velocity of its ends "
                              "(Eq 2 of the paper).")
      .value("axis", DampingLaw::axis, "Only along the link; rotation is free.")
      .value("isotropic", DampingLaw::isotropic,
             "The paper's other reading; damps rigid rotation too.")
      .finalize();
  py::native_enum<AngleLaw>(m, "AngleLaw", "enum.Enum", "How an angle pushes back.")
      .value("gradient", AngleLaw::gradient, "The negative gradient of Eq 9 and Eq 11.")
      .value("eq10", AngleLaw::eq10,
             "The paper's Eq 10: a pair force along the opposite edge; not conservative.")
      .finalize();
}

void bind_material(py::module_& m) {
  const Material usual;
  py::class_<Material> material(m, "Material",
                                "What an organ is made of, as a designer states it.");
  material.def(
      py::init([](double density, double young_modulus, double poisson_ratio, double damping_ratio,
                  std::optional<double> wall_thickness) {
        return Material{density, young_modulus, poisson_ratio, damping_ratio, wall_thickness};
      }),
      py::kw_only(), "density"_a = usual.density, "young_modulus"_a = usual.young_modulus,
      "poisson_ratio"_a = usual.poisson_ratio, "damping_ratio"_a = usual.damping_ratio,
      "wall_thickness"_a = usual.wall_thickness);
  material.def_readwrite("density", &Material::density, "[kg/m³]")
      .def_readwrite("young_modulus", &Material::young_modulus, "[Pa]")
      .def_readwrite("poisson_ratio", &Material::poisson_ratio, "[-]")
      .def_readwrite("damping_ratio", &Material::damping_ratio,
                     "[-] of a single link between its two end masses; 1 is critical.")
      .def_readwrite("wall_thickness", &Material::wall_thickness,
                     "[m] of a hollow organ or sheet, None for a solid.");
  def_value(material, &Material::density, &Material::young_modulus, &Material::poisson_ratio,
            &Material::damping_ratio, &Material::wall_thickness);
  def_repr(material,
           {"density", "young_modulus", "poisson_ratio", "damping_ratio", "wall_thickness"});
  m.def("validate", py::overload_cast<const Material&>(&validate), "material"_a,
        "Raises ValueError naming the field, what it got and the admissible range.");
}

template <std::size_t I>
using LawRows = typename std::tuple_element_t<I, decltype(laws::kLaws)>::Rows;
constexpr auto kLawIndices = std::make_index_sequence<std::tuple_size_v<decltype(laws::kLaws)>>();

/// TissueModel(rest_position, mass, fixed, one argument for each law, ...), all by keyword.
template <std::size_t... I>
void def_tissue_init(py::class_<TissueModel>& cls, std::index_sequence<I...>) {
  const TissueModel usual;
  cls.def(py::init([](const Numbers& rest_position, const Numbers& mass, const Integers& fixed,
                      const LawRows<I>&... rows, const Skin& skin, const Numbers& home,
                      double pressure, const Integers& triangles, double drag,
                      DampingLaw damping_law, AngleLaw angle_law) {
            TissueModel model;
            model.rest_position = copy_points(rest_position, "rest_position");
            model.mass = copy_numbers(mass, "mass");
            model.fixed = copy_indices(fixed, "fixed", model.rest_position.size());
            ((model.*std::get<I>(laws::kLaws).of = rows), ...);
            model.skin = skin;
            model.home = copy_numbers(home, "home");
            model.pressure = pressure;
            model.triangles = copy_index_rows<3>(triangles, "triangles");
            model.drag = drag;
            model.damping_law = damping_law;
            model.angle_law = angle_law;
            validate(model);
            return model;
          }),
          py::kw_only(), "rest_position"_a, "mass"_a, "fixed"_a = py::tuple(),
          (py::arg(std::get<I>(laws::kLaws).name) = LawRows<I>())..., "skin"_a = Skin(),
          "home"_a = py::tuple(), "pressure"_a = usual.pressure, "triangles"_a = py::tuple(),
          "drag"_a = usual.drag, "damping_law"_a = usual.damping_law,
          "angle_law"_a = usual.angle_law,
          "Copies its tables and validates the whole. Raises ValueError.");
}

/// A table of rows keeps their number; one of numbers alone may be replaced.
template <class SomeTable>
void def_law(py::class_<TissueModel>& model, const SomeTable& table) {
  std::string doc = write_text(table.tissue, "; may be empty.");
  doc[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(doc[0])));
  if constexpr (laws::is_numbers<SomeTable>) {
    model.def_readwrite(table.name, table.of, doc.c_str());
  } else {
    model.def_readonly(table.name, table.of, doc.c_str());
  }
}

void bind_tissue_fields(py::class_<TissueModel>& model) {
  def_view(model, "rest_position", &TissueModel::rest_position, "[m], shape (n, 3); a view.");
  def_view(model, "mass", &TissueModel::mass, "[kg], positive, shape (n,); a view.");
  def_table(model, "fixed", &TissueModel::fixed,
            "Particles held at rest, ascending, shape (k,); a view, read-only.");
  laws::for_each_table([&](const auto& table) { def_law(model, table); });
  def_view(model, "home", &TissueModel::home,
           "[N/m] pull of every particle to its rest position, shape (n,) or empty; a view.");
  model.def_readwrite("pressure", &TissueModel::pressure, "[Pa] inside above outside.");
  def_table(
      model, "triangles", &TissueModel::triangles,
      "Outer surface, counter-clockwise from outside, of vertices of the skin, or of particles "
      "where there is none, shape (t, 3); a view, read-only.");
  model.def_readwrite("drag", &TissueModel::drag, "[1/s], velocity lost to the surroundings.")
      .def_readwrite("damping_law", &TissueModel::damping_law, "How links are damped.")
      .def_readwrite("angle_law", &TissueModel::angle_law, "How angles push back.");
}

void bind_tissue_model(py::module_& m) {
  py::class_<TissueModel> model(
      m, "TissueModel",
      "An organ as built: everything about it that a simulation never changes. Made by a build_ "
      "function, or from tables, which are validated.");
  def_tissue_init(model, kLawIndices);
  bind_tissue_fields(model);
  std::apply(
      [&](const auto&... law) {
        def_value(model, &TissueModel::rest_position, &TissueModel::mass, &TissueModel::fixed,
                  law.of..., &TissueModel::skin, &TissueModel::home, &TissueModel::pressure,
                  &TissueModel::triangles, &TissueModel::drag, &TissueModel::damping_law,
                  &TissueModel::angle_law);
      },
      laws::kLaws);
  model.def("__repr__",
            [](const TissueModel& self) { return "<TissueModel: " + describe(self) + ">"; });

  m.def("particle_count", &particle_count, "model"_a, "How many particles a model has.");
  m.def("surface_count", &surface_count, "model"_a,
        "Vertices of the surface: those of the skin, or the particles where there is none.");
  m.def("compute_total_mass", &compute_total_mass, "model"_a, "[kg]");
  m.def("describe", py::overload_cast<const TissueModel&>(&describe), "model"_a,
        "One line for people: how many particles and links of each kind, and the total mass [g].");
  m.def("validate", py::overload_cast<const TissueModel&>(&validate), "model"_a,
        "Raises ValueError, naming table, row, what was found and what was expected; also where a "
        "triangle's constants make its tangent at rest indefinite.");
}

}  // namespace

void bind_model(py::module_& m) {
  bind_laws(m);
  bind_material(m);
  bind_law_tables(m);
  bind_solid_tables(m);
  bind_tissue_model(m);
  bind_builders(m);
  bind_membrane(m);
  bind_solids(m);
}

}  // namespace palpate::bindings
