// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/sum_over_pushes.h"

namespace palpate {

double sum_over_pushes(std::span<const Push> pushes, const TissueModel& tissue,
                       std::span<const Vec3> field) noexcept {
  const auto value_at = [&](int vertex) noexcept -> Vec3 {
    if (tissue.skin.corners.empty()) return field[static_cast<std::size_t>(vertex)];
    const auto& corners = tissue.skin.corners[static_cast<std::size_t>(vertex)];
    const auto& weights = tissue.skin.weights[static_cast<std::size_t>(vertex)];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) sum += weights[k] * field[corners[k]];
    return sum;
  };
  double total = 0.0;
  for (const Push& push : pushes) {
    const Triangle& corners = tissue.triangles[static_cast<std::size_t>(push.triangle)];
    Vec3 patch = Vec3::Zero();
    // bodies push single vertices
    for (int c = 0; c < 3; ++c) {
      if (push.weights[c] != 0.0)
        patch += push.weights[c] * value_at(corners[static_cast<std::size_t>(c)]);
    }
    total += push.force.dot(patch);
  }
  return total;
}

}  // namespace palpate
