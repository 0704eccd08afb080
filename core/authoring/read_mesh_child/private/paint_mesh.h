// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <assimp/scene.h>

#include "palpate/authoring/read_mesh_child/mean_colour.h"
#include "palpate/authoring/read_mesh_child/pictures.h"

namespace palpate::authoring {

/// Appends to a part how the triangles of a mesh are coloured, which it has just been given, and to
/// the mean of its colours: by the corners where they have colours, times the material's, as glTF
/// has it; else by the material. Its corners are taken the other way round where it `mirrors`.
void paint_mesh(const aiScene& scene, const aiMesh& mesh, bool is_linear, bool mirrors,
                Pictures& pictures, ImportedPart& part, MeanColour& mean);

}  // namespace palpate::authoring
