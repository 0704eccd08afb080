// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "palpate/sim/dynamics/private/dual.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// The angle laws of one triangle as functions of its three side lengths, written for a number type
// Real: double gives forces and energy, Dual their exact tangent. Column c belongs to corner c or
// to the side opposite it, as in Angles.

/// A side shorter than this part of its rest length is treated as if it were that long wherever
/// its length divides: forces stay finite in needles and collapsed triangles
/// [laws: degenerate].
inline constexpr double kShortestSide = 0.05;

/// A link shorter than this part of its rest length has no direction [laws: degenerate].
inline constexpr double kNoDirection = 1e-6;

template <class Real>
using PerSide = std::array<Real, 3>;

/// 1/l of every side [1/m], at most 1/(0.05 l0).
template <class Real>
PerSide<Real> invert_lengths(const PerSide<double>& rest, const PerSide<Real>& length) noexcept {
  PerSide<Real> inverse;
  for (int c = 0; c < 3; ++c) {
    inverse[c] = Real(1.0) / std::max<Real>(length[c], Real(kShortestSide * rest[c]));
  }
  return inverse;
}

/// cos_c = (l_i² + l_j² - l_c²) / (2 l_i l_j) at every corner, with i and j the sides beside it,
/// kept within [-1, 1] where rounding breaks the triangle inequality.
template <class Real>
PerSide<Real> compute_cosines(const PerSide<Real>& length, const PerSide<Real>& inverse) noexcept {
  const PerSide<Real> square = {length[0] * length[0], length[1] * length[1],
                                length[2] * length[2]};
  PerSide<Real> cosine;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const Real free = (square[i] + square[j] - square[c]) * (inverse[i] * inverse[j]) * Real(0.5);
    cosine[c] = std::clamp<Real>(free, Real(-1.0), Real(1.0));
  }
  return cosine;
}

/// What one row of Angles says of its triangle.
struct AngleRow {
  AngleRow(const Angles& angles, std::size_t row) noexcept
      : rest_cosine(angles.rest_cosine[row]),
        rest_length(angles.rest_length[row]),
        bend_stiffness(angles.bend_stiffness[row]),
        stretch_coupling(angles.stretch_coupling[row]) {}

  PerSide<double> rest_cosine, rest_length, bend_stiffness, stretch_coupling;
};

/// Eq 9 and Eq 11 as tensions of the sides [N], positive where a side pulls its ends together.
/// With q = cos - cos0 and d = l - l0 [laws: tension], for the corner A opposite side a and cyclic:
///
///     w_A = (K_theta_A q_A + K_btheta_A (d_b + d_c)) a/(bc),   s_A = K_btheta_A q_A
///     tau_a = -w_A + w_B cos C + w_C cos B + s_B + s_C
///
/// This is the gradient of the energy in the lengths, because d cos A/d(a,b,c) =
/// a/(bc) (-1, cos C, cos B).
template <class Real>
PerSide<Real> compute_angle_tensions(const AngleRow& row, const PerSide<Real>& length,
                                     const PerSide<Real>& inverse) noexcept {
  const PerSide<Real> cosine = compute_cosines(length, inverse);
  PerSide<Real> w, s;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const Real bend = cosine[c] - Real(row.rest_cosine[c]);
    const Real stretch = length[i] + length[j] - Real(row.rest_length[i] + row.rest_length[j]);
    const Real coupling = Real(row.stretch_coupling[c]);
    const Real torque = Real(row.bend_stiffness[c]) * bend + coupling * stretch;
    w[c] = torque * length[c] * inverse[i] * inverse[j];
    s[c] = coupling * bend;
  }
  PerSide<Real> tension;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    tension[c] = w[i] * cosine[j] + w[j] * cosine[i] - w[c] + s[i] + s[j];
  }
  return tension;
}

/// Eq 10 as a tension of the side opposite each corner [N]: tau_a = -K10_A q_A [laws: eq10]. A
/// closed angle has a larger cosine, so its opposite side pushes and the angle reopens.
template <class Real>
PerSide<Real> compute_eq10_tensions(const AngleRow& row, const PerSide<Real>& length,
                                    const PerSide<Real>& inverse) noexcept {
  const PerSide<Real> cosine = compute_cosines(length, inverse);
  PerSide<Real> tension;
  for (int c = 0; c < 3; ++c) {
    tension[c] = Real(row.bend_stiffness[c]) * (Real(row.rest_cosine[c]) - cosine[c]);
  }
  return tension;
}

}  // namespace palpate
