// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/scenario.h"

namespace palpate::scenario {

/// Reads a `.palpate` file of this or an older version: a scene that ticks with the very forces of
/// the one that was written. Throws FileError for whatever is wrong, in a sentence.
Scenario read(const std::string& path);

/// The same from what the file holds; `file` is what refusals call it.
Scenario unpack(Container container, const std::string& file);

}  // namespace palpate::scenario
