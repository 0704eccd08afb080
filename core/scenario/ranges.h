// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "palpate/sim/tick/scene.h"

// Not installed: how large and how small the numbers of a scene may be in a file.

namespace palpate::scenario {

/// What a number of a scene may be, both ends included. Far wider than any organ needs; beyond it
/// a run would stand still, never end, or be felt as nothing.
struct Range {
  /// As in the file, i for the number of the body or the instrument: of a number
  /// scene.instruments[i].tool.radius, of a table scene/bodies/i/tissue/mass.
  std::string name;
  const char* unit;
  double least, most;
};

/// Those of laws stand in the table of laws (sim/model/private/law_tables.h).
const std::vector<Range>& list_ranges();

/// Throws std::invalid_argument: "scene.instruments[0].tool.radius: got this, expected that".
void check_ranges(const Scene& scene);

}  // namespace palpate::scenario
