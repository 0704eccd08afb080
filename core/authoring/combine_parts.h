// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

/// The solids that `kept` bound, as one, without those that `taken` bound: closed, without a
/// triangle that crosses another, vertices of the parts where nothing was cut.
///
/// A part is closed and does not cross itself; its shells that face inwards are cavities. Throws
/// FileError naming `file` and the part that is not so, and where nothing is left or the result
/// cannot be had without crossings. [CGAL, Polygon Mesh Processing, corefinement]
SurfaceMesh combine_parts(const std::string& file, const std::vector<const ImportedPart*>& kept,
                          const std::vector<const ImportedPart*>& taken);

/// The same of the shells of one surface. Throws std::invalid_argument with the sentence.
SurfaceMesh unite_shells(const SurfaceMesh& mesh);

}  // namespace palpate::authoring
