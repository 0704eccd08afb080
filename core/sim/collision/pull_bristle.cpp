// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/pull_bristle.h"

namespace palpate {

/// g = k s + c ds/dt along the surface, of which friction bears mu N: where k s is more, the body's
/// point slips after until it is not.
Vec3 pull_bristle(const BristleLaw& law, const Vec3& stretch, const Vec3& velocity,
                  const Vec3& normal, double pressed, Vec3& slip) noexcept {
  const Vec3 along = stretch - normal.dot(stretch) * normal;
  const Vec3 speed = velocity - normal.dot(velocity) * normal;
  const double most = law.friction * pressed, length = along.norm();
  double kept = 1.0;
  if (law.stiffness * length > most) kept = most / (law.stiffness * length);
  slip = (1.0 - kept) * along;
  const Vec3 pull = law.stiffness * kept * along + law.damping * speed;
  const double size = pull.norm();
  return size > most ? Vec3(most / size * pull) : pull;
}

}  // namespace palpate
