// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/json_fields.h"
#include "palpate/sim/tick/scene.h"

// Not installed: rigid bodies, scenery and fluid of a scene, as a file has them.

namespace palpate::scenario {

inline Json print_vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// A list of three numbers. Throws FileError.
Vec3 parse_vector(Fields& fields, const char* name);

/// Gives a printed scene the numbers of its rigid bodies, its scenery and its fluid.
void print_hard_parts(const Scene& scene, Json& printed);

/// Reads them, of a scene whose bodies have been read. Throws FileError.
void parse_hard_parts(Fields& scene_fields, Scene& scene);

}  // namespace palpate::scenario
