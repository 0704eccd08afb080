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

/// An OBJ, in double precision where assimp has single: its vertices, polygons, objects and groups,
/// painted by its corners or its material library. Normals are left alone, and places on pictures
/// where they are wrong. nullopt for one that is not text of
/// single bytes, which is assimp's to read or refuse. Throws FileError with the line.
std::optional<ImportedScene> read_obj(const std::string& path);

/// An STL as text, in small letters or capitals; each solid is a part. Throws FileError with the
/// line.
ImportedScene read_text_stl(const std::string& path);

/// An OFF as text or binary: OFF, COFF, NOFF, CNOFF, STOFF and their like, 4OFF; with the colours
/// of its vertices where it is text; normals and texture coordinates are left alone. Throws
/// FileError with the line, or the number.
ImportedScene read_off(const std::string& path);

/// A PLY 1.0 as text or binary of either byte order: its vertices, polygons and strips, and the
/// mean of its colours; other elements and properties are passed over. Throws FileError with the
/// line, or the row.
ImportedScene read_ply(const std::string& path);

/// What the first word of an OFF says of its vertices.
struct OffKind {
  bool texture = false, colours = false, normals = false, weighted = false;
};

/// The binary part of an OFF, from byte `begin` on; faces of fewer than three corners are counted.
SurfaceMesh read_binary_off(const std::string& path, const OffKind& kind, std::size_t begin,
                            int& left_out);

}  // namespace palpate::authoring
