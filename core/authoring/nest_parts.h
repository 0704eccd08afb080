// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

/// How a part lies to the others of its file.
struct PartPlace {
  int inside = -1;           ///< the smallest part it lies inside of; -1 for none
  std::vector<int> crosses;  ///< parts whose triangles cross its own, ascending
  bool closed = false;       ///< every edge has two triangles or more, once it is welded
  int crossing_faces = 0;    ///< of its own triangles that cross each other; -1: not counted, as
                             ///< there are too many or no other part
};

/// For every part of a scene. Inside is what an outer part winds around [vanOosterom83] at more
/// than half of some of its vertices; what lies on the outer one is not inside. Where that would
/// take longer than a second or two nothing is inside of anything.
std::vector<PartPlace> find_places(const ImportedScene& scene);

}  // namespace palpate::authoring
