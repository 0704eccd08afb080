// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numbers>
#include <span>

#include "palpate/sim/base/types.h"

namespace palpate {

/// How curved the facets under a ball are at rest, and how far their middle lies below the highest
/// of them, by the pressures q on each [contact: facets]. With n the facets' normals, y the points
/// under the pressure, and means by q, the covariance of n and y is `curvature` <r²> on a surface
/// of that curvature, and 0 on one facet.
class FacetSums {
 public:
  /// A pressure of q [N] about the point of these barycentric weights.
  void add(double q, const Triangle& t, const Vec3& weights, std::span<const Vec3> rest) noexcept {
    const Vec3& a = rest[static_cast<std::size_t>(t[0])];
    const Vec3& b = rest[static_cast<std::size_t>(t[1])];
    const Vec3& c = rest[static_cast<std::size_t>(t[2])];
    const Vec3 across = (b - a).cross(c - a), y = weights[0] * a + weights[1] * b + weights[2] * c;
    const double length = across.norm();
    if (!(length > 0.0)) return;
    if (!(force_ > 0.0)) origin_ = y;
    force_ += q;
    normal_ += (q / length) * across;
    centre_ += q * (y - origin_);
    both_ += (q / length) * across.dot(y - origin_);
  }

  /// [m]
  double covariance() const noexcept {
    return force_ > 0.0 ? (both_ - normal_.dot(centre_) / force_) / force_ : 0.0;
  }

  /// [1/m] Their pressures on an area [m²]. Those of a ball, which go as the root of the distance
  /// to its rim, have the mean square distance <r²> of two fifths of the square of its radius.
  double curvature(double area) const noexcept {
    constexpr double kSpread = 0.4 * std::numbers::inv_pi;
    return area > 0.0 ? covariance() / (kSpread * area) : 0.0;
  }

  /// [m] Of a surface of that curvature: curvature <r²>/2.
  double drop() const noexcept { return std::max(0.0, 0.5 * covariance()); }

 private:
  double force_ = 0.0;          // [N]
  double both_ = 0.0;           // [N m]
  Vec3 origin_ = Vec3::Zero();  // [m]
  Vec3 normal_ = Vec3::Zero();  // [N]
  Vec3 centre_ = Vec3::Zero();  // [N m] from the origin
};

}  // namespace palpate
