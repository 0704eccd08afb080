// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Not installed: the only header in which nlohmann-json shows.

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "palpate/sim/base/error.h"

namespace palpate::scenario {

using Json = nlohmann::json;

/// The object that `text` is. Throws FileError for text that is not JSON, names a member twice,
/// goes deeper than kMostDepth, or is no object; `where` is the place of `text` in the file.
Json parse_object(std::string_view text, const std::string& file, const std::string& where);

/// As JSON text that gives back every number exactly. Throws std::invalid_argument, naming
/// `where`, for strings that are not UTF-8.
std::string print(const Json& json, const std::string& where);

/// A value in few words, for sentences.
std::string describe(const Json& value);

/// An object that is read member by member: what is missing, of another kind or never asked for
/// is a FileError.
class Fields {
 public:
  Fields(const Json& object, std::string file, std::string where);

  bool has(const char* name) const { return object_.contains(name); }
  const Json& any(const char* name);
  Fields object(const char* name);
  /// Whether a member is a list without entries.
  bool is_empty_list(const char* name);
  /// Of a list of 1 to `most` objects, in order.
  std::vector<Fields> objects(const char* name, std::size_t most);
  std::string text(const char* name, std::size_t most_bytes);
  double number(const char* name);
  double number_or(const char* name, double usual);  ///< where it is missing
  /// A list of `count` numbers.
  std::vector<double> numbers(const char* name, std::size_t count);
  /// A list of at most `most` whole numbers, each of 0 to `below` - 1.
  std::vector<int> indices(const char* name, std::size_t most, std::size_t below);
  std::int64_t whole(const char* name, std::int64_t least, std::int64_t most);
  /// The one of `names` that the member is.
  std::size_t choice(const char* name, std::initializer_list<const char*> names);

  /// Refuses members that nobody asked for.
  void finish() const;
  [[noreturn]] void refuse(const char* name, const std::string& found,
                           const std::string& expected) const;

 private:
  std::string place(std::string_view name) const;

  const Json& object_;
  std::string file_, where_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace palpate::scenario
