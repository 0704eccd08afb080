// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/tick/scene.h"

// Not installed: the tables of a scene, each under the name it has in a file.
//
// Writing and reading both walk this one list. It names every field there is, so a field that is
// added to one of the structs does not compile before its place in the file has been thought of.

namespace palpate::scenario {

template <class SomeLinks, class Visit>
void visit_links(const std::string& name, SomeLinks& links, Visit& visit) {
  auto& [ends, rest_length, stiffness, damping] = links;
  visit(name + "/ends", ends);
  visit(name + "/rest_length", rest_length);
  visit(name + "/stiffness", stiffness);
  visit(name + "/damping", damping);
}

template <class SomeAngles, class Visit>
void visit_angles(const std::string& name, SomeAngles& angles, Visit& visit) {
  auto& [corners, rest_cosine, rest_length, bend_stiffness, stretch_coupling, bond_share] = angles;
  visit(name + "/corners", corners);
  visit(name + "/rest_cosine", rest_cosine);
  visit(name + "/rest_length", rest_length);
  visit(name + "/bend_stiffness", bend_stiffness);
  visit(name + "/stretch_coupling", stretch_coupling);
  visit(name + "/bond_share", bond_share);
}

template <class SomePrisms, class Visit>
void visit_prisms(const std::string& name, SomePrisms& prisms, Visit& visit) {
  auto& [corners, rest_difference, shear_stiffness, shear_damping] = prisms;
  visit(name + "/corners", corners);
  visit(name + "/rest_difference", rest_difference);
  visit(name + "/shear_stiffness", shear_stiffness);
  visit(name + "/shear_damping", shear_damping);
}

template <class SomeVolumes, class Visit>
void visit_volumes(const std::string& name, SomeVolumes& volumes, Visit& visit) {
  // the share stands alone; what lies around each particle follows from the corners
  auto& [corners, rest_volume, bulk, first_around, around, nodal_share] = volumes;
  visit(name + "/corners", corners);
  visit(name + "/rest_volume", rest_volume);
  visit(name + "/bulk", bulk);
}

template <class SomeElastic, class Visit>
void visit_elastic(const std::string& name, SomeElastic& elastic, Visit& visit) {
  // as of volumes
  auto& [corners, lame, shear, first_around, around, reach, nodal_share, damping_time] = elastic;
  visit(name + "/corners", corners);
  visit(name + "/lame", lame);
  visit(name + "/shear", shear);
  visit(name + "/reach", reach);
}

template <class SomeSkin, class Visit>
void visit_skin(const std::string& name, SomeSkin& skin, Visit& visit) {
  auto& [corners, weights] = skin;
  visit(name + "/corners", corners);
  visit(name + "/weights", weights);
}

/// Where the arrays of a body are: "scene/bodies/0/".
inline std::string name_folder(std::size_t body) {
  return "scene/bodies/" + std::to_string(body) + "/";
}

template <class SomeBody, class Visit>
void visit_body(const std::string& folder, SomeBody& body, Visit& visit) {
  // kernel and vector target belong to the machine a scene runs on, and a response is solved for
  // again: no file has them
  auto& [tissue, substeps, substeps_max, force_error, kernel, integrator, simd_target, rest_areas,
         spectrum_stiffness, spectrum_damping, least_damping_time, response] = body;
  auto& [rest_position, mass, fixed, springs, bonds, angles, prisms, volumes, elastic, skin, home,
         pressure, triangles, drag, damping_law, angle_law] = tissue;
  const std::string t = folder + "tissue/";
  visit(t + "rest_position", rest_position);
  visit(t + "mass", mass);
  visit(t + "fixed", fixed);
  visit_links(t + "springs", springs, visit);
  visit_links(t + "bonds", bonds, visit);
  visit_angles(t + "angles", angles, visit);
  visit_prisms(t + "prisms", prisms, visit);
  visit_volumes(t + "volumes", volumes, visit);
  visit_elastic(t + "elastic", elastic, visit);
  visit_skin(t + "skin", skin, visit);
  visit(t + "home", home);
  visit(t + "triangles", triangles);
  visit(folder + "rest_areas", rest_areas);
}

/// visit(name, table) for every table of a Scene or a const Scene. Numbers that stand alone are
/// not tables: content.cpp has them.
template <class SomeScene, class Visit>
void visit_tables(SomeScene& scene, Visit visit) {
  auto& [bodies, rigid, scenery, instruments, gravity, rate, identity] = scene;
  for (std::size_t b = 0; b < bodies.size(); ++b) visit_body(name_folder(b), bodies[b], visit);
}

}  // namespace palpate::scenario
