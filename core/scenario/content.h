// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/scenario.h"

// Not installed: the JSON part of a `.palpate` file.

namespace palpate::scenario {

/// Title, task, the numbers of the scene that stand alone, and the authored document. Throws
/// std::invalid_argument for text that is too long, not UTF-8 or not JSON.
std::string print_content(const Scenario& scenario);

/// Fills in what print_content wrote. Throws FileError.
void parse_content(const std::string& content, const std::string& file, Scenario& scenario);

}  // namespace palpate::scenario
