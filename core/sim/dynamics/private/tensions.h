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

/// A side l shorter than this part s of its rest length L divides as a longer one,
///
///     l^ = (s L + l²/(s L))/2 >= s L/2
///
/// which leaves sL with the slope of l: in needles and collapsed triangles forces stay finite and
/// the gradient of an energy, and drive the side out again [laws: short sides].
inline constexpr double kBluntSide = 0.3;

/// A link shorter than this part of its rest length has no direction [laws: degenerate].
inline constexpr double kNoDirection = 1e-6;

template <class Real>
using PerSide = std::array<Real, 3>;

/// What the sides of a triangle divide by; all [1/m].
template <class Real>
struct Divisors {
  PerSide<Real> inverse;    ///< 1/l^
  PerSide<Real> slope;      ///< d ln l^/dl
  PerSide<Real> direction;  ///< 1/l, or 0 of a side that has no direction
  bool blunt = false;       ///< a side is short; if none is, all three are 1/l
};

template <class Real>
Divisors<Real> invert_lengths(const PerSide<double>& rest, const PerSide<Real>& length) noexcept {
  Divisors<Real> by;
  for (int c = 0; c < 3; ++c) {
    const Real least = Real(kBluntSide * rest[c]);
    if (length[c] < least) {
      const Real part = length[c] / least;
      by.blunt = true;
      by.inverse[c] = Real(2.0) / (least * (Real(1.0) + part * part));
      by.slope[c] = part * by.inverse[c];
      const bool directed = Real(kNoDirection * rest[c]) < length[c];
      by.direction[c] = directed ? Real(1.0) / length[c] : Real(0.0);
    } else {
      by.inverse[c] = by.slope[c] = by.direction[c] = Real(1.0) / length[c];
    }
  }
  return by;
}

/// cos_c = (l_i² + l_j² - l_c²) / (2 l^_i l^_j) at every corner, with i and j the sides beside it,
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
/// a/(bc) (-1, cos C, cos B). Where a side is short, d cos A/db is b/(b^ c^) - cos A d ln b^/db:
///
///     tau_a = -T_A a/(b^ c^) + T_B (a/(c^ a^) - cos B d ln a^/da)
///             + T_C (a/(a^ b^) - cos C d ln a^/da) + s_B + s_C,   T = K_theta q + K_btheta (d +
///             d')
template <class Real>
PerSide<Real> compute_angle_tensions(const AngleRow& row, const PerSide<Real>& length,
                                     const Divisors<Real>& by) noexcept {
  const PerSide<Real>& inverse = by.inverse;
  const PerSide<Real> cosine = compute_cosines(length, inverse);
  PerSide<Real> torque, w, s;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const Real bend = cosine[c] - Real(row.rest_cosine[c]);
    const Real stretch = length[i] + length[j] - Real(row.rest_length[i] + row.rest_length[j]);
    const Real coupling = Real(row.stretch_coupling[c]);
    torque[c] = Real(row.bend_stiffness[c]) * bend + coupling * stretch;
    w[c] = torque[c] * length[c] * inverse[i] * inverse[j];
    s[c] = coupling * bend;
  }
  PerSide<Real> tension;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    if (by.blunt) {
      const Real near = length[c] * inverse[c];
      tension[c] = torque[i] * (near * inverse[j] - cosine[i] * by.slope[c]) +
                   torque[j] * (near * inverse[i] - cosine[j] * by.slope[c]) - w[c] + s[i] + s[j];
    } else {
      tension[c] = w[i] * cosine[j] + w[j] * cosine[i] - w[c] + s[i] + s[j];
    }
  }
  return tension;
}

/// Eq 10 as a tension of the side opposite each corner [N]: tau_a = -K10_A q_A [laws: eq10]. A
/// closed angle has a larger cosine, so its opposite side pushes and the angle reopens.
template <class Real>
PerSide<Real> compute_eq10_tensions(const AngleRow& row, const PerSide<Real>& length,
                                    const Divisors<Real>& by) noexcept {
  const PerSide<Real> cosine = compute_cosines(length, by.inverse);
  PerSide<Real> tension;
  for (int c = 0; c < 3; ++c) {
    tension[c] = Real(row.bend_stiffness[c]) * (Real(row.rest_cosine[c]) - cosine[c]);
  }
  return tension;
}

}  // namespace palpate
