// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace palpate {

/// The parts written one after the other, numbers to six digits.
template <class... Parts>
std::string write_text(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Throws std::invalid_argument with the sentence every refusal of an argument has: where, what
/// was found there, what was expected.
[[noreturn]] inline void refuse(const std::string& where, const std::string& got,
                                const std::string& expected) {
  throw std::invalid_argument(where + ": got " + got + ", expected " + expected);
}

}  // namespace palpate
