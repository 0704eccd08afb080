// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/assessment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "palpate/scenario/assessment_parts.h"
#include "palpate/scenario/inclusion.h"
#include "palpate/scenario/manifest.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::scenario {
namespace {

constexpr std::size_t kMostTextBytes = 2000;
constexpr int kNewest = 1;

/// Of every language, and their keys in English.
void read_texts(Fields& fields, const std::string& file, Names& names) {
  const std::string where = std::string(kWhere) + ".texts";
  const Json& languages = fields.any("texts");
  if (!languages.is_object() || languages.size() > kMostLanguages) {
    fields.refuse("texts", describe(languages), "an object of at most 50 languages");
  }
  if (!languages.contains("en")) fields.refuse("texts.en", "nothing", "the texts in English");
  for (const auto& [code, texts] : languages.items()) {
    if (const auto problem = find_language_problem(code)) {
      fields.refuse("texts", "the code " + describe(Json(code)) + ", " + *problem,
                    "a code such as tr or pt-BR");
    }
    Fields said(texts, file, where + "." + code);
    if (texts.size() > kMostTexts) fields.refuse("texts", "too many texts", "at most 1000");
    for (const auto& [key, text] : texts.items()) {
      said.text(key.c_str(), kMostTextBytes);
      if (code == "en") names.texts.insert(key);
      if (languages["en"].contains(key)) continue;
      throw FileError(file, where + "." + code, "a text " + describe(Json(key)),
                      "one that texts.en has too");
    }
  }
}

std::vector<std::string> read_levels(Fields& fields) {
  std::vector<std::string> levels;
  if (!fields.has("levels")) return levels;
  const Json& list = fields.any("levels");
  if (!list.is_array() || list.empty() || list.size() > kMostLevels) {
    fields.refuse("levels", describe(list), "a list of 1 to 10 names");
  }
  for (const Json& level : list) {
    if (!level.is_string() || find_id_problem(level.get_ref<const std::string&>())) {
      fields.refuse("levels", describe(level), "names of small letters, digits, _ and -");
    }
    levels.push_back(level.get<std::string>());
    if (std::ranges::count(levels, levels.back()) > 1) {
      fields.refuse("levels", describe(level) + " once more", "each once");
    }
  }
  return levels;
}

std::string choose_level(const std::string& asked, const std::vector<std::string>& levels) {
  if (levels.empty() && asked.empty()) return "";
  if (asked.empty()) {
    const auto normal = std::ranges::find(levels, std::string("normal"));
    return normal == levels.end() ? levels.front() : *normal;
  }
  if (std::ranges::find(levels, asked) != levels.end()) return asked;
  std::string known;
  for (const std::string& level : levels) known += (known.empty() ? "" : ", ") + level;
  throw std::invalid_argument("level: got " + describe(Json(asked)) + ", expected " +
                              (known.empty() ? "none: there are no levels" : "one of " + known));
}

void read_finish(Fields fields, Parameters& parameters, Task& task) {
  task.time_limit = parameters.number(fields, "time_limit_s");
  if (fields.has("errors_at_most")) {
    task.errors_at_most = static_cast<int>(fields.whole("errors_at_most", 0, 1000000));
  }
  fields.finish();
}

/// What a debrief holds an attempt against; the judge knows nothing of it.
void read_goals(Fields& fields, Parameters& parameters) {
  constexpr std::size_t kMostGoals = 100;
  if (!fields.has("goals")) return;
  for (Fields& goal : fields.objects("goals", kMostGoals)) {
    goal.choice("metric", {"time", "errors", "warnings", "peak_force"});
    if (!goal.has("at_most") && !goal.has("at_least")) {
      goal.refuse("at_most", "no bound", "at_most, at_least or both");
    }
    for (const char* bound : {"at_most", "at_least"}) parameters.number_or(goal, bound, 0.0);
    Fields basis = goal.object("basis");
    basis.choice("kind", {"designer"});
    basis.finish();
    goal.finish();
  }
}

/// What is known of a task beside itself, and not read here.
constexpr const char *kSelfplay = "selfplay", *kReviews = "reviews";

void skip_provenance(Fields& fields) {
  constexpr std::size_t kMostReviews = 100;
  if (fields.has(kSelfplay) && !fields.any(kSelfplay).is_object()) {
    fields.refuse(kSelfplay, describe(fields.any(kSelfplay)), "an object");
  }
  if (!fields.has(kReviews)) return;
  for (Fields& review : fields.objects(kReviews, kMostReviews)) {
    review.choice("of", {"anatomy", "feel", "task", "translation"});
    for (const char* name : {"by", "role", "date", "content_sha256"}) {
      review.text(name, kMostTextBytes);
    }
    review.finish();
  }
}

std::string hash_assessment(Json parsed, const Arrays& arrays) {
  parsed.erase(kSelfplay);
  parsed.erase(kReviews);
  std::string text = parsed.dump();
  for (const auto& [name, array] : arrays) text += "\n" + name + " " + compute_sha256(array.bytes);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  return compute_sha256({bytes, text.size()});
}

/// The sentence of build_task, which counts places, with their ids.
[[noreturn]] void refuse_task(const std::string& file, const std::string& sentence,
                              const DrawnTask& drawn) {
  constexpr std::string_view kGot = ": got ", kExpected = ", expected ", kTask = "task: ";
  const std::size_t got = sentence.find(kGot), expected = sentence.rfind(kExpected);
  if (got == std::string::npos || expected == std::string::npos || expected < got) {
    throw FileError(file, kWhere, sentence, "a task that can be judged");
  }
  std::string where = sentence.substr(0, got);
  if (where.starts_with(kTask)) where.erase(0, kTask.size());
  if (where.starts_with("places[")) {
    const std::size_t end = where.find(']');
    const auto row = static_cast<std::size_t>(std::stoul(where.substr(7, end - 7)));
    where = "places." + drawn.places[row] + where.substr(end + 1);
  }
  const std::size_t begin = got + kGot.size();
  throw FileError(file, std::string(kWhere) + "." + where, sentence.substr(begin, expected - begin),
                  sentence.substr(expected + kExpected.size()));
}

/// Arrays that no place has.
void check_arrays(const std::string& file, const Arrays& arrays, const Json& parsed,
                  const Names& names) {
  constexpr std::string_view kConstants = "constants/";
  for (const auto& [name, array] : arrays) {
    const std::string place =
        name.starts_with(kConstants)
            ? name.substr(kConstants.size(), name.find('/', kConstants.size()) - kConstants.size())
            : "";
    if (names.inclusions.contains(place)) continue;
    const std::string id = name.starts_with("places/") ? name.substr(7) : "";
    const bool known = parsed["places"].contains(id) && parsed["places"][id].contains("region");
    if (!known) throw FileError(file, "assessment/" + name, "an array of no region", "none such");
  }
}

}  // namespace

