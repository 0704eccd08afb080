// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

// The readers of the child process. Each returns what the file says; the parent checks it again.

/// Through assimp, any format. Throws FileError.
ImportedScene read_with_assimp(const std::string& path, const std::string& format);

/// A binary STL: an 80-byte header, a count n, n records of 50 bytes. Bytes after the last record
/// are left alone with a note, where assimp would refuse the file. nullopt for a text STL. Throws
/// FileError where the records stop short of the count.
std::optional<ImportedScene> read_binary_stl(const std::string& path);

/// An OBJ of plain triangles, in double precision where assimp has single. nullopt for anything
/// out of the ordinary, which is assimp's to read or refuse.
std::optional<ImportedScene> read_plain_obj(const std::string& path);

}  // namespace palpate::authoring
