// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace palpate {

/// The sentence with which `act` is refused; empty where it is accepted.
template <class Act>
std::string find_refusal(Act act) {
  try {
    act();
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  }
  return "";
}

}  // namespace palpate
