// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/model/material.h"
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

void bind_links(py::module_& m) {
  py::class_<Links> links(
      m, "Links",
      "Pairs of particles that resist a change of distance: springs of the mass-spring model and "
      "bonds of the molecular model.");
  links.def(py::init([](const Integers& ends, const Numbers& rest_length, const Numbers& stiffness,
                        const Numbers& damping) {
              return Links{copy_index_rows<2>(ends, "ends"),
                           copy_numbers(rest_length, "rest_length"),
                           copy_numbers(stiffness, "stiffness"), copy_numbers(damping, "damping")};
            }),
            "ends"_a, "rest_length"_a, "stiffness"_a, "damping"_a, "Copies its tables.");
  links.def(py::init<>());
  def_table(links, "ends", &Links::ends,
            "Particle indices, ends[l, 0] < ends[l, 1], shape (l, 2); a view, read-only.");
  def_view(links, "rest_length", &Links::rest_length, "[m], shape (l,); a view.");
  def_view(links, "stiffness", &Links::stiffness,
           "[N/m], shape (l,); a bond's may be negative; a view.");
  def_view(links, "damping", &Links::damping, "[N·s/m], shape (l,); a view.");
  def_value(links, &Links::ends, &Links::rest_length, &Links::stiffness, &Links::damping);
  def_summary(links, [](const Links& self) {
    if (self.ends.empty()) return std::string("none");
    const auto [least, most] = std::minmax_element(self.stiffness.begin(), self.stiffness.end());
    return write_text(self.ends.size(), ", ", *least, " to ", *most, " N/m");
  });
}

void bind_angles(py::module_& m) {
  py::class_<Angles> angles(
      m, "Angles",
      "Triangles whose three corners resist a change of angle (molecular model, Eq 9 and 11). Row "
      "a is one triangle; column c belongs to its corner c, or to the side opposite corner c.");
  angles.def(py::init([](const Integers& corners, const Numbers& rest_cosine,
                         const Numbers& rest_length, const Numbers& bend_stiffness,
                         const Numbers& stretch_coupling, const Numbers& bond_share) {
               return Angles{copy_index_rows<3>(corners, "corners"),
                             copy_triples(rest_cosine, "rest_cosine"),
                             copy_triples(rest_length, "rest_length"),
                             copy_triples(bend_stiffness, "bend_stiffness"),
                             copy_triples(stretch_coupling, "stretch_coupling"),
                             copy_triples(bond_share, "bond_share")};
             }),
             "corners"_a, "rest_cosine"_a, "rest_length"_a, "bend_stiffness"_a,
             "stretch_coupling"_a, "bond_share"_a, "Copies its tables.");
  angles.def(py::init<>());
  def_table(angles, "corners", &Angles::corners,
            "Particle indices, shape (a, 3); a view, read-only.");
  def_view(angles, "rest_cosine", &Angles::rest_cosine,
           "[-] of the angle at the corner, shape (a, 3); a view.");
  def_view(angles, "rest_length", &Angles::rest_length,
           "[m] of the side opposite the corner, shape (a, 3); a view.");
  def_view(angles, "bend_stiffness", &Angles::bend_stiffness,
           "[J] K_theta of the corner, [N] under AngleLaw.eq10, shape (a, 3); a view.");
  def_view(angles, "stretch_coupling", &Angles::stretch_coupling,
           "[N] K_btheta of the corner, shape (a, 3); a view.");
  def_view(angles, "bond_share", &Angles::bond_share,
           "[N/m] this triangle's part of the bond opposite the corner, shape (a, 3); a view.");
  def_value(angles, &Angles::corners, &Angles::rest_cosine, &Angles::rest_length,
            &Angles::bend_stiffness, &Angles::stretch_coupling, &Angles::bond_share);
  def_summary(angles,
              [](const Angles& self) { return write_text(self.corners.size(), " triangles"); });
}

