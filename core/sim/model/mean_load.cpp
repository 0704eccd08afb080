// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/mean_load.h"

namespace palpate {

MeanLoad::MeanLoad(std::span<const Triangle> triangles, std::size_t vertex_count)
    : triangles_(triangles.begin(), triangles.end()),
      corner_(vertex_count, {0, 0}),
      force_(vertex_count, Vec3::Zero()),
      pushed_(vertex_count, 0),
      is_pushed_(vertex_count, 0) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      corner_[static_cast<std::size_t>(triangles_[t][c])] = {static_cast<int>(t),
                                                             static_cast<int>(c)};
    }
  }
}

/// A push f at the barycentric weights w is the forces w_c f on the corners.
void MeanLoad::add(std::span<const Push> pushes) noexcept {
  for (const Push& push : pushes) {
    const Triangle& t = triangles_[static_cast<std::size_t>(push.triangle)];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(t[c]);
      force_[v] += push.weights[static_cast<Eigen::Index>(c)] * push.force;
      if (is_pushed_[v] != 0) continue;
      is_pushed_[v] = 1;
      pushed_[pushed_count_++] = t[c];
    }
  }
}

void MeanLoad::take(int substeps, Load& load) noexcept {
  load.clear();
  for (std::size_t k = 0; k < pushed_count_; ++k) {
    const auto v = static_cast<std::size_t>(pushed_[k]);
    const auto& [triangle, corner] = corner_[v];
    load.add({triangle, Vec3::Unit(corner), force_[v] / substeps});
    force_[v].setZero();
    is_pushed_[v] = 0;
  }
  pushed_count_ = 0;
}

}  // namespace palpate
