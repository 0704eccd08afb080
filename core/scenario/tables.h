// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/model/private/law_tables.h"
#include "palpate/sim/tick/scene.h"

// Not installed: the tables of a scene, each under the name it has in a file.
//
// Writing and reading both walk this one list; its laws are those of the table of laws. A field
// that is added to one of the structs does not compile before its place in the file has been
// thought of.

namespace palpate::scenario {

/// visit(name, table) for every column of a law or the skin; what follows from others is in no
/// file, and numbers that stand alone are not tables.
template <class SomeTissue, class Visit>
void visit_laws(const std::string& folder, SomeTissue& tissue, const Visit& visit) {
  laws::for_each_table([&]<class Table>(const Table& table) {
    using T = typename Table::Rows;
    auto& rows = tissue.*table.of;
    const auto take = [&](const auto& column) {
      visit(folder + table.name + "/" + column.name, rows.*column.rows);
    };
    laws::for_each_column(
        table, laws::Overloaded{
                   [&]<std::size_t N>(const laws::Corners<T, N>& column) { take(column); },
                   [&]<class Row>(const laws::Numbers<T, Row>& column) { take(column); },
                   [&](const laws::Particles<T>& column) { take(column); }, [](const auto&) {}});
  });
}

/// visit(field, number) for every number of a law that stands alone.
template <class SomeTissue, class Visit>
void visit_law_numbers(SomeTissue& tissue, Visit visit) {
  laws::for_each_table([&]<class Table>(const Table& table) {
    using T = typename Table::Rows;
    laws::for_each_column(table, laws::Overloaded{[&](const laws::Scalar<T>& number) {
                                                    visit(number.field,
                                                          (tissue.*table.of).*number.value);
                                                  },
                                                  [](const auto&) {}});
  });
}

/// Where the arrays of a body are: "scene/bodies/0/".
inline std::string name_folder(std::size_t body) {
  return "scene/bodies/" + std::to_string(body) + "/";
}

template <class SomeBody, class Visit>
void visit_body(const std::string& folder, SomeBody& body, const Visit& visit) {
  // kernel and vector target belong to the machine a scene runs on, a response and a near field are
  // solved for again: no file has them
  auto& [tissue, substeps, substeps_max, force_error, kernel, integrator, iterations, simd_target,
         contact_modulus, far_compliance, contact_facets, tied_holds, tear_stretch, may_fold,
         weightless, rest_areas, spectrum_stiffness, spectrum_damping, least_damping_time,
         damped_limit, response, near_field] = body;
  const std::string t = folder + "tissue/";
  visit(t + "rest_position", tissue.rest_position);
  visit(t + "mass", tissue.mass);
  visit(t + "fixed", tissue.fixed);
  visit_laws(t, tissue, visit);
  visit(t + "home", tissue.home);
  visit(t + "triangles", tissue.triangles);
  visit(folder + "rest_areas", rest_areas);
}

/// visit(name, table) for every table of a rigid body or of scenery.
template <class SomeRigid, class Visit>
void visit_rigid(const std::string& folder, SomeRigid& body, const Visit& visit) {
  auto& [mesh, sphere_centres, sphere_radii, mass, inertia, position, orientation, friction,
         stiffness, contact_stiffness] = body;
  visit(folder + "mesh/vertices", mesh.vertices);
  visit(folder + "mesh/triangles", mesh.triangles);
  visit(folder + "sphere_centres", sphere_centres);
  visit(folder + "sphere_radii", sphere_radii);
}

template <class SomeScenery, class Visit>
void visit_scenery(const std::string& folder, SomeScenery& part, const Visit& visit) {
  auto& [mesh, bodies, friction] = part;
  visit(folder + "mesh/vertices", mesh.vertices);
  visit(folder + "mesh/triangles", mesh.triangles);
}

/// Of a body: the one table that a file has only where it is not empty.
inline std::string name_far_compliance(std::size_t body) {
  return name_folder(body) + "contact/far_compliance";
}

/// visit(name, table) for every table of a Scene or a const Scene. Numbers that stand alone are
/// not tables: content.cpp has them.
template <class SomeScene, class Visit>
void visit_tables(SomeScene& scene, Visit visit) {
  auto& [bodies, rigid, scenery, fluid, instruments, body_pairs, gravity, rate, exchange_rate,
         identity] = scene;
  for (std::size_t b = 0; b < bodies.size(); ++b) visit_body(name_folder(b), bodies[b], visit);
  for (std::size_t r = 0; r < rigid.size(); ++r) {
    visit_rigid("scene/rigid/" + std::to_string(r) + "/", rigid[r], visit);
  }
  for (std::size_t s = 0; s < scenery.size(); ++s) {
    visit_scenery("scene/scenery/" + std::to_string(s) + "/", scenery[s], visit);
  }
}

}  // namespace palpate::scenario
