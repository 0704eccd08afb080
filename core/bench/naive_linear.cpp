// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/naive_linear.h"

#include <algorithm>

namespace palpate::bench {

NaiveResponse::NaiveResponse(const Response& response)
    : response_(response),
      compliance_(response.compliance.begin(), response.compliance.end()),
      sag_(response.sag.begin(), response.sag.end()),
      displacement_(sag_.size(), 0.0),
      goal_(sag_.size(), 0.0),
      force_(3 * static_cast<std::size_t>(response.size.pushed), 0.0) {}

void NaiveResponse::follow(const ResponseState& state) {
  std::copy(state.displacement.begin(), state.displacement.end(), displacement_.begin());
}

void NaiveResponse::step(const TissueModel& model, const Load& load, double share,
                         std::span<Vec3> x) noexcept {
  std::fill(force_.begin(), force_.end(), 0.0);
  for (const Push& push : load.pushes()) {
    const Triangle& corners = model.triangles[static_cast<std::size_t>(push.triangle)];
    for (int c = 0; c < 3; ++c) {
      const int column = response_.column[static_cast<std::size_t>(corners[c])];
      if (column < 0) continue;
      for (int axis = 0; axis < 3; ++axis) {
        force_[3 * static_cast<std::size_t>(column) + static_cast<std::size_t>(axis)] +=
            push.weights[c] * push.force[axis];
      }
    }
  }
  const std::size_t width = goal_.size();
  std::copy(sag_.begin(), sag_.end(), goal_.begin());
  for (std::size_t row = 0; row < force_.size(); ++row) {
    if (force_[row] == 0.0) continue;  // most of it is zero
    const double* answer = compliance_.data() + row * width;
    for (std::size_t k = 0; k < width; ++k) goal_[k] += force_[row] * answer[k];
  }
  for (std::size_t k = 0; k < width; ++k) displacement_[k] += share * (goal_[k] - displacement_[k]);
  for (std::size_t row = 0; row < response_.particle.size(); ++row) {
    const auto i = static_cast<std::size_t>(response_.particle[row]);
    const double* at = &displacement_[3 * row];
    x[i] = model.rest_position[i] + Vec3(at[0], at[1], at[2]);
  }
}

}  // namespace palpate::bench
