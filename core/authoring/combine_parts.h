// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

/// One solid of many.
struct CombinedParts {
  SurfaceMesh mesh;
  std::vector<std::string> notes;  ///< what parts had to be changed in first, for people
};

/// The solids that `kept` bound, as one, without those that `taken` bound: closed, without a
/// triangle that crosses another, vertices of the parts where nothing was cut.
///
/// A part is closed, and its shells that face inwards are cavities. Where a few of its triangles
/// cross others of its own they are replaced first, see remove_crossings(), and a note says so.
/// Throws FileError naming `file` and the part that is no solid, and where nothing is left or the
/// result cannot be had without crossings. [CGAL, Polygon Mesh Processing, corefinement]
CombinedParts combine_parts(const std::string& file, const std::vector<const ImportedPart*>& kept,
                            const std::vector<const ImportedPart*>& taken);

/// The same of the shells of one surface. Throws std::invalid_argument with the sentence.
CombinedParts unite_shells(const SurfaceMesh& mesh);

}  // namespace palpate::authoring
