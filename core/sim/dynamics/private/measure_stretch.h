// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/dynamics/guard.h"

namespace palpate {

/// [m] Between two particles.
inline double measure_distance(std::span<const Vec3> x, int i, int j) noexcept {
  return (x[static_cast<std::size_t>(j)] - x[static_cast<std::size_t>(i)]).norm();
}

/// Links, springs before bonds, and rows of Angles that have torn may have any length: 1 of each;
/// empty where nothing has.
struct TornMask {
  std::span<const unsigned char> links, triangles;
};

Stretch measure_stretch(const TissueModel& model, std::span<const Vec3> x,
                        const TornMask& torn = {}) noexcept;

/// [1/s²] No less than the largest eigenvalue of M⁻¹K of a tissue that is stretched so, nor than
/// that at rest.
double bound_stiffness(const StretchSpectrum& spectrum, const Stretch& stretch) noexcept;

}  // namespace palpate
