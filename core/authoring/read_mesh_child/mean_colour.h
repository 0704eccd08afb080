// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "palpate/sim/base/types.h"

namespace palpate::authoring {

/// [IEC 61966-2-1]
inline double to_srgb(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

/// The mean of colours by the area that has them, channels of 0 to 1.
class MeanColour {
 public:
  void add(const Vec3& colour, double area) {
    if (!colour.allFinite() || !(area > 0.0) || !std::isfinite(area)) return;
    sum_ += area * colour.cwiseMax(0.0).cwiseMin(1.0);
    area_ += area;
  }

  /// nullopt where nothing was added, and for white, which is what formats say where nobody chose.
  std::optional<std::array<double, 3>> find(bool is_linear) const {
    if (!(area_ > 0.0)) return std::nullopt;
    Vec3 mean = sum_ / area_;
    if ((mean.array() > kWhite).all()) return std::nullopt;
    if (is_linear) mean = mean.unaryExpr(&to_srgb);
    mean = mean.cwiseMax(0.0).cwiseMin(1.0);
    return std::array{mean[0], mean[1], mean[2]};
  }

 private:
  static constexpr double kWhite = 0.998;  ///< within half a step of eight bits

  Vec3 sum_ = Vec3::Zero();
  double area_ = 0.0;
};

}  // namespace palpate::authoring
