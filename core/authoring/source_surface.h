// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// A surface that others are compared with and drawn back onto.
class SourceSurface {
 public:
  /// Copies what it needs; `mesh` must pass palpate::validate.
  explicit SourceSurface(const SurfaceMesh& mesh);
  ~SourceSurface();

  struct Closest {
    Vec3 point;    ///< [m]
    int triangle;  ///< of the source
  };

  /// The point of the surface next to `p` [m].
  Closest find_closest(const Vec3& p) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace palpate::authoring
