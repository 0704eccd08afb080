// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

struct Orientation {
  bool orientable;  ///< neighbours can agree everywhere; false for a Moebius band
  int turned;       ///< triangles turned
};

/// Turns triangles so that neighbours agree and the normals point outwards.
///
/// A shell is what hangs together by edges of two triangles. A closed one encloses a positive
/// volume, unless it lies inside another closed one: then it turns along with the outermost of
/// those, for only the author knows whether it is a cavity's wall or a nested part. An open one
/// turns its hollow side in: its volume about its own centroid is positive. One that is flat turns
/// as few triangles as possible.
Orientation orient(SurfaceMesh& mesh);

}  // namespace palpate::authoring
