// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// Writes .obj (text, 17 digits: reading it back gives the same bits) or .stl (binary, single
/// precision), in metres with z up, and says so in the file, so that read_mesh need not guess. The
/// file is there whole or not at all: it is written beside its place and renamed. Throws
/// std::invalid_argument for another extension or an invalid mesh, FileError where the disk
/// refuses.
void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh);

}  // namespace palpate::authoring
