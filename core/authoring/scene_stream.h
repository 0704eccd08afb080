// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

// What palpate-read-mesh writes to its standard output, in the byte order of the machine:
//
//     stream  := magic status (scene | refusal) magic
//     refusal := where got expected
//     scene   := unit up notes parts pictures filling    unit, up: empty where none is stated
//     notes   := count text*
//     parts   := count (name groups colour vertices triangles paint int32s)*
//     groups  := count text*
//     colour  := count (double)*              three numbers, or none
//     paint   := count (5 floats)*            u v r g b of each corner, or none at all
//     int32s  := count (int32)*               the picture of each triangle, or none at all
//     pictures := count (name text)*
//     filling := vertices count (4 int32)*
//     text    := count byte*      vertices := count (3 doubles)*      triangles := count (3 int32)*
//
// Counts and the status are uint32. The magic at the end tells that nothing is missing.
inline constexpr std::uint64_t kStreamMagic = 0x33'45'4e'45'43'53'4c'50;  // "PLSCENE3"
inline constexpr std::uint32_t kStreamScene = 0;
inline constexpr std::uint32_t kStreamRefusal = 1;

/// The scene in `bytes`, every count held against what is left of them. Throws FileError naming
/// `file` for a refusal and for a stream that is not as above.
ImportedScene decode_scene(const std::string& file, std::span<const char> bytes);

}  // namespace palpate::authoring
