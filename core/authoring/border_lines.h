// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// The border loops of a surface as closed lines in space.
class BorderLines {
 public:
  explicit BorderLines(const SurfaceMesh& mesh);

  /// The loop that passes next to `p`; -1 where the surface is closed.
  int find_loop(const Vec3& p) const;

  /// The point of a loop next to `p`.
  Vec3 find_closest(int loop, const Vec3& p) const;

 private:
  std::vector<Vec3Array> loops_;
};

}  // namespace palpate::authoring
