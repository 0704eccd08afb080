// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The most and the least that a link or a side of a triangle is of its rest length, and volumes of
/// theirs; 1 at rest.
struct Stretch {
  double longest = 1.0;          ///< [-] at least 1
  double shortest = 1.0;         ///< [-] at most 1
  double smallest_volume = 1.0;  ///< [-] of a tetrahedron; at most 1, below 0 inside out
  double smallest_mean = 1.0;    ///< [-] of the tetrahedra around a particle; at most 1
};

/// How stiff M⁻¹K of a tissue may get, from which of its terms; all in 1/s².
struct StretchSpectrum {
  StretchSpectrum() = default;
  /// `rest` is the largest eigenvalue at rest (estimate_spectrum).
  StretchSpectrum(const TissueModel& model, double rest);

  double rest = 0.0;
  double taut = 0.0;      ///< with links as stiff across as along: a bound
  double angles = 0.0;    ///< of angles, stretch-bend and prisms alone
  double pressure = 0.0;  ///< of pressure alone: a bound
  double volumes = 0.0;   ///< of each tetrahedron's volume alone
  double means = 0.0;     ///< of mean volumes alone
};

}  // namespace palpate
