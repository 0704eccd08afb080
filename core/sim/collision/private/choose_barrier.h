// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/collision/body_pair.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// [Pa] Young's modulus of a tissue as its constants have it at rest, mean over the body; 0 where
/// it has none of them. A wall's is that of its thickness, found from its mass.
double estimate_modulus(const TissueModel& tissue);

/// [m] A barrier between two surfaces: 0.15 of the longer mean side, that edges are covered by the
/// vertices of their neighbours, within 0.3 to 0.5 mm.
double choose_thickness(const TissueModel& first, const TissueModel& second);

/// Where two surfaces at rest are nearest.
struct Nearest {
  double gap = 0.0;      ///< [m] below 0 where the vertex is inside of the other body
  int vertex = -1;       ///< none within reach
  bool of_first = true;  ///< the vertex is the first body's
};

/// Looks no farther than `reach` [m] from the surfaces, and as deep as they go.
Nearest find_nearest_at_rest(const TissueModel& first, const TissueModel& second, double reach);

/// Where a tissue at rest is deepest in a mesh, or that in it; of_first where the vertex is the
/// tissue's. Vertices that are held, and what lies in triangles that are, may be anywhere.
Nearest find_deepest_at_rest(const TissueModel& tissue, const SurfaceMesh& mesh);

/// Checks the constants of a pair, chooses those that are 0, and checks that the bodies do not
/// begin deep in the barrier, which would fling them apart. Throws std::invalid_argument that
/// begins with `where`.
void choose_barrier(const std::string& where, const TissueModel& first, const TissueModel& second,
                    BodyPair& pair);

}  // namespace palpate
