// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/scenario/scenario.h"

namespace palpate::scenario {
namespace {

constexpr std::size_t kMostCodeBytes = 35;  ///< [BCP 47, 4.4.1]

bool is_small(char c) { return c >= 'a' && c <= 'z'; }

bool is_sign(char c) { return is_small(c) || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

}  // namespace

std::optional<std::string> find_language_problem(std::string_view code) {
  if (code.size() > kMostCodeBytes) return "which is too long";
  const std::string_view first = code.substr(0, code.find('-'));
  if (first.size() < 2 || first.size() > 3 || !std::all_of(first.begin(), first.end(), is_small)) {
    return "which does not begin with two or three small letters";
  }
  for (std::size_t begin = first.size(); begin < code.size();) {
    const std::size_t end = std::min(code.find('-', begin + 1), code.size());
    const std::string_view part = code.substr(begin + 1, end - begin - 1);
    if (part.empty() || part.size() > 8 || !std::all_of(part.begin(), part.end(), is_sign)) {
      return "with a part that is not 1 to 8 letters or digits";
    }
    begin = end;
  }
  return std::nullopt;
}

Words find_words(const Scenario& scenario, std::string_view language) {
  Words found{scenario.title, scenario.task};
  // the most general first, so that the nearest one has the last word
  for (const std::string_view code : {language.substr(0, language.find('-')), language}) {
    const auto at = scenario.languages.find(code);
    if (at == scenario.languages.end()) continue;
    if (!at->second.title.empty()) found.title = at->second.title;
    if (!at->second.task.empty()) found.task = at->second.task;
  }
  return found;
}

}  // namespace palpate::scenario
