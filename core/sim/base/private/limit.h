// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/base/types.h"

namespace palpate {

/// A vector that is no longer than `most`, in its direction.
inline Vec3 limit(const Vec3& v, double most) noexcept {
  const double length = v.norm();
  return length > most ? Vec3(v * (most / length)) : v;
}

}  // namespace palpate
