// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

/// Vertices closer than this part of the bounding box's diagonal are one: far above the rounding
/// of files in single precision (6e-8), far below the shortest real edge seen in organs.
inline constexpr double kWeldTolerance = 1e-6;

struct JoinOptions {
  std::vector<std::string> parts;   ///< names; all parts of the scene when empty
  std::optional<std::string> unit;  ///< m, cm, mm, um, in or ft; else as choose_unit says
  std::optional<std::string> up;    ///< x, y, z, -x, -y or -z; else as choose_up says
};

/// Chosen parts as one surface.
struct JoinedSurface {
  SurfaceMesh mesh;                ///< welded, in metres, z up
  std::vector<std::string> parts;  ///< the names of the parts it is made of
  std::string unit;                ///< of the file
  bool unit_guessed;
  std::string unit_reason;
  std::string up;  ///< axis of the file
  bool up_guessed;
  std::string up_reason;
  int welded_vertices;  ///< vertices that became one with another
};

/// Takes the chosen parts together, welds across them and turns them to metres and z up. Throws
/// FileError for a part the file does not have or when no triangle is left,
/// std::invalid_argument for an unknown unit or axis.
JoinedSurface join_parts(const ImportedScene& scene, const JoinOptions& options = {});

}  // namespace palpate::authoring
