// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {

/// A segment seen along its largest component, which turns the crossing of a triangle into a
/// question about signs in the plane.
struct Shear {
  explicit Shear(const Vec3& direction) noexcept {
    // without branches, which would be guessed wrongly as often as not
    const Vec3 size = direction.cwiseAbs();
    kz = size.y() > size.x() ? 1 : 0;
    kz = size.z() > std::max(size.x(), size.y()) ? 2 : kz;
    constexpr int kNext[] = {1, 2, 0, 1};
    kx = kNext[kz];
    ky = kNext[kz + 1];
    sx = direction[kx] / direction[kz];
    sy = direction[ky] / direction[kz];
    sz = 1.0 / direction[kz];
  }
  Vec3 apply(const Vec3& p) const noexcept {
    return {p[kx] - sx * p[kz], p[ky] - sy * p[kz], sz * p[kz]};
  }
  int kx, ky, kz;
  double sx, sy, sz;
};

/// [m] How far rounding may shift points of this box or of a segment.
double compute_slack(const Vec3& low, const Vec3& high, const Vec3& from, const Vec3& to) noexcept;

/// Where `segment` first meets one triangle, without its number; `length` [m] per parameter.
/// Nothing here depends on the tree, so neither does the answer.
std::optional<SurfacePoint> find_hit(const Shear& shear, Segment segment, double length,
                                     const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

}  // namespace palpate
