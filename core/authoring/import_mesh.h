// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/join_parts.h"
#include "palpate/authoring/repair_mesh.h"

namespace palpate::authoring {

/// An organ's surface as it can be shown, and how it came to be.
struct ImportedMesh {
  SurfaceMesh mesh;  ///< metres, z up, outward where it has an outside; open where the file is
  JoinedSurface joined;
  RepairedMesh repaired;
};

/// Joins, repairs and orients what was read. What can be drawn is never refused: whether a tissue
/// can be built on it is told by inspect_mesh() and palpate::validate. Throws FileError where
/// nothing is left that has an area.
ImportedMesh import_scene(const ImportedScene& scene, const JoinOptions& join = {});

}  // namespace palpate::authoring
