// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate::authoring {

/// Whether a triangle may meet a box whose sides lie along the axes: they do not where an axis
/// across an edge of either, or the triangle's plane, lies between them [AkenineMoller01]. Plain
/// numbers: where rounding could decide, they may meet. That their bounds overlap is known.
class TriangleBox {
 public:
  using Vector = std::array<double, 3>;

  TriangleBox(const std::array<Vector, 3>& triangle, const Vector& low, const Vector& high)
      : x_(triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double middle = 0.5 * (low[k] + high[k]);
      half_[k] = 0.5 * (high[k] - low[k]);
      away_ += std::abs(middle) + half_[k];
      for (Vector& x : x_) away_ += std::abs(x[k] -= middle);
    }
  }

  bool may_meet() const {
    std::array<Vector, 3> edge;
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t k = 0; k < 3; ++k) edge[v][k] = x_[(v + 1) % 3][k] - x_[v][k];
    }
    for (const Vector& e : edge) {
      if (are_apart(e, 0) || are_apart(e, 1) || are_apart(e, 2)) return false;
    }
    return !is_beyond_plane(edge[0], edge[1]);
  }

 private:
  /// Many times what rounding makes of sums of such products.
  static constexpr double kRounding = 1e-13;

  static double add_up(const Vector& e) { return std::abs(e[0]) + std::abs(e[1]) + std::abs(e[2]); }

  /// Along the product of an edge and the axis k.
  bool are_apart(const Vector& e, std::size_t k) const {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const auto along = [&](const Vector& x) { return e[a] * x[b] - e[b] * x[a]; };
    const double p = along(x_[0]), q = along(x_[1]), r = along(x_[2]);
    const double reach =
        std::abs(e[a]) * half_[b] + std::abs(e[b]) * half_[a] + kRounding * add_up(e) * away_;
    return (p > reach && q > reach && r > reach) || (p < -reach && q < -reach && r < -reach);
  }

  bool is_beyond_plane(const Vector& e, const Vector& f) const {
    double from = 0.0, reach = kRounding * add_up(e) * add_up(f) * away_;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const double normal = e[a] * f[b] - e[b] * f[a];
      from += normal * x_[0][k];
      reach += std::abs(normal) * half_[k];
    }
    return std::abs(from) > reach;
  }

  std::array<Vector, 3> x_;  // from the middle of the box
  Vector half_{};
  double away_ = 0.0;  // no less than any of these numbers, nor than the middle's
};

}  // namespace palpate::authoring
