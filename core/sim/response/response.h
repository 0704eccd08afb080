// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "palpate/sim/base/types.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// How much of a linear solid's response there is to keep; known before any of it is solved for.
struct ResponseSize {
  int moved = 0;          ///< particles that carry the surface and are not held
  int pushed = 0;         ///< those of them within reach of pushes
  std::size_t bytes = 0;  ///< of the table: 3 moved x 3 pushed floats
};

/// More than this a response may not have: 1365 particles under pushes that reach all of them.
inline constexpr std::size_t kMostResponseBytes = std::size_t{64} << 20;

/// Of the thickness of a body: how deep a press a linear solid is good for. Up to there it is
/// within 12 % of neo-Hookean elements on the same mesh at 17 of 18 places, and within 22 % at the
/// end of an ellipsoid (tests/bindings/study/test_linear_solid.py).
inline constexpr double kShallow = 0.15;

ResponseSize measure_response(const TissueModel& model);

/// How a linear solid answers when nothing of it swings: displacements of the particles that carry
/// its surface under forces on those that pushes reach. Made once by build_response, then shared.
struct Response {
  ResponseSize size;
  std::vector<int> particle;  ///< of the moved, ascending
  std::vector<int> row;       ///< per particle of the model: among the moved, or -1
  std::vector<int> column;    ///< per particle: among the pushed, or -1
  /// [m/N] (3 pushed, 3 moved): row 3c + k is what all of the moved do under 1 N on c along axis k
  CacheAligned<float> compliance;
  CacheAligned<float> sag;  ///< [m] (moved, 3) under gravity alone
  std::vector<double>
      self_compliance;        ///< [m/N] per vertex of the surface, of itself; 0 out of reach
  double damping_time = 0.0;  ///< [s]
};

/// Solves for the response of a linear solid in gravity [m/s²]: the inverse of its stiffness, of
/// which only what the surface needs is kept. Throws std::invalid_argument for another model, for
/// a table of more than `most` bytes, before anything is solved, and for a body that is not held.
Response build_response(const TissueModel& model, const Vec3& gravity = Vec3::Zero(),
                        std::size_t most = kMostResponseBytes);

/// What a response does as time goes on. With u the displacements, G the compliance and f the
/// pushes, Kelvin's and Voigt's tau u' = G f + sag - u.
///
/// Within a tick only what the tool may touch is kept up to date (relax.h).
struct ResponseState {
  ResponseState() = default;
  explicit ResponseState(const Response& response);

  CacheAligned<float> displacement;  ///< [m] (moved, 3) when the tick began
  std::vector<float> force;  ///< [N] (pushed, 3) of the tick, by what of it has come through
  std::vector<int> touched;  ///< the columns that are not 0, as many as `touched_count`
  int touched_count = 0;
  float kept = 1.0F;  ///< [-] of the displacement when the tick began
};

}  // namespace palpate
