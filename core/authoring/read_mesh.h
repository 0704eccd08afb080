// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "palpate/sim/base/error.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// How one corner of a triangle is coloured.
struct CornerPaint {
  std::array<float, 2> place = {};  ///< on the picture: 0 to 1 from its lower left, repeated beyond
  std::array<float, 3> colour = {1.0f, 1.0f, 1.0f};  ///< sRGB; where there is a picture, the factor
                                                     ///< of its colours, in linear light
};

/// A picture that surfaces are painted with, as its file has it: packed by PNG, JPEG or the like.
struct Picture {
  std::string name;
  std::vector<char> bytes;
};

/// One named part of a scene: its node's transforms applied, mirrored winding turned back. Still a
/// list of triangles as the file had it: vertices may be doubled, neighbours may disagree.
struct ImportedPart {
  std::string name;
  SurfaceMesh mesh;  ///< in units and axes of the file
  std::vector<std::string> groups =
      {};  ///< it stands under, outermost first; a part may be one too
  /// sRGB, 0 to 1: its material's, or the mean of its vertices' by area; absent where the file says
  /// none, and for white, which many formats say where nobody chose one.
  std::optional<std::array<double, 3>> colour = {};
  std::vector<CornerPaint> paint = {};  ///< three for each triangle; empty where all are alike
  std::vector<int> pictures = {};  ///< of each triangle, beside `paint`; -1 for one without picture
};

/// What a mesh file holds, before its unit and axes are chosen.
struct ImportedScene {
  std::string file;
  std::string format;  ///< in capitals: its extension, or what the reader was told
  std::vector<ImportedPart> parts;
  std::optional<std::string> unit;  ///< stated by the file or its format
  std::optional<std::string> up;    ///< x, y, z, -x, -y or -z, stated by the file or its format
  std::vector<std::string> notes;   ///< what was odd but could be read all the same
  std::vector<Picture> pictures = {};
  SolidMesh filling;  ///< tetrahedra whose outer faces the parts are; empty where the file has none
};

struct ReadOptions {
  std::filesystem::path reader;    ///< the program palpate-read-mesh, or one that answers like it
  std::string format;              ///< told the reader, in capitals; else the extension
  std::vector<std::string> words;  ///< told the reader before the file's name
  double time_limit = 10.0;        ///< [s] until the reader is stopped
  std::size_t memory_limit = 1'500'000'000;  ///< [bytes] the reader may use
};

/// Reads a mesh file in a child process, so that no file can crash, hang or exhaust this one.
///
/// Every coordinate is finite, every index in range, every part has a triangle; vertices that are
/// not finite are left out with their triangles, and a note says so. Throws FileError for a file
/// that cannot be read so, std::invalid_argument for limits that are not positive.
ImportedScene read_mesh(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace palpate::authoring
