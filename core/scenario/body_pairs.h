// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/json_fields.h"
#include "palpate/sim/tick/scene.h"

// Not installed: which bodies of a scene touch each other, as a file has it.

namespace palpate::scenario {

/// The list of pairs that build_scene made.
Json print_pairs(const Scene& scene);

/// Reads the pairs, none or more, of a scene whose bodies have been read; a body that has one with
/// itself may fold. Throws FileError.
void parse_pairs(Fields& scene_fields, Scene& scene);

}  // namespace palpate::scenario
