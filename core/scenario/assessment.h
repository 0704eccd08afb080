// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "palpate/scenario/scenario.h"
#include "palpate/sim/task/task.h"

/// The assessment of a scenario: what is asked of a trainee and judged, as it is authored
/// (CONTAINER.md: assessment), and the task that it comes to for one level and seed.
namespace palpate::scenario {

inline constexpr std::size_t kMostParameters = 100;
inline constexpr std::size_t kMostLevels = 10;
inline constexpr std::size_t kMostTexts = 1000;  ///< in each language

/// A parameter of an attempt.
struct DrawnValue {
  std::string name;
  std::string unit;    ///< N, m, s, rad, m3, place, or 1 for none
  double value = 0.0;  ///< in that unit; 0 of a place
  std::string place;   ///< its id; else empty
};

/// What is judged in one attempt, and the names of its rows.
struct DrawnTask {
  Task task;  ///< of build_task
  std::string id;
  std::string version;
  std::string level;  ///< empty where there are none
  std::uint64_t seed = 0;
  std::string sha256;               ///< of the assessment, whatever level and seed
  std::vector<std::string> steps;   ///< their ids, in order of the task's
  std::vector<std::string> limits;  ///< likewise
  std::vector<std::string> places;  ///< likewise; of a path with another width, once more
  std::vector<DrawnValue> values;   ///< by name
  /// Id of the place whose inclusion, a stiff spot, this attempt has; empty for none
  std::string inclusion;
  int inclusion_body = 0;  ///< of the scene, where that is
};

/// A number from 0 to below 1 for a parameter of a scenario, the same wherever it is drawn: of the
/// first 53 bits of the SHA-256 of seed, id and name, in text with a line feed between them. A
/// parameter that is added changes no other.
double draw(std::uint64_t seed, std::string_view id, std::string_view name);

/// The levels of a scenario's assessment; empty where there are none.
std::vector<std::string> list_levels(const Scenario& scenario);

/// The task of an attempt. An empty level is `normal`, or the first where there is no such. Throws
/// std::invalid_argument for a level that is not there, a scenario without an assessment, and one
/// that cannot be judged, naming the place in it, what it got and what was expected.
DrawnTask draw_task(const Scenario& scenario, const std::string& level = "",
                    std::uint64_t seed = 0);

/// The scene of an attempt: the scenario's, with the constants of the inclusion that was drawn, and
/// as many substeps as those need. Throws std::invalid_argument for constants that cannot be built.
Scene draw_scene(const Scenario& scenario, const DrawnTask& drawn);

}  // namespace palpate::scenario
