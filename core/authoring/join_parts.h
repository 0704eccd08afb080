// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

/// Vertices closer than this part of the bounding box's diagonal are one: far above the rounding
/// of files in single precision (6e-8), far below the shortest real edge seen in organs.
inline constexpr double kWeldTolerance = 1e-6;

struct JoinOptions {
  std::vector<std::string> parts;     ///< names of parts or of groups; all of the scene when empty
  std::optional<std::string> unit;    ///< m, cm, mm, um, in or ft; else as choose_unit says
  std::optional<std::string> up;      ///< x, y, z, -x, -y or -z; else as choose_up says
  std::optional<double> weld;         ///< [m] across parts; else kWeldTolerance alone
  bool unite = false;                 ///< the parts as solids, as one: see combine_parts()
  std::vector<std::string> subtract;  ///< parts or groups whose inside is taken away; they unite
};

/// Chosen parts as one surface.
struct JoinedSurface {
  SurfaceMesh mesh;                     ///< welded, in metres, z up
  std::vector<std::string> parts;       ///< the names of the parts it is made of
  std::vector<std::string> subtracted;  ///< the names of those that were taken away
  std::string unit;                     ///< of the file
  bool unit_guessed;
  std::string unit_reason;
  std::string up;  ///< axis of the file
  bool up_guessed;
  std::string up_reason;
  int welded_vertices;             ///< vertices that became one with another
  int welded_across;               ///< of those, by the stated tolerance
  double largest_move;             ///< [m] by the stated tolerance
  std::vector<std::string> notes;  ///< what parts had to be changed in to be united, for people
};

/// Takes the chosen parts together and turns them to metres and z up: welded across, or united as
/// solids. Throws FileError for a part the file does not have, for one that cannot be united or
/// subtracted, or when no triangle is left; std::invalid_argument for an unknown unit or axis, or a
/// tolerance that is no length.
JoinedSurface join_parts(const ImportedScene& scene, const JoinOptions& options = {});

}  // namespace palpate::authoring
