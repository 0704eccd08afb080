// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/contact_law.h"

namespace palpate {

/// Along a unit vector, n . t n.
inline double compute_along(const Symmetric& t, const Vec3& n) noexcept {
  return t[0] * n.x() * n.x() + t[1] * n.y() * n.y() + t[2] * n.z() * n.z() +
         2.0 * (t[3] * n.x() * n.y() + t[4] * n.y() * n.z() + t[5] * n.z() * n.x());
}

}  // namespace palpate