void bind_prisms(py::module_& m) {
  py::class_<Prisms> prisms(
      m, "Prisms",
      "Triangular prisms of a wall that resist transverse shear, which is what makes a wall bend. "
      "Row p joins a triangle of the inner face to the one above it; column c is the side opposite "
      "corner c.");
  prisms.def(py::init([](const Integers& corners, const Numbers& rest_difference,
                         const Numbers& shear_stiffness, const Numbers& shear_damping) {
               return Prisms{copy_index_rows<6>(corners, "corners"),
                             copy_triples(rest_difference, "rest_difference"),
                             copy_triples(shear_stiffness, "shear_stiffness"),
                             copy_triples(shear_damping, "shear_damping")};
             }),
             "corners"_a, "rest_difference"_a, "shear_stiffness"_a, "shear_damping"_a,
             "Copies its tables.");
  prisms.def(py::init<>());
  def_table(prisms, "corners", &Prisms::corners,
            "Particles: three inner, then the three above them, shape (p, 6); a view, read-only.");
  def_view(prisms, "rest_difference", &Prisms::rest_difference,
           "[m] first diagonal less the second, shape (p, 3); a view.");
  def_view(prisms, "shear_stiffness", &Prisms::shear_stiffness,
           "[N/m] of that difference, shape (p, 3); a view.");
  def_view(prisms, "shear_damping", &Prisms::shear_damping,
           "[N·s/m] likewise, shape (p, 3); a view.");
  def_value(prisms, &Prisms::corners, &Prisms::rest_difference, &Prisms::shear_stiffness,
            &Prisms::shear_damping);
  def_summary(prisms,
              [](const Prisms& self) { return write_text(self.corners.size(), " prisms"); });
}

/// As validate() would refuse it anyway, but before a table is read by index.
TissueModel make_model(const Numbers& rest_position, const Numbers& mass, const Integers& fixed,
                       const Links& springs, const Links& bonds, const Angles& angles,
                       const Prisms& prisms, const Volumes& volumes, const Elastic& elastic,
                       const Skin& skin, const Numbers& home, double pressure,
                       const Integers& triangles, double drag, DampingLaw damping_law,
                       AngleLaw angle_law) {
  auto rests = copy_points(rest_position, "rest_position");
  auto fixed_rows = copy_indices(fixed, "fixed", rests.size());
  TissueModel model{std::move(rests),
                    copy_numbers(mass, "mass"),
                    std::move(fixed_rows),
                    springs,
                    bonds,
                    angles,
                    prisms,
                    volumes,
                    elastic,
                    skin,
                    copy_numbers(home, "home"),
                    pressure,
                    copy_index_rows<3>(triangles, "triangles"),
                    drag,
                    damping_law,
                    angle_law};
  validate(model);
  return model;
}

void bind_tissue_fields(py::class_<TissueModel>& model) {
  def_view(model, "rest_position", &TissueModel::rest_position, "[m], shape (n, 3); a view.");
  def_view(model, "mass", &TissueModel::mass, "[kg], positive, shape (n,); a view.");
  def_table(model, "fixed", &TissueModel::fixed,
            "Particles held at rest, ascending, shape (k,); a view, read-only.");
  model.def_readonly("springs", &TissueModel::springs, "Mass-spring model; may be empty.")
      .def_readonly("bonds", &TissueModel::bonds, "Molecular model; may be empty.")
      .def_readonly("angles", &TissueModel::angles, "Molecular model; may be empty.")
      .def_readonly("prisms", &TissueModel::prisms, "Walls that bend; may be empty.")
      .def_readonly("volumes", &TissueModel::volumes, "Solids; may be empty.")
      .def_readonly("elastic", &TissueModel::elastic, "Linear solids; may be empty.")
      .def_readonly("skin", &TissueModel::skin, "Solids under a finer surface; may be empty.");
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
  const TissueModel usual;
  py::class_<TissueModel> model(
      m, "TissueModel",
      "An organ as built: everything about it that a simulation never changes. Made by a build_ "
      "function, or from tables, which are validated.");
  model.def(py::init(&make_model), py::kw_only(), "rest_position"_a, "mass"_a,
            "fixed"_a = py::tuple(), "springs"_a = Links(), "bonds"_a = Links(),
            "angles"_a = Angles(), "prisms"_a = Prisms(), "volumes"_a = Volumes(),
            "elastic"_a = Elastic(), "skin"_a = Skin(), "home"_a = py::tuple(),
            "pressure"_a = usual.pressure, "triangles"_a = py::tuple(), "drag"_a = usual.drag,
            "damping_law"_a = usual.damping_law, "angle_law"_a = usual.angle_law,
            "Copies its tables and validates the whole. Raises ValueError.");
  bind_tissue_fields(model);
  def_value(model, &TissueModel::rest_position, &TissueModel::mass, &TissueModel::fixed,
            &TissueModel::springs, &TissueModel::bonds, &TissueModel::angles, &TissueModel::prisms,
            &TissueModel::volumes, &TissueModel::elastic, &TissueModel::skin, &TissueModel::home,
            &TissueModel::pressure, &TissueModel::triangles, &TissueModel::drag,
            &TissueModel::damping_law, &TissueModel::angle_law);
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
  bind_links(m);
  bind_angles(m);
  bind_prisms(m);
  bind_solid_tables(m);
  bind_tissue_model(m);
  bind_builders(m);
  bind_membrane(m);
  bind_solids(m);
}

}  // namespace palpate::bindings
