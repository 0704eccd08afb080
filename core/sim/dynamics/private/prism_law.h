// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// The shear law of one side of a prism, which forces, energy and tangent share.

/// The two diagonals of a side: from particle ends[0] to ends[1], and from ends[2] to ends[3].
struct PrismSide {
  PrismSide(const std::array<int, 6>& corners, int side) noexcept {
    const int i = (side + 1) % 3, j = (side + 2) % 3;
    ends = {corners[i], corners[j + 3], corners[j], corners[i + 3]};
  }

  std::array<int, 4> ends;
};

/// The diagonals as they lie: lengths [m], and the directions from their first end to their
/// second; a diagonal of no length has none.
struct Diagonals {
  template <class At>
  Diagonals(const PrismSide& side, At at) noexcept {
    for (int d = 0; d < 2; ++d) {
      const Vec3 along = at(side.ends[2 * d + 1]) - at(side.ends[2 * d]);
      length[d] = along.norm();
      unit[d] = length[d] > 0.0 ? Vec3(along / length[d]) : Vec3(Vec3::Zero());
    }
  }

  std::array<double, 2> length;
  std::array<Vec3, 2> unit;
};

/// k s²/2 over all sides, s the difference of the two diagonals less that at rest.
template <class At>
double compute_prism_energy(const Prisms& prisms, At at) noexcept {
  double sum = 0.0;
  for (std::size_t p = 0; p < prisms.corners.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      const Diagonals now(PrismSide(prisms.corners[p], c), at);
      const double shear = now.length[0] - now.length[1] - prisms.rest_difference[p][c];
      sum += 0.5 * prisms.shear_stiffness[p][c] * shear * shear;
    }
  }
  return sum;
}

}  // namespace palpate
