// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/dynamics/guard.h"

namespace palpate {

Stretch measure_stretch(const TissueModel& model, std::span<const Vec3> x) noexcept;

/// [1/s²] No less than the largest eigenvalue of M⁻¹K of a tissue that is stretched so, nor than
/// that at rest.
double bound_stiffness(const StretchSpectrum& spectrum, const Stretch& stretch) noexcept;

}  // namespace palpate
