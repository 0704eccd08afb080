// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/read.h"

#include <stdexcept>

#include "palpate/scenario/around.h"
#include "palpate/scenario/assessment_parts.h"
#include "palpate/scenario/content.h"
#include "palpate/scenario/derived.h"
#include "palpate/scenario/migrate.h"
#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate::scenario {
namespace {

std::string describe_shape(const Array& array) {
  std::string text;
  for (const std::int64_t extent : array.shape) {
    text += (text.empty() ? "(" : ", ") + std::to_string(extent);
  }
  return "shape " + text + ")";
}

/// Moves an array out of the container into a table of the scene.
template <class Row>
void take_table(Arrays& arrays, const std::string& name, const std::string& file,
                std::vector<Row>& table) {
  const auto at = arrays.find(name);
  if (at == arrays.end()) throw FileError(file, name, "no such array", "one; it may be empty");
  if (!is_table<Row>(at->second)) {
    const std::int64_t columns = RowOf<Row>::columns;
    throw FileError(file, name, describe_shape(at->second) + " or another type",
                    (columns > 0 ? "(n, " + std::to_string(columns) + ")" : "(n)") +
                        (dtype_of<Row>() == Dtype::f8 ? " of <f8" : " of <i4"));
  }
  table = to_table<Row>(std::move(at->second));
  arrays.erase(at);
}

/// What is left: arrays of the designer's document and of the assessment.
void take_documents(Arrays& arrays, const std::string& file, Scenario& scenario) {
  const std::string authored = "authored/", assessment = "assessment/";
  for (auto& [name, array] : arrays) {
    if (name.starts_with(authored)) {
      scenario.authored_arrays.emplace(name.substr(authored.size()), std::move(array));
    } else if (name.starts_with(assessment)) {
      scenario.assessment_arrays.emplace(name.substr(assessment.size()), std::move(array));
    } else {
      throw FileError(file, name, "an array of no known table", "none such");
    }
  }
}

void check_tetrahedra(const std::string& file, const std::string& table,
                      const std::vector<std::array<int, 4>>& corners, int particles) {
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (const int i : corners[t]) {
      if (i >= 0 && i < particles) continue;
      throw FileError(file, table + "/corners: row " + std::to_string(t),
                      "particle " + std::to_string(i), "0 to " + std::to_string(particles - 1));
    }
  }
}

/// Corners must be particles before what lies around each is found: all else is checked with the
/// rest of the tissue.
void check_corners(const std::string& file, const std::string& folder, const TissueModel& tissue) {
  const int count = particle_count(tissue);
  check_tetrahedra(file, folder + "tissue/volumes", tissue.volumes.corners, count);
  check_tetrahedra(file, folder + "tissue/elastic", tissue.elastic.corners, count);
  check_tetrahedra(file, folder + "tissue/corotated", tissue.corotated.corners, count);
  check_tetrahedra(file, folder + "tissue/neo_hookean", tissue.neo_hookean.corners, count);
}

/// The same sentence as a FileError: an argument is refused as "where: got this, expected that".
[[noreturn]] void refuse(const std::string& file, const std::string& sentence) {
  constexpr std::string_view kGot = ": got ", kExpected = ", expected ";
  const std::size_t got = sentence.find(kGot), expected = sentence.rfind(kExpected);
  if (got == std::string::npos || expected == std::string::npos || expected < got) {
    throw FileError(file, "", sentence, "a scene that can be built");
  }
  const std::size_t begin = got + kGot.size();
  throw FileError(file, sentence.substr(0, got), sentence.substr(begin, expected - begin),
                  sentence.substr(expected + kExpected.size()));
}

/// What a migration refuses it does not know the file of.
void migrate_file(const std::string& file, Container& container) {
  try {
    migrate(migrations(), container);
  } catch (const FileError& problem) {
    throw FileError(file, problem.where, problem.got, problem.expected);
  }
}

}  // namespace

Scenario unpack(Container container, const std::string& file) {
  Scenario scenario;
  scenario.version = container.version;
  scenario.written_by = std::move(container.written_by);
  migrate_file(file, container);
  parse_content(container.content, file, scenario);
  visit_tables(scenario.scene, [&](const std::string& name, auto& table) {
    take_table(container.arrays, name, file, table);
  });
  std::vector<SoftBody>& bodies = scenario.scene.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::string name = name_far_compliance(b);
    if (!container.arrays.contains(name)) continue;
    take_table(container.arrays, name, file, bodies[b].far_compliance);
  }
  take_documents(container.arrays, file, scenario);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    check_corners(file, name_folder(b), bodies[b].tissue);
    find_around(bodies[b].tissue);
  }
  try {
    const Scene built = check_built(scenario.scene);
    scenario.scene.identity = built.identity;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].kernel = built.bodies[b].kernel;
      bodies[b].least_damping_time = built.bodies[b].least_damping_time;
      bodies[b].response = built.bodies[b].response;
      bodies[b].near_field = built.bodies[b].near_field;
    }
  } catch (const std::invalid_argument& problem) {
    refuse(file, problem.what());
  }
  check_assessment(scenario, file);
  return scenario;
}

Scenario read(const std::string& path) {
  return unpack(read_container(path, "palpate", newest_version()), path);
}

}  // namespace palpate::scenario
