// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/json_fields.h"

#include <algorithm>
#include <stdexcept>

#include "palpate/scenario/container.h"

namespace palpate::scenario {
namespace {

/// Goes through a document before it is built, for what the parser lets pass: members of one name,
/// of which it would keep the last, and depth, on which it has no limit. (The parser's own callback
/// would do, but the time it takes grows with the square of a list's length.)
class Watch : public nlohmann::json_sax<Json> {
 public:
  Watch(const std::string& file, const std::string& where) : file_(file), where_(where) {}

  bool start_object(std::size_t) override {
    enter();
    names_.emplace_back();
    return true;
  }
  bool end_object() override {
    names_.pop_back();
    return leave();
  }
  bool start_array(std::size_t) override {
    enter();
    return true;
  }
  bool end_array() override { return leave(); }
  bool key(string_t& name) override {
    if (!names_.back().insert(name).second) {
      refuse("two members named " + describe(Json(name)), "one");
    }
    return true;
  }
  bool parse_error(std::size_t byte, const std::string&, const Json::exception& problem) override {
    if (dynamic_cast<const Json::out_of_range*>(&problem) != nullptr) {
      refuse("a number too large for a float of 8 bytes", "JSON");
    }
    refuse("text that is not JSON from byte " + std::to_string(byte), "JSON");
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }

 private:
  void enter() {
    if (++depth_ > kMostDepth) {
      refuse("values within more than " + std::to_string(kMostDepth) + " others", "fewer");
    }
  }
  bool leave() {
    --depth_;
    return true;
  }
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw FileError(file_, where_, found, expected);
  }

  std::string file_, where_;
  std::vector<std::set<std::string>> names_;
  int depth_ = 0;
};

}  // namespace

Json parse_object(std::string_view text, const std::string& file, const std::string& where) {
  Watch watch(file, where);
  Json::sax_parse(text.begin(), text.end(), &watch);
  Json parsed = Json::parse(text.begin(), text.end());
  if (!parsed.is_object()) throw FileError(file, where, describe(parsed), "an object");
  return parsed;
}

std::string print(const Json& json, const std::string& where) {
  try {
    return json.dump();
  } catch (const Json::exception&) {
    throw std::invalid_argument(where + ": got text that is not UTF-8, expected UTF-8");
  }
}

std::string describe(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

Fields::Fields(const Json& object, std::string file, std::string where)
    : object_(object), file_(std::move(file)), where_(std::move(where)) {
  if (!object_.is_object()) throw FileError(file_, where_, describe(object_), "an object");
}

const Json& Fields::any(const char* name) {
  known_.insert(name);
  const auto at = object_.find(name);
  if (at == object_.end()) refuse(name, "nothing", "a value");
  return *at;
}

Fields Fields::object(const char* name) { return Fields(any(name), file_, place(name)); }

bool Fields::is_empty_list(const char* name) {
  const Json& list = any(name);
  return list.is_array() && list.empty();
}

std::vector<Fields> Fields::objects(const char* name, std::size_t most) {
  const Json& list = any(name);
  if (!list.is_array() || list.empty() || list.size() > most) {
    refuse(name, describe(list), "a list of 1 to " + std::to_string(most));
  }
  std::vector<Fields> fields;
  for (const Json& object : list) {
    fields.emplace_back(object, file_, place(name) + "[" + std::to_string(fields.size()) + "]");
  }
  return fields;
}

std::string Fields::text(const char* name, std::size_t most_bytes) {
  const Json& value = any(name);
  if (!value.is_string()) refuse(name, describe(value), "text");
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > most_bytes) {
    refuse(name, std::to_string(text.size()) + " bytes of text",
           "at most " + std::to_string(most_bytes));
  }
  return text;
}

double Fields::number(const char* name) {
  const Json& value = any(name);
  if (!value.is_number()) refuse(name, describe(value), "a number");
  return value.get<double>();
}

double Fields::number_or(const char* name, double usual) {
  return object_.contains(name) ? number(name) : usual;
}

std::vector<double> Fields::numbers(const char* name, std::size_t count) {
  const Json& list = any(name);
  if (!list.is_array() || list.size() != count ||
      !std::ranges::all_of(list, [](const Json& number) { return number.is_number(); })) {
    refuse(name, describe(list), "a list of " + std::to_string(count) + " numbers");
  }
  return list.get<std::vector<double>>();
}

std::vector<int> Fields::indices(const char* name, std::size_t most, std::size_t below) {
  const Json& list = any(name);
  const auto is_index = [below](const Json& index) {
    return index.is_number_unsigned() && index.get<std::uint64_t>() < below;
  };
  if (!list.is_array() || list.size() > most || !std::ranges::all_of(list, is_index)) {
    refuse(name, list.is_array() ? list.dump().substr(0, 60) : describe(list),
           "a list of at most " + std::to_string(most) + " whole numbers from 0 to " +
               std::to_string(below - 1));
  }
  return list.get<std::vector<int>>();
}

std::int64_t Fields::whole(const char* name, std::int64_t least, std::int64_t most) {
  const Json& value = any(name);
  const bool fits = value.is_number_integer() &&
                    !(value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX) &&
                    value.get<std::int64_t>() >= least && value.get<std::int64_t>() <= most;
  if (!fits) {
    refuse(name, describe(value),
           "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value.get<std::int64_t>();
}

std::size_t Fields::choice(const char* name, std::initializer_list<const char*> names) {
  const Json& value = any(name);
  std::string known;
  std::size_t index = 0;
  for (const char* candidate : names) {
    if (value == candidate) return index;
    known += (index++ == 0 ? "" : ", ") + std::string(candidate);
  }
  refuse(name, describe(value), "one of " + known);
}

void Fields::finish() const {
  for (const auto& [name, value] : object_.items()) {
    if (known_.contains(name)) continue;
    throw FileError(file_, where_, "an unknown member " + describe(Json(name)), "none such");
  }
}

void Fields::refuse(const char* name, const std::string& found, const std::string& expected) const {
  throw FileError(file_, place(name), found, expected);
}

std::string Fields::place(std::string_view name) const {
  return (where_.empty() ? "" : where_ + ".") + std::string(name);
}

}  // namespace palpate::scenario
