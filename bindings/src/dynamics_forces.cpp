// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "rows.h"

namespace palpate::bindings {

namespace {

void require_like(std::span<const Vec3> x, std::span<const Vec3> other, const char* name) {
  require_count(name, other.size(), x.size());
}

void bind_link_and_angle_forces(py::module_& m) {
  m.def(
      "accumulate_link_forces",
      [](const Links& links, DampingLaw law, const Numbers& x, const Numbers& v,
         const NumbersOut& f) {
        const auto xs = points(x, "x"), vs = points(v, "v");
        const auto fs = points_out(f, "f");
        require_like(xs, vs, "v");
        require_like(xs, fs, "f");
        require_links(links, xs.size());
        accumulate_link_forces(links, law, xs, vs, fs);
      },
      "links"_a, "law"_a, "x"_a, "v"_a, "f"_a,
      "Adds to f [N] the pull of every link: Hooke's law with damping (Eq 1, 2, 8).");
  const auto bind_angles = [&m](const char* name, auto kernel, const char* doc) {
    m.def(
        name,
        [kernel](const Angles& angles, const Numbers& x, const NumbersOut& f) {
          const auto xs = points(x, "x");
          const auto fs = points_out(f, "f");
          require_like(xs, fs, "f");
          require_angles(angles, xs.size());
          kernel(angles, xs, fs);
        },
        "angles"_a, "x"_a, "f"_a, doc);
  };
  bind_angles("accumulate_angle_forces", &accumulate_angle_forces,
              "Adds to f [N] Eq 9 and Eq 11 of the paper as edge tensions.");
  bind_angles("accumulate_eq10_forces", &accumulate_eq10_forces,
              "Adds to f [N] Eq 10 of the paper, as printed but with the sign that reopens a "
              "closed angle.");
}

void bind_prism_forces(py::module_& m) {
  m.def(
      "accumulate_prism_forces",
      [](const Prisms& prisms, const Numbers& x, const Numbers& v, const NumbersOut& f) {
        const auto xs = points(x, "x"), vs = points(v, "v");
        const auto fs = points_out(f, "f");
        require_like(xs, vs, "v");
        require_like(xs, fs, "f");
        for (const auto& corners : prisms.corners) {
          for (const int i : corners) {
            if (i >= 0 && static_cast<std::size_t>(i) < xs.size()) continue;
            refuse("prisms.corners", std::to_string(i), "0 to " + std::to_string(xs.size() - 1));
          }
        }
        accumulate_prism_forces(prisms, xs, vs, fs);
      },
      "prisms"_a, "x"_a, "v"_a, "f"_a,
      "Adds to f [N] what resists the transverse shear of a wall.");
}

void bind_volume_forces(py::module_& m) {
  m.def(
      "accumulate_volume_forces",
      [](const Volumes& volumes, const Numbers& x, const NumbersOut& f) {
        const auto xs = points(x, "x");
        const auto fs = points_out(f, "f");
        require_like(xs, fs, "f");
        require_volumes(volumes, xs.size());
        accumulate_volume_forces(volumes, xs, fs);
      },
      "volumes"_a, "x"_a, "f"_a, "Adds to f [N] what resists a change of volume.");
}

/// Of a law of tetrahedra whose places at rest are the model's.
template <class Table, auto accumulate, auto require>
void bind_solid_forces(py::module_& m, const char* name, const char* table_name, const char* doc) {
  m.def(
      name,
      [](const Table& table, const Numbers& rest, const Numbers& x, const Numbers& v,
         const NumbersOut& f) {
        const auto rests = points(rest, "rest"), xs = points(x, "x"), vs = points(v, "v");
        const auto fs = points_out(f, "f");
        require_like(xs, rests, "rest");
        require_like(xs, vs, "v");
        require_like(xs, fs, "f");
        require(table, xs.size());
        accumulate(table, rests, xs, vs, fs);
      },
      py::arg(table_name), "rest"_a, "x"_a, "v"_a, "f"_a, doc);
}

void bind_solids_forces(py::module_& m) {
  bind_solid_forces<Elastic, &accumulate_elastic_forces, &require_elastic>(
      m, "accumulate_elastic_forces", "elastic",
      "Adds to f [N] what resists strain; rest [m] are the places at rest.");
  bind_solid_forces<Hyperelastic, &accumulate_corotated_forces, &require_hyperelastic>(
      m, "accumulate_corotated_forces", "table",
      "Adds into f [N] what resists finite strain by the corotated law; see Hyperelastic. rest [m] "
      "are the places at rest.");
  bind_solid_forces<Hyperelastic, &accumulate_neo_hookean_forces, &require_hyperelastic>(
      m, "accumulate_neo_hookean_forces", "table",
      "Adds into f [N] what resists finite strain by the neo-Hookean law; see Hyperelastic. rest "
      "[m] are the places at rest.");
}

void bind_surface_forces(py::module_& m) {
  m.def(
      "accumulate_home_forces",
      [](const Numbers& home, const Numbers& rest, const Numbers& x, const NumbersOut& f) {
        const auto xs = points(x, "x"), rests = points(rest, "rest");
        const auto fs = points_out(f, "f");
        require_like(xs, rests, "rest");
        require_like(xs, fs, "f");
        const auto homes = numbers(home, "home");
        if (!homes.empty()) require_count("home", homes.size(), xs.size());
        accumulate_home_forces(homes, rests, xs, fs);
      },
      "home"_a, "rest"_a, "x"_a, "f"_a,
      "Adds to f [N] the pull of every particle to its rest position, home [N/m].");
  m.def(
      "accumulate_pressure_forces",
      [](const Integers& triangles, double pressure, const Numbers& x, const NumbersOut& f) {
        const auto rows = copy_index_rows<3>(triangles, "triangles");
        const auto xs = points(x, "x");
        const auto fs = points_out(f, "f");
        require_like(xs, fs, "f");
        require_triangles(rows, xs.size());
        accumulate_pressure_forces(rows, pressure, xs, fs);
      },
      "triangles"_a, "pressure"_a, "x"_a, "f"_a,
      "Adds to f [N] the push of a pressure [Pa] inside a surface.");
  m.def(
      "accumulate_push_forces",
      [](const Integers& triangles, const Skin& skin, const py::object& pushes,
         const NumbersOut& f) {
        const auto rows = copy_index_rows<3>(triangles, "triangles");
        const auto all = copy_rows<Push>(pushes, "pushes");
        const auto fs = points_out(f, "f");
        require_below<4>(skin.corners, fs.size(), "skin");
        require_count("skin.weights", skin.weights.size(), skin.corners.size());
        require_triangles(rows, skin.corners.empty() ? fs.size() : skin.corners.size());
        require_pushes(all, rows.size());
        accumulate_push_forces(rows, skin, all, fs);
      },
      "triangles"_a, "skin"_a, "pushes"_a, "f"_a,
      "Adds to f [N] pushes, a structured array as of Load.pushes() or a list of Push, shared by "
      "their barycentric weights, and again by those of a skin that is not empty.");
}

void bind_body_forces(py::module_& m) {
  m.def(
      "accumulate_gravity",
      [](const Numbers& mass, const Vec3& gravity, const NumbersOut& f) {
        const auto fs = points_out(f, "f");
        const auto masses = numbers(mass, "mass");
        require_count("mass", masses.size(), fs.size());
        accumulate_gravity(masses, gravity, fs);
      },
      "mass"_a, "gravity"_a, "f"_a, "Adds to f [N] the weight of every particle.");
  m.def(
      "accumulate_drag",
      [](const Numbers& mass, double drag, const Numbers& v, const NumbersOut& f) {
        const auto vs = points(v, "v");
        const auto fs = points_out(f, "f");
        require_like(vs, fs, "f");
        const auto masses = numbers(mass, "mass");
        require_count("mass", masses.size(), vs.size());
        accumulate_drag(masses, drag, vs, fs);
      },
      "mass"_a, "drag"_a, "v"_a, "f"_a,
      "Adds to f [N] what the surroundings take: drag [1/s] x mass x velocity.");
  m.def(
      "compute_forces",
      [](const TissueModel& model, const Load& load, const Numbers& x, const Numbers& v,
         const NumbersOut& f, const Numbers& internal) {
        const auto xs = points(x, "x"), vs = points(v, "v");
        const auto fs = points_out(f, "f");
        require_count("x", xs.size(), model.rest_position.size());
        require_like(xs, vs, "v");
        require_like(xs, fs, "f");
        require_pushes(load.pushes(), model.triangles.size());
        const auto variables = numbers(internal, "internal");
        if (!variables.empty()) require_count("internal", variables.size(), count_internal(model));
        compute_forces(model, load, xs, vs, fs, variables);
      },
      "model"_a, "load"_a, "x"_a, "v"_a, "f"_a, "internal"_a = py::tuple(),
      "Sets f [N] to all of the above for a model under a load. The entries of fixed particles "
      "hold what the support must carry. internal is State.internal; none stands for zeros.");
}

}  // namespace

void bind_forces(py::module_& m) {
  bind_link_and_angle_forces(m);
  bind_prism_forces(m);
  bind_volume_forces(m);
  bind_solids_forces(m);
  bind_surface_forces(m);
  bind_body_forces(m);
}

}  // namespace palpate::bindings