namespace {

DrawnTask read_all(const Scenario& scenario, const std::string& level, std::uint64_t seed,
                   const std::string& file, Names& names) {
  const Json parsed = parse_object(scenario.assessment, file, kWhere);
  Fields fields(parsed, file, kWhere);
  DrawnTask drawn;
  drawn.seed = seed;
  const std::int64_t version =
      fields.whole("palpate_scenario", 1, std::numeric_limits<std::int64_t>::max());
  if (version > kNewest) {
    fields.refuse("palpate_scenario", std::to_string(version),
                  "1; it was made by a newer program, which is needed to open it");
  }
  drawn.id = read_id(fields, "id");
  drawn.version = fields.text("version", kMostIdBytes);
  const std::vector<std::string> levels = read_levels(fields);
  drawn.level = choose_level(level, levels);
  read_texts(fields, file, names);
  read_text_key(fields, "title", names);
  read_bodies_and_instruments(fields, scenario.scene, file, names, drawn);
  Parameters parameters(drawn.id, drawn.level, seed);
  parameters.read(fields, file, kWhere, levels);
  read_places(fields, scenario.assessment_arrays, file, kWhere, parameters, names, drawn);
  parameters.check_places(file, kWhere, names.places);
  read_inclusion(fields, parameters, names, drawn);
  read_steps(fields, parameters, names, drawn);
  read_limits(fields, parameters, names, drawn);
  read_finish(fields.object("finish"), parameters, drawn.task);
  read_goals(fields, parameters);
  skip_provenance(fields);
  fields.finish();
  parameters.finish(file, kWhere);
  check_arrays(file, scenario.assessment_arrays, parsed, names);
  drawn.values = parameters.list();
  drawn.sha256 = hash_assessment(parsed, scenario.assessment_arrays);
  try {
    drawn.task = build_task(scenario.scene, std::move(drawn.task));
  } catch (const std::invalid_argument& problem) {
    refuse_task(file, problem.what(), drawn);
  }
  return drawn;
}

}  // namespace

