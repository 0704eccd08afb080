// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/response/response.h"

namespace palpate {

/// Which form of the tissue's laws a tick runs.
enum class Kernel {
  reference,  ///< double, plain, one particle after the other
  packed,     ///< float, in vector code
  response,   ///< of a linear solid: quasi-static, from its precomputed response
};

/// A tissue and how it is moved.
struct SoftBody {
  TissueModel tissue;
  int substeps = 0;      ///< steps per tick in the air; build_scene chooses when 0
  int substeps_max = 0;  ///< contact may raise them to this; build_scene chooses when 0

  /// [N] by which the force may be wrong: what is at rest may then sleep
  /// (packed/private/active_set.h), under the packed kernel. 0: all of the tissue moves in every
  /// substep
  double force_error = 0.0;

  /// packed is reference where Palpate has no vector code for this machine; build_scene chooses
  /// response in its place for a linear solid
  Kernel kernel = Kernel::packed;
  std::string simd_target;  ///< of the packed kernel: one of simd_targets(), empty for the best

  // filled in by build_scene
  std::vector<double> rest_areas;            ///< [m²] per triangle
  double spectrum_stiffness = 0.0;           ///< [1/s²] largest eigenvalue of M⁻¹K at rest
  double spectrum_damping = 0.0;             ///< [1/s] of M⁻¹C
  std::shared_ptr<const Response> response;  ///< under the response kernel, else null
};
static_assert(alignof(SoftBody) == 8);

/// A tool, and how the hand that moves it is coupled to it.
struct Instrument {
  Tool tool;
  Coupling coupling;
  double hold_stiffness = 500.0;  ///< [N/m] between tool and patch while attached
};

/// Tissues and the instruments that touch them: all that a tick needs and never changes. Each
/// instrument has a hand of its own.
struct Scene {
  std::vector<SoftBody> bodies = std::vector<SoftBody>(1);
  std::vector<Instrument> instruments = std::vector<Instrument>(1);
  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  double rate = 1000.0;         ///< [Hz]

  std::uint64_t identity = 0;  ///< another in every call of build_scene; copies share it
};
static_assert(alignof(Scene) == 8);

/// A scene of one tissue and one instrument with the usual values.
Scene make_scene(TissueModel tissue);

/// Checks a scene once and fills in what is derived from it.
/// Throws std::invalid_argument naming the field, what it got and what was expected.
Scene build_scene(Scene scene);

}  // namespace palpate
