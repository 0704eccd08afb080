// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "palpate/scenario/assessment.h"
#include "palpate/scenario/json_fields.h"

// Not installed: how an assessment is read, part by part. Each throws FileError.

namespace palpate::scenario {

inline constexpr std::size_t kMostIdBytes = 100;

/// What is wrong with an id of a step, a place ...: small letters, digits, `_` and `-`.
std::optional<std::string> find_id_problem(std::string_view id);
/// A member that is such an id.
std::string read_id(Fields& fields, const char* name);
/// The member `name` as an object, its members by name, each an id; empty where it is missing.
std::vector<std::pair<std::string, Fields>> read_named(Fields& fields, const char* name,
                                                       std::size_t most, const std::string& file,
                                                       const std::string& where);

/// Level and seed of an attempt, and what its parameters come to.
class Parameters {
 public:
  Parameters(std::string id, std::string level, std::uint64_t seed)
      : id_(std::move(id)), level_(std::move(level)), seed_(seed) {}

  /// The member "parameters", where there is one.
  void read(Fields& fields, const std::string& file, const std::string& where,
            const std::vector<std::string>& levels);

  /// A member that is a number, or "$name" of one.
  double number(Fields& fields, const char* name);
  double number_or(Fields& fields, const char* name, double usual);
  /// The same of an element of a list.
  double number(Fields& fields, const char* name, const Json& value);
  /// [least or null, most or null]; without bounds where it is missing.
  Band band(Fields& fields, const char* name);
  /// A place, or "$name" of one.
  std::string place(Fields& fields, const char* name);

  /// Refuses parameters that choose what is none of the places, whichever this seed has drawn.
  void check_places(const std::string& file, const std::string& where,
                    const std::map<std::string, int, std::less<>>& places) const;
  /// Refuses parameters that nothing has asked for.
  void finish(const std::string& file, const std::string& where) const;
  std::vector<DrawnValue> list() const;

 private:
  DrawnValue draw_value(const std::string& name, Fields fields,
                        const std::vector<std::string>& levels);
  double choose_value(Fields& fields, const std::vector<std::string>& levels) const;
  const DrawnValue& find(Fields& fields, const char* name, const std::string& reference);

  std::string id_, level_;
  std::uint64_t seed_;
  std::map<std::string, DrawnValue, std::less<>> values_;
  std::set<std::string, std::less<>> used_;
  std::map<std::string, std::vector<std::string>> choices_;  ///< of those that choose a place
};

/// Where the rows of a task stand, by id.
struct Names {
  std::map<std::string, int, std::less<>> bodies, instruments, places, steps;
  std::map<std::string, int, std::less<>> inclusions;  ///< places that have one, and their bodies
  std::map<std::string, int, std::less<>> objects;     ///< of Scene::rigid
  std::set<std::string, std::less<>> graspers;         ///< tools that can hold
  std::set<std::string, std::less<>> laparoscopes;     ///< tools that see
  std::set<std::string, std::less<>> texts;            ///< keys in English
};

/// What refusals of an assessment call it.
inline constexpr const char* kWhere = "manifest.json: content.assessment";

/// Which organ is which body, which tool which instrument and which object which rigid body;
/// without a number they are the only one. `drawn` gets the cameras.
void read_bodies_and_instruments(Fields& fields, const Scene& scene, const std::string& file,
                                 Names& names, DrawnTask& drawn);

/// Reads places, steps and limits into a task; `drawn` gets their ids.
void read_places(Fields& fields, const Arrays& arrays, const std::string& file,
                 const std::string& where, Parameters& parameters, Names& names, DrawnTask& drawn);
void read_steps(Fields& fields, Parameters& parameters, Names& names, DrawnTask& drawn);
void read_limits(Fields& fields, Parameters& parameters, const Names& names, DrawnTask& drawn);

/// A key of a text that is there in English.
void read_text_key(Fields& fields, const char* name, const Names& names);
int find_row(Fields& fields, const char* name, const std::string& id,
             const std::map<std::string, int, std::less<>>& rows, const char* what);
/// The instrument of the member "tool", which may be left out where there is one.
int read_tool(Fields& fields, const Names& names, std::string& tool);

/// The name of a place's vertices in a container.
inline std::string name_place_array(std::string_view id) {
  return "assessment/places/" + std::string(id);
}

/// Which place's inclusion an attempt has; refused where there are some and none is chosen.
void read_inclusion(Fields& fields, Parameters& parameters, const Names& names, DrawnTask& drawn);

/// The whole of a scenario's assessment for one level and seed; `file` is what refusals call it.
DrawnTask read_assessment(const Scenario& scenario, const std::string& level, std::uint64_t seed,
                          const std::string& file);
/// The same for every level, as a file is checked.
void check_assessment(const Scenario& scenario, const std::string& file);

}  // namespace palpate::scenario
