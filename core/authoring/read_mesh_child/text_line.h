// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace palpate::authoring {

/// Some editors begin a text in UTF-8 with these three bytes.
inline void drop_byte_order_mark(std::string& line) {
  if (line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
}

/// The beginning of a word in quotes, as a sentence may show it on a terminal.
inline std::string show_word(std::string_view word) {
  std::string shown(word.substr(0, 40));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  }
  return "'" + shown + "'";
}

/// Takes words and numbers off the front of a line.
class TextLine {
 public:
  explicit TextLine(std::string_view text) : rest_(text) {}

  std::string_view take_word() {
    skip_blanks();
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    return word;
  }

  std::string_view take_rest() {
    skip_blanks();
    return rest_.substr(0, rest_.find_last_not_of(kBlanks) + 1);
  }

  /// The next word as a number; false where there is none, or where it is not one.
  template <class Number>
  bool take(Number& value) {
    return parse(take_word(), value);
  }

  template <class Number>
  static bool parse(std::string_view word, Number& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if constexpr (std::is_floating_point_v<Number>) {
      if (is_nowhere(word, end)) {
        value = std::numeric_limits<Number>::quiet_NaN();
        return true;
      }
    }
    if (word.empty() || end != word.data() + word.size()) return false;
    if (problem == std::errc()) return true;
    // a number nearer to zero than any is zero; others out of range are none
    if constexpr (std::is_floating_point_v<Number>) {
      value = std::strtod(std::string(word).c_str(), nullptr);
      return problem == std::errc::result_out_of_range && std::abs(value) < 1.0;
    }
    return false;
  }

 private:
  /// 1.#QNAN, -1.#IND00 and their like, as programs for Windows write what is no number.
  static bool is_nowhere(std::string_view word, const char* end) {
    const std::string_view rest = word.substr(static_cast<std::size_t>(end - word.data()));
    return rest.starts_with("#QNAN") || rest.starts_with("#SNAN") || rest.starts_with("#IND") ||
           rest.starts_with("#INF");
  }

  static constexpr std::string_view kBlanks = " \t\r";

  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  }

  std::string_view rest_;
};

}  // namespace palpate::authoring
