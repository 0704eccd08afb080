// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate {

/// [-] Of a wall's shear stiffness what counts, as its shear is not the same throughout.
inline constexpr double kShearShare = 5.0 / 6.0;

/// [-] Flat triangles cannot follow a bent wall without shear of their own, which would lock a thin
/// one. The shear stiffness of prisms is therefore h²/(h² + 0.1 l²) of the wall's, l the longest
/// side, and comes to all of it as the mesh gets finer [LylyStenbergVihinen93].
inline constexpr double kUnlocking = 0.1;

inline double find_unlocked_shear(double thickness, double longest) {
  const double square = thickness * thickness;
  return square / (square + kUnlocking * longest * longest);
}

}  // namespace palpate
