// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/write.h"

#include <stdexcept>

#include "palpate/scenario/assessment_parts.h"
#include "palpate/scenario/content.h"
#include "palpate/scenario/derived.h"
#include "palpate/scenario/migrate.h"
#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"
#include "palpate/sim/base/error.h"

namespace palpate::scenario {

namespace {

/// Refused as an argument: it is of no file yet.
void check_task(const Scenario& scenario) {
  try {
    check_assessment(scenario, "");
  } catch (const FileError& problem) {
    throw std::invalid_argument("scenario: " + problem.where + ": got " + problem.got +
                                ", expected " + problem.expected);
  }
}

}  // namespace

Container pack(const Scenario& scenario) {
  check_built(scenario.scene);
  check_task(scenario);
  Container container{"palpate", newest_version(), print_content(scenario), {}, ""};
  visit_tables(scenario.scene, [&](const std::string& name, const auto& table) {
    container.arrays[name] = to_array(table);
  });
  for (std::size_t b = 0; b < scenario.scene.bodies.size(); ++b) {
    const std::vector<Symmetric>& far = scenario.scene.bodies[b].far_compliance;
    if (!far.empty()) container.arrays[name_far_compliance(b)] = to_array(far);
  }
  for (const auto& [name, array] : scenario.authored_arrays) {
    container.arrays["authored/" + name] = array;
  }
  for (const auto& [name, array] : scenario.assessment_arrays) {
    container.arrays["assessment/" + name] = array;
  }
  return container;
}

void write(const std::string& path, const Scenario& scenario) {
  write_container(path, pack(scenario));
}

}  // namespace palpate::scenario
