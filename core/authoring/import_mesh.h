// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/inspect_mesh.h"
#include "palpate/authoring/join_parts.h"
#include "palpate/authoring/repair_mesh.h"

namespace palpate::authoring {

/// A model may have this part of its faces crossing others: small folds, which decimation and
/// smoothing mostly take out. More of them are parts that lie inside each other.
inline constexpr double kMostSelfIntersecting = 0.02;

/// An organ's surface as a model can use it, and how it came to be.
struct ImportedMesh {
  SurfaceMesh mesh;  ///< passes palpate::validate; metres, z up, outward; open where the file is
  JoinedSurface joined;
  RepairedMesh repaired;
  MeshReport report;  ///< of mesh
};

/// Reads, joins, repairs, orients and checks. Throws FileError, with what to do about it where
/// that is known, for what cannot be handled yet: edges with more than two triangles, one-sided
/// surfaces, and too many faces that cross others.
ImportedMesh import_mesh(const std::filesystem::path& path, const ReadOptions& read,
                         const JoinOptions& join = {});

/// The same for a file that has been read.
ImportedMesh import_scene(const ImportedScene& scene, const JoinOptions& join = {});

}  // namespace palpate::authoring
