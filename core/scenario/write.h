// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/scenario.h"

namespace palpate::scenario {

/// Writes a `.palpate` file, whole or not at all. The scene is the result of build_scene.
/// Throws std::invalid_argument for what read() would refuse, FileError where the disk refuses.
void write(const std::string& path, const Scenario& scenario);

/// What the file holds.
Container pack(const Scenario& scenario);

}  // namespace palpate::scenario
