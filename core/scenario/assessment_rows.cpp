// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <utility>

#include "palpate/scenario/assessment_parts.h"

namespace palpate::scenario {
namespace {

constexpr std::array<std::pair<const char*, TaskVerb>, 11> kVerbs = {{
    {"touch", TaskVerb::touch},
    {"hold", TaskVerb::hold},
    {"push", TaskVerb::push},
    {"pull", TaskVerb::pull},
    {"grasp", TaskVerb::grasp},
    {"release", TaskVerb::release},
    {"trace", TaskVerb::trace},
    {"find", TaskVerb::find},
    {"look", TaskVerb::look},
    {"remove", TaskVerb::remove},
    {"carry", TaskVerb::carry},
}};
/// Verbs and measures of the format that cannot be judged yet, and what they wait for.
constexpr std::array<std::pair<const char*, const char*>, 2> kVerbsToCome = {{
    {"inject", "there is no syringe"},
    {"cut", "there are no scissors"},
}};
constexpr std::array<std::pair<const char*, TaskMeasure>, 14> kMeasures = {{
    {"force", TaskMeasure::force},
    {"force_rate", TaskMeasure::force_rate},
    {"contact", TaskMeasure::contact},
    {"depth", TaskMeasure::depth},
    {"distance", TaskMeasure::distance},
    {"speed", TaskMeasure::speed},
    {"clearance", TaskMeasure::clearance},
    {"path.off", TaskMeasure::off_path},
    {"strain", TaskMeasure::strain},
    {"loose", TaskMeasure::loose},
    {"out_of_view", TaskMeasure::out_of_view},
    {"object_force", TaskMeasure::object_force},
    {"pad_pressure", TaskMeasure::pad_pressure},
    {"torn", TaskMeasure::torn},
}};
constexpr std::array<std::pair<const char*, const char*>, 7> kMeasuresToCome = {{
    {"path.progress", "a step that traces asks for it"},
    {"volume", "there is no syringe"},
    {"cut.length", "there are no scissors"},
    {"cut.off", "there are no scissors"},
    {"in_view", "a step that looks asks for it"},
    {"holds", "a step that grasps asks for it"},
    {"inside", "a step that carries asks for it"},
}};

/// The row of a table that a member names; what is to come is refused with the reason.
template <class Rows, class ToCome>
auto read_row(Fields& fields, const char* name, const Rows& rows, const ToCome& to_come) {
  const std::string word = fields.text(name, kMostIdBytes);
  std::string known;
  for (const auto& [candidate, value] : rows) {
    if (word == candidate) return value;
    known += (known.empty() ? "" : ", ") + std::string(candidate);
  }
  for (const auto& [candidate, reason] : to_come) {
    if (word != candidate) continue;
    fields.refuse(name, describe(Json(word)) + ", which cannot be judged yet: " + reason,
                  "one of " + known);
  }
  fields.refuse(name, describe(Json(word)), "one of " + known);
}

/// A path that is traced with another width is a place of its own.
int with_width(int place, double width, DrawnTask& drawn) {
  TaskPlace& first = drawn.task.places[static_cast<std::size_t>(place)];
  if (first.radius == width) return place;
  TaskPlace other = first;
  other.radius = width;
  drawn.task.places.push_back(std::move(other));
  drawn.places.push_back(drawn.places[static_cast<std::size_t>(place)]);
  return static_cast<int>(drawn.task.places.size()) - 1;
}

/// Bands and what else belongs to each verb; a member that another one has is refused as unknown.
void read_verb(Fields& fields, Parameters& parameters, DrawnTask& drawn, TaskStep& step) {
  const auto is = [&](auto... verbs) { return ((step.verb == verbs) || ...); };
  if (is(TaskVerb::hold, TaskVerb::push, TaskVerb::pull, TaskVerb::trace, TaskVerb::find)) {
    step.force = parameters.band(fields, "force_N");
  }
  if (is(TaskVerb::hold, TaskVerb::push)) step.depth = parameters.band(fields, "depth_m");
  if (is(TaskVerb::pull, TaskVerb::look)) step.distance = parameters.band(fields, "distance_m");
  if (is(TaskVerb::trace)) {
    step.share = parameters.number_or(fields, "share", 1.0);
    const TaskPlace& path = drawn.task.places[static_cast<std::size_t>(step.place)];
    const double width = parameters.number_or(fields, "off_path_m", path.radius);
    step.place = with_width(step.place, width, drawn);
  }
  const bool has_band = fields.has("force_N") || fields.has("depth_m") || fields.has("distance_m");
  if (is(TaskVerb::hold, TaskVerb::push, TaskVerb::pull) && !has_band) {
    fields.refuse("do", "no band of force, depth or distance", "at least one");
  }
  if (!is(TaskVerb::trace, TaskVerb::find)) {
    step.duration = parameters.number_or(fields, "for_s", 0.0);
  }
  step.time_limit = parameters.number_or(fields, "within_s", 0.0);
}

std::vector<int> read_step_list(Fields& fields, const char* name, const Names& names) {
  const Json& list = fields.any(name);
  if (!list.is_array()) fields.refuse(name, describe(list), "a list of ids of steps");
  std::vector<int> rows;
  for (const Json& id : list) {
    if (!id.is_string()) fields.refuse(name, describe(id), "the id of a step");
    rows.push_back(find_row(fields, name, id.get<std::string>(), names.steps, "the id of a step"));
  }
  return rows;
}

int read_at(Fields& fields, const char* name, Parameters& parameters, const Names& names) {
  return find_row(fields, name, parameters.place(fields, name), names.places,
                  "a place of the scenario");
}

TaskStep read_step(Fields fields, std::size_t s, Parameters& parameters, const Names& names,
                   DrawnTask& drawn) {
  TaskStep step;
  fields.any("id");
  step.verb = read_row(fields, "do", kVerbs, kVerbsToCome);
  std::string tool;
  step.instrument = read_tool(fields, names, tool);
  const bool moves = step.verb == TaskVerb::carry || step.verb == TaskVerb::remove;
  const bool holds = moves || step.verb == TaskVerb::grasp || step.verb == TaskVerb::pull ||
                     step.verb == TaskVerb::release;
  if (holds && !names.graspers.contains(tool)) {
    fields.refuse("do", "a step for which the tool must hold", "a tool of the kind grasper");
  }
  if (fields.has("at") || step.verb != TaskVerb::release) {
    step.place = read_at(fields, "at", parameters, names);
  }
  if (step.verb == TaskVerb::look && !names.laparoscopes.contains(tool)) {
    fields.refuse("do", "a step for which the tool must see", "a tool of the kind laparoscope");
  }
  if (moves) {
    const char* which = step.verb == TaskVerb::carry ? "to" : "from";
    step.space = read_at(fields, which, parameters, names);
  }
  if (step.verb == TaskVerb::trace &&
      drawn.task.places[static_cast<std::size_t>(step.place)].kind != PlaceKind::path) {
    fields.refuse("at", "a place that is no path", "a path, which is what is traced");
  }
  read_verb(fields, parameters, drawn, step);
  read_text_key(fields, "say", names);
  if (fields.has("after")) {
    step.after = read_step_list(fields, "after", names);
  } else if (s > 0) {
    step.after = {static_cast<int>(s) - 1};
  }
  fields.finish();
  return step;
}

TaskLimit read_limit(Fields fields, Parameters& parameters, const Names& names) {
  constexpr std::array kConsequences = {LimitConsequence::warn, LimitConsequence::error,
                                        LimitConsequence::end};
  TaskLimit limit;
  fields.any("id");
  Fields when = fields.object("when");
  limit.measure = read_row(when, "measure", kMeasures, kMeasuresToCome);
  std::string tool;
  limit.instrument = read_tool(when, names, tool);
  if (when.has("place")) limit.place = read_at(when, "place", parameters, names);
  if (!is_yes_or_no(limit.measure)) {
    limit.above = !when.has("below");
    limit.bound = parameters.number(when, limit.above ? "above" : "below");
  }
  limit.duration = parameters.number_or(when, "for_s", limit.duration);
  when.finish();
  limit.then = kConsequences[fields.choice("then", {"warn", "error", "end"})];
  read_text_key(fields, "say", names);
  if (fields.has("during")) limit.during = read_step_list(fields, "during", names);
  fields.finish();
  return limit;
}

}  // namespace

void read_text_key(Fields& fields, const char* name, const Names& names) {
  const std::string key = fields.text(name, kMostIdBytes);
  if (!names.texts.contains(key)) {
    fields.refuse(name, describe(Json(key)), "a text that texts.en has");
  }
}

int find_row(Fields& fields, const char* name, const std::string& id,
             const std::map<std::string, int, std::less<>>& rows, const char* what) {
  const auto at = rows.find(id);
  if (at == rows.end()) fields.refuse(name, describe(Json(id)), what);
  return at->second;
}

int read_tool(Fields& fields, const Names& names, std::string& tool) {
  if (!fields.has("tool") && names.instruments.size() == 1) {
    tool = names.instruments.begin()->first;
  } else {
    tool = fields.text("tool", kMostIdBytes);
  }
  return find_row(fields, "tool", tool, names.instruments, "a tool of the scenario");
}

void read_steps(Fields& fields, Parameters& parameters, Names& names, DrawnTask& drawn) {
  std::vector<Fields> rows = fields.objects("steps", kMostSteps);
  for (Fields& row : rows) {
    const std::string id = read_id(row, "id");
    if (!names.steps.emplace(id, static_cast<int>(drawn.steps.size())).second) {
      row.refuse("id", describe(Json(id)) + " once more", "an id of its own");
    }
    drawn.steps.push_back(id);
  }
  for (std::size_t s = 0; s < rows.size(); ++s) {
    drawn.task.steps.push_back(read_step(std::move(rows[s]), s, parameters, names, drawn));
  }
}

void read_limits(Fields& fields, Parameters& parameters, const Names& names, DrawnTask& drawn) {
  if (!fields.has("limits")) return;
  for (Fields& row : fields.objects("limits", kMostLimits)) {
    const std::string id = read_id(row, "id");
    if (std::ranges::find(drawn.limits, id) != drawn.limits.end()) {
      row.refuse("id", describe(Json(id)) + " once more", "an id of its own");
    }
    drawn.limits.push_back(id);
    drawn.task.limits.push_back(read_limit(std::move(row), parameters, names));
  }
}

}  // namespace palpate::scenario
