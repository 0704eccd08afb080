// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenes/solids.h"

/// Linear solids of the same shapes.
namespace palpate::scenes {

/// A linear solid of 5 kPa and nu = 0.45, held at its base.
inline TissueModel make_linear_organ(int cells, double nodal_share, double damping_ratio = 0.0) {
  const SolidMesh solid = make_round_block(cells);
  SolidOptions options;
  options.nodal_share = nodal_share;
  options.fixed = find_base(solid);
  return build_linear_solid(solid, make_material({.damping_ratio = damping_ratio}), options);
}

/// The same under an ellipsoid that rides on it.
inline TissueModel make_covered_linear_organ(int cells, double nodal_share,
                                             double damping_ratio = 0.0) {
  return cover_with_skin(make_linear_organ(cells, nodal_share, damping_ratio),
                         make_ellipsoid({0.045, 0.032, 0.027}, 3));
}

}  // namespace palpate::scenes
