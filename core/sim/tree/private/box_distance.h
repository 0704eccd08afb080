// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// [m] From a point to the box around a surface; 0 inside.
inline double measure_to_box(const Vec3& p, const AabbTree& tree) noexcept {
  return (tree.low() - p).cwiseMax(p - tree.high()).cwiseMax(0.0).norm();
}

/// [m] Between the boxes around two surfaces; 0 where they overlap.
inline double measure_between(const AabbTree& a, const AabbTree& b) noexcept {
  return (a.low() - b.high()).cwiseMax(b.low() - a.high()).cwiseMax(0.0).norm();
}

}  // namespace palpate
