// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/scenario.h"

// Not installed: whether a scene is the result of build_scene.

namespace palpate::scenario {

/// Validates a scene as build_scene does, and that what is derived in it is what build_scene
/// derives, which comes back, and that no body steps longer than it is stable at rest. Throws
/// std::invalid_argument: "where: got this, expected that".
Scene check_built(const Scene& scene);

/// Throws std::invalid_argument where a scene has more bodies or instruments, or all of its bodies
/// together more rows of a table, than a file may hold.
void check_counts(const Scene& scene);

}  // namespace palpate::scenario
