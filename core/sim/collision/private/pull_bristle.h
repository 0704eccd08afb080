// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/base/types.h"

namespace palpate {

/// What bristles are like.
struct BristleLaw {
  double stiffness = 0.0;  ///< [N/m]
  double damping = 0.0;    ///< [N s/m]
  double friction = 0.0;   ///< [-]
};

/// [N] On the body. `stretch` [m] goes from the body's point to the other, which moves away from
/// it with `velocity` [m/s]; `pressed` [N] along `normal`. Sets by how much the body's point is to
/// be moved [m] where it slips.
Vec3 pull_bristle(const BristleLaw& law, const Vec3& stretch, const Vec3& velocity,
                  const Vec3& normal, double pressed, Vec3& slip) noexcept;

}  // namespace palpate
