// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/inclusion.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "palpate/scenario/around.h"
#include "palpate/scenario/ranges.h"
#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"

namespace palpate::scenario {
namespace {

constexpr std::string_view kFarCompliance = "contact/far_compliance";
/// What an inclusion may change: how stiff and how viscous tissue is, neither its shape nor mass.
constexpr std::array<std::string_view, 16> kConstants = {
    "tissue/springs/stiffness",    "tissue/springs/damping",       "tissue/bonds/stiffness",
    "tissue/bonds/damping",        "tissue/angles/bend_stiffness", "tissue/prisms/shear_stiffness",
    "tissue/prisms/shear_damping", "tissue/volumes/bulk",          "tissue/elastic/lame",
    "tissue/elastic/shear",        "tissue/corotated/lame",        "tissue/corotated/shear",
    "tissue/corotated/viscosity",  "tissue/neo_hookean/lame",      "tissue/neo_hookean/shear",
    "tissue/neo_hookean/viscosity"};

std::string name_place_folder(const std::string& place) { return "constants/" + place + "/"; }

template <class Row>
void take(const Arrays& arrays, const std::string& name, const std::string& file, bool same_rows,
          std::vector<Row>& table) {
  const auto at = arrays.find(name);
  if (at == arrays.end()) return;
  const std::string where = "assessment/" + name;
  if (!is_table<Row>(at->second)) {
    throw FileError(file, where, "another shape or type", "that of the scene's table");
  }
  std::vector<Row> rows = to_table<Row>(at->second);
  if (same_rows && rows.size() != table.size()) {
    throw FileError(file, where, std::to_string(rows.size()) + " rows",
                    std::to_string(table.size()) + ", as the scene has");
  }
  table = std::move(rows);
}

bool is_constant(std::string_view name) {
  return name == kFarCompliance || std::ranges::find(kConstants, name) != kConstants.end();
}

/// Arrays of a place's inclusion that are none of its constants, or of an empty table.
void check_names(const Arrays& arrays, const std::string& place, const std::string& file) {
  const std::string folder = name_place_folder(place);
  std::size_t count = 0;
  for (const auto& [name, array] : arrays) {
    if (!name.starts_with(folder)) continue;
    ++count;
    if (is_constant(std::string_view(name).substr(folder.size()))) continue;
    throw FileError(file, "assessment/" + name, "an array of no constant of tissue", "none such");
  }
  if (count > 0) return;
  throw FileError(file, "assessment/" + folder, "no arrays",
                  "the constants of the inclusion, which `palpate scenario publish` puts there");
}

}  // namespace

SoftBody with_inclusion(const Arrays& arrays, const std::string& place, SoftBody body,
                        const std::string& file) {
  check_names(arrays, place, file);
  const std::string folder = name_place_folder(place);
  const auto visit = [&](const std::string& name, auto& table) {
    if (is_constant(name)) take(arrays, folder + name, file, true, table);
  };
  visit_body("", body, visit);
  take(arrays, folder + std::string(kFarCompliance), file, false, body.far_compliance);
  find_around(body.tissue);
  return body;
}

void check_inclusions(const Scenario& scenario, const Names& names, const std::string& file) {
  for (const auto& [place, row] : names.inclusions) {
    Scene scene = scenario.scene;
    SoftBody& body = scene.bodies[static_cast<std::size_t>(row)];
    body = with_inclusion(scenario.assessment_arrays, place, std::move(body), file);
    try {
      check_ranges(scene);
    } catch (const std::invalid_argument& problem) {
      throw FileError(file, "assessment/" + name_place_folder(place), problem.what(),
                      "constants within the ranges of a scene");
    }
  }
}

}  // namespace palpate::scenario
