// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "options.h"
#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/model/tissue_model.h"
#include "value.h"

namespace palpate::bindings {

namespace {

Volumes copy_volumes(int particle_count, const Integers& corners, const Numbers& rest_volume,
                     const Numbers& bulk, double nodal_share) {
  auto rows = copy_index_rows<4>(corners, "corners");
  if (particle_count < 0) refuse("particle_count", std::to_string(particle_count), "0 or more");
  require_below<4>(rows, static_cast<std::size_t>(particle_count), "corners");
  return build_volumes(particle_count, std::move(rows), copy_numbers(rest_volume, "rest_volume"),
                       copy_numbers(bulk, "bulk"), nodal_share);
}

void bind_volumes(py::module_& m) {
  m.def("build_volumes", &copy_volumes, "particle_count"_a, "corners"_a, "rest_volume"_a, "bulk"_a,
        "nodal_share"_a = 0.0,
        "Volumes with the tables of what lies around each particle filled in. Copies its tables.");
}

Elastic copy_elastic(int particle_count, const Integers& corners, const Numbers& lame,
                     const Numbers& shear, double nodal_share, double damping_time) {
  auto rows = copy_index_rows<4>(corners, "corners");
  if (particle_count < 0) refuse("particle_count", std::to_string(particle_count), "0 or more");
  require_below<4>(rows, static_cast<std::size_t>(particle_count), "corners");
  return build_elastic(particle_count, std::move(rows), copy_numbers(lame, "lame"),
                       copy_numbers(shear, "shear"), nodal_share, damping_time);
}

void bind_elastic(py::module_& m) {
  m.def("build_elastic", &copy_elastic, "particle_count"_a, "corners"_a, "lame"_a, "shear"_a,
        "nodal_share"_a = 0.0, "damping_time"_a = 0.0,
        "A linear solid's table with what lies around each particle filled in; pushes reach all of "
        "its surface. Copies its tables.");
}

Hyperelastic copy_hyperelastic(int particle_count, const Integers& corners, const Numbers& lame,
                               const Numbers& shear, const Numbers& viscosity, double nodal_share) {
  auto rows = copy_index_rows<4>(corners, "corners");
  if (particle_count < 0) refuse("particle_count", std::to_string(particle_count), "0 or more");
  require_below<4>(rows, static_cast<std::size_t>(particle_count), "corners");
  return build_hyperelastic(particle_count, std::move(rows), copy_numbers(lame, "lame"),
                            copy_numbers(shear, "shear"), copy_numbers(viscosity, "viscosity"),
                            nodal_share);
}

void bind_hyperelastic(py::module_& m) {
  m.def("build_hyperelastic", &copy_hyperelastic, "particle_count"_a, "corners"_a, "lame"_a,
        "shear"_a, "viscosity"_a, "nodal_share"_a = 0.0,
        "A table of the corotated or the neo-Hookean law with what lies around each particle "
        "filled in. Copies its tables.");
}

void bind_skin(py::module_& m) {
  m.def(
      "move_skin",
      [](const Skin& its, const Numbers& x, const NumbersOut& surface) {
        const auto xs = points(x, "x");
        const auto out = points_out(surface, "surface");
        require_below<4>(its.corners, xs.size(), "skin");
        require_count("skin.weights", its.weights.size(), its.corners.size());
        require_count("surface", out.size(), its.corners.size());
        move_skin(its, xs, out);
      },
      "skin"_a, "x"_a, "surface"_a,
      "Sets surface [m] to where the vertices of a surface are that rides on particles at x [m].");
}

void bind_surface_of_model(py::module_& m) {
  m.def(
      "list_tetrahedra",
      [](const TissueModel& model) {
        return own(std::vector<std::array<int, 4>>(list_tetrahedra(model)));
      },
      "model"_a, "Tetrahedra of a solid of any law, shape (t, 4).");
  m.def(
      "compute_surface",
      [](const TissueModel& model, const Numbers& x) {
        const auto xs = points(x, "x");
        require_count("x", xs.size(), model.rest_position.size());
        return own(compute_surface(model, xs));
      },
      "model"_a, "x"_a,
      "[m] shape (n, 3), where the vertices of the model's surface are with its particles at x "
      "[m]: the skin's, "
      "or the particles themselves.");
  m.def(
      "compute_surface_mass",
      [](const TissueModel& model) { return own(compute_surface_mass(model)); }, "model"_a,
      "[kg] shape (n,), with what mass a vertex of the surface withstands a push when all of the "
      "surface is "
      "pushed alike.");
}

void bind_solid_options(py::module_& m) {
  const SolidOptions usual;
  using Options = Chosen<SolidOptions>;
  py::class_<Options> options(m, "SolidOptions",
                              "What a designer may choose about a solid beside its material.");
  options.def(
      py::init([](double nodal_share, const Numbers& stiffness_scale, const Integers& fixed,
                  double drag, DampingLaw damping_law) {
        Options made{
            {nodal_share, copy_numbers(stiffness_scale, "stiffness_scale"), {}, drag, damping_law},
            {}};
        set_fixed(made, fixed);
        return made;
      }),
      py::kw_only(), "nodal_share"_a = usual.nodal_share, "stiffness_scale"_a = py::tuple(),
      "fixed"_a = py::tuple(), "drag"_a = usual.drag, "damping_law"_a = usual.damping_law);
  options
      .def_readwrite("nodal_share", &SolidOptions::nodal_share,
                     "[-] 0 to 1: how much of the resistance to a change of volume acts on the "
                     "mean around each particle.")
      .def_property(
          "stiffness_scale",
          [](const Options& self) {
            return read_only(own(std::vector<double>(self.stiffness_scale)));
          },
          [](Options& self, const Numbers& value) {
            self.stiffness_scale = copy_numbers(value, "stiffness_scale");
          },
          "[-] per vertex of the solid, shape (n,), positive, empty for 1 everywhere. Reads as a "
          "read-only "
          "copy: assign a new array to change it.")
      .def_property(
          "fixed", [](const Options& self) { return read_only(own(std::vector<int>(self.fixed))); },
          [](Options& self, const Integers& value) { set_fixed(self, value); },
          "Vertices of the solid held at rest: indices, shape (k,), or a mask, one boolean per "
          "vertex, which is turned into the indices of its true rows. Reads as a read-only copy: "
          "assign a new array to change it.")
      .def_readwrite("drag", &SolidOptions::drag, "[1/s]")
      .def_readwrite("damping_law", &SolidOptions::damping_law, "How links are damped.");
  def_value(options, &Options::nodal_share, &Options::stiffness_scale, &Options::fixed,
            &Options::drag, &Options::damping_law, &Options::mask_size);
  def_repr(options, {"nodal_share", "stiffness_scale", "fixed", "drag", "damping_law"});
}

void bind_lame(py::module_& m) {
  py::class_<LameConstants> lame(m, "LameConstants", "Lamé's constants of a material.");
  lame.def(py::init([](double lambda, double mu) {
             return LameConstants{lambda, mu};
           }),
           py::kw_only(), "lambda_"_a = 0.0, "mu"_a = 0.0);
  lame.def_readwrite("lambda_", &LameConstants::lambda, "[Pa]")
      .def_readwrite("mu", &LameConstants::mu, "[Pa] the shear modulus.");
  def_value(lame, &LameConstants::lambda, &LameConstants::mu);
  def_repr(lame, {"lambda_", "mu"});
  m.def("compute_lame_constants", &compute_lame_constants, "material"_a,
        "Raises ValueError for a Poisson's ratio of 0.5, where lambda is infinite.");
  m.attr("LEAST_SOLID_POISSON") = kLeastSolidPoisson;
  m.attr("MOST_SOLID_POISSON") = kMostSolidPoisson;
}

}  // namespace

void bind_solid_tables(py::module_& m) {
  bind_volumes(m);
  bind_elastic(m);
  bind_hyperelastic(m);
  bind_skin(m);
}

void bind_solids(py::module_& m) {
  bind_surface_of_model(m);
  bind_solid_options(m);
  bind_lame(m);
  using Options = Chosen<SolidOptions>;
  m.def(
      "build_solid",
      [](const SolidMesh& solid, const Material& material, const Options& options) {
        return build_solid(solid, material, fit_mask(options, solid.vertices.size()));
      },
      "solid"_a, "material"_a, "options"_a = Options(), py::call_guard<py::gil_scoped_release>(),
      "The mass-spring model of a solid with true volumes: a spring along every edge of the "
      "tetrahedra, and what resists a change of volume in each of them. Raises ValueError, also "
      "for a Poisson's ratio outside of 0.25 to 0.49.");
  m.def(
      "build_linear_solid",
      [](const SolidMesh& solid, const Material& material, const Options& options) {
        return build_linear_solid(solid, material, fit_mask(options, solid.vertices.size()));
      },
      "solid"_a, "material"_a, "options"_a = Options(), py::call_guard<py::gil_scoped_release>(),
      "The linear elastic model of the same solid, for shallow presses: Hooke's law in every "
      "tetrahedron, no links. Raises ValueError as build_solid does.");
  m.def(
      "build_corotated_solid",
      [](const SolidMesh& solid, const Material& material, const Options& options) {
        return build_corotated_solid(solid, material, fit_mask(options, solid.vertices.size()));
      },
      "solid"_a, "material"_a, "options"_a = Options(), py::call_guard<py::gil_scoped_release>(),
      "The same solid of tetrahedra that may be strained and turned far, of corotated linear "
      "elasticity. Raises ValueError as build_solid does.");
  m.def(
      "build_neo_hookean_solid",
      [](const SolidMesh& solid, const Material& material, const Options& options) {
        return build_neo_hookean_solid(solid, material, fit_mask(options, solid.vertices.size()));
      },
      "solid"_a, "material"_a, "options"_a = Options(), py::call_guard<py::gil_scoped_release>(),
      "The same solid of tetrahedra that may be strained and turned far, of the stable "
      "neo-Hookean law. Raises ValueError as build_solid does.");
  m.def(
      "limit_reach",
      [](const TissueModel& model, const Integers& surface_vertices) {
        const auto count = static_cast<std::size_t>(surface_count(model));
        return limit_reach(model, copy_indices(surface_vertices, "surface_vertices", count));
      },
      "model"_a, "surface_vertices"_a,
      "The same linear solid for pushes on these vertices of its surface alone, indices of shape "
      "(k,) or a mask with one boolean per vertex of the surface; elsewhere it does "
      "not give. Raises ValueError for another model, no vertices, or one that is not there.");
  m.def("build_skin", &build_skin, "surface"_a, "solid"_a, py::call_guard<py::gil_scoped_release>(),
        "The skin by which a surface rides on the tetrahedra of a solid.");
  m.def("cover_with_skin", &cover_with_skin, "model"_a, "surface"_a,
        py::call_guard<py::gil_scoped_release>(),
        "The same solid under a finer surface, which is what is touched and seen. Raises "
        "ValueError where it lies so far from the tetrahedra that these say nothing about it.");
}

}  // namespace palpate::bindings
