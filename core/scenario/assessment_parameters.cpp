// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/scenario/assessment_parts.h"
#include "palpate/scenario/manifest.h"

namespace palpate::scenario {
namespace {

constexpr const char* kPlaceUnit = "place";
constexpr std::size_t kMostChoices = 100;
constexpr double kLargest = 1e6;  ///< of any number, in its unit

bool is_reference(const Json& value) {
  return value.is_string() && value.get_ref<const std::string&>().starts_with('$');
}

double read_finite(Fields& fields, const char* name, const Json& value) {
  if (!value.is_number() || !(std::abs(value.get<double>()) <= kLargest)) {
    fields.refuse(name, describe(value), "a number from -1e6 to 1e6");
  }
  return value.get<double>();
}

}  // namespace

std::optional<std::string> find_id_problem(std::string_view id) {
  if (id.empty() || id.size() > kMostIdBytes) return "which is empty or too long";
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!std::ranges::all_of(id, fits)) return "with other characters";
  return std::nullopt;
}

std::string read_id(Fields& fields, const char* name) {
  const std::string id = fields.text(name, kMostIdBytes);
  if (const auto problem = find_id_problem(id)) {
    fields.refuse(name, describe(Json(id)) + ", " + *problem, "small letters, digits, _ and -");
  }
  return id;
}

std::vector<std::pair<std::string, Fields>> read_named(Fields& fields, const char* name,
                                                       std::size_t most, const std::string& file,
                                                       const std::string& where) {
  std::vector<std::pair<std::string, Fields>> named;
  if (!fields.has(name)) return named;
  const Json& members = fields.any(name);
  if (!members.is_object() || members.size() > most) {
    fields.refuse(name, members.is_object() ? std::to_string(members.size()) : describe(members),
                  "an object of at most " + std::to_string(most));
  }
  for (const auto& [id, member] : members.items()) {
    if (const auto problem = find_id_problem(id)) {
      fields.refuse(name, "the name " + describe(Json(id)) + ", " + *problem,
                    "small letters, digits, _ and -");
    }
    named.emplace_back(id, Fields(member, file, where + "." + name + "." + id));
  }
  return named;
}

double draw(std::uint64_t seed, std::string_view id, std::string_view name) {
  const std::string text = std::to_string(seed) + "\n" + std::string(id) + "\n" + std::string(name);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const std::string digits = compute_sha256({bytes, text.size()});
  // 56 bits, of which the first 53
  const std::uint64_t bits = std::stoull(digits.substr(0, 14), nullptr, 16) >> 3;
  return std::ldexp(static_cast<double>(bits), -53);
}

void Parameters::read(Fields& fields, const std::string& file, const std::string& where,
                      const std::vector<std::string>& levels) {
  for (auto& [name, members] : read_named(fields, "parameters", kMostParameters, file, where)) {
    values_.emplace(name, draw_value(name, std::move(members), levels));
  }
}

DrawnValue Parameters::draw_value(const std::string& name, Fields fields,
                                  const std::vector<std::string>& levels) {
  DrawnValue drawn{.name = name, .unit = "", .value = 0.0, .place = ""};
  constexpr std::array<const char*, 7> kUnits = {"N", "m", "s", "rad", "m3", "1", kPlaceUnit};
  drawn.unit = kUnits[fields.choice("unit", {"N", "m", "s", "rad", "m3", "1", kPlaceUnit})];
  const double at = draw(seed_, id_, name);
  if (fields.has("uniform")) {
    const Json& ends = fields.any("uniform");
    if (!ends.is_array() || ends.size() != 2 || drawn.unit == kPlaceUnit) {
      fields.refuse("uniform", describe(ends), "two numbers, the least and the most");
    }
    const double least = read_finite(fields, "uniform", ends[0]);
    const double most = read_finite(fields, "uniform", ends[1]);
    if (!(least <= most)) fields.refuse("uniform", "the greater first", "the least and the most");
    drawn.value = least + at * (most - least);
  } else if (fields.has("choose")) {
    const Json& choices = fields.any("choose");
    if (!choices.is_array() || choices.empty() || choices.size() > kMostChoices) {
      fields.refuse("choose", describe(choices), "a list of 1 to 100");
    }
    const auto count = static_cast<double>(choices.size());
    const Json& chosen = choices[static_cast<std::size_t>(at * count)];
    const bool of_text = drawn.unit == kPlaceUnit;
    for (const Json& choice : choices) {
      if (of_text ? !choice.is_string() : !choice.is_number()) {
        fields.refuse("choose", describe(choice), of_text ? "ids of places" : "numbers");
      }
      if (of_text) choices_[name].push_back(choice.get<std::string>());
      if (!of_text) read_finite(fields, "choose", choice);
    }
    if (of_text) drawn.place = chosen.get<std::string>();
    if (!of_text) drawn.value = read_finite(fields, "choose", chosen);
  } else {
    if (drawn.unit == kPlaceUnit) fields.refuse("unit", "a place", "one beside choose");
    drawn.value = choose_value(fields, levels);
  }
  fields.finish();
  return drawn;
}

