// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palpate {

/// Where a member of a JSON object stands in its text, name and value.
struct JsonMember {
  std::size_t begin = 0, end = 0;
};

/// Checks that `text` is one JSON object [RFC8259], white space around it allowed, nested at most
/// 64 deep. Returns what is wrong and where, in words, or none.
std::optional<std::string> find_json_problem(std::string_view text);

/// The member `name` of the outermost object, none if it has none. `text` must be sound.
std::optional<JsonMember> find_json_member(std::string_view text, std::string_view name);

/// The object without its member `name` if it had one, and with `value` (JSON) under it at the
/// end. `object` must be sound.
std::string with_json_member(std::string_view object, std::string_view name,
                             std::string_view value);

}  // namespace palpate
