// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Largest eigenvalues at rest of M⁻¹K [1/s²] and M⁻¹C [1/s], fixed particles left out, with
/// `coupling` [N/m] holding the particle it hurts most. Estimated from above, to a thousandth
/// without a coupling.
struct Spectrum {
  double stiffness = 0.0;  ///< [1/s²]
  double damping = 0.0;    ///< [1/s]
};

Spectrum estimate_spectrum(const TissueModel& model, double coupling = 0.0);

/// [s] A step at which symplectic Euler is stable at rest, with a margin; `coupling` [N/m] is the
/// stiffness that a tool may add at any one particle. Lies between 0.6 and 1.0 of the exact limit,
/// at which the largest eigenvalue of M⁻¹(dt² K + 2 dt C) is 4; dt² lambda_K + 2 dt lambda_C < 4
/// is sufficient [motion: step] for that. Infinite where nothing can swing. Always the same for the
/// same model. Eq 10 may flutter at any step where its triangles are uneven and damping is low.
double stable_step(const TissueModel& model, double coupling = 0.0);

}  // namespace palpate
