// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/model/private/sum_over_pushes.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

/// Calls take(triangle, weights, stiffness) of all that both jaws do to one of the bodies.
template <class Take>
void for_each_spring(const Tool& tool, const OpenJaws& jaws, const JawSurfaces& surfaces, int body,
                     const ToolState& state, Take take) noexcept {
  for (int j = 0; j < 2; ++j) {
    const TouchedSurface& surface =
        surfaces[static_cast<std::size_t>(j)][static_cast<std::size_t>(body)];
    const double mu = find_friction(tool, surfaces[static_cast<std::size_t>(j)], body),
                 sliding = std::sqrt(1.0 + mu * mu);
    for_each_slope(jaws.shape(j), view(surface, body), state,
                   [&](int t, const Vec3& weights, double slope) noexcept {
                     take(t, weights, sliding * slope);
                   });
  }
  for (int k = 0; k < state.anchor_count; ++k) {
    const ToolState::Anchor& anchor = state.anchors[static_cast<std::size_t>(k)];
    if (anchor.body == body) take(anchor.triangle, anchor.weights, anchor.stiffness);
  }
}

}  // namespace

/// Of a contact J^T k J the row i has the sum k |J_i| sum_j |J_j|.
void ParticleRows::add(int triangle, const Vec3& weights, double stiffness) noexcept {
  const Triangle& t = tissue.triangles[static_cast<std::size_t>(triangle)];
  double all = 0.0;
  for_each_carrier(tissue, t, weights, [&](std::size_t, double w) noexcept { all += std::abs(w); });
  for_each_carrier(tissue, t, weights, [&](std::size_t i, double w) noexcept {
    sums[i] += stiffness * all * std::abs(w);
    largest = std::max(largest, sums[i] / tissue.mass[i]);
  });
}

void add_jaws_on_skin(const Tool& tool, const JawSurfaces& surfaces, int body,
                      const ToolState& state, ParticleRows& rows) noexcept {
  const OpenJaws jaws(tool, state.orientation, state.jaw_angle);
  for_each_spring(tool, jaws, surfaces, body, state,
                  [&](int t, const Vec3& weights, double stiffness) noexcept {
                    rows.add(t, weights, stiffness);
                  });
}

}  // namespace palpate