/// The value of this level, else the one that stands for all.
double Parameters::choose_value(Fields& fields, const std::vector<std::string>& levels) const {
  double value = read_finite(fields, "value", fields.any("value"));
  if (!fields.has("levels")) return value;
  const Json& others = fields.any("levels");
  if (!others.is_object()) fields.refuse("levels", describe(others), "an object");
  for (const auto& [level, other] : others.items()) {
    if (std::ranges::find(levels, level) == levels.end()) {
      fields.refuse("levels", describe(Json(level)), "one of the scenario's levels");
    }
    const double number = read_finite(fields, "levels", other);
    if (level == level_) value = number;
  }
  return value;
}

const DrawnValue& Parameters::find(Fields& fields, const char* name, const std::string& reference) {
  const auto at = values_.find(reference.substr(1));
  if (at == values_.end()) {
    fields.refuse(name, describe(Json(reference)), "$ and the name of a parameter");
  }
  used_.insert(at->first);
  return at->second;
}

double Parameters::number(Fields& fields, const char* name, const Json& value) {
  if (!is_reference(value)) return read_finite(fields, name, value);
  const DrawnValue& found = find(fields, name, value.get<std::string>());
  if (found.unit == kPlaceUnit) fields.refuse(name, "a place", "a number");
  return found.value;
}

double Parameters::number(Fields& fields, const char* name) {
  return number(fields, name, fields.any(name));
}

double Parameters::number_or(Fields& fields, const char* name, double usual) {
  return fields.has(name) ? number(fields, name) : usual;
}

Band Parameters::band(Fields& fields, const char* name) {
  Band band;
  if (!fields.has(name)) return band;
  const Json& ends = fields.any(name);
  if (!ends.is_array() || ends.size() != 2 || (ends[0].is_null() && ends[1].is_null())) {
    fields.refuse(name, describe(ends), "[least, most], one of which may be null");
  }
  if (!ends[0].is_null()) band.least = number(fields, name, ends[0]);
  if (!ends[1].is_null()) band.most = number(fields, name, ends[1]);
  if (!(band.least <= band.most)) {
    fields.refuse(name, "an empty band", "a least value no greater than the most");
  }
  return band;
}

std::string Parameters::place(Fields& fields, const char* name) {
  const std::string text = fields.text(name, kMostIdBytes + 1);
  if (!text.starts_with('$')) return text;
  const DrawnValue& found = find(fields, name, text);
  if (found.unit != kPlaceUnit) fields.refuse(name, "a number", "a place");
  return found.place;
}

void Parameters::check_places(const std::string& file, const std::string& where,
                              const std::map<std::string, int, std::less<>>& places) const {
  for (const auto& [name, choices] : choices_) {
    for (const std::string& choice : choices) {
      if (places.contains(choice)) continue;
      throw FileError(file, where + ".parameters." + name + ".choose", describe(Json(choice)),
                      "the id of a place");
    }
  }
}

void Parameters::finish(const std::string& file, const std::string& where) const {
  for (const auto& [name, value] : values_) {
    if (used_.contains(name)) continue;
    throw FileError(file, where + ".parameters." + name, "a parameter that nothing uses",
                    "\"$" + name + "\" somewhere");
  }
}

std::vector<DrawnValue> Parameters::list() const {
  std::vector<DrawnValue> listed;
  for (const auto& [name, value] : values_) listed.push_back(value);
  return listed;
}

}  // namespace palpate::scenario