DrawnTask read_assessment(const Scenario& scenario, const std::string& level, std::uint64_t seed,
                          const std::string& file) {
  Names names;
  return read_all(scenario, level, seed, file, names);
}

void check_assessment(const Scenario& scenario, const std::string& file) {
  if (scenario.assessment.empty()) {
    if (scenario.assessment_arrays.empty()) return;
    throw FileError(file, "assessment/" + scenario.assessment_arrays.begin()->first,
                    "an array of an assessment", "none, as there is no assessment");
  }
  Names names;
  read_all(scenario, "", 0, file, names);
  check_inclusions(scenario, names, file);
  for (const std::string& level : list_levels(scenario)) read_assessment(scenario, level, 0, file);
}

std::vector<std::string> list_levels(const Scenario& scenario) {
  if (scenario.assessment.empty()) return {};
  try {
    const Json parsed = parse_object(scenario.assessment, "", "assessment");
    Fields fields(parsed, "", "assessment");
    return read_levels(fields);
  } catch (const FileError& problem) {
    throw std::invalid_argument(problem.where + ": got " + problem.got + ", expected " +
                                problem.expected);
  }
}

DrawnTask draw_task(const Scenario& scenario, const std::string& level, std::uint64_t seed) {
  if (scenario.assessment.empty()) {
    throw std::invalid_argument(
        "scenario: got one without an assessment, expected one with a task "
        "that can be judged");
  }
  try {
    return read_assessment(scenario, level, seed, "");
  } catch (const FileError& problem) {
    throw std::invalid_argument(problem.where + ": got " + problem.got + ", expected " +
                                problem.expected);
  }
}

Scene draw_scene(const Scenario& scenario, const DrawnTask& drawn) {
  if (drawn.inclusion.empty()) return scenario.scene;
  const auto row = static_cast<std::size_t>(drawn.inclusion_body);
  if (row >= scenario.scene.bodies.size()) {
    throw std::invalid_argument("drawn: got a task of another scenario, expected one of this");
  }
  Scene scene = scenario.scene;
  SoftBody& body = scene.bodies[row];
  const int least = body.substeps, most = body.substeps_max;
  try {
    body = with_inclusion(scenario.assessment_arrays, drawn.inclusion, std::move(body), "");
  } catch (const FileError& problem) {
    throw std::invalid_argument(problem.where + ": got " + problem.got + ", expected " +
                                problem.expected);
  }
  body.substeps = body.substeps_max = 0;  // what is stiffer may need more of them
  scene = build_scene(std::move(scene));
  SoftBody& built = scene.bodies[row];
  built.substeps = std::max(built.substeps, least);
  built.substeps_max = std::max({built.substeps_max, most, built.substeps});
  return scene;
}

}  // namespace palpate::scenario
